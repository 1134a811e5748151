#pragma once

#include <cstddef>
#include <cstdint>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/error.h"
#include "limn/mesh/polygon_soup.h"
#include "mesh/unused_data.h"

namespace limn::detail {

/// OBJ text as a stream of checked statements for tinyobjloader.
///
/// tinyobjloader reads what it cannot make out as 0, knows no `\` continuations and tells no lines,
/// so this stands between it and the file: each refill of the stream buffer is one vertex or face
/// statement, joined, without comment, and known to be well-formed. Since tinyobjloader calls back
/// for a line before it asks for the next, `line()`, `position()` and `face_uvs()` in a callback
/// belong to the element it is about. Texture coordinates and tags go straight into the soup; other
/// statements are counted. Neither are passed on.
class ObjStatements final : public std::streambuf {
 public:
  /// `text` must outlive this; it is not copied. A byte order mark is skipped.
  ObjStatements(std::string_view text, PolygonSoup& soup, UnusedData& unused);

  /// 1-based line on which the last statement begins.
  [[nodiscard]] std::uint32_t line() const noexcept { return breaks_.front().line; }
  /// Coordinates of the last vertex statement, correctly rounded (tinyobjloader's are not).
  [[nodiscard]] const glm::dvec3& position() const noexcept { return position_; }
  /// Texture coordinate of every corner of the last face statement, from 0; kNone for none.
  [[nodiscard]] const std::vector<std::uint32_t>& face_uvs() const noexcept { return face_uvs_; }
  /// Texture coordinates that could not be used and became 0.
  [[nodiscard]] std::size_t broken_uvs() const noexcept { return broken_uvs_; }
  /// What ended the stream early: message and line, or an empty message.
  [[nodiscard]] const Error& error() const noexcept { return error_; }

 protected:
  int_type underflow() override;

 private:
  /// From `offset` in the statement on, the text comes from this line.
  struct LineBreak {
    std::size_t offset;
    std::uint32_t line;
  };

  bool read_statement();
  std::string_view read_line();
  bool check_vertex(std::string_view arguments);
  bool check_face(std::string_view arguments);
  bool check_corner(std::string_view word);
  bool check_index(std::string_view token, std::string_view index);
  bool read_uv(std::string_view arguments);
  bool read_tag(std::string_view arguments);
  bool refuse(std::string_view culprit, std::string message);

  std::string_view rest_;
  std::uint32_t next_line_ = 1;
  std::string statement_;
  std::vector<LineBreak> breaks_;
  std::int64_t vertices_ = 0;
  glm::dvec3 position_{0.0};
  std::vector<std::uint32_t> face_uvs_;
  std::size_t broken_uvs_ = 0;
  PolygonSoup& soup_;
  UnusedData& unused_;
  Error error_;
};

}  // namespace limn::detail
