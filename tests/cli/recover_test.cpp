// What brings work back: after a kill, and after another program had the mesh.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/recovery_store.h"
#include "cli/limn_program.h"
#include "limn/mesh/bundled.h"

namespace limn {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

TEST(Reattach, FindsFacesInAnotherOrder) {
  const test::ScratchFolder folder;
  const std::string project = folder.file("cube.limn");
  ASSERT_EQ(test::limn({"refine", "cube", "--paint", "faces=2:=3", "-o", project}).exit_code, 0);
  const auto mesh = load_bundled_mesh("cube").value().mesh;
  // As another program might write it: vertices and faces from the last to the first.
  std::string obj;
  for (std::size_t v = 8; v-- > 0;) {
    const glm::dvec3& p = mesh->positions()[v];
    obj +=
        "v " + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(p.z) + '\n';
  }
  for (std::size_t f = 6; f-- > 0;) {
    obj += 'f';
    for (const std::uint32_t corner : mesh->face(f)) {
      obj += ' ' + std::to_string(8 - corner);
    }
    obj += '\n';
  }
  test::write_file(folder / "other.obj", obj);
  const std::string out = folder.file("out.limn");
  const auto run = test::limn({"reattach", project, folder.file("other.obj"), "-o", out, "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("matched_by"), "vertices");
  EXPECT_TRUE(json.at("new_faces").empty());
  const Document document = load_project(out).value().document;
  EXPECT_EQ(document.depths[3], 3);
  EXPECT_EQ(document.mesh_path, folder.file("other.obj"));
  EXPECT_EQ(test::limn({"reattach", project, "none.obj"}).exit_code, 3);
  EXPECT_EQ(test::limn({"reattach", project, folder.file("other.obj"), "-o", "x.obj"}).exit_code,
            2);
}

TEST(Recover, ListsAndSavesWhatAKilledWindowLeft) {
  const test::ScratchFolder folder;
  ::setenv("XDG_STATE_HOME", folder.path().c_str(), 1);
  EXPECT_THAT(test::limn({"recover"}).out, HasSubstr("nothing to recover"));
  EXPECT_EQ(test::limn({"recover", "-o", folder.file("x.limn")}).exit_code, 1);
  Document document = make_document(load_bundled_mesh("cube").value(), "cube");
  document.depths.set(4, 2);
  {
    app::RecoveryStore store(folder / "limn/recovery");
    ASSERT_TRUE(store.keep(document, std::nullopt));
    EXPECT_EQ(Json::parse(test::limn({"recover", "--json"}).out), Json::array()) << "it lives";
  }
  EXPECT_EQ(Json::parse(test::limn({"recover", "--json"}).out).at(0).at("name"), "cube");
  const auto run = test::limn({"recover", "-o", folder.file("back.limn")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(load_project(folder / "back.limn").value().document.depths[4], 2);
  EXPECT_THAT(test::limn({"recover"}).out, HasSubstr("nothing to recover"));
  ::unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace limn
