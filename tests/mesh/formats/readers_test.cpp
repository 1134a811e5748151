// What the readers of PLY, OFF and STL make of legal but odd files, and how they refuse bad ones.
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/import.h"
#include "support/hostile_files.h"

namespace limn {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Corners = std::vector<std::uint32_t>;

PolygonSoup read(MeshFormat format, const std::string& bytes) {
  auto soup = read_soup(bytes, format, "file");
  EXPECT_TRUE(soup.has_value()) << to_string(soup.error());
  return soup ? *soup : PolygonSoup{};
}

std::string refusal(MeshFormat format, const std::string& bytes) {
  const auto soup = read_soup(bytes, format, "file");
  return soup ? "read" : to_string(soup.error());
}

std::string sound(const std::string& name) {
  for (const test::HostileFile& file : test::sound_files()) {
    if (file.name == name) {
      return file.bytes;
    }
  }
  ADD_FAILURE() << name;
  return {};
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

const std::string kPlyHead =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kPlyPoints = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(ReadPly, TextAndBothByteOrdersSayTheSame) {
  for (const char* name : {"sound.ply", "sound_little.ply", "sound_big.ply"}) {
    const PolygonSoup soup = read(MeshFormat::kPly, sound(name));
    EXPECT_THAT(soup.positions,
                ElementsAre(glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)));
    EXPECT_EQ(soup.face_vertices, (Corners{0, 1, 2}));
    EXPECT_THAT(soup.unused_data, IsEmpty());
  }
}

TEST(ReadPly, PropertiesOfEveryKindAnywhere) {
  const PolygonSoup soup = read(MeshFormat::kPly, sound("sound_rich.ply"));
  EXPECT_EQ(soup.positions[2], glm::dvec3(1, 1, 0));
  EXPECT_EQ(soup.face_vertices, (Corners{0, 1, 2, 0, 2, 3}));
  EXPECT_THAT(soup.face_depths, ElementsAre(2, 0));
  ASSERT_EQ(soup.creases.size(), 1U);
  EXPECT_EQ(soup.creases[0].vertices, (std::array<std::uint32_t, 2>{0, 2}));
  EXPECT_EQ(soup.creases[0].sharpness, 1.5f);
  ASSERT_EQ(soup.corners.size(), 1U);
  EXPECT_EQ(soup.corners[0].vertex, 1U);
  EXPECT_EQ(soup.corner_rule, CornerRule::kSmooth);
  // Corners win over vertices; the face without has none.
  ASSERT_EQ(soup.face_uvs.size(), 6U);
  EXPECT_EQ(soup.uvs[soup.face_uvs[2]], glm::dvec2(1, 1));
  EXPECT_GE(soup.face_uvs[3], soup.uvs.size());
  EXPECT_THAT(soup.unused_data,
              ElementsAre("4 vertex colours", "2 \"other\" elements", "2 \"quality\" face values",
                          "4 texture coordinates of vertices"));
}

TEST(ReadPly, PlacesAreLinesOrBytes) {
  const PolygonSoup text = read(MeshFormat::kPly, kPlyHead + "\n" + kPlyPoints + "\n\n4 0 1 2 3\n");
  EXPECT_EQ(text.place_unit, PlaceUnit::kLine);
  EXPECT_THAT(text.vertex_places, ElementsAre(11, 12, 13, 14));
  EXPECT_THAT(text.face_places, ElementsAre(17));
  const std::string bytes = sound("sound_little.ply");
  const auto begin = static_cast<std::uint32_t>(bytes.find("end_header\n") + 11);
  const PolygonSoup binary = read(MeshFormat::kPly, bytes);
  EXPECT_EQ(binary.place_unit, PlaceUnit::kByte);
  EXPECT_THAT(binary.vertex_places, ElementsAre(begin, begin + 12, begin + 24));
  EXPECT_THAT(binary.face_places, ElementsAre(begin + 36));
}

TEST(ReadPly, StripsTurnEverySecondTriangle) {
  const PolygonSoup soup =
      read(MeshFormat::kPly,
           replaced(sound("sound_strips.ply"), "5 0 1 2 3 -1", "11 0 1 2 3 -1 3 2 2 0 1 -1"));
  EXPECT_EQ(soup.face_vertices, (Corners{0, 1, 2, 2, 1, 3, 2, 0, 1}));
  EXPECT_EQ(soup.face_count(), 3U);
}

TEST(ReadPly, ListsOfTwoHundredAndFiftyFive) {
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 255\n"
      "property uchar x\nproperty uchar y\nproperty uchar z\nelement face 1\n"
      "property list uchar uchar vertex_index\nend_header\n";
  for (int i = 0; i < 255; ++i) {
    bytes += {static_cast<char>(i), static_cast<char>(i % 3), '\0'};
  }
  bytes += '\xFF';
  for (int i = 0; i < 255; ++i) {
    bytes += static_cast<char>(i);
  }
  const PolygonSoup soup = read(MeshFormat::kPly, bytes);
  EXPECT_EQ(soup.face(0).size(), 255U);
  EXPECT_EQ(soup.positions[254], glm::dvec3(254, 2, 0));
}

TEST(ReadPly, TextOfAFloatIsAFloat) {
  const std::string number = "0.1 0 0\n";
  const std::string text = kPlyHead + number + kPlyPoints.substr(6) + "4 0 1 2 3\n";
  EXPECT_EQ(read(MeshFormat::kPly, text).positions[0].x, static_cast<double>(0.1f));
  EXPECT_EQ(read(MeshFormat::kPly, replaced(text, "float x", "double x")).positions[0].x, 0.1);
}

TEST(ReadPly, LineEndsOfAnyKind) {
  const std::string text = kPlyHead + kPlyPoints + "4 0 1 2 3";
  for (const std::string end : {"\r", "\r\n"}) {
    std::string ended;
    for (const char c : text) {
      c == '\n' ? ended += end : ended += c;
    }
    EXPECT_EQ(read(MeshFormat::kPly, ended).face_vertices, (Corners{0, 1, 2, 3}));
  }
  // Data that begins with what looks like a line end.
  std::string binary = sound("sound_little.ply");
  binary[binary.find("end_header\n") + 11] = '\n';
  EXPECT_EQ(read(MeshFormat::kPly, binary).face_count(), 1U);
}

TEST(ReadPly, RefusesWithPlaceAndReason) {
  EXPECT_EQ(refusal(MeshFormat::kPly, replaced(kPlyHead, "float x", "floot x")),
            "file:4: \"floot\" is no type of a PLY property.");
  EXPECT_EQ(refusal(MeshFormat::kPly, replaced(kPlyHead, "vertex 4", "vertex 400")),
            "file:3: The file announces 400 \"vertex\" elements and ends before it could hold "
            "them; 0 bytes follow the header.");
  EXPECT_EQ(refusal(MeshFormat::kPly, kPlyHead + kPlyPoints + "4 0 1 2 x\n"),
            "file:14: \"x\" is not a number.");
  EXPECT_EQ(refusal(MeshFormat::kPly, kPlyHead + kPlyPoints + "4 0 1 2 -1\n"),
            "file:14: -1 is not the number of a vertex.");
  EXPECT_EQ(refusal(MeshFormat::kPly, kPlyHead + kPlyPoints + "4 0 1 2 3 0\n"),
            "file:14: \"0\" is one number more than this \"face\" has.");
  const std::string bytes = sound("sound_little.ply");
  EXPECT_EQ(refusal(MeshFormat::kPly, bytes.substr(0, bytes.size() - 1)),
            "file: byte " + std::to_string(bytes.size() - 12) +
                ": A list \"vertex_indices\" announces 3 numbers, but only 11 bytes follow.");
}

TEST(ReadPly, WhatFollowsIsCounted) {
  EXPECT_THAT(read(MeshFormat::kPly, kPlyHead + kPlyPoints + "4 0 1 2 3\n1 2 3\n\n4\n").unused_data,
              ElementsAre("2 lines after the last element"));
  EXPECT_THAT(read(MeshFormat::kPly, sound("sound_big.ply") + "abc").unused_data,
              ElementsAre("3 bytes after the last element"));
}

TEST(ReadOff, LettersAndColours) {
  const std::string body = "0 1 2\n";
  const auto points = [](const std::string& data) {
    return " 3 1 0\n0 0 0" + data + "\n1 0 0" + data + "\n0 1 0" + data + "\n3 0 1 2";
  };
  const std::pair<std::string, std::vector<std::string>> texts[] = {
      {"OFF" + points(""), {}},
      {points(""), {}},
      {"# a comment\nOFF # another\n" + points(""), {}},
      {"OFF" + points("") + " 7", {"1 face colour"}},
      {"OFF" + points("") + " 0.1 0.2 0.3 1", {"1 face colour"}},
      {"OFF" + points(" 255 0 0"), {"3 vertex colours"}},
      {"COFF" + points(" 0.5 0.5 0.5 1"), {"3 vertex colours"}},
      {"COFF" + points(" 255 255 255"), {"3 vertex colours"}},
      {"NOFF" + points(" 0 0 1"), {"3 normals"}},
      {"CNOFF" + points(" 0 0 1 1 1 1 1"), {"3 normals", "3 vertex colours"}},
      {"STOFF" + points(" 0.25 0.5"), {}},
      {"STCNOFF" + points(" 0 0 1 1 1 1 1 0.25 0.5"), {"3 normals", "3 vertex colours"}},
      {"nOFF 3" + points(""), {}},
  };
  for (const auto& [text, unused] : texts) {
    const PolygonSoup soup = read(MeshFormat::kOff, text);
    EXPECT_THAT(soup.positions,
                ElementsAre(glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)))
        << text;
    EXPECT_EQ(soup.face_vertices, (Corners{0, 1, 2})) << text;
    EXPECT_EQ(soup.unused_data, unused) << text;
    EXPECT_EQ(soup.uvs.empty(), !text.starts_with("ST")) << text;
    if (!soup.uvs.empty()) {
      EXPECT_EQ(soup.uvs[2], glm::dvec2(0.25, 0.5)) << text;
    }
  }
}

