#pragma once

#include <string>
#include <string_view>

#include "limn/mesh/polygon_soup.h"

namespace limn::generator {

/// A soup as OBJ text: a comment that names it, positions with six decimals, faces.
[[nodiscard]] std::string obj_text(const PolygonSoup& soup, std::string_view what);

}  // namespace limn::generator
