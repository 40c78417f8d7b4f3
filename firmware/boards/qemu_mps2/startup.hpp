#pragma once

namespace boards::qemu_mps2 {

/// What the program exits with after a fault or an exception that nobody expected.
inline constexpr int kFaultExitCode = 127;

/// Handler of every exception: prints the exception, the fault status and where it happened, then
/// exits with kFaultExitCode. Runs on a stack of its own.
extern "C" void fault() noexcept;

/// Handlers that a program may define; each is fault() where it does not.
extern "C" void pend_sv() noexcept;
extern "C" void sys_tick() noexcept;
extern "C" void uart0_receive() noexcept;

}  // namespace boards::qemu_mps2
