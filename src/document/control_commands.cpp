// Commands that change the control mesh. They hold the mesh that the document does not have, and
// swap; meshes are shared, never copied.
#include "limn/document/commands.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "limn/contract.h"
#include "limn/editing/edge_edits.h"
#include "mesh_bytes.h"

namespace limn {
namespace {

class AttributesCommand final : public Command {
 public:
  AttributesCommand(std::shared_ptr<const ControlMesh> control, std::string name)
      : other_(std::move(control)),
        mesh_bytes_(sizeof(ControlMesh) + attribute_bytes(*other_)),
        name_(std::move(name)) {}

  void apply(Document& document) override { swap_with(document); }
  void revert(Document& document) override { swap_with(document); }
  [[nodiscard]] std::size_t bytes() const noexcept override {
    return sizeof(*this) + mesh_bytes_ + name_.capacity();
  }
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  void swap_with(Document& document) {
    LIMN_EXPECTS(&document.control->topology() == &other_->topology());
    if (document.control != other_) {
      std::swap(document.control, other_);
      ++document.revisions.control;
    }
    mesh_bytes_ = bytes_beside(document, *other_);
  }

  std::shared_ptr<const ControlMesh> other_;
  std::size_t mesh_bytes_;
  std::string name_;
};

/// What another control mesh brings with it.
struct ControlState {
  std::shared_ptr<const ControlMesh> control;
  FaceDepths depths;
  Stage stage;
  FineDemands demands;
};

ControlState unpainted(std::shared_ptr<const ControlMesh> control) {
  const std::size_t faces = control->face_count();
  return {std::move(control), FaceDepths(faces), Stage{}, {}};
}

/// Takes the given mesh, or the one that was opened where there is none given.
class ReplaceCommand final : public Command {
 public:
  ReplaceCommand(ControlState other, std::string name)
      : other_(std::move(other)),
        mesh_bytes_(other_.control != nullptr ? mesh_bytes(*other_.control) : 0),
        name_(std::move(name)) {}

  void apply(Document& document) override {
    if (other_.control == nullptr) {
      other_ = unpainted(document.opened);
    }
    // Loop is left where the other mesh is none for it. Asked first, since asking may throw.
    painted_by_ = document.settings.scheme;
    const bool leaves_loop = painted_by_ == RefinementScheme::kLoop &&
                             !check_fits(*other_.control, Scheme::kLoop).has_value();
    swap_with(document);
    if (leaves_loop) {
      paint_by(document, RefinementScheme::kCatmullClark);
    }
  }
  void revert(Document& document) override {
    paint_by(document, painted_by_);
    swap_with(document);
  }
  [[nodiscard]] std::size_t bytes() const noexcept override {
    return sizeof(*this) + mesh_bytes_ + other_.depths.size() +
           other_.demands.size() * sizeof(FineDemand) + name_.capacity();
  }
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  void swap_with(Document& document) {
    const bool is_other_mesh = document.control != other_.control;
    const bool is_other_painting =
        is_other_mesh || document.depths != other_.depths || document.demands != other_.demands;
    const bool is_other_stage = document.stage != other_.stage;
    std::swap(document.control, other_.control);
    std::swap(document.depths, other_.depths);
    std::swap(document.demands, other_.demands);
    std::swap(document.stage, other_.stage);
    document.revisions.control += is_other_mesh ? 1 : 0;
    document.revisions.depths += is_other_painting ? 1 : 0;
    document.revisions.stage += is_other_stage ? 1 : 0;
    mesh_bytes_ = bytes_beside(document, *other_.control);
  }
  static void paint_by(Document& document, RefinementScheme scheme) {
    document.revisions.stage += document.settings.scheme != scheme ? 1 : 0;
    document.settings.scheme = scheme;
  }

