#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace limn::test {

/// A folder for one test, removed with everything in it at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::filesystem::path operator/(std::string_view name) const {
    return path_ / name;
  }
  /// Path of a file in it, as text.
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// A file's bytes. Throws where it cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);
/// Throws where it cannot be written.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace limn::test
