// The bytes of a file are let go before the mesh is built of what they say.
#include "limn/mesh/import.h"

#include <new>
#include <utility>

#include <fmt/format.h>

#include "files/regular_file.h"
#include "mesh/counted.h"
#include "mesh/formats/encoding.h"
#include "mesh/formats/import_limits.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/tell_format.h"

namespace limn {
namespace {

Error not_enough_memory(const std::string& source) {
  return {ErrorKind::kFailed, "There is not enough memory to read this mesh.", source};
}

Result<PolygonSoup> read_as(MeshFormat format, std::string_view bytes, const std::string& source) {
  switch (format) {
    case MeshFormat::kObj:
      return detail::read_obj(bytes, source);
    case MeshFormat::kPly:
      return detail::read_ply(bytes, source);
    case MeshFormat::kOff:
      return detail::read_off(bytes, source);
    case MeshFormat::kStl:
      return detail::read_stl(bytes, source);
  }
  return fail(ErrorKind::kFailed, "This format is not read.", source);
}

std::string no_faces(const PolygonSoup& soup) {
  std::string message =
      soup.positions.empty()
          ? std::string("There are neither vertices nor faces; is this a mesh?")
          : fmt::format("There are {} but no faces to paint on.",
                        detail::counted(soup.positions.size(), "vertex", "vertices"));
  std::vector<std::string> others = soup.unused_data;
  if (!soup.uvs.empty()) {
    others.push_back(detail::counted(soup.uvs.size(), "texture coordinate"));
  }
  for (std::size_t i = 0; i < others.size(); ++i) {
    message += fmt::format("{} {}", i == 0 ? " What there is:" : ",", others[i]);
  }
  return others.empty() ? message : message + '.';
}

Result<ImportedMesh> build(const Result<PolygonSoup>& soup, const BuildSettings& settings) {
  if (!soup) {
    return tl::unexpected<Error>(soup.error());
  }
  if (soup->face_count() == 0) {
    return fail(ErrorKind::kBadInput, no_faces(*soup), soup->source);
  }
  return build_control_mesh(*soup, settings);
}

}  // namespace

Result<PolygonSoup> read_soup(std::string_view bytes, std::optional<MeshFormat> expected,
                              const std::string& source) {
  try {
    if (bytes.size() > detail::most_import_bytes) {
      return fail(ErrorKind::kBadInput, too_large(bytes.size(), detail::most_import_bytes), source);
    }
    const std::optional<std::string> text = detail::utf8_of_utf16(bytes);
    bytes = text ? std::string_view(*text) : bytes;
    return detail::tell_format(bytes, expected, source).and_then([&](MeshFormat format) {
      return read_as(format, bytes, source);
    });
  } catch (const std::bad_alloc&) {
    return tl::unexpected<Error>(not_enough_memory(source));
  }
}

Result<ImportedMesh> import_bytes(std::string bytes, std::optional<MeshFormat> expected,
                                  const std::string& source, const BuildSettings& settings) {
  try {
    const Result<PolygonSoup> soup = read_soup(bytes, expected, source);
    bytes = {};
    return build(soup, settings);
  } catch (const std::bad_alloc&) {
    return tl::unexpected<Error>(not_enough_memory(source));
  }
}

Result<ImportedMesh> import_mesh(const std::filesystem::path& path, const BuildSettings& settings) {
  try {
    return read_regular_file(path, detail::most_import_bytes).and_then([&](std::string bytes) {
      return import_bytes(std::move(bytes), format_by_ending(path), path.string(), settings);
    });
  } catch (const std::bad_alloc&) {
    return tl::unexpected<Error>(not_enough_memory(path.string()));
  }
}

Result<ImportedMesh> import_obj(std::string_view text, const std::string& source,
                                const BuildSettings& settings) {
  try {
    if (text.size() > detail::most_import_bytes) {
      return fail(ErrorKind::kBadInput, too_large(text.size(), detail::most_import_bytes), source);
    }
    return build(detail::read_obj(text, source), settings);
  } catch (const std::bad_alloc&) {
    return tl::unexpected<Error>(not_enough_memory(source));
  }
}

}  // namespace limn
