#include "support/image_compare.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "limn/contract.h"
#include "render/png.h"

namespace limn::test {
namespace {

namespace fs = std::filesystem;

testing::AssertionResult written(const fs::path& path, const render::Image& image) {
  const Result<void> result = render::write_png(path, image);
  return result ? testing::AssertionSuccess()
                : testing::AssertionFailure() << to_string(result.error());
}

bool is_match(const render::Image& expected, const render::Image& image) {
  return expected == image ||
         (expected.size == image.size && is_rounding(compare_images(expected, image)));
}

}  // namespace

ImageDifference compare_images(const render::Image& a, const render::Image& b) {
  LIMN_EXPECTS(a.size == b.size);
  ImageDifference difference;
  difference.image = render::Image(a.size);
  for (int y = 0; y < a.size.y; ++y) {
    for (int x = 0; x < a.size.x; ++x) {
      int largest = 0;
      for (int channel = 0; channel < 4; ++channel) {
        largest = std::max(largest, std::abs(a.pixel(x, y)[channel] - b.pixel(x, y)[channel]));
      }
      difference.pixels += largest > 0 ? 1 : 0;
      difference.largest = std::max(difference.largest, largest);
      std::uint8_t* out = difference.image.pixel(x, y);
      const auto grey = static_cast<std::uint8_t>(a.pixel(x, y)[1] / 3);
      out[0] = largest > 0 ? static_cast<std::uint8_t>(std::min(255, 128 + largest)) : grey;
      out[1] = largest > 0 ? 0 : grey;
      out[2] = largest > 0 ? 0 : grey;
      out[3] = 255;
    }
  }
  return difference;
}

bool is_rounding(const ImageDifference& difference) {
  constexpr int kLargest = 2;
  constexpr std::size_t kOneIn = 1000;
  const std::size_t all = difference.image.rgba.size() / 4;
  return difference.largest <= kLargest && difference.pixels <= all / kOneIn;
}

std::string source_folder() {
  return LIMN_SOURCE_DIR;
}

bool is_updating_goldens() {
  const char* value = std::getenv("LIMN_UPDATE_GOLDENS");
  return value != nullptr && std::string_view(value) == "1";
}

testing::AssertionResult matches_golden(const render::Image& image, const std::string& name) {
  return matches_picture(image, "tests/golden/" + name + ".png");
}

testing::AssertionResult matches_picture(const render::Image& image, const std::string& path) {
  const fs::path golden = fs::path(LIMN_SOURCE_DIR) / path;
  const std::string name = golden.stem().string();
  const fs::path out = golden.parent_path() / (name + ".out.png");
  const fs::path diff = golden.parent_path() / (name + ".diff.png");
  if (is_updating_goldens()) {
    fs::remove(out);
    fs::remove(diff);
    const Result<render::Image> last = render::read_png(golden);
    return last && is_match(*last, image) ? testing::AssertionSuccess() : written(golden, image);
  }
  if (!fs::exists(golden)) {
    return testing::AssertionFailure() << golden << " is missing; what was drawn is in " << out
                                       << ". " << written(out, image).message();
  }
  const Result<render::Image> expected = render::read_png(golden);
  if (!expected) {
    return testing::AssertionFailure() << to_string(expected.error());
  }
  if (is_match(*expected, image)) {
    return testing::AssertionSuccess();
  }
  const testing::AssertionResult out_written = written(out, image);
  if (expected->size != image.size) {
    return testing::AssertionFailure()
           << name << " is " << image.size.x << " by " << image.size.y << " pixels, its golden "
           << expected->size.x << " by " << expected->size.y << "; see " << out << ". "
           << out_written.message();
  }
  const ImageDifference difference = compare_images(*expected, image);
  const testing::AssertionResult diff_written = written(diff, difference.image);
  return testing::AssertionFailure()
         << difference.pixels << " pixels of " << name << " differ from its golden, by up to "
         << difference.largest << "; see " << out << " and " << diff << ". "
         << out_written.message() << diff_written.message();
}

}  // namespace limn::test
