#pragma once

#ifdef __x86_64__
#include <cpuid.h>
#endif

namespace furrow::test {

/// Whether the processor has wide registers and tells what of them is in use (XGETBV with 1).
inline bool canTellUpperHalves() {
#ifdef __x86_64__
    unsigned a = 0;
    unsigned b = 0;
    unsigned c = 0;
    unsigned d = 0;
    constexpr unsigned kTells = 1U << 2U;
    return static_cast<bool>(__builtin_cpu_supports("avx")) &&
           __get_cpuid_count(0xD, 1, &a, &b, &c, &d) != 0 && (a & kTells) != 0;
#else
    return false;
#endif
}

/// Leaves something in the upper half of a wide register of the calling thread.
inline void useUpperHalves() {
#ifdef __x86_64__
    asm volatile("vcmptrueps %%ymm0, %%ymm0, %%ymm0" ::: "xmm0");
#endif
}

/// Whether there is something in the upper halves of the calling thread's wide registers.
inline bool areUpperHalvesInUse() {
#ifdef __x86_64__
    unsigned low = 0;
    unsigned high = 0;
    constexpr unsigned kUpperHalves = 1U << 2U;
    asm volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(1));
    return (low & kUpperHalves) != 0;
#else
    return false;
#endif
}

}  // namespace furrow::test
