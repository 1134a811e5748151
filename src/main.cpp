#include "cli/command_line.h"

int main(int argc, char** argv) {
  return limn::cli::run(argc, argv);
}
