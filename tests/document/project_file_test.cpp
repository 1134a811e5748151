#include "limn/document/project_file.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/project_fixture.h"
#include "limn/document/commands.h"
#include "limn/mesh/bundled.h"
#include "limn/mesh/import.h"
#include "support/scratch_folder.h"

namespace limn {
namespace {

using test::read_file;
using test::ScratchFolder;
using test::write_file;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using ProjectFile = test::ProjectFixture;
using test::expect_same_document;
using test::opened;

TEST_F(ProjectFile, ComesBackAsItWas) {
  for (const std::string_view name : {"cube", "icosahedron", "mixed", "grid", "torus_open"}) {
    Document document = opened(name);
    document.name = "B\xC3\xA4r \"quoted\" \\ \n";
    document.mesh_path = "/some where/\xC3\xA4.obj";
    for (std::size_t f = 0; f < document.depths.size(); ++f) {
      document.depths.set(f, static_cast<int>(f * 7 % (kMaxDepth + 1)));
    }
    document.settings = {.non_quads = NonQuadRule::kWherePainted,
                         .legalisation = name == "cube" ? LegalisationMethod::kGreedy
                                                        : LegalisationMethod::kLookAhead,
                         .corners = CornerRule::kSmooth};
    document.stage = {true, 3};
    const ViewState view{{0.1, -1e-30, 3e10}, 1.0 / 3.0, 725.5, -89.9, 20.0, true};
    ASSERT_TRUE(save_project(path_, document, view));
    const Result<Project> loaded = load_project(path_);
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    expect_same_document(document, loaded->document);
    EXPECT_EQ(loaded->view, view);
    EXPECT_EQ(loaded->document.project_path, path_);

    // And saving it again gives the same bytes.
    const std::string text = read_file(path_);
    ASSERT_TRUE(save_project(path_, loaded->document, loaded->view));
    EXPECT_EQ(read_file(path_), text);
  }
}

TEST_F(ProjectFile, WithoutAViewAndWithAllLevels) {
  Document document = opened("cube");
  document.stage = {false, kAllLevels};
  ASSERT_TRUE(save_project(path_, document, std::nullopt));
  const Project loaded = load_project(path_).value();
  expect_same_document(document, loaded.document);
  EXPECT_FALSE(loaded.view);
}

TEST_F(ProjectFile, AwkwardNumbersComeBackBitForBit) {
  std::mt19937_64 random(1985);
  for (int round = 0; round < 50; ++round) {
    PolygonSoup soup;
    for (int v = 0; v < 4; ++v) {
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis) {
        const double mantissa = std::uniform_real_distribution<>(-1.0, 1.0)(random);
        p[axis] = std::ldexp(mantissa, static_cast<int>(random() % 258) - 200);
      }
      soup.positions.push_back(p);
    }
    soup.positions[0].x = -0.0;
    soup.positions[1].y = 9007199254740993.0 * static_cast<double>(1 + random() % 100);
    soup.positions[2].z = 1e17;
    const std::vector<std::uint32_t> corners{2, 3, 0, 1};
    soup.add_face(corners);
    const Document document = make_document(build_control_mesh(soup).value(), "numbers");
    ASSERT_TRUE(save_project(path_, document, std::nullopt));
    const Result<Project> loaded = load_project(path_);
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    expect_same_document(document, loaded->document);
  }
}

TEST_F(ProjectFile, KeepsTheOpenedMeshForRevert) {
  Document document = opened("cube");
  replace_control_command(load_bundled_mesh("grid").value().mesh, "apply")->apply(document);
  document.depths.set(17, 2);
  ASSERT_TRUE(save_project(path_, document, std::nullopt));
  Document loaded = load_project(path_).value().document;
  expect_same_document(document, loaded);
  revert_command()->apply(loaded);
  EXPECT_EQ(loaded.control->face_count(), 6U);
  EXPECT_EQ(loaded.depths.size(), 6U);
}

TEST_F(ProjectFile, NamesThatAreNotUtf8DoNotBreakTheFile) {
  Document document = opened("cube");
  document.name = "caf\xE9";
  document.mesh_path = "/tmp/caf\xE9.obj";
  ASSERT_TRUE(save_project(path_, document, std::nullopt));
  const Project loaded = load_project(path_).value();
  EXPECT_EQ(loaded.document.name, "caf\xEF\xBF\xBD");
  EXPECT_EQ(loaded.document.mesh_path, "");
}

TEST_F(ProjectFile, OtherMembersArePassedOver) {
  EXPECT_EQ(complaint_with("\"version\": 1,",
                           "\"version\": 1, \"made_by\": {\"mesh\": [1, {\"faces\": [2]}]}, "
                           "\"mesh/positions\": [],"),
            "was loaded");
}

TEST_F(ProjectFile, WithoutALegalisationWasMadeWithTheGreedy) {
  std::string text = cube_text();
  const std::string_view member = "\"legalisation\": \"greedy\",";
  const std::size_t at = text.find(member);
  ASSERT_NE(at, std::string::npos);
  ASSERT_EQ(complaint(text.erase(at, member.size())), "was loaded");
  const Result<Project> loaded = load_project(path_);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->document.settings.legalisation, LegalisationMethod::kGreedy);
}

