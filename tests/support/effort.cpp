#include "support/effort.h"

namespace limn::test {

double effort() noexcept {
#if defined(__SANITIZE_THREAD__)
  return 0.1;  // Random meshes add little to what the tests of threads find, at ten times the cost.
#elif defined(LIMN_SANITIZED)
  return 0.25;
#else
  return 1.0;
#endif
}

}  // namespace limn::test
