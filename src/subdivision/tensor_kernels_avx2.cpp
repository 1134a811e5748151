// For processors whose vector registers hold a whole Point.
#include "subdivision/tensor_kernels.inl"

namespace limn {
const TensorKernels kAvx2Kernels = kKernelsHere;
}  // namespace limn
