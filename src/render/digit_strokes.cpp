// Each digit is a few lines and elliptical arcs; arcs become chords, fine enough for digits a dozen
// pixels high.
#include "render/digit_strokes.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/vec2.hpp>

namespace limn::render {
namespace {

struct Ellipse {
  glm::vec2 centre;
  glm::vec2 radii;
};

class Pen {
 public:
  explicit Pen(std::vector<glm::vec4>& strokes) : strokes_(strokes) {}

  void move(glm::vec2 to) { at_ = to; }
  void line(glm::vec2 to) {
    strokes_.emplace_back(at_, to);
    at_ = to;
  }
  /// From one angle to the other in degrees, counter-clockwise where it is the larger.
  void arc(const Ellipse& ellipse, float from, float to) {
    constexpr float kDegreesAChord = 26.0F;
    const auto point = [&ellipse](float degrees) {
      const float angle = degrees * std::numbers::pi_v<float> / 180.0F;
      return ellipse.centre + ellipse.radii * glm::vec2(std::cos(angle), std::sin(angle));
    };
    const auto chords = static_cast<int>(std::ceil(std::abs(to - from) / kDegreesAChord));
    move(point(from));
    for (int i = 1; i <= chords; ++i) {
      line(point(from + (to - from) * static_cast<float>(i) / static_cast<float>(chords)));
    }
  }

 private:
  std::vector<glm::vec4>& strokes_;
  glm::vec2 at_{0.0F};
};

void draw_six(Pen& pen) {
  pen.arc({{0.30F, 0.29F}, {0.27F, 0.29F}}, 0, 360);
  pen.move({0.04F, 0.36F});
  pen.line({0.12F, 0.66F});
  pen.line({0.26F, 0.87F});
  pen.line({0.45F, 1.0F});
}

void draw_digit(Pen& pen, int digit) {
  switch (digit) {
    case 0:
      pen.arc({{0.30F, 0.50F}, {0.28F, 0.50F}}, 0, 360);
      break;
    case 1:
      pen.move({0.10F, 0.77F});
      pen.line({0.34F, 1.0F});
      pen.line({0.34F, 0.0F});
      break;
    case 2:
      pen.arc({{0.29F, 0.72F}, {0.26F, 0.28F}}, 165, -35);
      pen.line({0.03F, 0.0F});
      pen.line({0.58F, 0.0F});
      break;
    case 3:
      pen.arc({{0.27F, 0.755F}, {0.24F, 0.245F}}, 150, -90);
      pen.arc({{0.27F, 0.255F}, {0.29F, 0.255F}}, 90, -150);
      break;
    case 4:
      pen.move({0.44F, 0.0F});
      pen.line({0.44F, 1.0F});
      pen.line({0.01F, 0.30F});
      pen.line({0.60F, 0.30F});
      break;
    case 5:
      pen.move({0.53F, 1.0F});
      pen.line({0.12F, 1.0F});
      pen.line({0.09F, 0.56F});
      pen.arc({{0.28F, 0.32F}, {0.29F, 0.32F}}, 130, -150);
      break;
    case 6:
      draw_six(pen);
      break;
    case 7:
      pen.move({0.03F, 1.0F});
      pen.line({0.57F, 1.0F});
      pen.line({0.20F, 0.0F});
      break;
    case 8:
      pen.arc({{0.30F, 0.76F}, {0.23F, 0.24F}}, 0, 360);
      pen.arc({{0.30F, 0.26F}, {0.28F, 0.26F}}, 0, 360);
      break;
    default:
      draw_six(pen);
      break;
  }
}

}  // namespace

DigitStrokes make_digit_strokes() {
  DigitStrokes font;
  Pen pen(font.strokes);
  for (int digit = 0; digit < 10; ++digit) {
    font.first[static_cast<std::size_t>(digit)] = static_cast<std::uint32_t>(font.strokes.size());
    draw_digit(pen, digit);
  }
  // A nine is a six turned over.
  for (std::size_t i = font.first[9]; i < font.strokes.size(); ++i) {
    font.strokes[i] = glm::vec4(0.6F, 1.0F, 0.6F, 1.0F) - font.strokes[i];
  }
  font.first[10] = static_cast<std::uint32_t>(font.strokes.size());
  return font;
}

}  // namespace limn::render
