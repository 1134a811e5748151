#pragma once

#include <filesystem>

#include "limn/error.h"
#include "render/image.h"

namespace limn::render {

/// Writes a picture as an 8-bit RGBA PNG, atomically. Errors: kFailed, naming the path.
[[nodiscard]] Result<void> write_png(const std::filesystem::path& path, const Image& image);

/// Reads a PNG of any kind as RGBA. Errors: kBadInput, naming the path and what is wrong with it.
[[nodiscard]] Result<Image> read_png(const std::filesystem::path& path);

}  // namespace limn::render
