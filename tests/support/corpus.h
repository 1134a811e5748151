#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn::test {

/// The meshes of assets/meshes, sorted by name.
[[nodiscard]] std::vector<std::filesystem::path> bundled_mesh_files();

/// The folder of real and broken meshes, if this machine has one: $LIMN_CORPUS, or ../shared/corpus
/// beside the source tree. Tests that use it must say so and pass without it.
[[nodiscard]] std::optional<std::filesystem::path> corpus_folder();

/// Files under the corpus with this ending (".obj"), sorted.
[[nodiscard]] std::vector<std::filesystem::path> corpus_files(const std::string& ending);

}  // namespace limn::test
