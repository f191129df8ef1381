#include "engine/radiation/kernels/kernels.h"

namespace bask::kernels {

KernelList runnableKernels() {
    KernelList list{{&kBaselineKernels}, 1};
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        list.sets[list.count++] = &kAvx2Kernels;
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
        list.sets[list.count++] = &kAvx512Kernels;
#endif
    return list;
}

namespace {

const Kernels*& chosen() {
    static const Kernels* set = [] {
        const KernelList list = runnableKernels();
        return list.sets[list.count - 1];
    }();
    return set;
}

} // namespace

const Kernels& kernels() {
    return *chosen();
}

void useKernels(const Kernels& set) {
    chosen() = &set;
}

} // namespace bask::kernels
