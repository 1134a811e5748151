#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "limn/subdivision/schemes/uniform.h"

namespace limn::ui {

/// A scheme with its choices in one word, as actions carry it: "loop", "loop:warren",
/// "linear:averaged". Corner rules are not in it.
[[nodiscard]] std::string scheme_word(const SchemeSettings& settings);
/// Reads what `scheme_word` writes; nothing for anything else.
[[nodiscard]] std::optional<SchemeSettings> scheme_from_word(std::string_view word);

/// "Loop, Warren's weights": for lists and captions.
[[nodiscard]] std::string scheme_title(const SchemeSettings& settings);

/// What a person should know before choosing it, a sentence a line.
[[nodiscard]] std::string scheme_description(const SchemeSettings& settings);

/// Every scheme with every choice it has, in the order of `schemes()`.
[[nodiscard]] std::span<const SchemeSettings> scheme_variants();

/// "Triangulate": what a fitting is called on a button.
[[nodiscard]] std::string_view fitting_label(Fitting fitting) noexcept;

}  // namespace limn::ui
