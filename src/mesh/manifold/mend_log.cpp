#include "mesh/manifold/mend_log.h"

#include <utility>
#include <vector>

#include "mesh/manifold/positions.h"

namespace limn::detail {
namespace {

/// The middle of the corners that there are; of a face without, the origin.
glm::dvec3 middle_of(const PolygonSoup& soup, std::uint32_t face) {
  glm::dvec3 sum(0.0);
  double count = 0.0;
  for (const std::uint32_t v : soup.face(face)) {
    count += 1.0;
    sum += (soup.positions[v] - sum) / count;
  }
  return sum;
}

std::vector<std::uint32_t> first_numbers(std::span<const std::uint32_t> sources,
                                         std::size_t source_count) {
  std::vector<std::uint32_t> numbers(source_count, kNone);
  for (std::size_t i = sources.size(); i-- > 0;) {
    numbers[sources[i]] = static_cast<std::uint32_t>(i);
  }
  return numbers;
}

}  // namespace

MendLog::MendLog(const PolygonSoup& soup) : soup_(soup) {
  report_.has_places = !soup.face_places.empty();
  report_.place_unit = soup.place_unit;
}

std::size_t MendLog::face_place(std::uint32_t face) const {
  return soup_.face_places.empty() ? face : soup_.face_places[face];
}

std::size_t MendLog::vertex_place(std::uint32_t vertex) const {
  return soup_.vertex_places.empty() ? vertex : soup_.vertex_places[vertex];
}

void MendLog::add_face(MendKind kind, std::uint32_t face) {
  report_.add(kind, {face, {kNone, kNone}, face_place(face), middle_of(soup_, face)});
}

void MendLog::add_vertex(MendKind kind, std::uint32_t vertex) {
  report_.add(kind, {kNone, {vertex, kNone}, vertex_place(vertex), soup_.positions[vertex]});
}

void MendLog::add_loose_vertex(std::uint32_t vertex) {
  if (is_usable(soup_.positions[vertex])) {
    add_vertex(MendKind::kLooseVertex, vertex);
  } else {
    report_.add(MendKind::kBrokenVertex,
                {kNone, {vertex, kNone}, vertex_place(vertex), glm::dvec3(0.0)});
  }
}

void MendLog::add_edge(MendKind kind, std::uint32_t face, std::uint32_t from, std::uint32_t to) {
  const glm::dvec3& start = soup_.positions[from];
  report_.add(kind,
              {face, {from, to}, face_place(face), start + 0.5 * (soup_.positions[to] - start)});
}

ImportReport MendLog::finish(std::span<const std::uint32_t> face_sources,
                             std::span<const std::uint32_t> vertex_sources) {
  if (report_.is_mended()) {
    const auto faces = first_numbers(face_sources, soup_.face_count());
    const auto vertices = first_numbers(vertex_sources, soup_.positions.size());
    for (Mend& mend : report_.mends) {
      for (MendedElement& element : mend.elements) {
        element.face = element.face == kNone ? kNone : faces[element.face];
        for (std::uint32_t& v : element.vertices) {
          v = v == kNone ? kNone : vertices[v];
        }
      }
    }
  }
  return std::move(report_);
}

}  // namespace limn::detail
