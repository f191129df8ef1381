#define BASK_KERNEL_WIDTH 16
#include "engine/radiation/kernels/loops.h"

namespace bask::kernels {

constinit const Kernels kBaselineKernels = kernelsNamed("baseline");

} // namespace bask::kernels
