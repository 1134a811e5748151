#pragma once

namespace limn {

/// Prints the broken contract on stderr and aborts. Called by LIMN_EXPECTS and LIMN_ASSERT alone.
[[noreturn]] void contract_broken(const char* condition, const char* file, int line);

}  // namespace limn

/// A precondition or invariant whose violation is a bug of the program, never of its input.
/// On in every build; use it where the check is cheap beside the work that follows.
#define LIMN_EXPECTS(condition) \
  ((condition) ? static_cast<void>(0) : ::limn::contract_broken(#condition, __FILE__, __LINE__))

/// An invariant that is too dear for release builds: checked where NDEBUG is not defined.
#ifdef NDEBUG
#define LIMN_ASSERT(condition) static_cast<void>(0)
#else
#define LIMN_ASSERT(condition) LIMN_EXPECTS(condition)
#endif
