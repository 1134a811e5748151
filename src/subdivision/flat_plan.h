#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/large_array.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/settings.h"
#include "subdivision/node_counts.h"

// Everything that a refinement needs to know of the control mesh and its labels, as flat arrays:
// for those who carry it out elsewhere, on a GPU.
namespace limn {

/// Set in FlatSpecial::shares where a level has two numbers only.
inline constexpr std::uint32_t kEvenShares = 0x80000000u;

inline constexpr std::size_t kRootPoints = 17;

/// A node of a patch's quadtree (Node in patch.h), packed. Shaders unpack it.
struct FlatNode {
  std::uint32_t bits = 0;   ///< Labels, 4 bits each; level << 16, owned corners << 20, owned sides
                            ///< << 24, lifted sides << 28.
  std::uint32_t place = 0;  ///< Sides whose numbers fall, 4 bits; level of the root << 4; column
                            ///< << 8, 12 bits; row << 20.
  std::uint32_t root = 0;
  std::uint32_t control_face = 0;
  std::array<std::uint32_t, 4> corners{};
  std::array<std::uint32_t, 4> sides{};  ///< The number of the first vertex inside, from corner i.
  std::uint32_t inside = 0;
  std::uint32_t quad = 0;
  std::uint32_t special = kNone;  ///< Of the root: its FlatSpecial.
  std::uint32_t unused = 0;
};
static_assert(sizeof(FlatNode) == 64);

/// What makes a root more than a bicubic B-spline patch: rings around its corners, and sides with a
/// semi-sharp crease.
///
/// Its pieces are those nodes of its quadtree, whatever the labels, that have such a corner or side
/// themselves: the root; at level r = 1..levels - 1 below it one for each corner that is special,
/// in their order, and where r < sharp levels, for each sharp side the 2^r - 2 between its ends.
/// They are numbered level by level.
struct FlatSpecial {
  std::uint32_t first_piece = 0;
  std::uint32_t bits = 0;  ///< Levels, 4 bits; corners that are special << 4, that have a ring <<
                           ///< 8, whose ring has an edge beyond side i << 12, beyond side i - 1 <<
                           ///< 16; sides that are curves << 20, that are sharp << 24.
  std::uint32_t root = 0;
  std::uint32_t first_ring_point = 0;     ///< For each corner with a ring, level by level: the
                                          ///< centre, the edge beyond side i, beyond side i - 1.
                                          ///< Then, for each, its limit and the normal there.
  std::array<std::uint32_t, 4> shares{};  ///< Of a sharp side: see FlatPlan::shares.
  std::uint32_t sharp_levels = 0;         ///< Of side i: << 8 i. With limits all there are, else
                                          ///< those above `levels` only.
  std::array<std::uint32_t, 3> unused{};
};
static_assert(sizeof(FlatSpecial) == 48);

/// A quad that is known from the start: a control face that stays, or a part of one that is no quad
/// and stays from level 1 on.
struct FlatQuad {
  std::uint32_t quad = 0;
  std::uint32_t record = 0;  ///< Control face | level << 28.
  std::array<std::uint32_t, 4> corners{};
};
static_assert(sizeof(FlatQuad) == 24);

/// A vertex that rests at level 1 in a face that is no quad.
struct FlatPoint {
  std::uint32_t vertex = 0;
  std::uint32_t level = 1;
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};
};
static_assert(sizeof(FlatPoint) == 32);

/// The arrays. Points are relative to `origin`, 3 floats each.
struct FlatPlan {
  glm::dvec3 origin{0.0};
  std::uint64_t vertex_count = 0;
  std::uint64_t quad_count = 0;
  std::uint8_t greatest_label = 0;
  bool has_limits = false;        ///< Rings know their limits, and points that rest have normals.
  bool has_limit_points = false;  ///< Points that rest lie at their limits.

  SubtreeTable subtrees;
  LargeArray<FlatNode> roots;  ///< Those that are split or refined: a label is positive.
  /// kRootPoints a root: its face with the points around it, row by row, and what all points of the
  /// root are relative to, which keeps digits where faces are small. Beyond boundaries and
  /// infinitely sharp sides they mirror those within, so that nothing needs to be known of these.
  LargeArray<glm::vec3> points;
  std::array<LargeArray<std::uint32_t>, kNodeKinds>
      first_nodes;  ///< Of each root, among the nodes of a kind.
  std::array<std::uint64_t, kNodeKinds> node_counts{};

  LargeArray<FlatSpecial> specials;
  std::uint64_t piece_count = 0;
  LargeArray<glm::vec3> ring_points;  ///< Relative to their root's, too.
  /// How much of a crease's rule the points on a sharp side take: for each of its sharp levels r,
  /// 2^r + 2 numbers for the edges -1..2^r of the side's own, then 2^r + 1 for its vertices; or,
  /// where they are all the same (kEvenShares), one for the edges and one for the vertices.
  LargeArray<float> shares;
  LargeArray<std::array<std::uint32_t, 2>> sharp_sides;  ///< Special root, side.

  LargeArray<FlatQuad> resting_quads;
  LargeArray<FlatPoint> resting_points;

  /// Control faces that are no quads and stay: prefix sums of sides, vertices, control faces.
  LargeArray<std::uint32_t> polygon_offsets{0};
  LargeArray<std::uint32_t> polygon_vertices;
  std::vector<std::uint32_t> polygon_control_faces;

  /// Of the control mesh's vertices: positions (and normals) of those that never move; others are
  /// 0 and written over.
  LargeArray<glm::vec3> control_points;
  LargeArray<glm::vec3> control_normals;  ///< Empty without limits.
};

/// Makes plans and keeps their memory for the next one.
class FlatPlanner {
 public:
  FlatPlanner();
  ~FlatPlanner();
  FlatPlanner(FlatPlanner&&) noexcept;
  FlatPlanner& operator=(FlatPlanner&&) noexcept;

  /// Arguments and errors as those of Refiner::refine. Plans for limits where normals or
  /// SurfacePoints::kLimit are asked for. Time is linear in the control mesh.
  [[nodiscard]] Result<void> plan(const ControlMesh& mesh, const VertexLabels& labels,
                                  const SubdivisionSettings& settings, const RefineLimits& limits,
                                  Progress& progress);

  /// The last plan, whose mesh need not live on.
  [[nodiscard]] const FlatPlan& result() const noexcept;

  /// What is still sharp in the refined mesh, whose vertex levels are known. The mesh of the last
  /// plan lives.
  void list_creases(RefinedMesh& result) const;

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace limn
