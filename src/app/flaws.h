#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/subdivision/crack_check.h"
#include "ui/model.h"

namespace limn::app {

/// What flaws are looked for in. The refined mesh and its check are null where there are none.
struct FlawSource {
  const ControlMesh& control;
  const RefinedMesh* refined = nullptr;
  const CrackCheck* cracks = nullptr;
};

/// Where one is, and what shall be in view around it.
struct FlawPlace {
  std::size_t element = 0;
  std::size_t count = 0;  ///< Places of this kind.
  glm::dvec3 position{0.0};
  std::vector<glm::dvec3> around;
};

/// The place `element` of a kind, counted round (the one after the last is the first); nothing
/// where there is none. Boundaries are loops, and cracks are faces of the refined mesh beside one.
[[nodiscard]] std::optional<FlawPlace> flaw_place(ui::FlawKind kind, std::size_t element,
                                                  const FlawSource& source);

}  // namespace limn::app
