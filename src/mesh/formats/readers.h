#pragma once

#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/polygon_soup.h"

// From the bytes of a mesh file to what it says. Pure functions: nothing is opened, and what is
// read is not interpreted further than the format goes. Everything a file holds is in the soup or
// counted in its `unused_data`. Errors, kBadInput: `source` and the line, or in binary data the
// byte. Time and memory are linear in the number of bytes: announced counts are held against the
// bytes that are left before anything is allocated for them.
namespace limn::detail {

/// Wavefront OBJ; for the statements and tags see mesh/import.h.
[[nodiscard]] Result<PolygonSoup> read_obj(std::string_view bytes, const std::string& source);

/// PLY 1.0, ascii and binary in both byte orders, with properties of any type. Used are `vertex`
/// (x, y, z; u, v or s, t or texture_u, texture_v), `face` (vertex_indices or vertex_index,
/// texcoord, limn_depth), `tristrips` and `edge` (vertex1, vertex2, limn_sharpness).
[[nodiscard]] Result<PolygonSoup> read_ply(std::string_view bytes, const std::string& source);

/// Geomview's OFF with the letters ST, C, N and 4 before it, as text, and as binary data in its own
/// byte order or, as some libraries write it, the other.
[[nodiscard]] Result<PolygonSoup> read_off(std::string_view bytes, const std::string& source);

/// STL as text or binary data. Corners whose coordinates are the same bits, 0 and -0 being one, are
/// welded to a vertex. The solids of a text are its objects.
[[nodiscard]] Result<PolygonSoup> read_stl(std::string_view bytes, const std::string& source);

/// Whether the bytes are as many as a binary STL says it has.
[[nodiscard]] bool is_binary_stl(std::string_view bytes) noexcept;

}  // namespace limn::detail
