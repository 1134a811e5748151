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

}  // namespace limn::test
