#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/build.h"
#include "limn/mesh/mesh_format.h"
#include "limn/mesh/polygon_soup.h"

namespace limn {

/// Reads a mesh file and builds its control mesh. The format is told by the content, and by the
/// name's ending where the content leaves it open. Regular files of up to 4 GiB are read, links are
/// followed, and nothing but the file itself is opened.
///
/// OBJ: `v` and `f` in all their forms, polygons of any size, negative indices, `\` continuations,
/// weights and colours, any line ends; `vt`, `o`, `g`, `usemtl` and `mtllib`; the tags of Pixar's
/// OpenSubdiv, whose vertices count from 0, and one of Limn's:
///   t crease N/S/0 v1 .. vN s1 .. sS   a chain of N - 1 edges with one sharpness (S = 1) or one
///                                      each (S = N - 1), or N/2 separate edges with one each
///   t corner N/S/0 v1 .. vN s1 .. sS   N vertices with one sharpness or one each
///   t interpolateboundary 1/0/0 k      1: corners of the boundary are sharp, 2: they are not
///   t creasemethod 0/0/1 chaikin       or normal
///   t limn_depth 1/0/0 d               depth d is painted on the faces that follow
/// Where no tag says so, faces with a material `depth_3` are painted 3.
/// PLY: ascii and binary, properties of any type in any order; texture coordinates of vertices (u,
/// v or s, t or texture_u, texture_v) or corners (`texcoord`), triangle strips, `limn_depth` of
/// faces, `limn_sharpness` of vertices and of edges (vertex1, vertex2).
/// OFF: with ST, C, N and 4 before it, as text or binary. STL: as text or binary; vertices with
/// equal coordinates are welded.
///
/// Numbers are read to the last bit, whatever the locale. Everything else that a file holds is
/// counted in ImportReport::unused_data. For what is mended and what is refused see mesh/build.h.
/// Errors: kBadInput with path and, where one is to blame, the 1-based line or the byte.
[[nodiscard]] Result<ImportedMesh> import_mesh(const std::filesystem::path& path,
                                               const BuildSettings& settings = {});

/// The same for a file's bytes that are already in memory. `expected` is what the name says or the
/// person means, `source` is used in messages only.
[[nodiscard]] Result<ImportedMesh> import_bytes(std::string bytes,
                                                std::optional<MeshFormat> expected,
                                                const std::string& source,
                                                const BuildSettings& settings = {});

/// The same for text that is known to be OBJ.
[[nodiscard]] Result<ImportedMesh> import_obj(std::string_view text, const std::string& source,
                                              const BuildSettings& settings = {});

/// What a file's bytes say, before it is a mesh. Errors: kBadInput where they are malformed.
[[nodiscard]] Result<PolygonSoup> read_soup(std::string_view bytes,
                                            std::optional<MeshFormat> expected,
                                            const std::string& source);

}  // namespace limn