TEST_F(ProjectFile, SaysWhereTheTextIsNotJson) {
  EXPECT_THAT(complaint(""), HasSubstr("empty"));
  EXPECT_THAT(complaint(" \n "), HasSubstr("empty"));
  EXPECT_THAT(complaint("v 0 0 0\nf 1 2 3\n"), HasSubstr("JSON"));
  EXPECT_EQ(line_, 1U);
  const std::string text = cube_text();
  complaint(text.substr(0, text.size() / 2));
  EXPECT_GT(line_, 10U);
  EXPECT_THAT(complaint_with("\"mesh\": {", "\"mesh\": {,"), HasSubstr("/mesh"));
  EXPECT_THAT(complaint_with("\"distance\": 3", "\"distance\": NaN"), HasSubstr("/view/distance"));
  EXPECT_THAT(complaint_with("\"distance\": 3", "\"distance\": 1e999"), HasSubstr("1e999"));
  EXPECT_THAT(complaint(text + "x"), HasSubstr("JSON"));
  EXPECT_LT(complaint("{\"format\": \"" + std::string(1000000, 'x')).size(), 500U);
}

TEST_F(ProjectFile, RefusesWhatIsNotAProject) {
  EXPECT_THAT(complaint("{}"), StartsWith("/format: "));
  EXPECT_THAT(complaint("[1, 2, 3]"), StartsWith("/format: "));
  EXPECT_THAT(complaint("17"), StartsWith("/format: "));
  EXPECT_THAT(complaint("null"), StartsWith("/format: "));
  EXPECT_THAT(complaint_with("limn-project", "limn-brush"), HasSubstr("no Limn project"));
}

TEST_F(ProjectFile, RefusesNewerVersionsBeforeAnythingElse) {
  EXPECT_THAT(complaint_with("\"version\": 1", "\"version\": 6"), HasSubstr("newer"));
  EXPECT_THAT(complaint_with("\"version\": 1", "\"version\": 0"), StartsWith("/version: "));
  EXPECT_THAT(complaint_with("\"version\": 1", "\"version\": \"1\""), StartsWith("/version: "));
  EXPECT_THAT(complaint_with("\"version\": 1,", ""), StartsWith("/version: "));
  // What a newer version means by its lists is not ours to judge, even where they come first.
  EXPECT_THAT(complaint("{\"depths\": [{}], \"format\": \"limn-project\", \"version\": 99}"),
              HasSubstr("newer"));
}

