#pragma once

namespace limn::bench {

/// Adds to the report what it was measured on and with: processor, cores, memory, system, compiler,
/// the peers' versions.
void describe_machine();

}  // namespace limn::bench
