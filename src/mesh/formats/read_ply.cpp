// Each property is given a role by its name; the numbers are then read in the order of the header,
// and each goes where its role says.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limn/mesh/control_mesh.h"
#include "mesh/formats/parse_number.h"
#include "mesh/formats/ply_header.h"
#include "mesh/formats/ply_values.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/refusal.h"
#include "mesh/formats/sharpness.h"
#include "mesh/formats/soup_values.h"
#include "mesh/formats/unused_data.h"
#include "mesh/formats/weld.h"
#include "mesh/formats/words.h"

namespace limn::detail {
namespace {

enum class Role {
  kX,
  kY,
  kZ,
  kU,
  kV,
  kFirst,
  kSecond,
  kSharpness,
  kDepth,
  kCount,  ///< Those before it are single numbers.
  kIndices,
  kUvs,
  kNone
};
constexpr auto SingleRoles = static_cast<std::size_t>(Role::kCount);

struct RoleName {
  std::string_view element;
  std::string_view property;
  bool is_list;
  Role role;
};

constexpr RoleName RoleNames[] = {
    {"vertex", "x", false, Role::kX},
    {"vertex", "y", false, Role::kY},
    {"vertex", "z", false, Role::kZ},
    {"vertex", "u", false, Role::kU},
    {"vertex", "v", false, Role::kV},
    {"vertex", "s", false, Role::kU},
    {"vertex", "t", false, Role::kV},
    {"vertex", "texture_u", false, Role::kU},
    {"vertex", "texture_v", false, Role::kV},
    {"vertex", "limn_sharpness", false, Role::kSharpness},
    {"face", "vertex_indices", true, Role::kIndices},
    {"face", "vertex_index", true, Role::kIndices},
    {"face", "texcoord", true, Role::kUvs},
    {"face", "limn_depth", false, Role::kDepth},
    {"tristrips", "vertex_indices", true, Role::kIndices},
    {"tristrips", "vertex_index", true, Role::kIndices},
    {"edge", "vertex1", false, Role::kFirst},
    {"edge", "vertex2", false, Role::kSecond},
    {"edge", "limn_sharpness", false, Role::kSharpness},
};

/// An element, and what its properties are to it.
struct Plan {
  const PlyElement& element;
  std::vector<Role> roles;
  std::array<bool, static_cast<std::size_t>(Role::kNone) + 1> has{};