TEST(ReadOff, AWeightDivides) {
  EXPECT_EQ(
      read(MeshFormat::kOff, "4OFF\n3 1 0\n2 4 6 2\n1 0 0 1\n0 1 0 1\n3 0 1 2\n").positions[0],
      glm::dvec3(1, 2, 3));
}

TEST(ReadOff, LinesAreBrokenAnywhere) {
  const PolygonSoup soup = read(MeshFormat::kOff, "OFF 3 1 0 0 0 0 1\n0 0\n\n0 1\n0\n3 0\n1\n2");
  EXPECT_EQ(soup.positions[2], glm::dvec3(0, 1, 0));
  EXPECT_EQ(soup.face_vertices, (Corners{0, 1, 2}));
  EXPECT_EQ(read(MeshFormat::kOff, "OFF\n3\n1\n0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").face_count(),
            1U);
}

TEST(ReadOff, BinaryInBothOrders) {
  const std::string big = sound("sound_binary.off");
  // The same words turned round, without the size of the face's colour, as some write it.
  std::string little = "OFF BINARY\n";
  for (std::size_t at = little.size(); at + 8 <= big.size(); at += 4) {
    const std::string word = big.substr(at, 4);
    little += std::string(word.rbegin(), word.rend());
  }
  for (const std::string& bytes : {big, little}) {
    const PolygonSoup soup = read(MeshFormat::kOff, bytes);
    EXPECT_EQ(soup.positions[1], glm::dvec3(1, 0, 0));
    EXPECT_EQ(soup.face_vertices, (Corners{0, 1, 2}));
    EXPECT_THAT(soup.face_places, ElementsAre(59));
  }
}

