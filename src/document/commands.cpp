// Painting remembers its edits. The others hold the state that the document is not in and swap the
// two, so that apply and revert are the same move and redo cannot differ from the first time.
#include "limn/document/commands.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "mesh_bytes.h"

namespace limn {
namespace {

class PaintCommand final : public Command {
 public:
  PaintCommand(std::vector<DepthEdit> edits, std::string name)
      : edits_(std::move(edits)), name_(std::move(name)) {
    edits_.shrink_to_fit();
  }

  void apply(Document& document) override {
    apply_edits(document.depths, edits_);
    count_up(document);
  }
  void revert(Document& document) override {
    revert_edits(document.depths, edits_);
    count_up(document);
  }
  [[nodiscard]] std::size_t bytes() const noexcept override {
    return sizeof(*this) + edits_.capacity() * sizeof(DepthEdit) + name_.capacity();
  }
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  void count_up(Document& document) const {
    if (!edits_.empty()) {
      ++document.revisions.depths;
    }
  }

  std::vector<DepthEdit> edits_;
  std::string name_;
};

class StageCommand final : public Command {
 public:
  StageCommand(Stage stage, std::string name) : other_(stage), name_(std::move(name)) {}

  void apply(Document& document) override { swap_with(document); }
  void revert(Document& document) override { swap_with(document); }
  [[nodiscard]] std::size_t bytes() const noexcept override {
    return sizeof(*this) + name_.capacity();
  }
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  void swap_with(Document& document) {
    if (other_ != document.stage) {
      std::swap(document.stage, other_);
      ++document.revisions.stage;
    }
  }

  Stage other_;
  std::string name_;
};

class SettingsCommand final : public Command {
 public:
  explicit SettingsCommand(SubdivisionSettings settings) : other_(settings) {}

  void apply(Document& document) override { swap_with(document); }
  void revert(Document& document) override { swap_with(document); }
  [[nodiscard]] std::size_t bytes() const noexcept override { return sizeof(*this); }
  [[nodiscard]] std::string name() const override { return "change subdivision settings"; }

 private:
  void swap_with(Document& document) {
    if (other_ != document.settings) {
      std::swap(document.settings, other_);
      ++document.revisions.stage;
    }
  }

  SubdivisionSettings other_;
};

/// What keeping `mesh` costs whoever does, beside what the document keeps anyway.
std::size_t bytes_beside(const Document& document, const ControlMesh& mesh) {
  const auto shares_surface = [&](const std::shared_ptr<const ControlMesh>& other) {
    return other != nullptr && &other->topology() == &mesh.topology();
  };
  if (&mesh == document.control.get() || &mesh == document.opened.get()) {
    return 0;
  }
  return shares_surface(document.control) || shares_surface(document.opened)
             ? sizeof(ControlMesh) + attribute_bytes(mesh)
             : mesh_bytes(mesh);
}

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
};

ControlState unpainted(std::shared_ptr<const ControlMesh> control) {
  const std::size_t faces = control->face_count();
  return {std::move(control), FaceDepths(faces), Stage{}};
}

/// Takes the given mesh, or the one that was opened where there is none given.
class ReplaceCommand final : public Command {
 public:
  ReplaceCommand(std::shared_ptr<const ControlMesh> control, std::string name)
      : name_(std::move(name)) {
    if (control != nullptr) {
      other_ = unpainted(std::move(control));
      mesh_bytes_ = mesh_bytes(*other_.control);
    }
  }

  void apply(Document& document) override {
    if (other_.control == nullptr) {
      other_ = unpainted(document.opened);
    }
    swap_with(document);
  }
  void revert(Document& document) override { swap_with(document); }
  [[nodiscard]] std::size_t bytes() const noexcept override {
    return sizeof(*this) + mesh_bytes_ + other_.depths.size() + name_.capacity();
  }
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  void swap_with(Document& document) {
    const bool is_other_mesh = document.control != other_.control;
    const bool is_other_painting = is_other_mesh || document.depths != other_.depths;
    const bool is_other_stage = document.stage != other_.stage;
    std::swap(document.control, other_.control);
    std::swap(document.depths, other_.depths);
    std::swap(document.stage, other_.stage);
    document.revisions.control += is_other_mesh ? 1 : 0;
    document.revisions.depths += is_other_painting ? 1 : 0;
    document.revisions.stage += is_other_stage ? 1 : 0;
    mesh_bytes_ = bytes_beside(document, *other_.control);
  }

  ControlState other_;
  std::size_t mesh_bytes_ = 0;
  std::string name_;
};

}  // namespace

std::unique_ptr<Command> paint_command(std::vector<DepthEdit> edits, std::string name) {
  return std::make_unique<PaintCommand>(std::move(edits), std::move(name));
}

std::unique_ptr<Command> stage_command(Stage stage, std::string name) {
  return std::make_unique<StageCommand>(stage, std::move(name));
}

std::unique_ptr<Command> settings_command(SubdivisionSettings settings) {
  return std::make_unique<SettingsCommand>(settings);
}

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
  return std::make_unique<ReplaceCommand>(std::move(control), std::move(name));
}

std::unique_ptr<Command> revert_command() {
  return std::make_unique<ReplaceCommand>(nullptr, "revert to the opened mesh");
}

}  // namespace limn
