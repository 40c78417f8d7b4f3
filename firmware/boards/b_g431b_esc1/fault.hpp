#pragma once

namespace board {

/// Drive off, brake on, and the device starts again. Runs from RAM, needs no stack of what went
/// before, and works whatever was started so far.
[[noreturn]] void fail_safe();

/// Handler of every fault and of every interrupt that nobody expects: fail_safe() on a fresh stack.
extern "C" void isr_fault();

}  // namespace board
