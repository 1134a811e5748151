#include "render/surface/markers.h"

#include <algorithm>

#include "limn/contract.h"

namespace limn::render {
namespace {

/// As shaders/markers.vert.glsl reads it.
struct MarkerRecord {
  glm::vec3 position;
  std::uint32_t number_and_style;
};
static_assert(sizeof(MarkerRecord) == 16);

template <class PositionOf>
std::vector<Marker> markers_at(std::span<const IrregularVertex> vertices,
                               PositionOf&& position_of) {
  constexpr std::uint8_t kMostShown = 99;
  std::vector<Marker> markers;
  markers.reserve(vertices.size());
  for (const IrregularVertex& vertex : vertices) {
    const auto style = static_cast<std::uint8_t>(MarkerStyle::kValence);
    markers.push_back({glm::vec3(position_of(vertex.vertex)),
                       static_cast<MarkerStyle>(style + vertex.band),
                       std::min(vertex.valence, kMostShown)});
  }
  return markers;
}

}  // namespace

std::vector<Marker> label_markers(const ControlMesh& mesh, const VertexLabels& labels,
                                  std::span<const std::uint32_t> illegal,
                                  std::span<const std::uint32_t> raised) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  const glm::dvec3 origin = mesh.bounds().centre();
  std::vector<Marker> markers;
  markers.reserve(labels.size());
  for (std::size_t v = 0; v < labels.size(); ++v) {
    markers.push_back({glm::vec3(mesh.positions()[v] - origin), MarkerStyle::kLabel, labels[v]});
  }
  for (const std::uint32_t vertex : raised) {
    markers[vertex].style = MarkerStyle::kRelabelled;
  }
  for (const std::uint32_t vertex : illegal) {
    markers[vertex].style = MarkerStyle::kIllegal;
  }
  return markers;
}

std::vector<Marker> depth_markers(const ControlMesh& mesh, std::span<const std::uint8_t> depths) {
  LIMN_EXPECTS(depths.size() == mesh.face_count());
  const glm::dvec3 origin = mesh.bounds().centre();
  std::vector<Marker> markers;
  for (std::size_t f = 0; f < depths.size(); ++f) {
    if (depths[f] == 0) {
      continue;
    }
    glm::dvec3 sum(0.0);
    const std::span<const std::uint32_t> face = mesh.face(f);
    for (const std::uint32_t vertex : face) {
      sum += mesh.positions()[vertex] - origin;
    }
    markers.push_back(
        {glm::vec3(sum / static_cast<double>(face.size())), MarkerStyle::kFaceNumber, depths[f]});
  }
  return markers;
}

std::vector<Marker> valence_markers(const ControlMesh& mesh,
                                    std::span<const IrregularVertex> vertices,
                                    const glm::dvec3& origin) {
  return markers_at(vertices, [&](std::uint32_t v) { return mesh.positions()[v] - origin; });
}

std::vector<Marker> valence_markers(const RefinedMesh& mesh,
                                    std::span<const IrregularVertex> vertices,
                                    const glm::dvec3& origin) {
  return markers_at(vertices, [&](std::uint32_t v) { return mesh.position(v) - origin; });
}

MarkerBuffers::MarkerBuffers()
    : no_attributes_(gl::VertexArray::create("markers")), records_(gl::Buffer::create("markers")) {}

void MarkerBuffers::upload(std::span<const Marker> markers, std::uint64_t revision) {
  LIMN_EXPECTS(revision != 0);
  std::vector<MarkerRecord> records;
  records.reserve(markers.size());
  for (const Marker& marker : markers) {
    LIMN_EXPECTS(marker.number < 100);
    records.push_back({marker.position, static_cast<std::uint32_t>(marker.number) |
                                            static_cast<std::uint32_t>(marker.style) << 8U});
  }
  records_.upload(records);
  count_ = records.size();
  revision_ = revision;
}

void MarkerBuffers::draw() const {
  if (count_ == 0) {
    return;
  }
  records_.bind_storage(8);
  no_attributes_.bind();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count_ * 6));
}

}  // namespace limn::render