TEST(ReadOff, RefusesWithPlaceAndReason) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(refusal(MeshFormat::kOff, "OFF\n3 1 0\n" + points + "3 0 1 3\n"),
            "file:6: A face names vertex 3, counted from 0, but the file has 3 vertices.");
  EXPECT_EQ(refusal(MeshFormat::kOff, "OFF\n3 2 0\n" + points + "3 0 1 2\n"),
            "file:7: The file ends after 1 of 2 faces.");
  EXPECT_EQ(refusal(MeshFormat::kOff, "OFF\n300 1 0\n" + points + "3 0 1 2\n"),
            "file:2: This announces 300 vertices and 1 face, but only 27 bytes follow.");
  EXPECT_EQ(refusal(MeshFormat::kOff, "OFF\n3 1 0\n0 0,5 0\n" + points),
            "file:3: \"0,5\" is not a number.");
  // Lines that are broken at random would be vertices with something else behind them.
  EXPECT_EQ(refusal(MeshFormat::kOff, "OFF\n3 1 0\n0 0 0 1\n0 0\n0 1 0\n3 0 1 2\n"),
            "file:3: Vertex 1 has 1 number more than a vertex, and not enough for a colour.");
  EXPECT_EQ(refusal(MeshFormat::kOff, "5OFF\n3 1 0\n"),
            "file:1: \"5OFF\" is not how an OFF file "
            "begins.");
}

