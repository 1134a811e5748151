// Magic numbers first, then the first words of a text.
#include "mesh/formats/tell_format.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "mesh/formats/off_header.h"
#include "mesh/formats/parse_number.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/text_cursor.h"

namespace limn::detail {
namespace {

using namespace std::string_view_literals;

struct Foreign {
  std::string_view beginning;
  std::string_view name;
};

/// What people pick by mistake. Where a file begins with text, capitals do not matter.
constexpr Foreign Foreigners[] = {
    {"\x89PNG\r\n\x1A\n"sv, "a PNG picture"},
    {"\xFF\xD8\xFF"sv, "a JPEG picture"},
    {"GIF8"sv, "a GIF picture"},
    {"II*\0"sv, "a TIFF picture"},
    {"MM\0*"sv, "a TIFF picture"},
    {"\x76\x2F\x31\x01"sv, "an OpenEXR picture"},
    {"#?RADIANCE"sv, "a Radiance picture"},
    {"8BPS"sv, "a Photoshop picture"},
    {"RIFF"sv, "a RIFF file (a sound, film or WebP picture)"},
    {"PK\x03\x04"sv, "a ZIP archive (as are 3MF, USDZ and office files); unpack it first"},
    {"\x1F\x8B"sv, "a gzip archive; unpack it first"},
    {"BZh"sv, "a bzip2 archive; unpack it first"},
    {"\xFD"
     "7zXZ\0"sv,
     "an xz archive; unpack it first"},
    {"\x28\xB5\x2F\xFD"sv, "a Zstandard archive; unpack it first"},
    {"7z\xBC\xAF\x27\x1C"sv, "a 7-Zip archive; unpack it first"},
    {"Rar!"sv, "a RAR archive; unpack it first"},
    {"%PDF"sv, "a PDF document"},
    {"%!PS"sv, "a PostScript document"},
    {"{\\rtf"sv, "an RTF document"},
    {"SQLite format 3"sv, "a database"},
    {"\x7F"
     "ELF"sv,
     "a program"},
    {"MZ"sv, "a Windows program"},
    {"glTF"sv, "a binary glTF scene; convert it to OBJ or PLY"},
    {"Kaydara FBX Binary"sv, "an FBX scene; convert it to OBJ or PLY"},
    {"; FBX"sv, "an FBX scene; convert it to OBJ or PLY"},
    {"BLENDER"sv, "a Blender file; export it as OBJ or PLY"},
    {"#usda"sv, "a USD scene; convert it to OBJ or PLY"},
    {"PXR-USDC"sv, "a USD scene; convert it to OBJ or PLY"},
    {"Ogawa"sv, "an Alembic scene; convert it to OBJ or PLY"},
    {"\x89HDF"sv, "an HDF file"},
    {"ISO-10303-21"sv, "a STEP model; convert it to a mesh first"},
    {"#VRML"sv, "a VRML scene; convert it to OBJ or PLY"},
    {"//Maya"sv, "a Maya scene; export it as OBJ"},
    {"MeshVersionFormatted"sv, "a Medit mesh; convert it to OBJ or PLY"},
    {"$MeshFormat"sv, "a Gmsh mesh; convert it to OBJ or PLY"},
    {"# vtk DataFile"sv, "a VTK file; convert it to PLY"},
    {"xof 0"sv, "a DirectX mesh; convert it to OBJ or PLY"},
    {"<!doctype html"sv, "a web page"},
    {"<html"sv, "a web page"},
    {"<svg"sv, "an SVG drawing"},
    {"<collada"sv, "a COLLADA scene; convert it to OBJ or PLY"},
    {"<x3d"sv, "an X3D scene; convert it to OBJ or PLY"},
    {"<amf"sv, "an AMF model; convert it to STL"},
    {"version https://git-lfs"sv, "the stand-in of a file that Git LFS did not fetch"},
};

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool begins_with(std::string_view bytes, std::string_view beginning) {
  return bytes.size() >= beginning.size() &&
         std::equal(beginning.begin(), beginning.end(), bytes.begin(),
                    [](char a, char b) { return lower(a) == lower(b); });
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || is_line_end(text.front()))) {
    text.remove_prefix(1);
  }
  return text;
}

/// What the bytes are, if they are known and no mesh.
std::string_view foreign_name(std::string_view bytes) {
  constexpr std::size_t looked_at = 1024;
  std::string_view text = without_blanks(without_byte_order_mark(bytes.substr(0, looked_at)));
  for (const Foreign& foreign : Foreigners) {
    if (begins_with(bytes, foreign.beginning) || begins_with(text, foreign.beginning)) {
      return foreign.name;
    }
  }
  if (begins_with(text, "<?xml")) {
    for (const std::string_view element : {"<collada"sv, "<x3d"sv, "<svg"sv, "<html"sv, "<amf"sv}) {
      for (std::size_t at = text.find('<', 1); at != std::string_view::npos;
           at = text.find('<', at + 1)) {
        if (begins_with(text.substr(at), element)) {
          return foreign_name(text.substr(at));
        }
      }
    }
    return "an XML document";
  }
  if (begins_with(text, "{")) {
    return text.find("\"limn\"") != std::string_view::npos
               ? "a Limn project; give its name the ending .limn"sv
           : text.find("\"asset\"") != std::string_view::npos
               ? "a glTF scene; convert it to OBJ or PLY"sv
               : "a JSON document"sv;
  }
  return {};
}

bool is_obj_keyword(std::string_view word) {
  constexpr std::string_view keywords[] = {"v", "vt",     "vn",     "vp", "f", "fo", "o",
                                           "g", "usemtl", "mtllib", "s",  "l", "p",  "t"};
  return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

/// What the first words of a text say, if they say anything.
std::optional<MeshFormat> by_first_words(std::string_view bytes) {
  TextCursor cursor(bytes, {'#', false});
  const std::string_view word = cursor.next_word_anywhere();
  if (word == "ply") {
    return MeshFormat::kPly;
  }
  if (read_off_keyword(word)) {
    return MeshFormat::kOff;
  }
  if (word.size() == 5 && begins_with(word, "solid")) {
    return MeshFormat::kStl;
  }
  return is_obj_keyword(word) ? std::optional(MeshFormat::kObj) : std::nullopt;
}

}  // namespace

Result<MeshFormat> tell_format(std::string_view bytes, std::optional<MeshFormat> expected,
                               const std::string& source) {
  if (bytes.empty()) {
    return fail(ErrorKind::kBadInput, "The file is empty.", source);
  }
  if (is_binary_stl(bytes)) {  // Its header may begin with anything.
    return MeshFormat::kStl;
  }
  if (const std::string_view name = foreign_name(bytes); !name.empty()) {
    return fail(ErrorKind::kBadInput, fmt::format("This is not a mesh but {}.", name), source);
  }
  if (const std::optional<MeshFormat> told = by_first_words(bytes)) {
    return *told;
  }
  if (!expected) {
    return fail(ErrorKind::kBadInput,
                "Neither its name nor its content is that of a mesh; OBJ, PLY, OFF and STL files "
                "are read.",
                source);
  }
  return *expected;
}

}  // namespace limn::detail
