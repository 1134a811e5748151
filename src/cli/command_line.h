#pragma once

namespace limn::cli {

/// The whole program: reads the command line, does what it says, returns the exit code
/// (0 done, 1 failed, 2 usage, 3 bad input, 4 over budget, 130 cancelled).
int run(int argc, char** argv);

}  // namespace limn::cli
