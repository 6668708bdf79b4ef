#pragma once

namespace furrow {

/// Clears the upper halves of the calling thread's wide registers, where the processor has such.
/// A thread begins with the registers of the one that made it, and libraries that were built for wide
/// registers may leave something in the upper halves. From then on each switch between code that was built
/// for any x86-64 processor, as ours is, and code that was not, as sine and cosine of the system, takes
/// dozens of cycles: plans took three times as long in the window as on the command line. For threads of
/// work, before they begin; a few cycles. Source: Intel 64 and IA-32 Architectures Optimization Reference
/// Manual, "Mixing AVX code with SSE code".
void clearWideRegisters();

}  // namespace furrow