TEST(ReadStl, WeldsCornersAtTheSamePlace) {
  const std::string text =
      "solid part one\n  FACET NORMAL 0 0 1\n outer loop\nvertex 0 0 0\nvertex 1e0 0 0\n"
      "vertex 0 1 0\nendloop endfacet\nfacet normal 0 0 0 outer loop vertex -0 -0.0 0 "
      "vertex 0 1 0 vertex -1 0 0 endloop\nendfacet\nendsolid part one\n"
      "solid\ncolor 1 0 0\nfacet normal 0 0 1\nouter loop\nvertex 5 5 5\nvertex 6 5 5\n"
      "vertex 5 6 5\nvertex 5 5.5 5\nendloop\nendfacet\nendsolid\n";
  const PolygonSoup soup = read(MeshFormat::kStl, text);
  EXPECT_EQ(soup.positions.size(), 8U);
  EXPECT_EQ(soup.face_vertices, (Corners{0, 1, 2, 0, 2, 3, 4, 5, 6, 7}));
  EXPECT_THAT(soup.vertex_places, ElementsAre(4, 5, 6, 8, 15, 16, 17, 18));
  EXPECT_THAT(soup.face_places, ElementsAre(2, 8, 13));
  EXPECT_THAT(soup.names.objects.names, ElementsAre("part one"));
  EXPECT_THAT(soup.names.objects.of_faces, ElementsAre(0, 0, kNone));
  EXPECT_THAT(soup.unused_data, ElementsAre("2 facet normals", "1 colour"));
}

TEST(ReadStl, BinaryThatCallsItselfSolid) {
  std::string bytes = sound("sound_binary.stl");
  bytes.replace(0, 11, "solid thing");
  bytes[bytes.size() - 2] = 7;
  const PolygonSoup soup = read(MeshFormat::kStl, bytes);
  EXPECT_EQ(soup.positions[1], glm::dvec3(1, 0, 0));
  EXPECT_THAT(soup.face_places, ElementsAre(84));
  EXPECT_THAT(soup.unused_data,
              ElementsAre("1 header text", "1 facet normal", "1 facet attribute"));
}

