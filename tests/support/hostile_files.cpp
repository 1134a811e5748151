#include "support/hostile_files.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <random>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace limn::test {
namespace {

using namespace std::string_literals;
using Files = std::vector<HostileFile>;

template <class T>
std::string number_bytes(T value, bool is_big = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (is_big) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  result.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) {
    result += text;
  }
  return result;
}

const std::string kObjVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string ply_header(const std::string& format, const std::string& vertices,
                       const std::string& faces, const std::string& list = "uchar int") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list " + list + " vertex_indices\nend_header\n";
}

std::string ply_text(const std::string& vertices = "3", const std::string& faces = "1") {
  return ply_header("ascii", vertices, faces) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
}

std::string ply_vertices(bool is_big) {
  std::string bytes;
  for (const float x : {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}) {
    bytes += number_bytes(x, is_big);
  }
  return bytes;
}

std::string ply_binary(bool is_big, const std::string& vertices = "3",
                       const std::string& faces = "1") {
  std::string bytes =
      ply_header(is_big ? "binary_big_endian" : "binary_little_endian", vertices, faces) +
      ply_vertices(is_big) + '\3';
  for (const std::int32_t v : {0, 1, 2}) {
    bytes += number_bytes(v, is_big);
  }
  return bytes;
}

std::string off_text(const std::string& counts = "3 1 0") {
  return "OFF\n" + counts + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
}

std::string off_binary(std::uint32_t vertices = 3, std::uint32_t faces = 1,
                       std::uint32_t corners = 3) {
  std::string bytes = "OFF BINARY\n";
  for (const std::uint32_t n : {vertices, faces, 0U}) {
    bytes += number_bytes(n, true);
  }
  bytes += ply_vertices(true);
  for (const std::uint32_t n : {corners, 0U, 1U, 2U, 0U}) {
    bytes += number_bytes(n, true);
  }
  return bytes;
}

std::string stl_binary(std::uint32_t announced = 1) {
  std::string bytes(80, '\0');
  bytes += number_bytes(announced);
  for (const float x : {0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}) {
    bytes += number_bytes(x);
  }
  return bytes + "\0\0"s;
}

std::string stl_text(const std::string& vertex = "1 0 0") {
  return "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex " + vertex +
         "\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
}

/// Every format as text with one number of a vertex replaced.
void add_number(Files& files, const std::string& name, const std::string& number) {
  files.push_back({name + ".obj", "v 0 " + number + " 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"});
  files.push_back({name + ".ply",
                   ply_header("ascii", "3", "1") + "0 " + number + " 0\n1 0 0\n0 1 0\n3 0 1 2\n"});
  files.push_back({name + ".off", "OFF\n3 1 0\n0 " + number + " 0\n1 0 0\n0 1 0\n3 0 1 2\n"});
  files.push_back({name + ".stl", stl_text("1 " + number + " 0")});
}

