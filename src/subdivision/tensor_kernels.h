#pragma once

#include <cstddef>

#include "subdivision/bicubic_errors.h"
#include "subdivision/tensor_grid.h"

// Internal to this folder.
namespace limn {

/// The longest row of a grid that limits are asked of, with the ring.
inline constexpr std::size_t kLongestLimitRow = 35;

/// Rows of points in single precision, coordinate by coordinate. Read and written by eights, so
/// there is room for some more.
using CoordinateRow = float[3][kLongestLimitRow + 13];

/// Rows of a grid, ring included, combined: 6 times the mean and twice the tangent.
struct CombinedRow {
  CoordinateRow means;
  CoordinateRow differences;
};

/// The loops over the points of grids, which are compiled for several kinds of processor. All give
/// the same results to the bit: none uses fused multiply-add.
struct TensorKernels {
  void (*refine_grid)(const GridView& grid, StoredPoint* out);
  void (*refine_line)(const GridLine& line, StoredPoint* out);
  void (*refine_inner_rows)(const GridView& grid, float* out, std::size_t width);
  void (*limit_inner_rows)(const GridView& grid, float* out);
  void (*limit_line)(const GridLine& line, StoredPoint* out);
  /// All rows of the grid with the ring, moved by -`middle` and then scaled.
  void (*load_rows)(const GridView& grid, const StoredPoint& middle, const StoredPoint& scale,
                    CoordinateRow* rows);
  /// At row rows[0] out of the row before, itself and the one after; `is_between`: between it and
  /// the next, out of two before and two after.
  void (*combine_rows)(const CoordinateRow* rows, std::size_t n, bool is_between, CombinedRow& out);
  /// The normals of the 2 n + 1 vertices of a row one level down, 3 floats each, and up to 15 more.
  /// Whether all are exact enough.
  bool (*write_normals)(const CombinedRow& row, std::size_t n, float* out);
  void (*bicubic_errors)(const BicubicBatch& batch, bool at_level, BicubicErrors& errors);
};

/// Those for the processor at hand.
[[nodiscard]] const TensorKernels& tensor_kernels() noexcept;

extern const TensorKernels kBaselineKernels;
#ifdef LIMN_HAS_AVX2_KERNELS
extern const TensorKernels kAvx2Kernels;
#endif

}  // namespace limn
