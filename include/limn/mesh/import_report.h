#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/flat_topology.h"

namespace limn {

/// One way in which a control mesh differs from what its file says, in the order in which a soup is
/// mended (mesh/build.h).
enum class MendKind {
  kRepeatedCorner,     ///< The same vertex twice in a row in a face; merged.
  kDegenerateFace,     ///< A face with fewer than three distinct vertices; dropped.
  kDuplicateFace,      ///< A face on the vertices of an earlier one, in the same circle; dropped.
  kFlippedFace,        ///< Clashed with its neighbours' orientation; turned over.
  kOneSidedEdge,       ///< Lay where a one-sided surface (Moebius band) clashes; cut open.
  kCrowdedEdge,        ///< Had three or more faces; pairs stay joined, the rest is detached.
  kSplitVertex,        ///< Joined several fans of faces; a copy is added for each further one.
  kLooseVertex,        ///< In no face; kept aside and written back.
  kBrokenVertex,       ///< In no face, with coordinates that are no usable numbers; left out.
  kLostCrease,         ///< A crease tag between vertices that share no edge; left out.
  kLostCorner,         ///< A corner tag on a vertex of no face; left out.
  kNegativeSharpness,  ///< A tag with a sharpness below 0, taken as 0.
  kFilledUv,           ///< A corner without texture coordinates in a mesh that has some; all these
                       ///< share one more point, 0 0.
  kBrokenUv,           ///< Texture coordinates that are not finite or beyond 1e18; became 0.
  kCappedDepth,        ///< A painted depth beyond the greatest there is; became that.
};
inline constexpr std::size_t kMendKindCount = 15;

/// What a report calls a kind where programs read it: "flipped_faces".
[[nodiscard]] std::string_view name_of(MendKind kind) noexcept;

/// How a file's elements are told: by the line of a text, or by the offset of a byte.
enum class PlaceUnit { kLine, kByte };

/// A single face, edge or vertex that was mended.
struct MendedElement {
  std::uint32_t face = kNone;                           ///< Of the control mesh, if it has it.
  std::array<std::uint32_t, 2> vertices{kNone, kNone};  ///< The same; both for an edge.
  std::size_t place = 0;     ///< Line from 1 or byte from 0 in the file; without such places the
                             ///< element's number in the soup, from 0.
  glm::dvec3 position{0.0};  ///< Where it is or was: the middle of a face or an edge.
};

/// All mends of one kind.
struct Mend {
  /// So many are told one by one.
  static constexpr std::size_t kMostElements = 1000;

  MendKind kind{};
  std::size_t count = 0;                ///< At least 1.
  std::vector<MendedElement> elements;  ///< The first of them; none for attributes.
};

/// What had to be mended, or was set aside, to make a control mesh of what a file holds.
struct ImportReport {
  std::vector<Mend> mends;                  ///< By kind, rising.
  bool has_places = false;                  ///< Whether elements have places in the file,
  PlaceUnit place_unit = PlaceUnit::kLine;  ///< and of which unit.
  std::vector<std::string> unused_data;     ///< What the file holds and Limn does not read, counted
                                            ///< ("12 normals", "2 line elements").

  /// True where the mesh differs from the file's.
  [[nodiscard]] bool is_mended() const noexcept { return !mends.empty(); }
  [[nodiscard]] std::size_t count(MendKind kind) const noexcept;
  /// Counts mends of a kind without telling which.
  void add(MendKind kind, std::size_t count = 1);
  /// Counts one element. It is told unless there are too many.
  void add(MendKind kind, const MendedElement& element);
  /// One sentence per kind of mend and of unused data; empty where the file came in as it was.
  [[nodiscard]] std::vector<std::string> sentences() const;
};

/// What happened to so many elements, as a sentence.
[[nodiscard]] std::string sentence_of(MendKind kind, std::size_t count);

/// Where an element of a report is, for people: "line 12", "byte 340", "face 3".
[[nodiscard]] std::string place_of(const ImportReport& report, const Mend& mend,
                                   const MendedElement& element);

}  // namespace limn
