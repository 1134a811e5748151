#pragma once

#include <array>
#include <cstdint>

namespace limn {

/// An opaque sRGB colour.
struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  [[nodiscard]] bool operator==(const Rgb&) const = default;
};

/// The depths that have a colour of their own: 0..6, and 7 for 7 and more.
inline constexpr int kDepthColours = 8;

/// One colour a depth, ordered: CIE lightness falls evenly from depth 1 on, so the order is seen
/// also in grey print and by people with any of the three colour-vision deficiencies. Depth 0 is a
/// neutral clay, so that unpainted reads as unpainted.
[[nodiscard]] const std::array<Rgb, kDepthColours>& depth_palette() noexcept;

/// The colour of a depth >= 0; all from 7 on share one.
[[nodiscard]] Rgb depth_colour(int depth) noexcept;

/// Black or white, whichever is read better on this colour.
[[nodiscard]] Rgb text_colour_on(Rgb background) noexcept;

inline constexpr Rgb kIllegalColour{0xd0, 0x27, 0x8d};     ///< Illegal faces and vertices: magenta.
inline constexpr Rgb kRelabelledColour{0xf5, 0xa6, 0x23};  ///< Relabelled vertices: amber.
inline constexpr Rgb kAccentColour{0xf5, 0xa6, 0x23};      ///< Brush ring, focus: amber.

}  // namespace limn
