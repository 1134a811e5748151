#include "support/effort.h"

namespace limn::test {

double effort() noexcept {
#ifdef LIMN_SANITIZED
  return 0.1;
#else
  return 1.0;
#endif
}

}  // namespace limn::test
