#pragma once

#include <concepts>
#include <cstdint>
#include <string>

namespace limn::ui {

/// "12,480".
[[nodiscard]] std::string grouped(std::uint64_t count);
template <std::signed_integral T>
[[nodiscard]] std::string grouped(T count) {
  return count < 0 ? "-" + grouped(std::uint64_t{0} - static_cast<std::uint64_t>(count))
                   : grouped(static_cast<std::uint64_t>(count));
}

/// "1,204 faces", "1 face": the count with its noun, which takes an s but after 1; give
/// `plural` where that is wrong ("vertices").
[[nodiscard]] std::string counted(std::uint64_t count, const char* noun,
                                  const char* plural = nullptr);

/// "812 B", "1.4 MB": three figures at most, units of 1000.
[[nodiscard]] std::string bytes_text(std::uint64_t bytes);

/// "16 µs", "0.4 ms", "12 ms", "3.2 s".
[[nodiscard]] std::string seconds_text(double seconds);

/// part / whole as "31 %"; "0.4 %" under one; "–" where whole is 0.
[[nodiscard]] std::string percent_text(double part, double whole);

/// "0.00123", "1.2e-06": three figures.
[[nodiscard]] std::string distance_text(double distance);
/// A distance as a part of the mesh's diagonal: "0.052 %".
[[nodiscard]] std::string diagonal_text(double distance, double diagonal);

}  // namespace limn::ui
