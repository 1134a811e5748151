#pragma once

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "render/image.h"

namespace limn::test {

/// How two pictures of the same size differ.
struct ImageDifference {
  std::size_t pixels = 0;  ///< How many are not the same.
  int largest = 0;         ///< Largest difference of a channel, 0..255.
  render::Image image;     ///< Grey where they agree, red where not, the stronger the brighter.
};
[[nodiscard]] ImageDifference compare_images(const render::Image& a, const render::Image& b);

/// Whether the same scene, drawn by another processor, may differ so: at most a pixel in a
/// thousand, by up to 2 of 255. The software rasteriser compiles for the processor at hand, and
/// some round differently where the edges of lines and letters are blended: seen were 255 pixels of
/// four million, by up to 2.
[[nodiscard]] bool is_rounding(const ImageDifference& difference);

/// Whether a picture is tests/golden/NAME.png, but for rounding.
///
/// A missing golden fails and writes NAME.out.png beside it; a mismatch also writes NAME.diff.png.
/// With LIMN_UPDATE_GOLDENS=1 in the environment the golden is rewritten instead, unless it
/// matches: look at it.
[[nodiscard]] testing::AssertionResult matches_golden(const render::Image& image,
                                                      const std::string& name);

/// The same for any picture of the tree, by its path from the root: "docs/guide/start.png".
[[nodiscard]] testing::AssertionResult matches_picture(const render::Image& image,
                                                       const std::string& path);

/// The root of the tree.
[[nodiscard]] std::string source_folder();
/// Whether what was expected is to be rewritten: LIMN_UPDATE_GOLDENS=1.
[[nodiscard]] bool is_updating_goldens();

}  // namespace limn::test