TEST_F(ProjectFile, NamesTheCulpritAmongTheDepths) {
  const auto with = [&](std::string_view depths) {
    return complaint_with("[0, 0, 0, 5, 0, 0]", depths);
  };
  EXPECT_EQ(with("[0, 0, 0, 10, 0, 0]"), "was loaded");
  EXPECT_THAT(with("[0, 0, 0, 11, 0, 0]"), StartsWith("/depths/3: "));
  EXPECT_THAT(with("[0, 0, 0, 0, 0, -1]"), StartsWith("/depths/5: "));
  EXPECT_THAT(with("[0, 1.0, 0, 0, 0, 0]"), StartsWith("/depths/1: "));
  EXPECT_THAT(with("[true, 0, 0, 0, 0, 0]"), StartsWith("/depths/0: "));
  EXPECT_THAT(with("[0, 0, \"1\", 0, 0, 0]"), StartsWith("/depths/2: "));
  EXPECT_THAT(with("[0, 0, 0, 0, null, 0]"), StartsWith("/depths/4: "));
  EXPECT_THAT(with("[0, 0, [0], 0, 0, 0]"), StartsWith("/depths/2: "));
  EXPECT_THAT(with("[0, 0, {}, 0, 0, 0]"), StartsWith("/depths/2: "));
  EXPECT_THAT(with("[0, 0, 256, 0, 0, 0]"), StartsWith("/depths/2: "));
  EXPECT_THAT(with("[0, 0, 18446744073709551616, 0, 0, 0]"), StartsWith("/depths/2: "));
  EXPECT_THAT(with("[0, 0, 0, 0, 0]"), HasSubstr("5 entries for 6 faces"));
  EXPECT_THAT(with("[0, 0, 0, 0, 0, 0, 0]"), HasSubstr("7 entries for 6 faces"));
  EXPECT_THAT(with("6"), StartsWith("/depths: must be a list"));
  EXPECT_THAT(with("{\"0\": 1}"), StartsWith("/depths: must be a list"));
  EXPECT_THAT(with("[0, 0, 0, 0, 0, 0], \"depths\": [0, 0, 0, 0, 0, 0]"), HasSubstr("twice"));
}

TEST_F(ProjectFile, NamesTheCulpritInTheMesh) {
  const std::string text = cube_text();
  const std::size_t first = text.find('[', text.find("\"positions\"") + 14);
  const std::string position = text.substr(first, text.find(']', first) - first + 1);
  EXPECT_THAT(complaint_with(position, "[1, 2]"), StartsWith("/mesh/positions/0: has 2"));
  EXPECT_THAT(complaint_with(position, "[1, 2, 3, 4]"), StartsWith("/mesh/positions/0: has 4"));
  EXPECT_THAT(complaint_with(position, "7"), StartsWith("/mesh/positions/0: "));
  EXPECT_THAT(complaint_with(position, "[1, \"2\", 3]"), StartsWith("/mesh/positions/0/1: "));
  EXPECT_THAT(complaint_with(position, "[1, 2, null]"), StartsWith("/mesh/positions/0/2: "));
  EXPECT_THAT(complaint_with(position, "[1, 2, [3]]"), StartsWith("/mesh/positions/0/2: "));
  EXPECT_THAT(complaint_with(position, "[[1, 2, 3]]"), StartsWith("/mesh/positions/0/0: "));
  EXPECT_THAT(complaint_with(position, "{\"x\": 1}"), StartsWith("/mesh/positions/0: "));

  const std::size_t faces = text.find('[', text.find("\"faces\"") + 10);
  const std::string face = text.substr(faces, text.find(']', faces) - faces + 1);
  EXPECT_THAT(complaint_with(face, "[0, 1, 2, 8]"), StartsWith("/mesh/faces/0/3: "));
  EXPECT_THAT(complaint_with(face, "[0, 1, -2, 3]"), StartsWith("/mesh/faces/0/2: "));
  EXPECT_THAT(complaint_with(face, "[0, 1.5, 2, 3]"), StartsWith("/mesh/faces/0/1: "));
  EXPECT_THAT(complaint_with(face, "[0, 1, 4294967296]"), StartsWith("/mesh/faces/0/2: "));
  EXPECT_THAT(complaint_with(face, "[0, 1]"), StartsWith("/mesh/faces/0: has 2"));
  EXPECT_THAT(complaint_with(face, "[]"), StartsWith("/mesh/faces/0: has 0"));
  EXPECT_THAT(complaint_with(face, "[0, 1, 1, 0]"), StartsWith("/mesh: "));
  EXPECT_THAT(complaint_with("\"faces\"", "\"fases\""), StartsWith("/mesh/faces: is missing"));
  EXPECT_THAT(complaint_with("\"positions\"", "\"p\""), StartsWith("/mesh/positions: is missing"));
  EXPECT_THAT(complaint_with("\"mesh\"", "\"mash\""), StartsWith("/mesh: is missing"));
}

