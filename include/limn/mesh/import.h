#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/build.h"

namespace limn {

/// Reads a mesh file and builds its control mesh; the format is told by the file's ending (OBJ, in
/// either case). Regular files of up to 4 GiB are read, links are followed, and nothing but the
/// file itself is opened.
///
/// Errors: kBadInput with path and, where one is to blame, the 1-based line.
[[nodiscard]] Result<ImportedMesh> import_mesh(const std::filesystem::path& path);

/// The same for OBJ text that is already in memory (standard input, a bundled mesh).
/// `source` is used in messages only.
///
/// Reads `v` and `f` in all their forms: polygons of any size, negative indices, `\` continuations,
/// weights and colours, any line ends. Reads `vt`, and the tags of Pixar's OpenSubdiv, whose
/// vertices count from 0:
///   t crease N/S/0 v1 .. vN s1 .. sS   a chain of N - 1 edges with one sharpness (S = 1) or one
///                                      each (S = N - 1), or N/2 separate edges with one each
///   t corner N/S/0 v1 .. vN s1 .. sS   N vertices with one sharpness or one each
///   t interpolateboundary 1/0/0 k      1: corners of the boundary are sharp, 2: they are not
///   t creasemethod 0/0/1 chaikin       or normal
/// Coordinates are read to the last bit, whatever the locale. A malformed number or index is an
/// error; every other statement is counted in ImportReport::unused_data.
[[nodiscard]] Result<ImportedMesh> import_obj(std::string_view text, const std::string& source);

}  // namespace limn
