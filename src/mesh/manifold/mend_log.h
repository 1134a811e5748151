#pragma once

#include <cstdint>
#include <span>

#include "limn/mesh/polygon_soup.h"

namespace limn::detail {

/// Collects what is mended in the soup's numbers, since the mesh has none yet.
class MendLog {
 public:
  explicit MendLog(const PolygonSoup& soup);

  void add_face(MendKind kind, std::uint32_t face);
  void add_vertex(MendKind kind, std::uint32_t vertex);
  /// One in no face: kLooseVertex, or kBrokenVertex where it lies nowhere.
  void add_loose_vertex(std::uint32_t vertex);
  /// `face` is one at the edge.
  void add_edge(MendKind kind, std::uint32_t face, std::uint32_t from, std::uint32_t to);
  /// For attributes, which are not told one by one.
  [[nodiscard]] ImportReport& report() noexcept { return report_; }

  /// The report in the mesh's numbers: `face_sources` and `vertex_sources` have the soup's number
  /// of every face and vertex; of several copies of a vertex the first counts.
  [[nodiscard]] ImportReport finish(std::span<const std::uint32_t> face_sources,
                                    std::span<const std::uint32_t> vertex_sources);

 private:
  [[nodiscard]] std::size_t face_place(std::uint32_t face) const;
  [[nodiscard]] std::size_t vertex_place(std::uint32_t vertex) const;

  const PolygonSoup& soup_;
  ImportReport report_;
};

}  // namespace limn::detail
