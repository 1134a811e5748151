#include "limn/mesh/import.h"

#include <clocale>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/formats/parse_number.h"
#include "mesh/mesh_checks.h"

namespace limn {
namespace {

using test::faces_of;
using test::faults_of;
using test::import_text;
using test::refusal_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using Faces = std::vector<std::vector<std::uint32_t>>;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Faces faces_in(const std::string& text) {
  const ImportedMesh imported = import_text(text);
  return imported.mesh == nullptr ? Faces{} : faces_of(*imported.mesh);
}

TEST(ImportObj, ReadsPolygonsOfAnySize) {
  const ImportedMesh imported = import_text(kSquare +
                                            "v 2 0.5 0.1\nv 0.5 2 0\nv 0.2 3 0\nf 1 2 3 4\n"
                                            "f 2 5 3\nf 4 3 6 7 \n");
  EXPECT_EQ(faces_of(*imported.mesh), (Faces{{0, 1, 2, 3}, {1, 4, 2}, {3, 2, 5, 6}}));
  EXPECT_EQ(imported.mesh->positions()[4], glm::dvec3(2.0, 0.5, 0.1));
  EXPECT_FALSE(imported.report.is_mended());
  EXPECT_THAT(imported.report.unused_data, IsEmpty());
}

TEST(ImportObj, KeepsConcavePolygonsWhole) {
  EXPECT_EQ(faces_in("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n"),
            (Faces{{0, 1, 2, 3, 4}}));
}

TEST(ImportObj, CornersInEveryForm) {
  const std::string rest = "vt 0 0\nvt 1 0\nvn 0 0 1\n";
  for (const char* face :
       {"f 1 2 3 4", "f 1/1 2/2 3/1 4/2", "f 1/1/1 2/2/1 3/1/1 4/2/1", "f 1//1 2//1 3//1 4//1",
        "f 1/ 2// 3/1/ 4", "f -4 -3 -2 -1", "f -4/-2/-1 2/-1 3//-1 -1", "\tf  1\t2  3\t 4  ",
        "f +1 +2 03 4", "f 1 2 3 4 # a comment", "f 1 2 3 4\t#a comment", "fo 1 2 3 4",
        "  fo 1 2 3 4"}) {
    EXPECT_EQ(faces_in(kSquare + rest + face), (Faces{{0, 1, 2, 3}})) << face;
  }
}

TEST(ImportObj, NegativeIndicesCountFromWhereTheyStand) {
  EXPECT_EQ(faces_in("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 1 1 0\nv 2 2 0\nf -4 -2 -1 -3\n"),
            (Faces{{0, 1, 2}, {1, 3, 4, 2}}));
}

TEST(ImportObj, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(faces_in("f 1 2 3 4\n" + kSquare), (Faces{{0, 1, 2, 3}}));
}

TEST(ImportObj, LineEndsAndByteOrderMark) {
  std::string text = "\xEF\xBB\xBF# box\n" + kSquare + "\n\n   \nf 1 2 \\\n  3 \\\n4";
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string ended;
    for (const char c : text) {
      c == '\n' ? ended += end : ended += c;
    }
    EXPECT_EQ(faces_in(ended), (Faces{{0, 1, 2, 3}}));
    EXPECT_EQ(faces_in(ended + end), (Faces{{0, 1, 2, 3}}));
  }
}

TEST(ImportObj, Continuations) {
  EXPECT_EQ(faces_in("v 0 0 \\\n0\nv 1\\\n 0 0\nv 1 1 0\nv 0 1 0\nf\\\n 1 2 3\\\n\\\n 4"),
            (Faces{{0, 1, 2, 3}}));
  EXPECT_EQ(faces_in(kSquare + "f 1 2 3 \\  \n 4\n"), (Faces{{0, 1, 2, 3}}));
  // At the very end there is nothing to go on with.
  EXPECT_EQ(faces_in(kSquare + "f 1 2 3 4 \\"), (Faces{{0, 1, 2, 3}}));
  EXPECT_EQ(faces_in(kSquare + "f 1 2 3 4 \\\n"), (Faces{{0, 1, 2, 3}}));
  // A comment that ends in a Windows folder does not swallow the next line.
  EXPECT_EQ(faces_in("# C:\\meshes\\\n" + kSquare + "  # \\\nf 1 2 3 4\n"), (Faces{{0, 1, 2, 3}}));
}

TEST(ImportObj, NumbersAreReadToTheLastBit) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponents(-12.0, 12.0);
  for (int i = 0; i < 3000; ++i) {
    const double value = std::pow(10.0, exponents(random)) * (i % 2 == 0 ? 1.0 : -1.0);
    char written[40];
    std::snprintf(written, sizeof written, "%.17g", value);
    double back = 0.0;
    ASSERT_TRUE(detail::parse_number(written, back));
    ASSERT_EQ(back, value) << written;
  }
  const ImportedMesh imported = import_text(
      "v 0.1 -.5 +3.\nv 1e-3 1E+3 -1.5e02\nv 0.333333333333333314829616256247 1e-400 -0\nf 1 2 3");
  EXPECT_EQ(imported.mesh->positions()[0], glm::dvec3(0.1, -0.5, 3.0));
  EXPECT_EQ(imported.mesh->positions()[1], glm::dvec3(1e-3, 1e3, -150.0));
  EXPECT_EQ(imported.mesh->positions()[2], glm::dvec3(1.0 / 3.0, 0.0, 0.0));
}