/// Every format as text with one index of a face replaced.
void add_index(Files& files, const std::string& name, const std::string& index) {
  files.push_back({name + ".obj", kObjVertices + "f 1 2 " + index + "\n"});
  files.push_back({name + ".ply",
                   ply_header("ascii", "3", "1") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 " + index + "\n"});
  files.push_back({name + ".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 " + index + "\n"});
}

void add_foreigners(Files& files) {
  const std::string rest = "\r\n\x1A\n"s + std::string(300, '\x5A');
  const std::pair<const char*, std::string> foreigners[] = {
      {"picture.obj", "\x89PNG" + rest},
      {"photo.ply", "\xFF\xD8\xFF\xE0" + rest},
      {"film.off", "GIF89a" + rest},
      {"scan.stl", "II*\0"s + rest},
      {"archive.obj", "PK\3\4" + rest},
      {"archive.ply", "\x1F\x8B\x08" + rest},
      {"archive.off", "BZh9" + rest},
      {"document.obj", "%PDF-1.4" + rest},
      {"page.obj", "<!DOCTYPE html>\n<html><body>404</body></html>\n"},
      {"page.ply", "\n\n<html>\n<body>v 1 2 3</body></html>\n"},
      {"scene.obj", "glTF\2\0\0\0"s + rest},
      {"scene.ply", "{\"asset\": {\"version\": \"2.0\"}}"},
      {"scene.off", "Kaydara FBX Binary  \0"s + rest},
      {"scene.stl", "; FBX 7.3.0 project file\n"},
      {"scene2.obj", "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"x\"></COLLADA>\n"},
      {"model.obj", "ISO-10303-21;\nHEADER;\n"},
      {"blend.obj", "BLENDER-v300" + rest},
      {"program.obj",
       "\x7F"
       "ELF\2\1\1\0"s +
           rest},
      {"program.stl", "MZ\x90\0"s + rest},
      {"data.obj", "{\"a\": [1, 2]}"},
      {"pointer.obj", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n"},
      {"text.obj", "Dear diary,\ntoday I did nothing.\n"},
      {"text.ply", "Dear diary,\n"},
      {"text.off", "Dear diary,\n"},
      {"text.stl", "Dear diary,\n"},
  };
  for (const auto& [name, bytes] : foreigners) {
    files.push_back({name, bytes});
  }
  std::mt19937 random(5);
  for (const char* ending : {".obj", ".ply", ".off", ".stl"}) {
    files.push_back({"empty"s + ending, ""});
    files.push_back({"blank"s + ending, " \n\t\r\n \n"});
    files.push_back({"mark"s + ending, "\xEF\xBB\xBF"});
    files.push_back({"zeros"s + ending, std::string(4096, '\0')});
    files.push_back({"ones"s + ending, std::string(4096, '\xFF')});
    files.push_back({"letter"s + ending, "v"});
    std::string noise(4096, '\0');
    std::generate(noise.begin(), noise.end(), [&] { return static_cast<char>(random() % 256); });
    files.push_back({"noise"s + ending, noise});
  }
}

void add_counts(Files& files) {
  for (const char* count : {"-1", "2", "4", "1000000", "2147483647", "4294967295", "4294967296",
                            "18446744073709551615", "99999999999999999999999", "x", "3.5", ""}) {
    const std::string n(count);
    files.push_back({"vertices" + n + ".ply", ply_text(n)});
    files.push_back({"vertices" + n + "_little.ply", ply_binary(false, n)});
    files.push_back({"vertices" + n + "_big.ply", ply_binary(true, n)});
    files.push_back({"vertices" + n + ".off", off_text(n + " 1 0")});
  }
  for (const char* count : {"-1", "0", "2", "2147483647", "4294967295", "4294967296", "1e9", "x"}) {
    const std::string n(count);
    files.push_back({"faces" + n + ".ply", ply_text("3", n)});
    files.push_back({"faces" + n + "_little.ply", ply_binary(false, "3", n)});
    files.push_back({"faces" + n + ".off", off_text("3 " + n + " 0")});
  }
  // One facet or face too few leaves something over, which is reported.
  for (const std::uint32_t n : {2U, 1000U, 0x7FFFFFFFU, 0xFFFFFFFFU}) {
    files.push_back({fmt::format("facets{}.stl", n), stl_binary(n)});
    files.push_back({fmt::format("vertices{}_binary.off", n), off_binary(n)});
    files.push_back({fmt::format("faces{}_binary.off", n), off_binary(3, n)});
    files.push_back({fmt::format("corners{}_binary.off", n), off_binary(3, 1, n)});
    files.push_back({fmt::format("corners{}.off", n),
                     "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + fmt::format("{} 0 1 2\n", n + 2)});
    files.push_back({fmt::format("list{}.ply", n), ply_header("ascii", "3", "1") +
                                                       "0 0 0\n1 0 0\n0 1 0\n" +
                                                       fmt::format("{} 0 1 2\n", n + 2ULL)});
    files.push_back({fmt::format("list{}_little.ply", n),
                     ply_header("binary_little_endian", "3", "1", "uint int") +
                         ply_vertices(false) + number_bytes(n)});
  }
  files.push_back({"facets0.stl", stl_binary(0)});
  const std::string full = ply_header("binary_little_endian", "3", "1") + ply_vertices(false);
  files.push_back({"list255.ply", full + '\xFF'});
  files.push_back({"negative_list.ply", ply_header("binary_little_endian", "3", "1", "char int") +
                                            ply_vertices(false) + '\xFF'});
  for (const float count : {std::numeric_limits<float>::quiet_NaN(), -1.0f, 0.5f, 1e30f}) {
    files.push_back({fmt::format("list_of_{}.ply", count),
                     ply_header("binary_little_endian", "3", "1", "float int") +
                         ply_vertices(false) + number_bytes(count)});
  }
}

void add_headers(Files& files, std::size_t scale) {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string good = ply_text();
  const auto replaced = [&good](const std::string& what, const std::string& by) {
    std::string text = good;
    return text.replace(text.find(what), what.size(), by);
  };
  const std::pair<const char*, std::string> headers[] = {
      {"no_end.ply", "ply\nformat ascii 1.0\nelement vertex 1000000000\n"},
      {"short.ply", "ply\nformat ascii 1.0\n"},
      {"no_format.ply", replaced("format ascii 1.0\n", "")},
      {"version.ply", replaced("1.0", "2.0")},
      {"encoding.ply", replaced("ascii", "utf8")},
      {"type.ply", replaced("float x", "quad x")},
      {"no_name.ply", replaced("float x", "float")},
      {"no_x.ply", replaced("float x", "float a")},
      {"list_x.ply", replaced("float x", "list uchar float x")},
      {"orphan.ply", replaced("element vertex 3\n", "")},
      {"twice.ply", replaced("element face 1",
                             "element vertex 3\nproperty float x\nproperty "
                             "float y\nproperty float z\nelement face 1")},
      {"word.ply", replaced("end_header", "beginning")},
      {"too_many.ply", replaced("0 0 0\n", "0 0 0 0\n")},
      {"too_few.ply", replaced("0 0 0\n", "0 0\n")},
      {"nothing.ply", replaced("element face 1\nproperty list uchar int vertex_indices\n", "")},
      {"ply", "ply"},
      {"ply.ply", "ply\n"},
      {"off.off", "OFF"},
      {"off2.off", "OFF\n"},
      {"off3.off", "OFF 3"},
      {"off4.off", "OFF BINARY"},
      {"off5.off", "4nOFF\n7\n3 1 0\n" + body},
      {"off6.off", "XOFF\n3 1 0\n" + body},
      {"off7.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 2 3 4 5\n"},
      {"off8.off", "OFF\n3 1 0\n0 0 0 1 2 3 4 5\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"off9.off", "STOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"solid.stl", "solid"},
      {"open.stl", "solid a\n"},
      {"nothing.stl", "solid a\nendsolid a\n"},
      {"keyword.stl", "solid a\nfacet abnormal 0 0 1\n"},
      {"loop.stl", "solid a\nfacet normal 0 0 1\nouter ring\n"},
      {"no_loop.stl", "solid a\nfacet normal 0 0 1\nendfacet\nendsolid\n"},
      {"behind.stl", stl_text() + "facet normal 0 0 1\n"},
  };
  for (const auto& [name, bytes] : headers) {
    files.push_back({name, bytes});
  }
  files.push_back(
      {"properties.ply",
       replaced("element face", repeated("property float a\n", 5000 * scale) + "element face")});
  files.push_back(
      {"elements.ply",
       replaced("end_header", repeated("element e 4294967295\n", 5000 * scale) + "end_header"),
       false});
}

void add_numbers(Files& files) {
  for (const char* number :
       {"nan", "-nan", "NaN", "inf", "-inf", "Infinity", "1e400", "-1e400", "1,5", "0x10", "1e",
        "--1", "1.2.3", "1.#IND", "x", "\xC2\xBD", "1e19", "\x1B[31m"}) {
    add_number(files, fmt::format("number{}", files.size()), number);
  }
  for (const char* index : {"-99", "5", "2147483647", "2147483648", "4294967294", "4294967295",
                            "4294967296", "9223372036854775807", "9223372036854775808",
                            "99999999999999999999", "1.5", "x", "nan", "1e3"}) {
    add_index(files, fmt::format("index{}", files.size()), index);
  }
  files.push_back({"index0.obj", kObjVertices + "f 0 1 2\n"});
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 3e38f}) {
    std::string bytes = stl_binary();
    bytes.replace(96, 4, number_bytes(value));
    files.push_back({fmt::format("{}.stl", value), bytes});
    bytes = off_binary();
    bytes.replace(23, 4, number_bytes(value, true));
    files.push_back({fmt::format("{}_binary.off", value), bytes});
    bytes = ply_binary(false);
    bytes.replace(bytes.find("end_header\n") + 11, 4, number_bytes(value));
    files.push_back({fmt::format("{}_little.ply", value), bytes});
  }
}

void add_obj_statements(Files& files) {
  const std::pair<const char*, bool> lines[] = {
      {"f", true},
      {"f 1//1 2//1 5000//1", true},
      {"f 1/1/1/1 2 3", true},
      {"f a b c", true},
      {"f 1 2 3/x", true},
      {"v", true},
      {"v 1", true},
      {"v 1 2 3 4 5 6 7 8 9", true},
      {"vt", true},
      {"vt x", true},
      {"t crease 1000000000/1/0 0 1 2", true},
      {"t crease 99999999999999999999/1/0 0 1", true},
      {"t crease -1/1/0", true},
      {"t crease 2/1/0 0 1 nan", true},
      {"t corner 0/0/0", true},
      {"t limn_depth 1/0/0 -1", true},
      {"t limn_depth 1/0/0 99999999999", true},
      {"t", false},
      {"t limn_depth 1/0/0 4000000000", false},
      {"t crease 2/1/0 4000000000 -7 1e300", false},
      {"usemtl depth_99999999999999999999", false},
      {"usemtl", false},
      {"mtllib ../../../../../../etc/passwd", false},
      {"mtllib /dev/zero", false},
      {"mtllib", false},
      {"call /etc/passwd", false},
      {"csh -rm", false},
      {"g \\", false},
      {"f 1 2 3/4000000000", false},
      {"f 1 2 3//99999", false},
      {"f 1 1 1", false},
      {"f 1", false},
      {"f 1 2 1 2 1 2", false},
      {"\\", false},
      {"# \\", false},
  };
  for (const auto& [line, is_bad] : lines) {
    files.push_back({fmt::format("statement{}.obj", files.size()),
                     kObjVertices + "f 1 2 3\n" + line + "\nf 1 3 4\n", is_bad});
  }
}

void add_large(Files& files, std::size_t scale) {
  const std::size_t n = 20000 * scale;
  files.push_back({"long_comment.obj",
                   "#" + std::string(10 * n, 'x') + "\n" + kObjVertices + "f 1 2 3 4\n", false});
  files.push_back({"long_word.obj", kObjVertices + "f 1 2 " + std::string(10 * n, '1') + "\n"});
  files.push_back({"long_number.obj",
                   "v 0." + std::string(10 * n, '1') + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", false});
  files.push_back({"continuations.obj", kObjVertices + "f 1 2 3" + repeated(" \\\n", n), false});
  files.push_back({"backslashes.obj", kObjVertices + "f 1 2 3 " + std::string(5 * n, '\\')});
  files.push_back(
      {"spaced_backslashes.obj", kObjVertices + "f 1 2 3" + repeated(" \\ ", n) + "\n"});
  files.push_back(
      {"carriage_returns.obj", std::string(10 * n, '\r') + kObjVertices + "f 1 2 3 4\n", false});
  std::string polygon = "f";
  std::string points;
  std::string fan;
  std::string same;
  std::string words;
  std::string doubled;
  for (std::size_t i = 1; i <= n; ++i) {
    points += fmt::format("v {} {} {}\n", i, i % 7, i % 5);
    polygon += fmt::format(" {}", i);
    fan += i > 2 ? fmt::format("f 1 {} {}\n", i - 1, i) : "";
    same += "f 1 2 3\n";
    words += fmt::format("g w{}\nword{} 1\n", i, i);
    doubled += fmt::format("f 1 2 {}\n", 3 + i % (n - 3));
  }
  files.push_back({"polygon.obj", points + polygon + "\n", false});
  files.push_back({"fan.obj", points + fan, false});
  files.push_back({"same_face.obj", points + same, false});
  files.push_back({"crowded_edge.obj", points + doubled, false});
  files.push_back({"words.obj", words + kObjVertices + "f 1 2 3 4\n", false});
  files.push_back({"polygon_again.obj", points + polygon + polygon.substr(1) + "\n", false});
  std::string soup = "OFF\n3 " + std::to_string(n) + " 0\n0 0 0\n1 0 0\n0 1 0\n";
  files.push_back({"empty_faces.off", soup + repeated("0\n", n)});
  files.push_back({"empty_lists.ply", ply_header("binary_little_endian", "3", std::to_string(n)) +
                                          ply_vertices(false) + std::string(n, '\0')});
  files.push_back({"one_point.stl", "solid a\n" +
                                        repeated("facet normal 0 0 0\nouter loop\nvertex 1 1 1\n"
                                                 "vertex 1 1 1\nvertex 1 1 1\nendloop\nendfacet\n",
                                                 n / 20) +
                                        "endsolid a\n"});
}

}  // namespace

Files sound_files() {
  const std::string uvs = "vt 0 0\nvt 1 0\nvt 1 1\n";
  return {
      {"sound.obj", kObjVertices + "f 1 2 3 4\n", false},
      {"sound_rich.obj",
       "mtllib a.mtl\no box\ng left side\nusemtl red\n" + kObjVertices + "v 9 9 9\n" + uvs +
           "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nt limn_depth 1/0/0 3\ng right\nusemtl blue\n"
           "f 1/1 3/3 \\\n 4/2\nt crease 2/1/0 0 2 2.5\nt corner 1/1/0 1 10\n"
           "t interpolateboundary 1/0/0 2\nt creasemethod 0/0/1 chaikin\n",
       false},
      {"sound_depths.obj",
       "\xEF\xBB\xBF" + kObjVertices + "usemtl depth_2\nf -4 -3 -2\nusemtl depth_0.001\nf 1 3 4\n",
       false},
      {"sound.ply", ply_text(), false},
      {"sound_little.ply", ply_binary(false), false},
      {"sound_big.ply", ply_binary(true), false},
      {"sound_rich.ply",
       "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info limn_corners smooth\r\n"
       "element vertex 4\r\nproperty uchar red\r\nproperty double x\r\nproperty double y\r\n"
       "property double z\r\nproperty float s\r\nproperty float t\r\n"
       "property float limn_sharpness\r\nelement other 2\r\nproperty list int short a\r\n"
       "element face 2\r\nproperty float quality\r\nproperty list uchar uint vertex_index\r\n"
       "property list uchar float texcoord\r\nproperty uchar limn_depth\r\nelement edge 1\r\n"
       "property int vertex1\r\nproperty int vertex2\r\nproperty float limn_sharpness\r\n"
       "end_header\r\n9 0 0 0 0 0 0\r\n9 1 0 0 1 0 3\r\n9 1 1 0 1 1 0\r\n9 0 1 0 0 1 0\r\n"
       "2 1 2\r\n0\r\n0.5 3 0 1 2 6 0 0 1 0 1 1 2\r\n0.5 3 0 2 3 0 0\r\n0 2 1.5\r\n",
       false},
      {"sound_strips.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty int z\n"
       "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
       "0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 0 1 2 3 -1\n",
       false},
      {"sound.off", off_text(), false},
      {"sound_binary.off", off_binary(), false},
      {"sound_rich.off",
       "# made by hand\nSTCN4OFF\n3 1 3\n0 0 0 1 0 0 1 1 0 0 1 0 0\n2 0 0 2 0 0 1 1 0 0 1 1 0\n"
       "0 1 0 1 0 0 1 1 0 0 1 0 1\n3 0 1 2 0.5 0.5 0.5\n",
       false},
      {"sound_free.off", "OFF 3 1 0 0 0 0 1 0 0 0 1 0\n3 0 1 2", false},
      {"sound.stl", stl_text(), false},
      {"sound_binary.stl", stl_binary(), false},
      {"sound_two.stl", stl_text() + "\n" + stl_text("2 0 0"), false},
  };
}

Files hostile_files(std::size_t scale) {
  Files files;
  add_foreigners(files);
  add_counts(files);
  add_headers(files, scale);
  add_numbers(files);
  add_obj_statements(files);
  add_large(files, scale);
  return files;
}

}  // namespace limn::test
