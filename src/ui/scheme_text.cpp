#include "ui/scheme_text.h"

#include <vector>

#include <fmt/format.h>

namespace limn::ui {
namespace {

constexpr std::string_view kWarren = ":warren";
constexpr std::string_view kAveraged = ":averaged";

/// The choice behind the scheme's name; empty for the first one.
std::string_view choice_word(const SchemeSettings& settings) {
  if (settings.scheme == Scheme::kLoop && settings.weights == LoopWeights::kWarren) {
    return kWarren;
  }
  return settings.scheme == Scheme::kLinear && settings.averages ? kAveraged : "";
}

std::string_view choice_title(const SchemeSettings& settings) {
  if (settings.scheme == Scheme::kLoop) {
    return settings.weights == LoopWeights::kWarren ? ", Warren's weights" : ", original weights";
  }
  if (settings.scheme == Scheme::kLinear) {
    return settings.averages ? ", averaged" : ", split only";
  }
  return "";
}

std::string_view faces_taken(FaceKinds kinds) {
  switch (kinds) {
    case FaceKinds::kTriangles:
      return "triangles";
    case FaceKinds::kQuads:
      return "quads";
    case FaceKinds::kAny:
      break;
  }
  return "faces with any number of sides";
}

}  // namespace

std::string scheme_word(const SchemeSettings& settings) {
  return fmt::format("{}{}", scheme_info(settings.scheme).name, choice_word(settings));
}

std::optional<SchemeSettings> scheme_from_word(std::string_view word) {
  for (const SchemeSettings& settings : scheme_variants()) {
    if (word == scheme_word(settings)) {
      return settings;
    }
  }
  return std::nullopt;
}

std::string scheme_title(const SchemeSettings& settings) {
  return fmt::format("{}{}", scheme_info(settings.scheme).title, choice_title(settings));
}

std::string scheme_description(const SchemeSettings& settings) {
  const SchemeInfo& info = scheme_info(settings.scheme);
  return fmt::format("Takes {}.\nMakes {}.\n{}\nLimit: {}.\nBoundary: {}.\n{}.",
                     faces_taken(info.takes), info.makes,
                     info.interpolates ? "Interpolates: vertices stay where they are."
                                       : "Approximates: vertices move.",
                     info.continuity, info.boundary, info.source);
}

std::span<const SchemeSettings> scheme_variants() {
  static const std::vector<SchemeSettings> variants = [] {
    std::vector<SchemeSettings> all;
    for (const SchemeInfo& info : schemes()) {
      all.push_back({.scheme = info.scheme});
      if (info.scheme == Scheme::kLoop) {
        all.push_back({.scheme = info.scheme, .weights = LoopWeights::kWarren});
      } else if (info.scheme == Scheme::kLinear) {
        all.push_back({.scheme = info.scheme, .averages = true});
      }
    }
    return all;
  }();
  return variants;
}

std::string_view fitting_label(Fitting fitting) noexcept {
  return fitting == Fitting::kTriangulate ? "Triangulate" : "One Catmull-Clark step";
}

}  // namespace limn::ui