TEST(ImportObj, NumbersDoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, name);  // Those that are not installed change nothing.
    EXPECT_EQ(import_text("v 1.5 1e-320 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").mesh->positions()[0],
              glm::dvec3(1.5, 1e-320, 0.0));
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(ImportObj, MalformedNumbersAreErrorsWithTheirLine) {
  EXPECT_EQ(refusal_of(kSquare + "v 1 x 0\nf 1 2 5"), "text.obj:5: \"x\" is not a number.");
  for (const char* number : {"1,5", "1.2.3", "0x10", "1e", "1e+", "--1", "+-1", ".", "-", "1.#IND",
                             "3.1+e2", "1f", "\x01", "1/2", "\xC3\xA4"}) {
    EXPECT_THAT(refusal_of("v 0 0 " + std::string(number) + "\n"),
                testing::AllOf(StartsWith("text.obj:1: "), HasSubstr("is not a number")))
        << number;
  }
  EXPECT_THAT(refusal_of("v 1 2\n"), HasSubstr("text.obj:1: A vertex needs three coordinates; this "
                                               "one has 2."));
  EXPECT_THAT(refusal_of("\nv\n"), HasSubstr("text.obj:2: A vertex needs three coordinates"));
  EXPECT_THAT(refusal_of("v 1 2 3 4 5 6 7 8 9\n"), HasSubstr("more than eight numbers"));
  // The line is the one the word stands on, also within a continued statement.
  EXPECT_THAT(refusal_of("v 1 2 3\nv 1 \\\n 2 \\\n oops\n"), StartsWith("text.obj:4: \"oops\""));
  EXPECT_THAT(refusal_of("v 1 2 3\rv 1 \\\r 2\\\r\roops\r"),
              StartsWith("text.obj:2: A vertex needs"));
}

TEST(ImportObj, BrokenVerticesInNoFaceAreLeftOutAndTold) {
  const ImportedMesh imported = import_text(kSquare + "v 1 2.5.5 0\nv 8 8 8\nv nan 0 0\nf 1 2 3\n");
  EXPECT_EQ(imported.mesh->vertex_count(), 3U);
  EXPECT_EQ(imported.report.count(MendKind::kLooseVertex), 2U);
  EXPECT_EQ(imported.mesh->attributes().loose_vertices.size(), 2U);
  EXPECT_EQ(imported.report.count(MendKind::kBrokenVertex), 2U);
  ASSERT_FALSE(imported.report.mends.empty());
  EXPECT_EQ(imported.report.mends.back().elements.at(0).place, 5U);
  EXPECT_EQ(imported.report.mends.back().elements.at(1).place, 7U);
}

TEST(ImportObj, NonFiniteCoordinatesAreErrorsWithTheirLine) {
  for (const char* number : {"nan", "-nan", "NaN", "inf", "-Infinity", "1e400", "-1e999"}) {
    EXPECT_THAT(refusal_of(kSquare + "# more\nv 0 " + std::string(number) + " 0\nf 1 2 5"),
                StartsWith("text.obj:6: This vertex has a coordinate that is not a finite number"))
        << number;
  }
}

