#include "render/surface/markers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "limn/contract.h"

namespace limn::render {
namespace {

/// As shaders/markers.vert.glsl reads it.
struct MarkerRecord {
  glm::vec3 position;
  std::uint32_t number_and_style;
};
static_assert(sizeof(MarkerRecord) == 16);

constexpr int kMostShown = 99;

/// A candidate with what it is weighed by.
Marker pill_of(const LegalisationCandidate& candidate, LegalisationMethod order,
               const glm::dvec3& position) {
  Marker marker{glm::vec3(position), MarkerStyle::kCandidate};
  if (order == LegalisationMethod::kGreedy) {
    const auto shown = [](std::uint32_t value) {
      return static_cast<std::uint8_t>(std::min<std::uint32_t>(value, kMostShown));
    };
    marker.number = shown(candidate.valence);
    marker.second = shown(candidate.cost);
    return marker;
  }
  const int tenths = std::min(std::abs(static_cast<int>(std::lround(10.0F * candidate.score))),
                              10 * kMostShown + 9);
  marker.number = static_cast<std::uint8_t>(tenths / 10);
  marker.second = static_cast<std::uint8_t>(tenths % 10);
  marker.text = candidate.score < 0.0F ? MarkerText::kNegative : MarkerText::kDecimal;
  return marker;
}

template <class PositionOf>
std::vector<Marker> markers_at(std::span<const IrregularVertex> vertices,
                               PositionOf&& position_of) {
  std::vector<Marker> markers;
  markers.reserve(vertices.size());
  for (const IrregularVertex& vertex : vertices) {
    const auto style = static_cast<std::uint8_t>(MarkerStyle::kValence);
    markers.push_back({glm::vec3(position_of(vertex.vertex)),
                       static_cast<MarkerStyle>(style + vertex.band),
                       std::min<std::uint8_t>(vertex.valence, kMostShown)});
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

std::vector<Marker> step_markers(const ControlMesh& mesh, const VertexLabels& labels,
                                 const StepMarkers& step) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  const glm::dvec3 origin = mesh.bounds().centre();
  const auto place = [&](std::uint32_t v) { return mesh.positions()[v] - origin; };
  enum class Kind : std::uint8_t { kOther, kIllegal, kRaised, kFalling, kPill };
  std::vector<Kind> kinds(labels.size(), Kind::kOther);
  const auto mark = [&kinds](std::span<const std::uint32_t> vertices, Kind kind) {
    for (const std::uint32_t v : vertices) {
      kinds[v] = kind;
    }
  };
  mark(step.illegal, Kind::kIllegal);
  mark(step.raised, Kind::kRaised);
  mark(step.falling, Kind::kFalling);
  for (const LegalisationCandidate& candidate : step.candidates) {
    kinds[candidate.vertex] = Kind::kPill;
  }
  std::vector<Marker> markers;
  for (std::uint32_t v = 0; v < kinds.size(); ++v) {
    const auto add = [&](MarkerStyle style, std::uint8_t number) {
      markers.push_back({glm::vec3(place(v)), style, number});
    };
    if (kinds[v] == Kind::kIllegal) {
      add(MarkerStyle::kIllegal, 0);
    } else if (kinds[v] == Kind::kRaised) {
      add(MarkerStyle::kRelabelled, labels[v]);
    } else if (kinds[v] == Kind::kFalling) {
      // What it will be, in the pill of the one that is picked.
      markers.push_back({glm::vec3(place(v)), MarkerStyle::kPicked, 1, 0, MarkerText::kBecomes});
    } else if (kinds[v] == Kind::kOther && step.shows_labels) {
      add(MarkerStyle::kLabel, labels[v]);
    }
  }
  // The best are drawn last, over the others.
  for (std::size_t i = step.candidates.size(); i-- > 0;) {
    markers.push_back(pill_of(step.candidates[i], step.order, place(step.candidates[i].vertex)));
  }
  if (!step.candidates.empty()) {
    markers.back().style = MarkerStyle::kPicked;
  }
  return markers;
}

MarkerBuffers::MarkerBuffers()
    : no_attributes_(gl::VertexArray::create("markers")), records_(gl::Buffer::create("markers")) {}

void MarkerBuffers::upload(std::span<const Marker> markers, std::uint64_t revision) {
  LIMN_EXPECTS(revision != 0);
  std::vector<MarkerRecord> records;
  records.reserve(markers.size());
  for (const Marker& marker : markers) {
    LIMN_EXPECTS(marker.number <= kMostShown && marker.second <= kMostShown);
    records.push_back({marker.position, static_cast<std::uint32_t>(marker.number) |
                                            static_cast<std::uint32_t>(marker.style) << 8U |
                                            static_cast<std::uint32_t>(marker.second) << 16U |
                                            static_cast<std::uint32_t>(marker.text) << 24U});
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
