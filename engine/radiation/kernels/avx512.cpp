#define BASK_KERNEL_WIDTH 64
#include "engine/radiation/kernels/loops.h"

namespace bask::kernels {

constinit const Kernels kAvx512Kernels = kernelsNamed("avx512");

} // namespace bask::kernels
