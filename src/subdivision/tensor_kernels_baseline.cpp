// For any processor.
#include "subdivision/tensor_kernels.inl"

namespace limn {
const TensorKernels kBaselineKernels = kKernelsHere;
}  // namespace limn
