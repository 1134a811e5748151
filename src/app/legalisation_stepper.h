#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "limn/document/document.h"
#include "limn/document/refinement.h"
#include "limn/subdivision/legalisation_trace.h"
#include "ui/model.h"

namespace limn::app {

/// Plays the removal of illegal vertices move by move, for whoever wants to see it. Works on the
/// labels of the newest painting; when these change it begins anew.
class LegalisationStepper {
 public:
  void show(bool is_shown);
  [[nodiscard]] bool is_shown() const noexcept { return is_shown_; }

  /// Takes up the labels in force; `labels` is null where there are none yet. Does nothing while it
  /// is not shown, or where it has them already.
  void update(const Document& document, const DerivedLabels* labels, std::uint64_t revision);
  /// To so many moves made, within what there are.
  void seek(std::size_t position);
  [[nodiscard]] std::size_t position() const noexcept { return trace_ ? trace_->position() : 0; }
  [[nodiscard]] std::size_t size() const noexcept { return trace_ ? trace_->size() : 0; }

  /// What is to be seen at this position; null while nothing is shown.
  struct Moment {
    std::vector<std::uint32_t> illegal_faces;
    std::vector<std::uint32_t> illegal_vertices;
    std::vector<std::uint32_t> raised_vertices;
    std::vector<LegalisationCandidate> candidates;  ///< Best first: that is the one picked.
    std::vector<std::uint32_t> falling;             ///< Vertices that the next move sets to 0.
  };
  [[nodiscard]] const Moment* moment() const noexcept { return trace_ ? &moment_ : nullptr; }
  [[nodiscard]] const VertexLabels& labels() const { return trace_->labels(); }
  /// Counts up with everything that is to be seen.
  [[nodiscard]] std::uint64_t revision() const noexcept { return revision_; }

  /// For the panel; spans in it live until the next change.
  [[nodiscard]] ui::StepperStatus status() const;

 private:
  void look();

  bool is_shown_ = false;
  std::optional<LegalisationTrace> trace_;
  std::uint64_t labels_revision_ = 0;
  Moment moment_;
  std::uint64_t revision_ = 0;
};

}  // namespace limn::app