  ControlState other_;
  RefinementScheme painted_by_ = RefinementScheme::kCatmullClark;  ///< Before it was applied.
  std::size_t mesh_bytes_;
  std::string name_;
};

/// The painting after an edge was split. What is appended is cut from one of the triangles that
/// were at the edge: the one with the same vertex opposite.
FaceDepths depths_after_split(const Document& document, std::uint32_t edge,
                              const ControlMesh& after) {
  const ControlMesh& before = *document.control;
  FaceDepths depths(after.face_count());
  for (std::size_t f = 0; f < before.face_count(); ++f) {
    depths.set(f, document.depths[f]);
  }
  for (std::size_t f = before.face_count(); f < after.face_count(); ++f) {
    const std::span<const std::uint32_t> half = after.face(f);
    for (const std::uint32_t corner : before.topology().edge_corners[edge]) {
      if (corner == kNone) {
        continue;
      }
      const std::uint32_t whole = before.topology().corner_faces[corner];
      const auto shared = std::ranges::count_if(half, [&](std::uint32_t vertex) {
        return std::ranges::find(before.face(whole), vertex) != before.face(whole).end();
      });
      if (shared == 2) {
        depths.set(f, document.depths[whole]);
      }
    }
  }
  return depths;
}

/// The demands on faces that are the same in another mesh.
FineDemands demands_after(const Document& document, const ControlMesh& after) {
  std::vector<FineDemand> kept;
  std::ranges::copy_if(document.demands.all(), std::back_inserter(kept),
                       [&](const FineDemand& demand) {
                         const std::uint32_t f = demand.face.control_face;
                         return f < after.face_count() &&
                                std::ranges::equal(after.face(f), document.control->face(f));
                       });
  return FineDemands(kept);
}

/// The painting after a fitting, which puts what becomes of a face in that face's place.
FaceDepths depths_after_fitting(const Document& document, Fitting fitting,
                                const ControlMesh& after) {
  const ControlMesh& before = *document.control;
  FaceDepths depths(after.face_count());
  std::size_t next = 0;
  for (std::size_t f = 0; f < before.face_count(); ++f) {
    const std::size_t sides = before.face(f).size();
    const bool is_cut = fitting == Fitting::kTriangulate;
    const int depth = is_cut ? document.depths[f] : std::max(document.depths[f] - 1, 0);
    // Cut by diagonals, unless there is a new vertex with all sides around it.
    const bool has_centre = std::ranges::any_of(
        after.face(next), [&](std::uint32_t vertex) { return vertex >= before.vertex_count(); });
    const std::size_t last = next + (is_cut && !has_centre ? sides - 2 : sides);
    for (; next < last; ++next) {
      depths.set(next, depth);
    }
  }
  LIMN_EXPECTS(next == after.face_count());
  return depths;
}

}  // namespace

std::unique_ptr<Command> attributes_command(std::shared_ptr<const ControlMesh> control,
                                            std::string name) {
  LIMN_EXPECTS(control != nullptr);
  return std::make_unique<AttributesCommand>(std::move(control), std::move(name));
}

std::unique_ptr<Command> crease_command(const Document& document, const CreaseRule& rule) {
  MeshAttributes attributes = document.control->attributes();
  attributes.creases = apply_crease_rule(*document.control, rule);
  std::string name = "clear creases";
  if (std::holds_alternative<SharpenEdges>(rule)) {
    const auto sharp = std::ranges::count_if(attributes.creases.edge_sharpness,
                                             [](float sharpness) { return sharpness > 0.0f; });
    name = fmt::format("crease edges ({} sharp)", sharp);
  }
  const bool is_same = attributes.creases == document.control->creases();
  return attributes_command(is_same ? document.control
                                    : std::make_shared<const ControlMesh>(
                                          document.control->with_attributes(std::move(attributes))),
                            std::move(name));
}

std::unique_ptr<Command> replace_control_command(std::shared_ptr<const ControlMesh> control,
                                                 std::string name) {
  LIMN_EXPECTS(control != nullptr);
  return std::make_unique<ReplaceCommand>(unpainted(std::move(control)), std::move(name));
}

Result<std::unique_ptr<Command>> split_edge_command(const Document& document, std::uint32_t edge) {
  auto after = split_edge(*document.control, edge);
  if (!after) {
    return tl::unexpected(std::move(after.error()));
  }
  FaceDepths depths = depths_after_split(document, edge, **after);
  FineDemands demands = demands_after(document, **after);
  return std::make_unique<ReplaceCommand>(
      ControlState{*std::move(after), std::move(depths), document.stage, std::move(demands)},
      "split edge");
}

Result<std::unique_ptr<Command>> flip_edge_command(const Document& document, std::uint32_t edge) {
  auto after = flip_edge(*document.control, edge);
  if (!after) {
    return tl::unexpected(std::move(after.error()));
  }
  FineDemands demands = demands_after(document, **after);
  return std::make_unique<ReplaceCommand>(
      ControlState{*std::move(after), document.depths, document.stage, std::move(demands)},
      "flip edge");
}

std::unique_ptr<Command> fit_command(const Document& document, Fitting fitting) {
  std::shared_ptr<const ControlMesh> after = make_fit(*document.control, fitting);
  FaceDepths depths = depths_after_fitting(document, fitting, *after);
  return std::make_unique<ReplaceCommand>(
      ControlState{std::move(after), std::move(depths), Stage{}, {}},
      fitting == Fitting::kTriangulate ? "triangulate" : "one Catmull-Clark step");
}

std::unique_ptr<Command> reattach_command(PaintingTransfer transfer) {
  LIMN_EXPECTS(transfer.mesh != nullptr);
  return std::make_unique<ReplaceCommand>(
      ControlState{std::move(transfer.mesh), std::move(transfer.depths), Stage{}, {}},
      "replace mesh");
}

std::unique_ptr<Command> revert_command() {
  return std::make_unique<ReplaceCommand>(ControlState{}, "revert to the opened mesh");
}

}  // namespace limn
