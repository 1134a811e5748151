// The bundled meshes are what the generator writes.
#include "limn/mesh/bundled.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <unistd.h>

namespace limn {
namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class GeneratedMeshes : public ::testing::Test {
 protected:
  GeneratedMeshes()
      : folder_(std::filesystem::temp_directory_path() /
                ("limn-generated-meshes-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~GeneratedMeshes() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

TEST_F(GeneratedMeshes, AreTheOnesInTheProgram) {
  const std::string command =
      std::string("'") + LIMN_GENERATE_MESHES + "' '" + folder_.string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    files += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(files, bundled_meshes().size());
  for (const BundledMesh& mesh : bundled_meshes()) {
    const std::string name = std::string(mesh.name) + ".obj";
    EXPECT_FALSE(mesh.description.empty()) << name;
    EXPECT_THAT(mesh.obj_text, ::testing::StartsWith("# ")) << name;
    EXPECT_EQ(read_file(folder_ / name), mesh.obj_text) << name;
    EXPECT_EQ(read_file(std::filesystem::path(LIMN_ASSETS) / "meshes" / name), mesh.obj_text)
        << name;
  }
}

}  // namespace
}  // namespace limn
