#include "subdivision/bicubic_errors.h"

#include "subdivision/tensor_kernels.h"

namespace limn {

void bicubic_errors(const BicubicBatch& batch, bool at_level, BicubicErrors& errors) noexcept {
  tensor_kernels().bicubic_errors(batch, at_level, errors);
}

}  // namespace limn
