#define BASK_KERNEL_WIDTH 32
#include "engine/radiation/kernels/loops.h"

namespace bask::kernels {

constinit const Kernels kAvx2Kernels = kernelsNamed("avx2");

} // namespace bask::kernels
