// Figures for people: always grouped by thousands, so that a column of them lines up.

#include "ui/format.h"

#include <fmt/format.h>

#include <array>

namespace limn::ui {

std::string grouped(std::uint64_t count) {
  std::string text = fmt::to_string(count);
  for (std::size_t end = text.size(); end > 3; end -= 3) {
    text.insert(end - 3, 1, ',');
  }
  return text;
}

std::string counted(std::uint64_t count, const char* noun, const char* plural) {
  std::string text = grouped(count) + ' ';
  if (count == 1) {
    return text + noun;
  }
  return plural != nullptr ? text + plural : text + noun + 's';
}

std::string bytes_text(std::uint64_t bytes) {
  if (bytes < 1000) {
    return fmt::format("{} B", bytes);
  }
  constexpr std::array<const char*, 6> kUnits{"kB", "MB", "GB", "TB", "PB", "EB"};
  double value = static_cast<double>(bytes) / 1000.0;
  std::size_t unit = 0;
  while (value >= 999.5 && unit + 1 < kUnits.size()) {
    value /= 1000.0;
    ++unit;
  }
  return fmt::format(fmt::runtime(value < 9.95 ? "{:.1f} {}" : "{:.0f} {}"), value, kUnits[unit]);
}

std::string seconds_text(double seconds) {
  if (seconds < 0.00009995) {
    return fmt::format("{:.0f} µs", seconds * 1.0e6);
  }
  if (seconds < 0.00995) {
    return fmt::format("{:.1f} ms", seconds * 1000.0);
  }
  if (seconds < 0.9995) {
    return fmt::format("{:.0f} ms", seconds * 1000.0);
  }
  return fmt::format(fmt::runtime(seconds < 9.95 ? "{:.1f} s" : "{:.0f} s"), seconds);
}

std::string percent_text(double part, double whole) {
  if (whole <= 0.0) {
    return "–";
  }
  const double percent = 100.0 * part / whole;
  return fmt::format(fmt::runtime(percent > 0.0 && percent < 0.95 ? "{:.1f} %" : "{:.0f} %"),
                     percent);
}

std::string distance_text(double distance) {
  return fmt::format("{:.3g}", distance);
}

std::string diagonal_text(double distance, double diagonal) {
  return diagonal > 0.0 ? fmt::format("{:.3g} %", 100.0 * distance / diagonal) : "–";
}

}  // namespace limn::ui
