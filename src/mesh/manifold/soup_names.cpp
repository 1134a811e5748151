#include "mesh/manifold/soup_names.h"

#include <utility>

#include <fmt/format.h>

namespace limn::detail {

std::string SoupNames::vertex(std::size_t v) const {
  if (soup_.vertex_places.empty()) {
    return fmt::format("vertex {}", v);
  }
  return fmt::format("the vertex of {} {}", soup_.place_unit == PlaceUnit::kLine ? "line" : "byte",
                     soup_.vertex_places[v]);
}

tl::unexpected<Error> SoupNames::blame_vertex(std::size_t v, const std::string& message) const {
  return soup_.vertex_places.empty()
             ? fail(ErrorKind::kBadInput, fmt::format("Vertex {} {}", v, message), soup_.source)
             : tl::unexpected<Error>(error_at(soup_.place_unit, soup_.vertex_places[v],
                                              "This vertex " + message, soup_.source));
}

tl::unexpected<Error> SoupNames::blame_face(std::size_t f, const std::string& message) const {
  return soup_.face_places.empty()
             ? fail(ErrorKind::kBadInput, fmt::format("Face {} {}", f, message), soup_.source)
             : tl::unexpected<Error>(error_at(soup_.place_unit, soup_.face_places[f],
                                              "This face " + message, soup_.source));
}

Error error_at(PlaceUnit unit, std::size_t place, std::string message, std::string source) {
  Error error{ErrorKind::kBadInput, std::move(message), std::move(source), 0};
  if (unit == PlaceUnit::kLine) {
    error.line = place;
  } else {
    error.byte = place;
  }
  return error;
}

}  // namespace limn::detail
