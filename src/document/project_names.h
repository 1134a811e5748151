#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "field_reader.h"
#include "limn/subdivision/schemes/scheme.h"
#include "limn/subdivision/settings.h"

// What things are called in a project file.
namespace limn {

inline constexpr std::string_view kProjectFormat = "limn-project";
/// 2 brought creases, corners and texture coordinates, 3 uniform schemes and adaptive Loop,
/// 4 names of faces and vertices in no face, 5 demands on finer faces. A project is written as the
/// oldest version that holds it, for programs that know no other. The checksum is in projects of
/// every version, since programs pass over what they do not know.
inline constexpr std::int64_t kProjectVersion = 5;

inline constexpr std::array<Named<NonQuadRule>, 2> kNonQuadRules{
    {{"uniform-first-step", NonQuadRule::kUniformFirstStep},
     {"where-painted", NonQuadRule::kWherePainted}}};
inline constexpr std::array<Named<LegalisationMethod>, 2> kLegalisations{
    {{"greedy", LegalisationMethod::kGreedy}, {"look-ahead", LegalisationMethod::kLookAhead}}};
inline constexpr std::array<Named<SurfacePoints>, 2> kSurfacePoints{
    {{"level", SurfacePoints::kLevel}, {"limit", SurfacePoints::kLimit}}};
inline constexpr std::array<Named<TextureRule>, 2> kTextureRules{
    {{"smooth-inside", TextureRule::kSmoothInside}, {"linear", TextureRule::kLinear}}};

inline constexpr std::array<Named<RefinementScheme>, 2> kRefinementSchemes{
    {{"catmull-clark", RefinementScheme::kCatmullClark}, {"loop", RefinementScheme::kLoop}}};
inline constexpr std::array<Named<LoopWeights>, 2> kLoopWeights{
    {{"original", LoopWeights::kOriginal}, {"warren", LoopWeights::kWarren}}};

inline std::array<Named<Scheme>, kSchemeCount> scheme_names() {
  std::array<Named<Scheme>, kSchemeCount> names;
  std::ranges::transform(schemes(), names.begin(), [](const SchemeInfo& info) {
    return Named<Scheme>{info.name, info.scheme};
  });
  return names;
}

}  // namespace limn
