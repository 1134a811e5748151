#include <csignal>

#include "cli/command_line.h"

int main(int argc, char** argv) {
  // Beyond a limit on file sizes writing then fails, and is told, instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
  return limn::cli::run(argc, argv);
}
