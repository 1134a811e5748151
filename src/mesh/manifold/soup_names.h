#pragma once

#include <cstddef>
#include <string>

#include "limn/error.h"
#include "limn/mesh/polygon_soup.h"

namespace limn::detail {

/// Speaks of a soup's elements by their places in the file, or else by number from 0.
class SoupNames {
 public:
  explicit SoupNames(const PolygonSoup& soup) : soup_(soup) {}

  [[nodiscard]] std::string vertex(std::size_t v) const;
  /// An error, kBadInput. `message` goes on from the name of the vertex.
  [[nodiscard]] tl::unexpected<Error> blame_vertex(std::size_t v, const std::string& message) const;
  /// The same for a face.
  [[nodiscard]] tl::unexpected<Error> blame_face(std::size_t f, const std::string& message) const;

 private:
  const PolygonSoup& soup_;
};

/// An error of a file at a place of the unit.
[[nodiscard]] Error error_at(PlaceUnit unit, std::size_t place, std::string message,
                             std::string source);

}  // namespace limn::detail
