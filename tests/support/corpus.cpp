#include "support/corpus.h"

#include <algorithm>
#include <cstdlib>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_under(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ending) {
      found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::vector<fs::path> bundled_mesh_files() {
  return files_under(fs::path(LIMN_SOURCE_DIR) / "assets" / "meshes", ".obj");
}

std::optional<fs::path> corpus_folder() {
  if (const char* named = std::getenv("LIMN_CORPUS"); named != nullptr && *named != '\0') {
    return fs::path(named);
  }
  const fs::path beside = fs::path(LIMN_SOURCE_DIR) / ".." / "shared" / "corpus";
  if (fs::is_directory(beside)) {
    return fs::canonical(beside);
  }
  return std::nullopt;
}

std::vector<fs::path> corpus_files(const std::string& ending) {
  const auto folder = corpus_folder();
  return folder ? files_under(*folder, ending) : std::vector<fs::path>{};
}

}  // namespace limn::test
