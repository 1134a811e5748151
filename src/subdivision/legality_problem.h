#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/large_array.h"
#include "limn/subdivision/labels.h"

// Internal to this folder.
namespace limn {

/// Which corners of a quad are positive, a bit each.
using QuadMask = std::uint8_t;

/// Two neighbouring corners and no other.
[[nodiscard]] constexpr bool is_illegal_mask(unsigned mask) noexcept {
  constexpr unsigned kIllegal = 1U << 0b0011U | 1U << 0b0110U | 1U << 0b1100U | 1U << 0b1001U;
  return (kIllegal >> mask & 1U) != 0;
}

/// Faces that a relabel adds to a refined mesh, up to what does not depend on relabels, for a quad
/// by its positive labels: it stays, becomes a Y-element, or splits. Illegal ones will split.
///
/// That is all a relabel adds: a vertex that becomes 1 is 0 again after one step, and so is every
/// point made beside it, so what becomes of the quads' children depends on the painting alone.
[[nodiscard]] constexpr std::uint32_t added_faces(int positive_labels) noexcept {
  return positive_labels == 0 ? 0 : positive_labels == 1 ? 2 : 3;
}

/// The same by which of its labels are positive.
[[nodiscard]] constexpr std::uint32_t added_faces_of(unsigned mask) noexcept {
  constexpr auto kTwoBitsAMask = [] {
    std::uint32_t bits = 0;
    for (unsigned m = 0; m < 16; ++m) {
      bits |= added_faces(std::popcount(m)) << 2 * m;
    }
    return bits;
  }();
  return kTwoBitsAMask >> 2 * mask & 3U;
}

/// Legalisation as a choice of bits: which vertices become positive, vertices that faces other than
/// quads tie together being one variable, and which quads that makes illegal.
///
/// On a mesh of quads every vertex is a variable, and the arrays are the mesh's own.
class LegalityProblem {
 public:
  /// `mesh` must outlive it.
  explicit LegalityProblem(const ControlMesh& mesh);
  LegalityProblem(const LegalityProblem&) = delete;
  LegalityProblem& operator=(const LegalityProblem&) = delete;

  [[nodiscard]] std::size_t variable_count() const noexcept { return first_corners_.size() - 1; }
  [[nodiscard]] std::size_t quad_count() const noexcept { return corner_variables_.size() / 4; }

  [[nodiscard]] std::uint32_t variable_of(std::uint32_t vertex) const noexcept {
    return variables_.empty() ? vertex : variables_[vertex];
  }
  /// The vertices of a variable: calls `visit(vertex)` for each, ascending.
  template <class Visit>
  void for_each_vertex(std::uint32_t variable, const Visit& visit) const {
    if (variables_.empty()) {
      visit(variable);
      return;
    }
    for (std::uint32_t i = first_members_[variable]; i < first_members_[variable + 1]; ++i) {
      visit(members_[i]);
    }
  }
  /// Faces that its faces other than quads add when it rises.
  [[nodiscard]] std::uint32_t polygon_faces(std::uint32_t variable) const noexcept {
    return polygon_faces_.empty() ? 0 : polygon_faces_[variable];
  }

  /// Variables at the corners of a quad, in cyclic order.
  [[nodiscard]] std::span<const std::uint32_t, 4> quad(std::uint32_t q) const noexcept {
    return std::span<const std::uint32_t, 4>(corner_variables_.data() + std::size_t{4} * q, 4);
  }
  /// The corners of quad q that a variable stands at.
  [[nodiscard]] unsigned bits_in(std::uint32_t q, std::uint32_t variable) const noexcept {
    const std::span<const std::uint32_t, 4> at = quad(q);
    return static_cast<unsigned>(at[0] == variable) |
           static_cast<unsigned>(at[1] == variable) << 1U |
           static_cast<unsigned>(at[2] == variable) << 2U |
           static_cast<unsigned>(at[3] == variable) << 3U;
  }
  /// Quads around a variable.
  [[nodiscard]] std::size_t quads_around(std::uint32_t variable) const noexcept {
    return first_corners_[variable + 1] - first_corners_[variable];
  }
  /// Calls `visit(q, bits)` once for every quad around a variable; bits are its corners there.
  template <class Visit>
  void for_each_quad(std::uint32_t variable, const Visit& visit) const {
    for (std::uint32_t i = first_corners_[variable]; i < first_corners_[variable + 1]; ++i) {
      const std::uint32_t q = corners_[i] / 4;
      visit(q, variables_.empty() ? 1U << corners_[i] % 4 : bits_in(q, variable));
    }
  }
  /// Calls `visit(variable, bits)` once for every variable of a quad.
  template <class Visit>
  void for_each_variable(std::uint32_t q, const Visit& visit) const {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t variable = quad(q)[i];
      const unsigned bits = variables_.empty() ? 1U << i : bits_in(q, variable);
      if (static_cast<unsigned>(std::countr_zero(bits)) == i) {
        visit(variable, bits);
      }
    }
  }

  /// The mask of every quad under `labels`, which have a variable's vertices all zero or none.
  [[nodiscard]] LargeArray<QuadMask> masks(const VertexLabels& labels) const;

 private:
  std::span<const std::uint32_t> corner_variables_;  ///< 4 a quad.
  std::span<const std::uint32_t> first_corners_;     ///< Prefix sums of quads around variables.
  std::span<const std::uint32_t> corners_;           ///< One corner of each, 4 q + i.
  const ControlMesh* mesh_;

  // Only where there are faces other than quads:
  std::vector<std::uint32_t> variables_;      ///< Of every vertex.
  std::vector<std::uint32_t> first_members_;  ///< Prefix sums of vertices of variables.
  std::vector<std::uint32_t> members_;
  std::vector<std::uint32_t> polygon_faces_;
  std::vector<std::uint32_t> own_corner_variables_;
  std::vector<std::uint32_t> own_first_corners_;
  std::vector<std::uint32_t> own_corners_;
};

}  // namespace limn
