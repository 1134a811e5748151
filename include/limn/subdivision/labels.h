#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// L(v) for every vertex: how many more levels the faces around v still get.
using VertexLabels = std::vector<std::uint8_t>;

/// How the labels of one face's corners, taken in order, tell it to be subdivided.
enum class FacePattern : std::uint8_t {
  kStays,    ///< No positive label.
  kSplit,    ///< n >= 5, or 3 or 4 positive, or the two opposite ones: n quads, as in uniform
             ///< Catmull-Clark.
  kY,        ///< A quad with one positive label: a Y-element of three quads.
  kIllegal,  ///< A quad with two neighbouring positive labels.
};

/// The pattern of a quad with labels a, b, c, d in cyclic order (only their being positive counts).
[[nodiscard]] FacePattern quad_pattern(int a, int b, int c, int d) noexcept;

/// L(v) = max of the depths of the faces around v (Yong & Cheng 2005). `depths` has one entry per
/// control face, 0..kMaxDepth.
[[nodiscard]] VertexLabels vertex_labels(const ControlMesh& mesh,
                                         std::span<const std::uint8_t> depths);

/// Raises the labels as `rule` asks for meshes with faces that are no quads; labels of all-quad
/// meshes are returned as they are.
///
/// kUniformFirstStep: every label + 1, where anything at all is painted (an unpainted mesh is left
/// alone). kWherePainted: while a non-quad face has a positive and a zero label, its zeros
/// become 1.
[[nodiscard]] VertexLabels apply_non_quad_rule(const ControlMesh& mesh, VertexLabels labels,
                                               NonQuadRule rule);

/// The quads that a method of legalisation leaves none of, ascending. kGreedy: those with exactly
/// two labels 0 in either arrangement, the paper's illegal faces. kLookAhead: only those whose two
/// labels 0 are neighbours; where they are opposite the quad splits.
[[nodiscard]] std::vector<std::uint32_t> illegal_faces(
    const ControlMesh& mesh, const VertexLabels& labels,
    LegalisationMethod method = LegalisationMethod::kGreedy);

/// The zero vertices of illegal faces, ascending.
[[nodiscard]] std::vector<std::uint32_t> illegal_vertices(
    const ControlMesh& mesh, const VertexLabels& labels,
    LegalisationMethod method = LegalisationMethod::kGreedy);

}  // namespace limn
