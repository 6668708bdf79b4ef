#include "planner/jobs/wide_registers.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace furrow {

#ifdef __x86_64__

namespace {

__attribute__((target("avx"))) void clearUpperHalves() {
    _mm256_zeroupper();
}

}  // namespace

void clearWideRegisters() {
    if (__builtin_cpu_supports("avx")) {
        clearUpperHalves();
    }
}

#else

void clearWideRegisters() {}

#endif

}  // namespace furrow
