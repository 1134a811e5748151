// Painting remembers its edits. The others hold the state that the document is not in and swap the
// two, so that apply and revert are the same move and redo cannot differ from the first time.
// Commands that change the control mesh are in control_commands.cpp.
#include "limn/document/commands.h"

#include <utility>

#include "limn/contract.h"

namespace limn {
namespace {

/// Swaps settings where they differ.
void swap_settings(Document& document, SubdivisionSettings& other) {
  if (other != document.settings) {
    std::swap(document.settings, other);
    ++document.revisions.stage;
  }
}

class PaintCommand final : public Command {
 public:
  PaintCommand(std::vector<DepthEdit> edits, std::string name, DemandEdits demands,
               std::optional<SubdivisionSettings> settings)
      : edits_(std::move(edits)),
        demands_(std::move(demands)),
        other_settings_(settings),
        name_(std::move(name)) {
    edits_.shrink_to_fit();
  }

  void apply(Document& document) override {
    apply_edits(document.depths, edits_);
    document.demands.apply(demands_);
    finish(document);
  }
  void revert(Document& document) override {
    revert_edits(document.depths, edits_);
    document.demands.revert(demands_);
    finish(document);
  }
  [[nodiscard]] std::size_t bytes() const noexcept override {
    return sizeof(*this) + edits_.capacity() * sizeof(DepthEdit) + name_.capacity() +
           (demands_.removed.capacity() + demands_.added.capacity()) * sizeof(FineDemand);
  }
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  void finish(Document& document) {
    if (!edits_.empty() || !demands_.empty()) {
      ++document.revisions.depths;
    }
    if (other_settings_) {
      swap_settings(document, *other_settings_);
    }
  }

  std::vector<DepthEdit> edits_;
  DemandEdits demands_;
  std::optional<SubdivisionSettings> other_settings_;
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

  void apply(Document& document) override { swap_settings(document, other_); }
  void revert(Document& document) override { swap_settings(document, other_); }
  [[nodiscard]] std::size_t bytes() const noexcept override { return sizeof(*this); }
  [[nodiscard]] std::string name() const override { return "change subdivision settings"; }

 private:
  SubdivisionSettings other_;
};

class SchemeCommand final : public Command {
 public:
  SchemeCommand(std::optional<SchemeSettings> scheme, Stage stage, std::string name)
      : scheme_(scheme), stage_(stage), name_(std::move(name)) {}

  void apply(Document& document) override { swap_with(document); }
  void revert(Document& document) override { swap_with(document); }
  [[nodiscard]] std::size_t bytes() const noexcept override {
    return sizeof(*this) + name_.capacity();
  }
  [[nodiscard]] std::string name() const override { return name_; }

 private:
  void swap_with(Document& document) {
    if (scheme_ != document.scheme || stage_ != document.stage) {
      std::swap(document.scheme, scheme_);
      std::swap(document.stage, stage_);
      ++document.revisions.stage;
    }
  }

  std::optional<SchemeSettings> scheme_;
  Stage stage_;
  std::string name_;
};

}  // namespace

std::unique_ptr<Command> paint_command(std::vector<DepthEdit> edits, std::string name,
                                       DemandEdits demands,
                                       std::optional<SubdivisionSettings> settings) {
  return std::make_unique<PaintCommand>(std::move(edits), std::move(name), std::move(demands),
                                        settings);
}

std::unique_ptr<Command> stage_command(Stage stage, std::string name) {
  return std::make_unique<StageCommand>(stage, std::move(name));
}

std::unique_ptr<Command> settings_command(SubdivisionSettings settings) {
  return std::make_unique<SettingsCommand>(settings);
}

std::unique_ptr<Command> scheme_command(std::optional<SchemeSettings> scheme, Stage stage,
                                        std::string name) {
  LIMN_EXPECTS(!scheme || (stage.levels >= 0 && stage.levels <= kMostSchemeLevels));
  return std::make_unique<SchemeCommand>(scheme, stage, std::move(name));
}

}  // namespace limn
