#include "support/mesh_difference.h"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace limn::test {
namespace {

bool is_same_number(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

template <class Point>
bool are_same_bits(const Point& one, const Point& other) {
  for (int i = 0; i < Point::length(); ++i) {
    if (!is_same_number(one[i], other[i])) {
      return false;
    }
  }
  return true;
}

template <class Point>
std::string points_difference(std::span<const Point> one, std::span<const Point> other,
                              const char* what) {
  if (one.size() != other.size()) {
    return fmt::format("{} {}, and {}", one.size(), what, other.size());
  }
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (!are_same_bits(one[i], other[i])) {
      return fmt::format("{} {} at {} {}, and at {} {}", what, i, one[i].x, one[i].y, other[i].x,
                         other[i].y);
    }
  }
  return {};
}

using Sharpness = std::map<std::pair<std::uint32_t, std::uint32_t>, float>;

Sharpness sharp_edges(const ControlMesh& mesh) {
  Sharpness sharp;
  const std::vector<float>& values = mesh.creases().edge_sharpness;
  for (std::size_t e = 0; e < values.size(); ++e) {
    if (values[e] > 0.0f) {
      const auto [a, b] = mesh.topology().edge_vertices[e];
      sharp[{std::min(a, b), std::max(a, b)}] = values[e];
    }
  }
  return sharp;
}

std::string sharpness_difference(const ControlMesh& one, const ControlMesh& other) {
  if (sharp_edges(one) != sharp_edges(other)) {
    return "creases differ";
  }
  if (one.creases().vertex_sharpness != other.creases().vertex_sharpness) {
    return "corners differ";
  }
  if (one.creases().method != other.creases().method ||
      one.attributes().corners != other.attributes().corners) {
    return "rules differ";
  }
  return {};
}

/// Values are compared, and not in which order they come.
std::string uv_difference(const ControlMesh& one, const ControlMesh& other) {
  if (one.texture().empty() || other.texture().empty()) {
    return one.texture().empty() == other.texture().empty() ? "" : "one has no texture";
  }
  const auto& here = one.texture();
  const auto& there = other.texture();
  for (std::size_t c = 0; c < here.corner_values.size(); ++c) {
    const glm::dvec2& uv = here.values[here.corner_values[c]];
    if (!are_same_bits(uv, there.values[there.corner_values[c]])) {
      return fmt::format("the texture at corner {} differs", c);
    }
  }
  if (one.texture_surface()->topology.edge_corners !=
      other.texture_surface()->topology.edge_corners) {
    return "seams differ";
  }
  return {};
}

std::string name_of_face(const FaceNames& names, std::size_t face) {
  return names.empty() || names.of_faces[face] == kNone ? "" : names.names[names.of_faces[face]];
}

std::string names_difference(const FaceNaming& one, const FaceNaming& other, std::size_t faces) {
  for (std::size_t f = 0; f < faces; ++f) {
    if (name_of_face(one.objects, f) != name_of_face(other.objects, f) ||
        name_of_face(one.groups, f) != name_of_face(other.groups, f) ||
        name_of_face(one.materials, f) != name_of_face(other.materials, f)) {
      return fmt::format("names of face {} differ", f);
    }
  }
  return one.material_libraries == other.material_libraries ? "" : "material libraries differ";
}

}  // namespace

std::string difference(const ControlMesh& one, const ControlMesh& other, const Compared& compared) {
  std::string found = points_difference(one.positions(), other.positions(), "vertex");
  if (found.empty() && (one.topology().face_offsets != other.topology().face_offsets ||
                        one.topology().corner_vertices != other.topology().corner_vertices)) {
    found = "faces differ";
  }
  if (found.empty() && compared.loose_vertices) {
    found = points_difference(std::span(one.attributes().loose_vertices),
                              std::span(other.attributes().loose_vertices), "loose vertex");
  }
  if (found.empty() && compared.sharpness) {
    found = sharpness_difference(one, other);
  }
  if (found.empty() && compared.uvs) {
    found = uv_difference(one, other);
  }
  if (found.empty() && compared.names) {
    found = names_difference(one.attributes().names, other.attributes().names, one.face_count());
  }
  return found;
}

}  // namespace limn::test
