#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace limn::test {

struct ProgramRun {
  int exit_code = -1;  ///< 128 + the signal's number where a signal ended it.
  std::string out;
  std::string err;
};

/// Runs a program to its end, with `input` on its standard input, without a shell.
[[nodiscard]] ProgramRun run_program(const std::filesystem::path& program,
                                     const std::vector<std::string>& arguments,
                                     const std::string& input = {});

/// A folder for one test, removed with everything in it at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  /// Path of a file in it, as text.
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// A file's contents; a test failure where it cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace limn::test
