#include "round_trip.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  limn::fuzz::check_round_trip(limn::MeshFormat::kObj, data, size);
  return 0;
}
