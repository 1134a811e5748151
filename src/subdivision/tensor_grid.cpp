// What costs time is in tensor_kernels.inl; here the kernels for the processor at hand are chosen.
#include "subdivision/tensor_grid.h"

#include "subdivision/tensor_kernels.h"

namespace limn {

const TensorKernels& tensor_kernels() noexcept {
#ifdef LIMN_HAS_AVX2_KERNELS
  static const TensorKernels& best =
      __builtin_cpu_supports("avx2") != 0 ? kAvx2Kernels : kBaselineKernels;
  return best;
#else
  return kBaselineKernels;
#endif
}

void refine_grid(const GridView& grid, Point* out) {
  tensor_kernels().refine_grid(grid, out);
}

void refine_line(const GridLine& line, Point* out) {
  tensor_kernels().refine_line(line, out);
}

void refine_inner_rows(const GridView& grid, float* out, std::size_t width) {
  tensor_kernels().refine_inner_rows(grid, out, width);
}

void limit_inner_rows(const GridView& grid, float* out) {
  tensor_kernels().limit_inner_rows(grid, out);
}

void limit_line(const GridLine& line, Point* out) {
  tensor_kernels().limit_line(line, out);
}

void bilinear_inner_rows(const GridView& grid, float* out, std::size_t width) {
  for (std::size_t row = 2; row <= 2 * grid.n; ++row) {
    const Point* below = grid.points + (row + 1) / 2 * grid.stride;
    const Point* above = grid.points + (row / 2 + 1) * grid.stride;
    for (std::size_t column = 2; column <= 2 * grid.n; ++column) {
      const std::size_t left = (column + 1) / 2;
      const std::size_t right = column / 2 + 1;
      const Point point = (below[left] + below[right] + above[left] + above[right]) * 0.25;
      for (std::size_t i = 0; i < width; ++i) {
        *out++ = static_cast<float>(point[i]);
      }
    }
  }
}

void refine_curve(const GridLine& line, Point* out, std::size_t out_step) {
  Point before = line.points[0];
  Point here = line.points[line.along];
  for (std::size_t x = 0; x <= line.n; ++x) {
    const Point after = line.points[(x + 2) * line.along];
    out[2 * x * out_step] = curve_edge_point(before, here);
    out[(2 * x + 1) * out_step] = curve_vertex_point(before, here, after);
    before = here;
    here = after;
  }
  out[(2 * line.n + 2) * out_step] = curve_edge_point(before, here);
}

}  // namespace limn