TEST(ImportObj, MalformedFacesAreErrorsWithTheirLine) {
  const auto refuse_face = [](const std::string& face) { return refusal_of(kSquare + face); };
  EXPECT_THAT(refuse_face("f 1 2 3 0"), HasSubstr("text.obj:5: A face names vertex 0;"));
  EXPECT_THAT(refuse_face("f 1 2 -5"), HasSubstr("text.obj:5: A face names vertex -5, counted back "
                                                 "from here, but only 4 stand before it."));
  EXPECT_EQ(refuse_face("\n\nf 1 2 5\nf 9 9 9"),
            "text.obj:7: A face names vertex 5, but the file has 4 vertices.");
  EXPECT_THAT(refuse_face("f 1 2 3000000000"), HasSubstr("text.obj:5: A face names vertex "));
  EXPECT_THAT(refuse_face("f 1 2 99999999999999999999"), HasSubstr("is not a corner of a face"));
  EXPECT_THAT(refuse_face("f 1 2 -99999999999"), HasSubstr("counted back from here"));
  EXPECT_EQ(refuse_face("f"), "text.obj:5: This face has no corners.");
  EXPECT_EQ(refuse_face("\nf # 1 2 3"), "text.obj:6: This face has no corners.");
  EXPECT_THAT(refuse_face("f 1 2/1/1/1 3"), HasSubstr("more than three indices"));
  for (const char* corner : {"x", "1.5", "1/x", "1//x", "/1", "//", "1a", "+-1", "2,"}) {
    EXPECT_THAT(refuse_face("f 1 2 " + std::string(corner)),
                testing::AllOf(StartsWith("text.obj:5: "), HasSubstr("is not a corner of a face")))
        << corner;
  }
  EXPECT_THAT(refuse_face("f 1 2 \\\n 3 \\\n oops"), StartsWith("text.obj:7: "));
  EXPECT_THAT(refuse_face("f 1 2 2 1"),
              StartsWith("text.obj: There are no faces to paint on: 1 face had fewer"));
}

TEST(ImportObj, MessagesShowNoControlCharacters) {
  const std::string message = refusal_of("v 0 0 \x1B[31mred\xFF" + std::string(500, 'x') + "\n");
  EXPECT_EQ(message, "text.obj:1: \"?[31mred?xxxxxxxxxxxxxxxxxxxxxxx...\" is not a number.");
}

TEST(ImportObj, NothingIsLostInSilence) {
  const ImportedMesh imported = import_text(
      "mtllib missing.mtl\no box\n" + kSquare +
      "v 0 0 1 0.5\nv 1 0 1 0.1 0.2 0.3\nv 1 1 1 1\n"
      "vt 0 0 0.5\nvt 1 1\nvn 0 0 1\nvp 0.5\ng a b\nusemtl red\ns 1\nf 1 2 3 4\ns off\nf 5 6 2 1\n"
      "f 6 7 3 2\nl 1 2\nl 2 3\np 1\ncstype bspline\ndeg 3\ncurv 0 1 1 2\nend\nsurf 0 1 0 1 1 2\n"
      "t crease 2/1/0 0 1 2.0\nt crease 2/1/0 1 2 2.0\nt corner 1/1/0 0 3\n"
      "t interpolateboundary 1/0/0 0\nt hole 1/0/0 2\nt creasemethod 0/0/1 fancy\nfoo 1\nfoo "
      "2\nbevel on\n");
  EXPECT_THAT(
      imported.report.unused_data,
      ElementsAre("1 vertex weight", "1 vertex colour", "1 third texture coordinate", "1 normal",
                  "1 parameter-space point", "2 smoothing group statements", "2 line elements",
                  "1 point element", "3 free-form attributes", "1 free-form curve",
                  "1 free-form surface", "1 \"interpolateboundary\" tag", "1 \"hole\" tag",
                  "1 \"creasemethod\" tag", "2 \"foo\" statements", "1 display attribute",
                  "2 texture coordinates"));
  EXPECT_FALSE(imported.report.is_mended());
  EXPECT_EQ(imported.report.sentences().size(), imported.report.unused_data.size());
}

TEST(ImportObj, UnknownStatementsAreSummedUp) {
  std::string text = kSquare + "f 1 2 3 4\n";
  for (int i = 0; i < 500; ++i) {
    text += "word" + std::to_string(i) + " 1\n";
  }
  const ImportedMesh imported = import_text(text);
  ASSERT_EQ(imported.report.unused_data.size(), 9U);
  EXPECT_EQ(imported.report.unused_data[7], "1 \"word7\" statement");
  EXPECT_EQ(imported.report.unused_data[8], "492 other unknown statements");
}

