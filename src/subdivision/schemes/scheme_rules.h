#pragma once

#include <cstddef>
#include <cstdint>

#include "limn/subdivision/schemes/scheme.h"
#include "limn/subdivision/schemes/uniform.h"
#include "subdivision/schemes/level_mesh.h"
#include "subdivision/schemes/point_sink.h"

// Internal to this folder: what a scheme is made of, one file each.
namespace limn {

struct SchemeRules {
  /// The faces of the next level. (For sqrt(3) these depend on LevelMesh::level.)
  LevelFaces (*split)(const LevelMesh& from);
  /// Everything else of the next level but points and sharpness, `to.faces` being there.
  void (*connect)(const LevelMesh& from, LevelMesh& to);
  /// Points of all vertices of the next level. `to` has its sharpness and nothing else.
  void (*place)(const LevelMesh& from, const SchemeSettings& settings, const LevelMesh& to,
                const PointSink& sink);
  std::size_t (*vertex_count)(const LevelMesh& from);
  bool has_creases;  ///< Sharpness wears off from level to level; others leave it out.
};

[[nodiscard]] const SchemeRules& linear_rules() noexcept;
[[nodiscard]] const SchemeRules& loop_rules() noexcept;
[[nodiscard]] const SchemeRules& butterfly_rules() noexcept;
[[nodiscard]] const SchemeRules& kobbelt_rules() noexcept;
[[nodiscard]] const SchemeRules& sqrt3_rules() noexcept;
[[nodiscard]] const SchemeRules& doo_sabin_rules() noexcept;
[[nodiscard]] const SchemeRules& midedge_rules() noexcept;
[[nodiscard]] const SchemeRules& biquartic_rules() noexcept;

}  // namespace limn
