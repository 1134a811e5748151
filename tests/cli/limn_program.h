#pragma once

#include "support/run_program.h"
#include "support/scratch_folder.h"

namespace limn::test {

/// Runs the program that is shipped.
inline ProgramRun limn(const std::vector<std::string>& arguments, const std::string& input = {}) {
  return run_program(LIMN_PROGRAM, arguments, input);
}

}  // namespace limn::test
