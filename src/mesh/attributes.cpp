// Tags find their edges by bisection among the edges whose lower end some tag names, which are few
// in most meshes.
#include "mesh/attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limn/contract.h"
#include "limn/mesh/control_mesh.h"
#include "mesh/counted.h"

namespace limn::detail {
namespace {

struct NamedEdge {
  std::array<std::uint32_t, 2> ends;  ///< Rising.
  std::uint32_t edge;
};

std::array<std::uint32_t, 2> rising(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The edges whose lower end is flagged, sorted by their ends.
std::vector<NamedEdge> edges_at(const std::vector<std::uint8_t>& is_named, const FaceArrays& faces,
                                const EdgeMatching& edges) {
  std::vector<NamedEdge> result;
  for (std::size_t f = 0; f + 1 < faces.offsets.size(); ++f) {
    std::uint32_t last = faces.offsets[f + 1] - 1;
    for (std::uint32_t c = faces.offsets[f]; c < faces.offsets[f + 1]; last = c++) {
      const std::uint32_t e = edges.corner_edges[last];
      const auto ends = rising(faces.vertices[last], faces.vertices[c]);
      if (is_named[ends[0]] != 0 && edges.edge_corners[e][0] == last) {
        result.push_back({ends, e});
      }
    }
  }
  std::ranges::sort(result, {}, &NamedEdge::ends);
  return result;
}

float checked(float sharpness, ImportReport& report) {
  LIMN_EXPECTS(std::isfinite(sharpness));
  if (sharpness < 0.0f) {
    report.add(MendKind::kNegativeSharpness);
    return 0.0f;
  }
  return sharpness;
}

std::vector<float> without_zeros_alone(std::vector<float> sharpness) {
  const bool is_any = std::ranges::any_of(sharpness, [](float s) { return s > 0.0f; });
  return is_any ? std::move(sharpness) : std::vector<float>{};
}

}  // namespace

std::vector<float> edge_sharpness(std::span<const CreaseTag> tags, const FaceArrays& faces,
                                  const EdgeMatching& edges, ImportReport& report) {
  if (tags.empty()) {
    return {};
  }
  std::vector<std::uint8_t> is_named(faces.vertex_count, 0);
  for (const CreaseTag& tag : tags) {
    const std::uint32_t low = std::min(tag.vertices[0], tag.vertices[1]);
    if (low < is_named.size()) {
      is_named[low] = 1;
    }
  }
  const std::vector<NamedEdge> named = edges_at(is_named, faces, edges);
  std::vector<float> sharpness(edges.edge_corners.size(), 0.0f);
  for (const CreaseTag& tag : tags) {
    const auto ends = rising(tag.vertices[0], tag.vertices[1]);
    // Several edges of the same ends are one edge of the file that was cut.
    const auto first = std::ranges::lower_bound(named, ends, {}, &NamedEdge::ends);
    const auto last = std::ranges::upper_bound(named, ends, {}, &NamedEdge::ends);
    if (first == last) {
      report.add(MendKind::kLostCrease);
      continue;
    }
    const float value = checked(tag.sharpness, report);
    std::for_each(first, last, [&](const NamedEdge& at) { sharpness[at.edge] = value; });
  }
  return without_zeros_alone(std::move(sharpness));
}

std::vector<float> vertex_sharpness(const PolygonSoup& soup,
                                    std::span<const std::uint32_t> vertex_sources,
                                    ImportReport& report) {
  if (soup.corners.empty()) {
    return {};
  }
  std::vector<std::uint8_t> is_there(soup.positions.size(), 0);
  for (const std::uint32_t source : vertex_sources) {
    is_there[source] = 1;
  }
  std::vector<float> of_sources(soup.positions.size(), 0.0f);
  for (const CornerTag& tag : soup.corners) {
    if (tag.vertex >= is_there.size() || is_there[tag.vertex] == 0) {
      report.add(MendKind::kLostCorner);
    } else {
      of_sources[tag.vertex] = checked(tag.sharpness, report);
    }
  }
  std::vector<float> sharpness(vertex_sources.size());
  for (std::size_t v = 0; v < sharpness.size(); ++v) {
    sharpness[v] = of_sources[vertex_sources[v]];
  }
  return without_zeros_alone(std::move(sharpness));
}

TextureCoordinates texture_coordinates(const PolygonSoup& soup,
                                       std::vector<std::uint32_t> corner_uvs,
                                       ImportReport& report) {
  std::vector<std::uint32_t> new_numbers(soup.uvs.size(), kNone);
  std::size_t missing = 0;
  for (const std::uint32_t uv : corner_uvs) {
    if (uv < new_numbers.size()) {
      new_numbers[uv] = 0;
    } else {
      ++missing;
    }
  }
  TextureCoordinates result;
  for (std::size_t uv = 0; uv < new_numbers.size(); ++uv) {
    if (new_numbers[uv] != kNone) {
      new_numbers[uv] = static_cast<std::uint32_t>(result.values.size());
      result.values.push_back(soup.uvs[uv]);
    }
  }
  if (const std::size_t unused = soup.uvs.size() - result.values.size(); unused > 0) {
    report.unused_data.push_back(counted(unused, "texture coordinate"));
  }
  if (result.values.empty()) {
    return {};
  }
  if (missing > 0) {
    report.add(MendKind::kFilledUv, missing);
    result.values.emplace_back(0.0, 0.0);
  }
  const auto filler = static_cast<std::uint32_t>(result.values.size() - 1);
  for (std::uint32_t& uv : corner_uvs) {
    uv = uv < new_numbers.size() ? new_numbers[uv] : filler;
  }
  result.corner_values = std::move(corner_uvs);
  return result;
}

}  // namespace limn::detail
