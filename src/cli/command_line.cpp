#include "cli/command_line.h"

namespace limn::cli {

int run(int, char**) {
  return 2;
}

}  // namespace limn::cli
