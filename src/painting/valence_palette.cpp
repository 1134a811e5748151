// Whether a vertex lies on the boundary shows without any table of edges: around an inner vertex
// every neighbour follows it in one face and precedes it in another, so that the numbers of those
// that follow and of those that precede add up to the same. At a boundary the sums differ by the
// first neighbour and the last.
#include "limn/painting/valence_palette.h"

#include <algorithm>
#include <span>

namespace limn {
namespace {

template <class Mesh>
std::vector<IrregularVertex> find_irregular(const Mesh& mesh) {
  std::vector<std::uint32_t> faces_around(mesh.vertex_count(), 0);
  std::vector<std::uint64_t> imbalance(mesh.vertex_count(), 0);
  bool is_all_triangles = true;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::span<const std::uint32_t> face = mesh.face(f);
    is_all_triangles &= face.size() == 3;
    std::uint32_t before = face.back();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t next = face[i + 1 == face.size() ? 0 : i + 1];
      ++faces_around[face[i]];
      imbalance[face[i]] += std::uint64_t{next} - std::uint64_t{before};
      before = face[i];
    }
  }
  std::vector<IrregularVertex> found;
  for (std::uint32_t v = 0; v < faces_around.size(); ++v) {
    const bool is_boundary = imbalance[v] != 0;
    const std::int64_t valence = std::int64_t{faces_around[v]} + (is_boundary ? 1 : 0);
    const std::int64_t regular = is_all_triangles ? (is_boundary ? 4 : 6) : (is_boundary ? 3 : 4);
    const std::int64_t off = valence - regular;
    if (off != 0 && faces_around[v] > 0) {
      const int band = off < -1 ? 0 : off == -1 ? 1 : off == 1 ? 2 : 3;
      found.push_back({v, static_cast<std::uint8_t>(std::min<std::int64_t>(valence, 255)),
                       static_cast<std::uint8_t>(band)});
    }
  }
  return found;
}

}  // namespace

std::vector<IrregularVertex> irregular_vertices(const ControlMesh& mesh) {
  return find_irregular(mesh);
}

std::vector<IrregularVertex> irregular_vertices(const RefinedMesh& mesh) {
  return find_irregular(mesh);
}

ValenceCounts count_valences(const std::vector<IrregularVertex>& vertices) noexcept {
  ValenceCounts counts{};
  for (const IrregularVertex& vertex : vertices) {
    ++counts[vertex.band];
  }
  return counts;
}

const char* valence_band_name(std::size_t band) noexcept {
  constexpr std::array kNames = {"2 or more too few", "1 too few", "1 too many",
                                 "2 or more too many"};
  return kNames[band];
}

const std::array<Rgb, kValenceBands>& valence_palette() noexcept {
  // ColorBrewer's PuOr without its middle.
  static constexpr std::array<Rgb, kValenceBands> kPalette{
      {{0x54, 0x27, 0x88}, {0x99, 0x8e, 0xc3}, {0xf1, 0xa3, 0x40}, {0xb3, 0x58, 0x06}}};
  return kPalette;
}

}  // namespace limn
