// tinyobjloader reads checked statements (obj_statements.h) through its callback interface: the one
// that keeps polygons whole, opens no material files and tells what belongs to which statement.
#include <istream>
#include <new>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include <tiny_obj_loader.h>

#include "limn/contract.h"
#include "limn/mesh/import.h"
#include "mesh/counted.h"
#include "mesh/import_limits.h"
#include "mesh/obj_statements.h"
#include "files/regular_file.h"

namespace limn {
namespace {

static_assert(std::is_same_v<tinyobj::real_t, double>);

/// What the callbacks work on.
struct Reading {
  detail::ObjStatements& statements;
  PolygonSoup& soup;
};

void add_vertex(void* user, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t) {
  auto& [statements, soup] = *static_cast<Reading*>(user);
  soup.positions.push_back(statements.position());
  soup.vertex_places.push_back(statements.line());
}

void add_face(void* user, tinyobj::index_t* corners, int count) {
  auto& [statements, soup] = *static_cast<Reading*>(user);
  for (int i = 0; i < count; ++i) {
    const int index = corners[i].vertex_index;
    // Negative indices count back from the last vertex so far.
    soup.face_vertices.push_back(index > 0 ? static_cast<std::uint32_t>(index - 1)
                                           : static_cast<std::uint32_t>(soup.positions.size()) -
                                                 static_cast<std::uint32_t>(-index));
  }
  soup.face_uvs.insert(soup.face_uvs.end(), statements.face_uvs().begin(),
                       statements.face_uvs().end());
  soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_vertices.size()));
  soup.face_places.push_back(statements.line());
}

Result<void> check_encoding(std::string_view text, const std::string& source) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return fail(ErrorKind::kBadInput, "The text is encoded as UTF-16; save it as UTF-8.", source);
  }
  if (text.find('\0') != std::string_view::npos) {
    return fail(ErrorKind::kBadInput, "This is binary data and not the text of an OBJ file.",
                source);
  }
  return {};
}

/// A face may name vertices that come later, so this waits for the end.
Result<void> check_indices(const PolygonSoup& soup) {
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    for (const std::uint32_t v : soup.face(f)) {
      if (v >= soup.positions.size()) {
        return fail(
            ErrorKind::kBadInput,
            fmt::format("A face names vertex {}, but the file has {} {}.", v + 1ULL,
                        soup.positions.size(), soup.positions.size() == 1 ? "vertex" : "vertices"),
            soup.source, soup.face_places[f]);
      }
    }
  }
  return {};
}

std::string no_faces(const PolygonSoup& soup, const std::vector<std::string>& unused) {
  std::string message =
      soup.positions.empty()
          ? std::string(
                "There are neither vertices nor faces; is this an OBJ "
                "file?")
          : fmt::format("There are {} vertices but no faces to paint on.", soup.positions.size());
  if (!unused.empty()) {
    message += " What there is:";
    for (std::size_t i = 0; i < unused.size(); ++i) {
      message += fmt::format("{} {}", i == 0 ? "" : ",", unused[i]);
    }
    message += '.';
  }
  return message;
}

Result<ImportedMesh> read_and_build(std::string_view text, const std::string& source) {
  if (auto encoding = check_encoding(text, source); !encoding) {
    return tl::unexpected<Error>(std::move(encoding.error()));
  }
  detail::UnusedData unused;
  PolygonSoup soup;
  soup.source = source;
  detail::ObjStatements statements(text, soup, unused);
  Reading reading{statements, soup};
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = add_vertex;
  callbacks.index_cb = add_face;
  std::istream in(&statements);
  in.exceptions(std::ios::badbit);  // Else the stream would swallow a failed allocation.
  const bool is_read = tinyobj::LoadObjWithCallback(in, callbacks, &reading);
  if (!statements.error().message.empty()) {
    Error error = statements.error();
    error.path = source;
    return tl::unexpected<Error>(std::move(error));
  }
  LIMN_EXPECTS(is_read);  // It fails on what the statements refuse, and on nothing else.

  std::vector<std::string> phrases = unused.phrases();
  if (soup.face_count() == 0) {
    if (!soup.uvs.empty()) {
      phrases.push_back(detail::counted(soup.uvs.size(), "texture coordinate"));
    }
    return fail(ErrorKind::kBadInput, no_faces(soup, phrases), source);
  }
  if (auto indices = check_indices(soup); !indices) {
    return tl::unexpected<Error>(std::move(indices.error()));
  }
  auto imported = build_control_mesh(soup);
  if (imported) {
    ImportReport& report = imported->report;
    report.add(MendKind::kBrokenUv, statements.broken_uvs());
    report.unused_data.insert(report.unused_data.begin(), phrases.begin(), phrases.end());
  }
  return imported;
}

}  // namespace

Result<ImportedMesh> import_obj(std::string_view text, const std::string& source) {
  if (text.size() > detail::most_import_bytes) {
    return fail(ErrorKind::kBadInput, too_large(text.size(), detail::most_import_bytes), source);
  }
  try {
    return read_and_build(text, source);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::kFailed, "There is not enough memory to read this mesh.", source);
  }
}

}  // namespace limn
