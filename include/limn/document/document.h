#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "limn/document/view_state.h"
#include "limn/mesh/build.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/face_depths.h"
#include "limn/subdivision/fine_demands.h"
#include "limn/subdivision/prediction.h"
#include "limn/subdivision/schemes/scheme.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// How far the artist has asked to see the subdivision carried out. The refined mesh is always
/// derived from the control mesh and the depths; this only says how much of it to show.
struct Stage {
  bool is_legalised = false;  ///< Illegal vertices removed (shown in the labels).
  int levels = 0;  ///< 0: the control mesh; n: after n steps; kAllLevels: to the end, which a
                   ///< uniform scheme does not have (at most kMostSchemeLevels).

  [[nodiscard]] bool operator==(const Stage&) const = default;
};

/// Counts up whenever the named part changes, undo and redo included, so that whoever derives
/// something from it (the renderer, a refinement) knows when to do so again. Every document starts
/// at numbers of its own, far from any other's: equal numbers mean the same contents of the same
/// document, and 0 means nothing at all.
struct Revisions {
  std::uint64_t control = 0;
  std::uint64_t depths = 0;  ///< Demands, too.
  std::uint64_t stage = 0;   ///< Stage, settings or scheme.

  [[nodiscard]] bool operator==(const Revisions&) const = default;
};

/// What is open: the control mesh and its painting. Plain data, changed by commands alone
/// (document/command.h). The refined mesh is derived and is not part of it.
struct Document {
  std::shared_ptr<const ControlMesh> control;
  FaceDepths depths;    ///< One entry per face of `control`.
  FineDemands demands;  ///< On finer faces of it. Catmull-Clark's: Loop and uniform schemes pass
                        ///< over them.
  SubdivisionSettings settings;
  /// The uniform scheme that is shown instead of what is painted; nothing: the painting. Its corner
  /// rule is that of `settings` (`shown_scheme`).
  std::optional<SchemeSettings> scheme;
  Stage stage;

  std::string name;                    ///< For the title bar: "creature", "spot.obj".
  std::filesystem::path mesh_path;     ///< Empty for a bundled mesh.
  std::filesystem::path project_path;  ///< Empty until saved.
  ImportReport import_report;          ///< Of the mesh as it was opened; empty for a project.

  /// The mesh as it was opened, for Revert; the same object as `control` until Apply.
  std::shared_ptr<const ControlMesh> opened;

  Revisions revisions;
};

/// The most levels that anything in the document is painted with, demands included where the scheme
/// heeds them.
[[nodiscard]] int deepest_painting(const Document& document) noexcept;

/// The uniform scheme that is shown, with the document's corner rule.
[[nodiscard]] std::optional<SchemeSettings> shown_scheme(const Document& document) noexcept;

/// A fresh document, with the boundary rule and the painting that the mesh comes with. `mesh.mesh`
/// must be there.
[[nodiscard]] Document make_document(ImportedMesh mesh, std::string name,
                                     std::filesystem::path mesh_path = {});

}  // namespace limn
