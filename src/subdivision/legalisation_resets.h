#pragma once

#include <functional>

#include "limn/subdivision/legalisation.h"
#include "subdivision/legality_problem.h"

// Internal to this folder.
namespace limn {

/// Resets to 0 every vertex that `result.steps` raised, and every two that share a quad, whose
/// quads all stay legal, until there is none; latest first. Adds the steps. No reset makes a
/// refined mesh larger. `masks` are those of `result.labels`, before and afterwards. `goes_on` is
/// asked now and then; false, with the rest left as it is, once it says no.
///
/// In time that is linear in the mesh for bounded valence; pairs are not sought from vertices of
/// very many quads.
[[nodiscard]] bool take_back_needless(const LegalityProblem& problem, LargeArray<QuadMask>& masks,
                                      Legalisation& result, const std::function<bool()>& goes_on);

}  // namespace limn
