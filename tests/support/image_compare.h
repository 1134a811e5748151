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

/// Whether a picture is, pixel for pixel, tests/golden/NAME.png.
///
/// A missing golden fails and writes NAME.out.png beside it; a mismatch also writes NAME.diff.png.
/// With LIMN_UPDATE_GOLDENS=1 in the environment the golden is rewritten instead: look at it.
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
