#include "tests/corpus/plan_invariants.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

using namespace furrow;

/// Whatever field, machine and settings the bytes choose: no crash, no bad address, and a plan that holds
/// together or a refusal that says what to do. `tst_drawn_plans --chosen FILE` shows an input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const test::DrawnRequest drawn = test::chosenRequest({data, size});
    if (const test::DrawnVerdict verdict = test::verdictOn(drawn); !verdict.fault.empty()) {
        std::fprintf(stderr, "ERROR: %s: %s\n", verdict.fault.c_str(), drawn.told.c_str());
        std::abort();
    }
    return 0;
}