  [[nodiscard]] bool has_role(Role role) const { return has[static_cast<std::size_t>(role)]; }
};

Plan plan_of(const PlyElement& element) {
  Plan plan{element, {}, {}};
  for (const PlyProperty& property : element.properties) {
    Role role = Role::kNone;
    for (const RoleName& known : RoleNames) {
      if (known.element == element.name && known.property == property.name &&
          known.is_list == property.count_type.has_value() && !plan.has_role(known.role)) {
        role = known.role;
      }
    }
    plan.roles.push_back(role);
    plan.has[static_cast<std::size_t>(role)] = true;
  }
  return plan;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_colour(std::string_view name) {
  if (name.starts_with("diffuse_")) {
    name.remove_prefix(std::string_view("diffuse_").size());
  }
  return is_one_of(name, {"red", "green", "blue", "alpha", "r", "g", "b", "a"});
}

class PlyBody {
 public:
  PlyBody(std::string_view bytes, const PlyHeader& header, const std::string& source)
      : header_(header), values_(bytes, header, source) {
    soup_.source = source;
    soup_.place_unit = values_.place_unit();
  }
  [[nodiscard]] Result<PolygonSoup> read();

 private:
  bool read_element(const Plan& plan);
  bool read_instance(const Plan& plan);
  bool read_list(const PlyProperty& property, Role role);
  bool read_index(PlyType type, std::vector<std::uint32_t>& indices);
  bool use_vertex(const Plan& plan);
  bool use_face(const Plan& plan);
  bool use_strip();
  bool use_edge();
  void add_strip_face(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void take_wedges();
  void count_unused(const Plan& plan, bool is_used);
  void read_remarks();
  [[nodiscard]] double single(Role role) const { return singles_[static_cast<std::size_t>(role)]; }

  const PlyHeader& header_;
  PlyValues values_;
  PolygonSoup soup_;
  UnusedData unused_;
  std::array<double, SingleRoles> singles_{};
  std::vector<std::uint32_t> indices_;  ///< Of the instance.
  std::vector<double> uvs_;             ///< Of the instance.
  std::vector<glm::dvec2> wedges_;      ///< Of all corners so far, where any has one.
  std::vector<bool> has_wedge_;
  bool has_vertices_ = false;
};

Result<PolygonSoup> PlyBody::read() {
  for (const PlyElement& element : header_.elements) {
    const Plan plan = plan_of(element);
    if (element.name == "vertex" && std::exchange(has_vertices_, true)) {
      return refuse_line(soup_.source, element.line, "The vertices are announced twice.");
    }
    if (element.name == "vertex" &&
        !(plan.has_role(Role::kX) && plan.has_role(Role::kY) && plan.has_role(Role::kZ))) {
      return refuse_line(soup_.source, element.line,
                         "The vertices do not have properties x, y and z.");
    }
    if (!read_element(plan)) {
      return tl::unexpected<Error>(values_.error());
    }
  }
  read_remarks();
  const bool is_text = values_.place_unit() == PlaceUnit::kLine;
  unused_.add(values_.count_rest(),
              is_text ? "line after the last element" : "byte after the last element",
              is_text ? "lines after the last element" : "bytes after the last element");
  if (!soup_.face_depths.empty()) {
    soup_.face_depths.resize(soup_.face_count(), 0);
  }
  take_wedges();
  soup_.unused_data = unused_.phrases();
  return std::move(soup_);
}

bool PlyBody::read_element(const Plan& plan) {
  const PlyElement& element = plan.element;
  const bool is_vertex = element.name == "vertex";
  const bool is_face = element.name == "face" && plan.has_role(Role::kIndices);
  const bool is_strip = element.name == "tristrips" && plan.has_role(Role::kIndices);
  const bool is_edge = element.name == "edge" && plan.has_role(Role::kFirst) &&
                       plan.has_role(Role::kSecond) && plan.has_role(Role::kSharpness);
  count_unused(plan, is_vertex || is_face || is_strip || is_edge);
  if (element.properties.empty()) {
    return true;
  }
  if (is_vertex) {
    soup_.positions.reserve(element.count);
    soup_.vertex_places.reserve(element.count);
  } else if (is_face) {
    soup_.face_offsets.reserve(soup_.face_offsets.size() + element.count);
    soup_.face_places.reserve(soup_.face_places.size() + element.count);
  }
  for (std::uint64_t i = 0; i < element.count; ++i) {
    values_.begin(element, i);
    if (!read_instance(plan) || !values_.end()) {
      return false;
    }
    if ((is_vertex && !use_vertex(plan)) || (is_face && !use_face(plan)) ||
        (is_strip && !use_strip()) || (is_edge && !use_edge())) {
      return false;
    }
  }
  return true;
}

bool PlyBody::read_instance(const Plan& plan) {
  indices_.clear();
  uvs_.clear();
  double ignored = 0.0;
  for (std::size_t p = 0; p < plan.roles.size(); ++p) {
    const PlyProperty& property = plan.element.properties[p];
    const Role role = plan.roles[p];
    if (property.count_type) {
      if (!read_list(property, role)) {
        return false;
      }
    } else if (!values_.next(property.type, role < Role::kCount
                                                ? singles_[static_cast<std::size_t>(role)]
                                                : ignored)) {
      return false;
    }
  }
  return true;
}

bool PlyBody::read_list(const PlyProperty& property, Role role) {
  std::size_t length = 0;
  if (!values_.next_length(property, length)) {
    return false;
  }
  double value = 0.0;
  for (std::size_t i = 0; i < length; ++i) {
    if (role == Role::kIndices) {
      if (!read_index(property.type, indices_)) {
        return false;
      }
    } else if (!values_.next(property.type, value)) {
      return false;
    } else if (role == Role::kUvs) {
      uvs_.push_back(value);
    }
  }
  return true;
}

/// A vertex from 0, or -1, which ends a strip and is no vertex anywhere else.
bool PlyBody::read_index(PlyType type, std::vector<std::uint32_t>& indices) {
  double value = 0.0;
  if (!values_.next(type, value)) {
    return false;
  }
  if (value == -1.0) {
    indices.push_back(kNone);
    return true;
  }
  if (!(value >= 0.0 && value < static_cast<double>(kNone)) || std::floor(value) != value) {
    return values_.refuse(fmt::format("{} is not the number of a vertex.", value));
  }
  indices.push_back(static_cast<std::uint32_t>(value));
  return true;
}

bool PlyBody::use_vertex(const Plan& plan) {
  if (plan.has_role(Role::kU) && plan.has_role(Role::kV)) {
    add_uv(soup_, single(Role::kU), single(Role::kV));
  }
  if (plan.has_role(Role::kSharpness)) {
    const std::optional<float> sharpness = to_sharpness(single(Role::kSharpness));
    if (!sharpness) {
      return values_.refuse("The sharpness of this vertex is not a number.");
    }
    if (*sharpness != 0.0f) {
      soup_.corners.push_back({static_cast<std::uint32_t>(soup_.positions.size()), *sharpness});
    }
  }
  add_vertex(soup_, {single(Role::kX), single(Role::kY), single(Role::kZ)}, values_.place());
  return true;
}

bool PlyBody::use_face(const Plan& plan) {
  if (std::find(indices_.begin(), indices_.end(), kNone) != indices_.end()) {
    return values_.refuse("-1 is not the number of a vertex.");
  }
  if (plan.has_role(Role::kDepth)) {
    const double depth = single(Role::kDepth);
    constexpr double most = std::numeric_limits<std::uint32_t>::max();
    if (!(depth >= 0.0 && depth <= most) || std::floor(depth) != depth) {
      return values_.refuse(fmt::format("{} is not a depth.", depth));
    }
    soup_.face_depths.resize(soup_.face_count(), 0);
    soup_.face_depths.push_back(static_cast<std::uint32_t>(depth));
  }
  if (uvs_.size() == 2 * indices_.size() && !uvs_.empty()) {
    wedges_.resize(soup_.face_vertices.size());
    has_wedge_.resize(soup_.face_vertices.size(), false);
    for (std::size_t i = 0; i < indices_.size(); ++i) {
      wedges_.emplace_back(uvs_[2 * i], uvs_[2 * i + 1]);
      has_wedge_.push_back(true);
    }
  } else {
    unused_.add(uvs_.size(), "texture number that fits no corner",
                "texture numbers that fit no corner");
  }
  soup_.face_vertices.insert(soup_.face_vertices.end(), indices_.begin(), indices_.end());
  end_face(soup_, values_.place());
  return true;
}

void PlyBody::add_strip_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  // Strips repeat vertices to turn corners; these triangles are none.
  if (a != b && b != c && c != a) {
    soup_.face_vertices.insert(soup_.face_vertices.end(), {a, b, c});
    end_face(soup_, values_.place());
  }
}

bool PlyBody::use_strip() {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    if (indices_[i] == kNone) {
      begin = i + 1;
    } else if (i >= begin + 2) {
      const bool is_odd = (i - begin) % 2 != 0;
      add_strip_face(indices_[is_odd ? i - 1 : i - 2], indices_[is_odd ? i - 2 : i - 1],
                     indices_[i]);
    }
  }
  return true;
}

bool PlyBody::use_edge() {
  CreaseTag tag;
  const std::array<Role, 2> roles{Role::kFirst, Role::kSecond};
  for (std::size_t i = 0; i < 2; ++i) {
    const double vertex = single(roles[i]);
    if (!(vertex >= 0.0 && vertex < static_cast<double>(kNone)) || std::floor(vertex) != vertex) {
      return values_.refuse(fmt::format("{} is not the number of a vertex.", vertex));
    }
    tag.vertices[i] = static_cast<std::uint32_t>(vertex);
  }
  const std::optional<float> sharpness = to_sharpness(single(Role::kSharpness));
  if (!sharpness) {
    return values_.refuse("The sharpness of this edge is not a number.");
  }
  tag.sharpness = *sharpness;
  soup_.creases.push_back(tag);
  return true;
}

/// Texture coordinates of corners win over those of vertices. Corners of a vertex that have the
/// same share a point of the texture.
void PlyBody::take_wedges() {
  if (wedges_.empty()) {
    soup_.face_uvs = soup_.uvs.empty() ? std::vector<std::uint32_t>{} : soup_.face_vertices;
    return;
  }
  unused_.add(soup_.uvs.size(), "texture coordinate of vertices",
              "texture coordinates of vertices");
  soup_.uvs.clear();
  soup_.broken_uvs = 0;
  std::vector<WeldKey> keys;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t c = 0; c < wedges_.size(); ++c) {
    if (has_wedge_[c]) {
      keys.push_back(corner_key(soup_.face_vertices[c], wedges_[c]));
      corners.push_back(c);
    }
  }
  const Welding welding = weld(keys);
  for (const std::uint32_t first : welding.first) {
    const glm::dvec2& uv = wedges_[corners[first]];
    add_uv(soup_, uv.x, uv.y);
  }
  soup_.face_uvs.assign(soup_.face_vertices.size(), kNone);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    soup_.face_uvs[corners[i]] = welding.numbers[i];
  }
}

