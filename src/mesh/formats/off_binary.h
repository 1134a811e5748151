#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/polygon_soup.h"
#include "mesh/formats/off_header.h"

namespace limn::detail {

/// Reads what follows the header line of a binary OFF, from byte `begin` of the file on.
[[nodiscard]] Result<PolygonSoup> read_off_binary(std::string_view bytes, std::size_t begin,
                                                  const OffVertex& vertex,
                                                  const std::string& source);

}  // namespace limn::detail
