// libpng's simplified interface converts any kind of PNG to RGBA and reports errors without
// longjmp. The file is encoded in memory, so that writing it is one atomic step.
#include "render/png.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <png.h>

#include "limn/contract.h"
#include "limn/files/atomic_file.h"

namespace limn::render {
namespace {

/// Frees what libpng holds for an image, also on an early return.
struct PngImage {
  png_image value{};
  PngImage() { value.version = PNG_IMAGE_VERSION; }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_image_free(&value); }
};

}  // namespace

Result<void> write_png(const std::filesystem::path& path, const Image& image) {
  LIMN_EXPECTS(image.size.x > 0 && image.size.y > 0);
  LIMN_EXPECTS(image.rgba.size() ==
               static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y) * 4);
  PngImage png;
  png.value.width = static_cast<png_uint_32>(image.size.x);
  png.value.height = static_cast<png_uint_32>(image.size.y);
  png.value.format = PNG_FORMAT_RGBA;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(png.value);
  std::vector<char> encoded(bytes);
  if (png_image_write_to_memory(&png.value, encoded.data(), &bytes, 0, image.rgba.data(), 0,
                                nullptr) == 0) {
    return fail(ErrorKind::kFailed,
                fmt::format("The picture could not be encoded: {}.", png.value.message),
                path.string());
  }
  return write_file_atomically(path, [&](std::ostream& out) {
    out.write(encoded.data(), static_cast<std::streamsize>(bytes));
  });
}

Result<Image> read_png(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    return fail(ErrorKind::kBadInput,
                fmt::format("The picture could not be opened: {}.", std::strerror(errno)),
                path.string());
  }
  const std::vector<char> encoded{std::istreambuf_iterator<char>(in),
                                  std::istreambuf_iterator<char>()};
  PngImage png;
  if (png_image_begin_read_from_memory(&png.value, encoded.data(), encoded.size()) == 0) {
    return fail(ErrorKind::kBadInput, fmt::format("Not a readable PNG: {}.", png.value.message),
                path.string());
  }
  // A header may promise any size; nothing that draws here comes near this one.
  constexpr png_uint_32 kMaxSide = 1U << 15U;
  if (png.value.width > kMaxSide || png.value.height > kMaxSide) {
    return fail(
        ErrorKind::kBadInput,
        fmt::format("The picture is too large: {} by {} pixels, at most {} a side are read.",
                    png.value.width, png.value.height, kMaxSide),
        path.string());
  }
  png.value.format = PNG_FORMAT_RGBA;
  Image image(glm::ivec2(png.value.width, png.value.height));
  if (png_image_finish_read(&png.value, nullptr, image.rgba.data(), 0, nullptr) == 0) {
    return fail(ErrorKind::kBadInput, fmt::format("Not a readable PNG: {}.", png.value.message),
                path.string());
  }
  return image;
}

}  // namespace limn::render
