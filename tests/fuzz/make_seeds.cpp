// Writes the inputs that fuzzing starts from: one folder for each target under the folder that is
// given.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "limn/document/project_file.h"
#include "limn/mesh/bundled.h"
#include "support/hostile_files.h"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

void write_meshes(const fs::path& folder, const std::vector<limn::test::HostileFile>& files) {
  constexpr std::size_t longest = 4096;
  for (const limn::test::HostileFile& file : files) {
    const std::string ending = fs::path(file.name).extension().string();
    if (file.bytes.size() <= longest && ending.size() == 4) {
      write(folder / ending.substr(1) / file.name, file.bytes);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    return 2;
  }
  const fs::path folder = argv[1];
  write_meshes(folder, limn::test::sound_files());
  write_meshes(folder, limn::test::hostile_files());
  const auto cube = limn::load_bundled_mesh("cube");
  std::ostringstream project;
  limn::write_project(project, limn::make_document(*cube, "cube"), std::nullopt);
  write(folder / "project" / "cube.limn", project.str());
  return 0;
}
