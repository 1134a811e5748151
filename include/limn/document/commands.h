#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limn/document/command.h"
#include "limn/document/painting_transfer.h"
#include "limn/error.h"
#include "limn/painting/crease_rule.h"
#include "limn/painting/depth_change.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn {

/// Changes depths: a stroke, a rule, "zero all"; and demands on finer faces. Both must fit the
/// document they are applied to. The stage stays: what is shown refined is derived again from the
/// new painting. `settings` are what it was chosen for, where they become others.
[[nodiscard]] std::unique_ptr<Command> paint_command(
    std::vector<DepthEdit> edits, std::string name, DemandEdits demands = {},
    std::optional<SubdivisionSettings> settings = std::nullopt);

/// Shows more or less of the subdivision.
[[nodiscard]] std::unique_ptr<Command> stage_command(Stage stage, std::string name);

/// Other subdivision settings.
[[nodiscard]] std::unique_ptr<Command> settings_command(SubdivisionSettings settings);

/// Shows a uniform scheme, or what is painted where there is none, at a stage of its own.
[[nodiscard]] std::unique_ptr<Command> scheme_command(std::optional<SchemeSettings> scheme,
                                                      Stage stage, std::string name);

/// Gives the control mesh other attributes: creases, corner rule, texture coordinates. `control` is
/// the same surface as the document's, from ControlMesh::with_attributes. Depths and stage stay.
[[nodiscard]] std::unique_ptr<Command> attributes_command(
    std::shared_ptr<const ControlMesh> control, std::string name);

/// The control mesh with its creases after the rule: an attributes command.
[[nodiscard]] std::unique_ptr<Command> crease_command(const Document& document,
                                                      const CreaseRule& rule);

/// Replaces the control mesh, unpainted and at stage 0: Apply (the refined mesh becomes the control
/// mesh). Demands on finer faces are gone with the faces they were on. As with all commands that
/// change it, settings that ask for Loop ask for Catmull-Clark where the new mesh is not all
/// triangles.
[[nodiscard]] std::unique_ptr<Command> replace_control_command(
    std::shared_ptr<const ControlMesh> control, std::string name);

/// Single edges of the control mesh (editing/edge_edits.h). The stage stays, and so does the
/// painting: both halves of a face that is cut keep its depth, and demands stay on all faces but
/// those that were cut or turned.
/// Errors: kFailed, with the reason, where the edge cannot be split or flipped.
[[nodiscard]] Result<std::unique_ptr<Command>> split_edge_command(const Document& document,
                                                                  std::uint32_t edge);
[[nodiscard]] Result<std::unique_ptr<Command>> flip_edge_command(const Document& document,
                                                                 std::uint32_t edge);

/// The control mesh made to fit a scheme (`make_fit`), at stage 0. What becomes of a face keeps its
/// depth, or one level less where the face was subdivided. Demands on finer faces go.
[[nodiscard]] std::unique_ptr<Command> fit_command(const Document& document, Fitting fitting);

/// Takes up a painting that was carried over to another control mesh, at stage 0. Demands on finer
/// faces are not carried over.
[[nodiscard]] std::unique_ptr<Command> reattach_command(PaintingTransfer transfer);

/// Back to the mesh as it was opened, unpainted and at stage 0.
[[nodiscard]] std::unique_ptr<Command> revert_command();

}  // namespace limn