TEST(ImportObj, MendsWithAReport) {
  const ImportedMesh imported = import_text(kSquare +
                                            "v 5 5 5\nv 2 1 0\nv 2 2 0\nf 1 2 3 3\nf 1 4 3\n"
                                            "f 3 6 7\n");
  EXPECT_EQ(faces_of(*imported.mesh), (Faces{{0, 1, 2}, {0, 2, 3}, {6, 4, 5}}));
  EXPECT_EQ(imported.mesh->positions()[4], glm::dvec3(2.0, 1.0, 0.0));
  EXPECT_EQ(imported.mesh->positions()[6], imported.mesh->positions()[2]);
  EXPECT_THAT(imported.report.sentences(),
              ElementsAre("1 corner of a face repeated the one before and was merged with it.",
                          "1 face was turned over to agree with the neighbours.",
                          "1 vertex was added where parts of the surface met in a single point or "
                          "edge.",
                          "1 vertex is in no face; it is kept aside and written back."));
}

TEST(ImportObj, RefusesWhatIsNoMesh) {
  EXPECT_THAT(refusal_of(""), HasSubstr("neither vertices nor faces"));
  EXPECT_THAT(refusal_of("\xEF\xBB\xBF"), HasSubstr("neither vertices nor faces"));
  EXPECT_THAT(refusal_of("\\\n\\"), HasSubstr("neither vertices nor faces"));
  EXPECT_THAT(refusal_of("# nothing\n"), HasSubstr("neither vertices nor faces"));
  EXPECT_THAT(refusal_of(kSquare + "l 1 2\n"),
              HasSubstr("text.obj: There are 4 vertices but no faces to paint on. What there is: "
                        "1 line element."));
  EXPECT_THAT(refusal_of("solid cube\nfacet normal 0 0 1\n"), HasSubstr("\"solid\" statement"));
  EXPECT_THAT(refusal_of(kSquare + std::string("f 1 2 3\0", 8)), HasSubstr("binary data"));
}

TEST(ImportObj, LongLinesAndPolygons) {
  std::string text;
  std::string face = "f";
  for (int i = 1; i <= 50000; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(i % 7) + " 0\n";
    face += " " + std::to_string(i) + (i % 10 == 0 ? " \\\n" : "");
  }
  EXPECT_EQ(import_text(text + face).mesh->face(0).size(), 50000U);
  EXPECT_THAT(refusal_of(text + face + " -60000\n"), StartsWith("text.obj:55001: "));
}

// Whatever happens to a text, the answer is a sound mesh or an error.
TEST(ImportObj, MutationsNeverBreakIt) {
  const std::string original =
      "# mixed\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0 1\nv 0 1 0\nv 0 0 1\nv 1 0 1 .5 .5 .5\n"
      "v 1 1 1\nv 0 1 1e0\nvt 0 0\nvn 0 0 1\ng a\nusemtl m\nf 4/1/1 3/1/1 2/1/1 1/1/1\n"
      "f 5//1 6//1 \\\n 7//1 8//1\nf 1 2 6 5\nf -7 -6 -2 -3\nf 3 4 8 7\nf 4 1 5\nf 4 5 8\n"
      "t crease 2/1/0 0 1 2.5\nt corner 2/2/0 3 7 1 2e1\nl 1 2\ns off\n";
  ASSERT_TRUE(import_obj(original, "o").has_value());
  const std::string alphabet("0123456789-+./ \t\n\r\\#vftnelxE\0\xFF", 30);
  std::mt19937 random(11);
  const auto pick = [&](std::size_t below) {
    return std::uniform_int_distribution<std::size_t>(0, below - 1)(random);
  };
  int accepted = 0;
  for (int round = 0; round < 8000; ++round) {
    std::string text = original;
    switch (round % 4) {
      case 0:
        text.resize(pick(text.size()));
        break;
      case 1:
        for (std::size_t i = 1 + pick(3); i > 0; --i) {
          text[pick(text.size())] = static_cast<char>(pick(256));
        }
        break;
      case 2:
        for (std::size_t i = 1 + pick(4); i > 0; --i) {
          text[pick(text.size())] = alphabet[pick(alphabet.size())];
        }
        break;
      default:
        text.insert(pick(text.size()), text.substr(pick(text.size()), pick(30)));
        text.erase(pick(text.size()), pick(10));
    }
    const auto imported = import_obj(text, "mutant");
    if (imported) {
      ++accepted;
      ASSERT_THAT(faults_of(*imported->mesh), IsEmpty()) << text;
    } else {
      ASSERT_EQ(imported.error().kind, ErrorKind::kBadInput) << text;
      ASSERT_FALSE(imported.error().message.empty());
    }
  }
  EXPECT_GT(accepted, 500);
  EXPECT_LT(accepted, 7500);
}

}  // namespace
}  // namespace limn
