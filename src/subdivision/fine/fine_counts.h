#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "subdivision/cage.h"
#include "subdivision/fine/fine_walk.h"

// How much becomes of control faces whose labels of finer levels are given. Internal to this
// folder.
namespace limn {

/// What becomes of one control face.
struct FineFaceCounts : FaceCounts {
  std::uint8_t deepest = 0;  ///< Level of its finest faces.
};

/// Counts by face and side. For a cage with the faces of the control mesh that the labels are for.
class FineCounts {
 public:
  /// `labels` are of the cage's vertices, held to the levels.
  FineCounts(const Cage& cage, std::span<const std::uint8_t> labels, const FineLabels& fine,
             int levels);

  /// Whether a control face is counted here.
  [[nodiscard]] bool has(std::size_t face) const noexcept { return numbers_[face] != kNone; }
  [[nodiscard]] const FineFaceCounts& face(std::size_t f) const noexcept {
    return faces_[numbers_[f]];
  }
  /// Vertices strictly inside a side.
  [[nodiscard]] std::uint32_t side(std::size_t face, std::size_t side) const noexcept {
    return sides_[first_sides_[numbers_[face]] + side];
  }

 private:
  std::vector<std::uint32_t> numbers_;  ///< By control face; kNone: not here.
  std::vector<FineFaceCounts> faces_;
  std::vector<std::uint32_t> first_sides_;
  std::vector<std::uint32_t> sides_;
};

}  // namespace limn
