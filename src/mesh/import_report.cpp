// One table says for every kind what programs and what people call it.
#include "limn/mesh/import_report.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "limn/contract.h"
#include "mesh/counted.h"

namespace limn {
namespace {

struct KindText {
  MendKind kind;
  std::string_view name;
  std::string_view one;  ///< Follows "1 ".
  std::string_view many;
};

constexpr std::array<KindText, kMendKindCount> Texts{{
    {MendKind::kRepeatedCorner, "repeated_corners",
     "corner of a face repeated the one before and was merged with it.",
     "corners of faces repeated the one before and were merged with it."},
    {MendKind::kDegenerateFace, "degenerate_faces",
     "face had fewer than three distinct vertices and was dropped.",
     "faces had fewer than three distinct vertices and were dropped."},
    {MendKind::kDuplicateFace, "duplicate_faces",
     "face was there twice; the second one was dropped.",
     "faces repeated others and were dropped."},
    {MendKind::kFlippedFace, "flipped_faces", "face was turned over to agree with the neighbours.",
     "faces were turned over to agree with the neighbours."},
    {MendKind::kOneSidedEdge, "one_sided_edges",
     "edge of a one-sided surface, like a Moebius band, was cut open.",
     "edges of a one-sided surface, like a Moebius band, were cut open."},
    {MendKind::kCrowdedEdge, "crowded_edges",
     "edge had three or more faces; the straightest pairs stay joined, the rest ends there.",
     "edges had three or more faces; the straightest pairs stay joined, the rest ends there."},
    {MendKind::kSplitVertex, "split_vertices",
     "vertex was added where parts of the surface met in a single point or edge.",
     "vertices were added where parts of the surface met in a single point or edge."},
    {MendKind::kLooseVertex, "isolated_vertices",
     "vertex is in no face; it is kept aside and written back.",
     "vertices are in no face; they are kept aside and written back."},
    {MendKind::kBrokenVertex, "broken_vertices",
     "vertex is in no face and has coordinates that are no usable numbers; it was left out.",
     "vertices are in no face and have coordinates that are no usable numbers; they were left "
     "out."},
    {MendKind::kLostCrease, "lost_creases",
     "crease tag was left out: it names no edge of the mesh.",
     "crease tags were left out: they name no edge of the mesh."},
    {MendKind::kLostCorner, "lost_corners",
     "corner tag was left out: it names no vertex of the mesh.",
     "corner tags were left out: they name no vertex of the mesh."},
    {MendKind::kNegativeSharpness, "negative_sharpness", "sharpness was negative and became 0.",
     "values of sharpness were negative and became 0."},
    {MendKind::kFilledUv, "filled_uvs",
     "corner without texture coordinates was given the point 0 0.",
     "corners without texture coordinates were given one point, 0 0."},
    {MendKind::kBrokenUv, "broken_uvs", "texture coordinate was no usable number and became 0.",
     "texture coordinates were no usable numbers and became 0."},
    {MendKind::kCappedDepth, "capped_depths",
     "painted depth was beyond the greatest there is and became that.",
     "painted depths were beyond the greatest there is and became that."},
}};

const KindText& text_of(MendKind kind) {
  const KindText& text = Texts[static_cast<std::size_t>(kind)];
  LIMN_EXPECTS(text.kind == kind);
  return text;
}

/// The mend of a kind, made where it belongs if there is none.
Mend& mend_of(std::vector<Mend>& mends, MendKind kind) {
  const auto at = std::ranges::lower_bound(mends, kind, {}, &Mend::kind);
  if (at != mends.end() && at->kind == kind) {
    return *at;
  }
  return *mends.insert(at, Mend{kind, 0, {}});
}

}  // namespace

std::string_view name_of(MendKind kind) noexcept {
  return text_of(kind).name;
}

std::size_t ImportReport::count(MendKind kind) const noexcept {
  const auto found = std::ranges::find(mends, kind, &Mend::kind);
  return found == mends.end() ? 0 : found->count;
}

void ImportReport::add(MendKind kind, std::size_t count) {
  if (count > 0) {
    mend_of(mends, kind).count += count;
  }
}

void ImportReport::add(MendKind kind, const MendedElement& element) {
  Mend& mend = mend_of(mends, kind);
  ++mend.count;
  if (mend.elements.size() < Mend::kMostElements) {
    mend.elements.push_back(element);
  }
}

std::vector<std::string> ImportReport::sentences() const {
  std::vector<std::string> result;
  for (const Mend& mend : mends) {
    result.push_back(sentence_of(mend.kind, mend.count));
  }
  for (const std::string& data : unused_data) {
    result.push_back(fmt::format("Not used: {}.", data));
  }
  return result;
}

std::string sentence_of(MendKind kind, std::size_t count) {
  return detail::counted(count, text_of(kind).one, text_of(kind).many);
}

std::string place_of(const ImportReport& report, const Mend& mend, const MendedElement& element) {
  if (report.has_places) {
    return fmt::format("{} {}", report.place_unit == PlaceUnit::kLine ? "line" : "byte",
                       element.place);
  }
  const bool is_vertex = mend.kind == MendKind::kSplitVertex ||
                         mend.kind == MendKind::kLooseVertex ||
                         mend.kind == MendKind::kBrokenVertex;
  return fmt::format("{} {}", is_vertex ? "vertex" : "face", element.place);
}

}  // namespace limn
