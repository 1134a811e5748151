// A mirror takes the corners of a face to those of its partner, on around or back around. That says
// where columns and rows go.
#include "limn/painting/fine_mirror.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace limn {
namespace {

/// Corner i of a face is corner first + i, or first - i, of its partner.
struct CornerMap {
  std::uint32_t first = 0;
  bool goes_back = false;
  std::uint32_t sides = 4;

  [[nodiscard]] std::uint32_t operator()(std::uint32_t corner) const {
    return (goes_back ? first + sides - corner : first + corner) % sides;
  }
};

CornerMap corner_map(const ControlMesh& mesh, std::uint32_t face, std::uint32_t partner,
                     const glm::dvec3& sign) {
  const auto corners = mesh.face(face);
  const auto images = mesh.face(partner);
  const glm::dvec3 centre = mesh.bounds().centre();
  CornerMap best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const bool goes_back : {false, true}) {
    for (std::uint32_t first = 0; first < corners.size(); ++first) {
      const CornerMap map{first, goes_back, static_cast<std::uint32_t>(corners.size())};
      double away = 0.0;
      for (std::uint32_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 image = sign * (mesh.positions()[corners[i]] - centre);
        away += glm::distance(image, mesh.positions()[images[map(i)]] - centre);
      }
      if (away < nearest) {
        nearest = away;
        best = map;
      }
    }
  }
  return best;
}

/// Of a unit square, in order.
glm::ivec2 square_corner(std::uint32_t i) {
  return {i == 1 || i == 2 ? 1 : 0, i >= 2 ? 1 : 0};
}

FineFace image_of(const FineFace& face, std::uint32_t partner, const CornerMap& map) {
  FineFace image = face;
  image.control_face = partner;
  if (face.level == 0) {
    return image;
  }
  if (map.sides != 4) {
    image.corner = map(face.corner);
    if (map.goes_back) {
      std::swap(image.column, image.row);
    }
    return image;
  }
  const glm::ivec2 origin = square_corner(map(0));
  const glm::ivec2 at = origin * ((1 << face.level) - 1) +
                        (square_corner(map(1)) - origin) * int{face.column} +
                        (square_corner(map(3)) - origin) * int{face.row};
  image.column = static_cast<std::uint16_t>(at.x);
  image.row = static_cast<std::uint16_t>(at.y);
  return image;
}

auto key_of(const FineFace& face) {
  return std::tuple(face.control_face, face.corner, face.level, face.row, face.column);
}

}  // namespace

std::vector<FineFace> with_images(const ControlMesh& mesh, const FaceMirror& mirror,
                                  std::span<const FineFace> faces) {
  std::vector<FineFace> all(faces.begin(), faces.end());
  const MirrorAxes& axes = mirror.axes();
  std::size_t table = 0;
  for (unsigned some = 1; some < 8 && table < mirror.partners().size(); ++some) {
    const bool x = (some & 1U) != 0;
    const bool y = (some & 2U) != 0;
    const bool z = (some & 4U) != 0;
    if ((x && !axes.x) || (y && !axes.y) || (z && !axes.z)) {
      continue;
    }
    const std::vector<std::uint32_t>& partners = mirror.partners()[table++];
    const glm::dvec3 sign(x ? -1.0 : 1.0, y ? -1.0 : 1.0, z ? -1.0 : 1.0);
    std::uint32_t last = kNone;
    CornerMap map;
    for (const FineFace& face : faces) {
      const std::uint32_t partner = partners[face.control_face];
      if (partner == kNone) {
        continue;
      }
      if (std::exchange(last, face.control_face) != face.control_face) {
        map = corner_map(mesh, face.control_face, partner, sign);
      }
      all.push_back(image_of(face, partner, map));
    }
  }
  const auto comes_before = [](const FineFace& a, const FineFace& b) {
    return key_of(a) < key_of(b);
  };
  std::ranges::sort(all, comes_before);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace limn