void PlyBody::count_unused(const Plan& plan, bool is_used) {
  const PlyElement& element = plan.element;
  if (!is_used) {
    unused_.add_named(element.count, element.name, "element");
    return;
  }
  bool has_colour = false;
  bool has_normal = false;
  const bool has_half_uv = plan.has_role(Role::kU) != plan.has_role(Role::kV);
  for (std::size_t p = 0; p < plan.roles.size(); ++p) {
    const std::string_view name = element.properties[p].name;
    const bool is_half_uv = has_half_uv && (plan.roles[p] == Role::kU || plan.roles[p] == Role::kV);
    if (plan.roles[p] != Role::kNone && !is_half_uv) {
      continue;
    }
    if (is_colour(name)) {
      has_colour = true;
    } else if (is_one_of(name, {"nx", "ny", "nz"})) {
      has_normal = true;
    } else {
      unused_.add_named(element.count, name, fmt::format("{} value", element.name));
    }
  }
  unused_.add(has_normal ? element.count : 0, "normal");
  unused_.add(has_colour ? element.count : 0, fmt::format("{} colour", element.name));
}

/// How sharpness goes on, in the form that Limn writes.
void PlyBody::read_remarks() {
  for (const std::string_view remark : header_.remarks) {
    if (remark == "limn_creasing chaikin") {
      soup_.creasing = CreasingMethod::kChaikin;
    } else if (remark == "limn_corners sharp" || remark == "limn_corners smooth") {
      soup_.corner_rule = remark.ends_with("sharp") ? CornerRule::kSharp : CornerRule::kSmooth;
    } else {
      unused_.add(1, "remark");
    }
  }
}

}  // namespace

Result<PolygonSoup> read_ply(std::string_view bytes, const std::string& source) {
  return read_ply_header(bytes, source).and_then([&](const PlyHeader& header) {
    return PlyBody(bytes, header, source).read();
  });
}

}  // namespace limn::detail
