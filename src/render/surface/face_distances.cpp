// Drawn faces are sorted by their number of sides (render/surface/surface.h): so are the bytes.
#include "render/surface/face_distances.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "limn/contract.h"

namespace limn::render {

FaceDistances::FaceDistances() : bytes_(gl::Buffer::create("face distances")) {}

void FaceDistances::upload(const RefinedMesh& mesh, std::span<const float> of_faces,
                           double greatest) {
  LIMN_EXPECTS(of_faces.size() == mesh.face_count());
  upload_sorted([&](std::size_t f) { return mesh.face(f).size(); }, of_faces, greatest);
}

void FaceDistances::upload(const ControlMesh& mesh, std::span<const float> of_faces,
                           double greatest) {
  LIMN_EXPECTS(of_faces.size() == mesh.face_count());
  upload_sorted([&](std::size_t f) { return mesh.face(f).size(); }, of_faces, greatest);
}

template <class SidesOf>
void FaceDistances::upload_sorted(const SidesOf& sides_of, std::span<const float> of_faces,
                                  double greatest) {
  count_ = of_faces.size();
  std::vector<std::size_t> next;  // By the number of sides.
  for (std::size_t f = 0; f < count_; ++f) {
    const std::size_t sides = sides_of(f);
    next.resize(std::max(next.size(), sides + 2), 0);
    ++next[sides + 1];
  }
  for (std::size_t sides = 1; sides < next.size(); ++sides) {
    next[sides] += next[sides - 1];
  }
  std::vector<std::uint8_t> bytes((count_ / 4 + 1) * 4, 0);
  const double scale = greatest > 0.0 ? 255.0 / greatest : 0.0;
  for (std::size_t f = 0; f < count_; ++f) {
    const double value = std::clamp(scale * static_cast<double>(of_faces[f]), 0.0, 255.0);
    bytes[next[sides_of(f)]++] = static_cast<std::uint8_t>(std::lround(value));
  }
  bytes_.upload(bytes);
}

}  // namespace limn::render