TEST_F(ProjectFile, RefusesAMeshThatWouldHaveToBeMended) {
  const std::string text = cube_text();
  const std::size_t faces = text.find('[', text.find("\"faces\"") + 10);
  std::string face = text.substr(faces, text.find(']', faces) - faces + 1);
  // The other way round: its neighbours disagree, and mending would turn it.
  std::string turned = face;
  std::swap(turned[1], turned[10]);
  std::swap(turned[4], turned[7]);
  ASSERT_NE(turned, face);
  EXPECT_THAT(complaint_with(face, turned), StartsWith("/mesh: is damaged"));
  // A vertex in no face, which an import would drop.
  EXPECT_THAT(complaint_with("\"positions\": [", "\"positions\": [[9, 9, 9],"),
              StartsWith("/mesh: "));
  // Without any face.
  EXPECT_THAT(complaint("{\"format\": \"limn-project\", \"version\": 1, \"name\": \"\", "
                        "\"mesh_path\": \"\", \"settings\": {\"non_quads\": \"where-painted\", "
                        "\"legalisation\": \"greedy\", \"corners\": \"sharp\"}, \"stage\": "
                        "{\"legalised\": false, \"levels\": 0}, \"depths\": [], \"mesh\": "
                        "{\"positions\": [], \"faces\": []}}"),
              StartsWith("/mesh: "));
}

TEST_F(ProjectFile, NamesTheCulpritInTheRest) {
  EXPECT_THAT(complaint_with("\"uniform-first-step\"", "\"never\""),
              HasSubstr("/settings/non_quads: must be one of \"uniform-first-step\""));
  EXPECT_THAT(complaint_with("\"greedy\"", "7"), StartsWith("/settings/legalisation: "));
  EXPECT_THAT(complaint_with("\"greedy\"", "\"lavish\""),
              HasSubstr("/settings/legalisation: must be one of \"greedy\", \"look-ahead\""));
  EXPECT_THAT(complaint_with("\"settings\": {", "\"settings\": [], \"old\": {"),
              StartsWith("/settings: must be an object"));
  EXPECT_THAT(complaint_with("\"legalised\": false", "\"legalised\": 0"),
              StartsWith("/stage/legalised: "));
  EXPECT_THAT(complaint_with("\"levels\": 0", "\"levels\": -1"), StartsWith("/stage/levels: "));
  EXPECT_THAT(complaint_with("\"levels\": 0", "\"levels\": 256"), StartsWith("/stage/levels: "));
  EXPECT_THAT(complaint_with("\"levels\": 0", "\"levels\": \"most\""),
              StartsWith("/stage/levels: "));
  EXPECT_THAT(complaint_with("\"levels\": 0", "\"levels\": 0.5"), StartsWith("/stage/levels: "));
  EXPECT_THAT(complaint_with("\"name\": \"cube\"", "\"name\": 3"), StartsWith("/name: "));
  EXPECT_THAT(complaint_with("\"name\": \"cube\"", "\"name\": \"a\\u0000b\""),
              HasSubstr("zero byte"));
  EXPECT_THAT(complaint_with("\"name\": \"cube\",", ""), StartsWith("/name: is missing"));
  EXPECT_THAT(complaint_with("\"name\": \"cube\"", "\"name\": \"a\", \"name\": \"b\""),
              HasSubstr("twice"));
  EXPECT_THAT(complaint_with("\"pitch\": 0", "\"pitch\": 91"), StartsWith("/view/pitch: 91"));
  EXPECT_THAT(complaint_with("\"distance\": 3", "\"distance\": 0"), StartsWith("/view/distance"));
  EXPECT_THAT(complaint_with("\"view\": {", "\"view\": 3, \"old\": {"), StartsWith("/view: "));
}

