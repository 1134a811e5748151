// Greatest and least go over the vertices: what a face takes from its neighbours is what its
// vertices have gathered from their faces. A mean must count each neighbour once, however many
// vertices it shares, so there the faces around are walked with a mark on those already met.
#include "limn/painting/depth_filter.h"

#include <algorithm>
#include <vector>

#include "limn/contract.h"

namespace limn {
namespace {

/// `choose` is std::max or std::min.
template <class Choose>
FaceDepths gather(const ControlMesh& mesh, const FaceDepths& depths, int start, Choose&& choose) {
  const FlatTopology& topology = mesh.topology();
  std::vector<int> at_vertex(mesh.vertex_count(), start);
  for (std::size_t c = 0; c < topology.corner_vertices.size(); ++c) {
    int& value = at_vertex[topology.corner_vertices[c]];
    value = choose(value, depths[topology.corner_faces[c]]);
  }
  FaceDepths result(depths.size());
  for (std::size_t f = 0; f < depths.size(); ++f) {
    int value = start;
    for (const std::uint32_t vertex : mesh.face(f)) {
      value = choose(value, at_vertex[vertex]);
    }
    result.set(f, value);
  }
  return result;
}

FaceDepths invert(const FaceDepths& depths) {
  FaceDepths result(depths.size());
  const int deepest = depths.deepest();
  for (std::size_t f = 0; f < depths.size(); ++f) {
    result.set(f, deepest - depths[f]);
  }
  return result;
}

/// sum / count to the nearest whole number, a half towards `own`.
int rounded_mean(int sum, int count, int own) {
  LIMN_EXPECTS(count > 0);
  const int twice = 2 * sum;
  // `low` is the lower of the two numbers that the mean lies between.
  const int low = sum / count;
  const int middle = (2 * low + 1) * count;
  if (twice == middle) {
    return own > low ? low + 1 : low;
  }
  return twice > middle ? low + 1 : low;
}

FaceDepths smooth(const ControlMesh& mesh, const FaceDepths& depths) {
  const FlatTopology& topology = mesh.topology();
  FaceDepths result(depths.size());
  std::vector<std::uint32_t> met_by(depths.size(), kNone);
  for (std::uint32_t f = 0; f < depths.size(); ++f) {
    int sum = 0;
    int count = 0;
    for (const std::uint32_t vertex : mesh.face(f)) {
      for (std::uint32_t i = topology.vertex_offsets[vertex];
           i < topology.vertex_offsets[vertex + 1]; ++i) {
        const std::uint32_t face = topology.corner_faces[topology.vertex_corners[i]];
        if (met_by[face] != f) {
          met_by[face] = f;
          sum += depths[face];
          ++count;
        }
      }
    }
    result.set(f, rounded_mean(sum, count, depths[f]));
  }
  return result;
}

}  // namespace

FaceDepths filter_depths(const ControlMesh& mesh, const FaceDepths& depths, DepthFilter filter) {
  LIMN_EXPECTS(depths.size() == mesh.face_count());
  switch (filter) {
    case DepthFilter::kGrow:
      return gather(mesh, depths, 0, [](int a, int b) { return std::max(a, b); });
    case DepthFilter::kShrink:
      return gather(mesh, depths, kMaxDepth, [](int a, int b) { return std::min(a, b); });
    case DepthFilter::kInvert:
      return invert(depths);
    case DepthFilter::kSmooth:
      return smooth(mesh, depths);
    case DepthFilter::kClear:
      break;
  }
  return FaceDepths(depths.size());
}

}  // namespace limn
