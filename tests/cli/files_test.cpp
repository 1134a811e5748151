// Formats, validation and many files at once.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn/mesh/bundled.h"
#include "limn/mesh/import.h"
#include "limn_program.h"
#include "support/mesh_difference.h"

namespace limn::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Convert, ThroughEveryFormat) {
  const ScratchFolder scratch;
  const auto cube = load_bundled_mesh("cube")->mesh;
  for (const std::string name : {"a.ply", "b.OFF", "c.obj", "d.limn"}) {
    const ProgramRun run = limn({"convert", "cube", scratch.file(name)});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, IsEmpty());
    const ProgramRun back = limn({"convert", scratch.file(name), "-", "--format", "ply"});
    const auto again = import_bytes(back.out, {}, name);
    ASSERT_TRUE(again.has_value()) << to_string(again.error());
    EXPECT_EQ(difference(*cube, *again->mesh), "");
  }
  const ProgramRun stl = limn({"convert", "cube", scratch.file("e.stl")});
  EXPECT_THAT(stl.err, HasSubstr("STL files do not hold: 6 faces that are no triangles"));
  EXPECT_EQ(import_mesh(scratch.file("e.stl"))->mesh->face_count(), 12U);
}

TEST(Convert, ReadsStandardInputWhateverItIs) {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const ProgramRun run = limn({"convert", "-", "-", "--format", "ply", "--ascii"}, off);
  EXPECT_THAT(run.out, HasSubstr("format ascii 1.0\nelement vertex 3\n"));
  EXPECT_EQ(limn({"convert", "-", "-", "--format", "off"}, run.out).out, off);
}

TEST(Convert, MistakesAreUsageErrors) {
  EXPECT_EQ(limn({"convert", "cube", "out.xyz"}).exit_code, 2);
  EXPECT_EQ(limn({"convert", "cube"}).exit_code, 2);
  EXPECT_EQ(limn({"convert", "missing.obj", "-"}).exit_code, 3);
  EXPECT_EQ(limn({"convert", "cube", "/nowhere/at/all.ply"}).exit_code, 1);
}

TEST(Convert, DepthsGoAlong) {
  const ScratchFolder scratch;
  ASSERT_EQ(limn({"refine", "cube", "--paint", "faces=0:=2", "--levels", "0", "-o",
                  scratch.file("painted.obj")})
                .exit_code,
            0);
  EXPECT_THAT(read_file(scratch.file("painted.obj")), HasSubstr("usemtl depth_2\nf "));
  EXPECT_THAT(read_file(scratch.file("limn_depths.mtl")), HasSubstr("newmtl depth_2\nKd 0."));
  ASSERT_EQ(limn({"convert", scratch.file("painted.obj"), scratch.file("painted.ply")}).exit_code,
            0);
  const auto painted = import_mesh(scratch.file("painted.ply"));
  EXPECT_THAT(painted->depths, testing::ElementsAre(2, 0, 0, 0, 0, 0));
}

/// A cube with one face turned over.
std::string bent_cube(const ScratchFolder& scratch) {
  std::string text = limn({"convert", "cube", "-"}).out;
  text.replace(text.find("f 1 5 7 3"), 9, "f 3 7 5 1");
  write_file(scratch.file("bent.obj"), text);
  return scratch.file("bent.obj");
}

TEST(Validate, TellsWhatWasMendedAndWhere) {
  const ScratchFolder scratch;
  const std::string bent = bent_cube(scratch);
  const ProgramRun run = limn({"validate", "cube", bent});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr("cube: sound, 8 vertices, 6 faces in 1 part, closed\n"));
  EXPECT_THAT(run.out, HasSubstr("mended"));
  EXPECT_THAT(run.out, HasSubstr("1 face was turned over"));
  EXPECT_THAT(run.out, HasSubstr("    line 9 at -1 0 0\n"));

  const Json report = Json::parse(limn({"validate", bent, "--json"}).out);
  EXPECT_EQ(report["mends"][0]["kind"], "flipped_faces");
  EXPECT_EQ(report["mends"][0]["elements"][0]["face"], 0);
}

TEST(Validate, StrictlyRefusesWhatWouldBeMended) {
  const ScratchFolder scratch;
  const std::string bent = bent_cube(scratch);
  EXPECT_EQ(limn({"validate", "cube", "--strict"}).exit_code, 0);
  EXPECT_EQ(limn({"validate", bent, "--strict"}).exit_code, 3);
  EXPECT_EQ(limn({"convert", bent, "-", "--strict"}).exit_code, 3);
  const ProgramRun both = limn({"validate", bent, "cube", "--strict", "--json"});
  EXPECT_EQ(both.exit_code, 3);
  const Json report = Json::parse(both.out);
  EXPECT_EQ(report[0]["ok"], false);
  EXPECT_EQ(report[0]["error"]["line"], 9);
  EXPECT_EQ(report[1]["ok"], true);
}

TEST(Refine, ManyFilesGoOnPastABadOne) {
  const ScratchFolder scratch;
  write_file(scratch.file("bad.obj"), "junk\n");
  const ProgramRun run =
      limn({"refine", "cube", scratch.file("bad.obj"), "missing.ply", "grid", "--paint", "all:=1",
            "--output-folder", scratch.file("out"), "--format", "ply", "--json"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("bad.obj: There are neither vertices nor faces"));
  EXPECT_THAT(run.err, HasSubstr("2 of 4 files failed"));
  const Json report = Json::parse(run.out);
  ASSERT_EQ(report.size(), 4U);
  EXPECT_EQ(report[0]["faces"], 24);
  EXPECT_EQ(report[1]["error"]["exit_code"], 3);
  EXPECT_EQ(report[3]["ok"], true);
  EXPECT_EQ(import_mesh(scratch.file("out/cube-refined.ply"))->mesh->face_count(), 24U);
  EXPECT_TRUE(import_mesh(scratch.file("out/grid-refined.ply")).has_value());
}

TEST(Refine, ManyFilesNeedAFolder) {
  EXPECT_EQ(limn({"refine", "cube", "grid", "-o", "out.obj"}).exit_code, 2);
  EXPECT_EQ(limn({"refine", "cube", "a/cube.obj", "--output-folder", "x"}).exit_code, 2);
  EXPECT_EQ(limn({"refine", "cube", "-o", "a.obj", "--output-folder", "x"}).exit_code, 2);
  const ProgramRun numbers = limn({"refine", "cube", "grid", "--paint", "all:=1"});
  EXPECT_EQ(numbers.exit_code, 0);
  EXPECT_THAT(numbers.err, testing::AllOf(HasSubstr("cube\n"), HasSubstr("grid\n")));
}

}  // namespace
}  // namespace limn::test