TEST(ReadStl, RefusesWithPlaceAndReason) {
  const std::string text = sound("sound.stl");
  EXPECT_EQ(refusal(MeshFormat::kStl, replaced(text, "vertex 1 0 0", "vertex 1 0 z")),
            "file:5: \"z\" is not a number.");
  EXPECT_EQ(refusal(MeshFormat::kStl, replaced(text, "endloop", "loopend")),
            "file:7: \"loopend\" stands where a vertex or the end of the loop should be.");
  EXPECT_THAT(refusal(MeshFormat::kStl, replaced(text, "endsolid\n", "")),
              HasSubstr("The file ends before its solid does"));
  EXPECT_EQ(refusal(MeshFormat::kStl, sound("sound_binary.stl") + "x"), "read");
  EXPECT_EQ(refusal(MeshFormat::kStl, sound("sound_binary.stl").substr(0, 120)),
            "file: byte 80: This announces 1 facet, but there is room for 0. The file is cut off, "
            "or no STL.");
}

TEST(ReadObj, NamesAndDepths) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const PolygonSoup named =
      read(MeshFormat::kObj, points +
                                 "mtllib a b.mtl\nmtllib limn_depths.mtl\nf 1 2 3\no box # top\n"
                                 "g left  side\nusemtl red\nf 1 2 3\ng\nf 1 3 4\no never\nusemtl "
                                 "depth_x\n");
  EXPECT_THAT(named.names.material_libraries, ElementsAre("a b.mtl"));
  EXPECT_THAT(named.names.objects.names, ElementsAre("box"));
  EXPECT_THAT(named.names.objects.of_faces, ElementsAre(kNone, 0, 0));
  EXPECT_THAT(named.names.groups.names, ElementsAre("left side"));
  EXPECT_THAT(named.names.groups.of_faces, ElementsAre(kNone, 0, kNone));
  EXPECT_THAT(named.names.materials.of_faces, ElementsAre(kNone, 0, 0));
  EXPECT_THAT(named.unused_data, ElementsAre("1 object without faces", "1 material without faces"));
  EXPECT_THAT(named.face_depths, IsEmpty());

  const std::string face = "f 1 2 3\n";
  const PolygonSoup painted =
      read(MeshFormat::kObj, points + face + "usemtl depth_3\n" + face + "usemtl depth_2.001\n" +
                                 face + "usemtl red\n" + face);
  EXPECT_THAT(painted.face_depths, ElementsAre(0, 3, 2, 0));
  EXPECT_THAT(painted.names.materials.of_faces, ElementsAre(kNone, kNone, kNone, 0));
  // Tags are meant; materials may be anyone's.
  const PolygonSoup tagged =
      read(MeshFormat::kObj, points + "usemtl depth_3\n" + face + "t limn_depth 1/0/0 5\n" + face +
                                 "usemtl red\n" + face);
  EXPECT_THAT(tagged.face_depths, ElementsAre(0, 5, 5));
}

TEST(TellFormat, NamesWhatIsNoMesh) {
  const auto refuse = [](const std::string& bytes) { return refusal(MeshFormat::kObj, bytes); };
  EXPECT_EQ(refuse("\x89PNG\r\n\x1A\n...."), "file: This is not a mesh but a PNG picture.");
  EXPECT_EQ(refuse("<!doctype HTML>"), "file: This is not a mesh but a web page.");
  EXPECT_EQ(refuse("<?xml version='1.0'?><COLLADA>"),
            "file: This is not a mesh but a COLLADA scene; convert it to OBJ or PLY.");
  EXPECT_EQ(refuse("{\"format\": \"limn\", \"limn\": 1}"),
            "file: This is not a mesh but a Limn project; give its name the ending .limn.");
  EXPECT_THAT(refuse("PK\x03\x04"), HasSubstr("ZIP archive"));
  EXPECT_THAT(refuse(""), HasSubstr("The file is empty."));
}

}  // namespace
}  // namespace limn
