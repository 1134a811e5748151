#include "limn/contract.h"

#include <cstdio>
#include <cstdlib>

namespace limn {

void contract_broken(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "limn: internal error, please report it: %s does not hold (%s:%d)\n",
               condition, file, line);
  std::abort();
}

}  // namespace limn