TEST_F(ProjectFile, RefusesDeepNesting) {
  EXPECT_THAT(complaint(std::string(1000000, '[')), HasSubstr("nested"));
  std::string objects;
  for (int i = 0; i < 100000; ++i) {
    objects += "{\"a\":";
  }
  EXPECT_THAT(complaint(objects), HasSubstr("nested"));
  EXPECT_THAT(complaint("{\"depths\": " + std::string(100000, '[')), HasSubstr("nested"));
}

TEST_F(ProjectFile, ManyEntriesDoNotFillTheMemory) {
  std::string text = "{\"format\": \"limn-project\", \"version\": 1, \"view\": [";
  for (int i = 0; i < 100000; ++i) {
    text += "0,";
  }
  EXPECT_THAT(complaint(text + "0]}"), HasSubstr("one entry too many"));
}

TEST_F(ProjectFile, RefusesWhatIsNoRegularFile) {
  const auto refused = [](const std::filesystem::path& path) {
    const Result<Project> project = load_project(path);
    EXPECT_FALSE(project);
    EXPECT_EQ(project.error().kind, ErrorKind::kBadInput);
    return project.error().message;
  };
  EXPECT_THAT(refused(folder_ / "missing.limn"), HasSubstr("no such file"));
  EXPECT_THAT(refused(folder_.path()), HasSubstr("folder"));
  EXPECT_THAT(refused("/dev/zero"), HasSubstr("not a regular file"));
  const std::filesystem::path pipe = folder_ / "pipe.limn";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refused(pipe), HasSubstr("not a regular file"));  // And does not wait for a writer.
  const std::filesystem::path huge = folder_ / "huge.limn";
  write_file(huge, "{");
  std::filesystem::resize_file(huge, std::uintmax_t{1} << 40U);  // Sparse: takes no room.
  EXPECT_THAT(refused(huge), HasSubstr("files of up to 1 GiB are read"));
}

TEST_F(ProjectFile, AFailedSaveLeavesTheOldFile) {
  cube_text();
  const std::string before = read_file(path_);
  ViewState nowhere;
  nowhere.distance = std::nan("");
  const Result<void> saved = save_project(path_, opened("grid"), nowhere);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().kind, ErrorKind::kFailed);
  EXPECT_EQ(read_file(path_), before);
  EXPECT_FALSE(save_project(folder_ / "no/such/folder.limn", opened("cube"), std::nullopt));
}

/// However a project is damaged, loading it gives an error or a document that holds together.
TEST_F(ProjectFile, DamagedProjectsAreRefusedOrWhole) {
  Document document = opened("mixed");
  document.depths.set(7, 3);
  ASSERT_TRUE(save_project(path_, document, ViewState{}));
  const std::string mixed = test::without_checksum(read_file(path_));
  const std::string cube = cube_text();
  const std::string_view pieces = "0123456789[]{},:\"-.eEtfn \\u\n\xFF\x80";
  std::mt19937 random(23);
  int loaded_count = 0;
  for (int round = 0; round < 2500; ++round) {
    std::string text = round % 4 == 0 ? mixed : cube;
    switch (random() % 4) {
      case 0:
        text.resize(random() % text.size());
        break;
      case 1: {
        char& byte = text[random() % text.size()];
        byte = static_cast<char>(byte ^ (1 << random() % 8));
        break;
      }
      case 2:
        text.insert(random() % text.size(), 1, pieces[random() % pieces.size()]);
        break;
      default:
        text.erase(random() % text.size(), 1 + random() % 20);
    }
    const Result<Project> project = parse_project(text, "damaged");
    if (!project) {
      ASSERT_EQ(project.error().kind, ErrorKind::kBadInput);
      ASSERT_FALSE(project.error().message.empty());
      continue;
    }
    ++loaded_count;
    const Document& loaded = project->document;
    ASSERT_EQ(loaded.depths.size(), loaded.control->face_count());
    ASSERT_NE(loaded.opened, nullptr);
    ASSERT_LE(loaded.depths.deepest(), kMaxDepth);
    if (loaded_count % 20 == 0) {
      ASSERT_TRUE(save_project(folder_ / "again.limn", loaded, project->view));
    }
  }
  EXPECT_GT(loaded_count, 0);
  EXPECT_LT(loaded_count, 2000);
}

}  // namespace
}  // namespace limn
