#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/painting/valence_palette.h"
#include "ui/model.h"

namespace limn::app {

/// Whether a control mesh is one for a scheme, and how large its levels are; worked out once per
/// mesh and scheme.
class SchemeFacts {
 public:
  void update(const std::shared_ptr<const ControlMesh>& mesh,
              const std::optional<SchemeSettings>& scheme);

  [[nodiscard]] const std::optional<ui::SchemeMisfit>& misfit() const noexcept { return misfit_; }
  /// Of levels 0..kMostSchemeLevels; empty without a scheme and at a misfit.
  [[nodiscard]] const std::vector<SchemeCounts>& counts() const noexcept { return counts_; }

 private:
  std::shared_ptr<const ControlMesh> mesh_;
  std::optional<SchemeSettings> scheme_;
  std::optional<ui::SchemeMisfit> misfit_;
  std::vector<SchemeCounts> counts_;
};

/// Faces of each level of the mesh shown: counted when they are first asked for.
class ShownLevels {
 public:
  /// The refined mesh where there is one, otherwise the control mesh, whose faces are of level 0.
  void update(const std::shared_ptr<const ControlMesh>& control,
              const std::shared_ptr<const RefinedMesh>& refined);

  [[nodiscard]] const ui::DepthCounts& counts() const noexcept { return counts_; }

 private:
  std::shared_ptr<const ControlMesh> control_;
  std::shared_ptr<const RefinedMesh> refined_;
  ui::DepthCounts counts_{};
};

/// Irregular vertices of the mesh shown: found when they are first asked for.
class ShownValences {
 public:
  /// The refined mesh where there is one, otherwise the control mesh.
  void update(const std::shared_ptr<const ControlMesh>& control,
              const std::shared_ptr<const RefinedMesh>& refined);

  [[nodiscard]] const std::vector<IrregularVertex>& vertices() const noexcept { return vertices_; }
  [[nodiscard]] const ValenceCounts& counts() const noexcept { return counts_; }
  /// Counts up with every other mesh.
  [[nodiscard]] std::uint64_t revision() const noexcept { return revision_; }

 private:
  std::shared_ptr<const ControlMesh> control_;
  std::shared_ptr<const RefinedMesh> refined_;
  std::vector<IrregularVertex> vertices_;
  ValenceCounts counts_{};
  std::uint64_t revision_ = 0;
};

}  // namespace limn::app
