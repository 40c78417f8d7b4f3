#include "firmware/boards/qemu_mps2/image/real_time_run.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/boards/qemu_mps2/image/machine.hpp"
#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "firmware/boards/qemu_mps2/image/run_files.hpp"
#include "firmware/boards/qemu_mps2/registers.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"
#include "firmware/boards/qemu_mps2/startup.hpp"
#include "hal/qemu_mps2/system_timer.hpp"

namespace boards::qemu_mps2 {
/// Priorities of the interrupts, most urgent first; the hardware has the high three bits at least.
constexpr std::uint32_t kSamplePriority = 0x00;
constexpr std::uint32_t kReceivePriority = 0x40;
constexpr std::uint32_t kSettlePriority = 0xe0;

/// Keeps PendSV away, and nothing else: BASEPRI, ARMv7-M Architecture Reference Manual (DDI 0403E),
/// B1.4.3. (hal::Hold)
struct SettleHold {
  void hold() { __asm__ volatile("msr basepri, %0" ::"r"(kSettlePriority) : "memory"); }
  void release() { __asm__ volatile("msr basepri, %0" ::"r"(0) : "memory"); }
};

/// All samples of a profile in memory, again and again.
class SampleLoop {
 public:
  static constexpr std::size_t kMost = 131'072;

  /// What is wrong, in words; null where nothing is.
  template <class ProfileT>
  const char* fill(ProfileT& profile) {
    while (const auto row = profile.next()) {
      if (size_ == rows_.size()) {
        return "the profile is too long to be held in memory; accepted: 131072 samples";
      }
      rows_[size_++] = *row;
    }
    return size_ == 0 ? "the profile has no samples" : nullptr;
  }

  /// @pre filled
  const Row& isr_next() {
    const Row& row = rows_[at_];
    at_ = at_ + 1 == size_ ? 0 : at_ + 1;
    return row;
  }

 private:
  std::array<Row, kMost> rows_{};
  std::size_t size_ = 0;
  std::size_t at_ = 0;
};

namespace {

constexpr std::uint32_t kTicksPerMicrosecond = kClock_Hz / 1'000'000;

using Timer = hal::qemu_mps2::SystemTimer<kTicksPerMicrosecond>;
using Backing = FileBacking<HostFile>;

hal::qemu_mps2::SysTickRegisters& sys_tick_registers() {
  constexpr std::uintptr_t kBase = 0xE000'E010;
  return *reinterpret_cast<hal::qemu_mps2::SysTickRegisters*>(kBase);
}

struct Board {
  Board(Backing& backing, const Settings& settings)
      : machine(uart, timer, backing, hold, settings) {}

  Uart0 uart{uart0_registers()};
  Timer timer{sys_tick_registers()};
  SettleHold hold;
  Machine<Uart0, Timer, Backing, SettleHold> machine;
  SampleLoop samples;
};

/// What the interrupts work on: they take no arguments.
constinit Board* running = nullptr;

void start_interrupts() {
  registers::kSystemHandlerPriority3.write((kSamplePriority << 24) | (kSettlePriority << 16));
  registers::kInterruptPriority0.write(kReceivePriority);
  constexpr std::uint32_t kUart0Receive = 1u << 0;
  registers::kInterruptSetEnable0.write(kUart0Receive);
}

/// Until the time is over; for ever where it is 0.
void poll_until(Board& board, hal::Time end) {
  hal::Time next{};
  for (;;) {
    const hal::Time now = board.timer.now();
    if (now >= next) {
      next = now + hal::milliseconds(1);
      board.machine.app.poll();
    }
    if (end != hal::Time{} && now >= end) {
      return;
    }
    __asm__ volatile("wfi");
  }
}

}  // namespace

extern "C" void sys_tick() noexcept {
  constexpr std::uint32_t kSetPendSv = 1u << 28;
  running->timer.isr_tick();
  running->machine.sensor.put(running->samples.isr_next());
  if (running->machine.app.isr_sample()) {
    registers::kInterruptControlState.write(kSetPendSv);
  }
}

extern "C" void pend_sv() noexcept {
  for (std::size_t i = 0; i < kTendons && running->machine.app.settle(); ++i) {
  }
}

extern "C" void uart0_receive() noexcept {
  running->uart.isr_receive();
}

Failure run_in_real_time(const Options& options) {
  HostFile file(options.profile, HostFile::Mode::read);
  if (!file.is_open()) {
    return {"profile", "cannot be opened"};
  }
  auto& profile = make_once<Profile<HostFile>>(file);
  if (const char* wrong = profile.open()) {
    return {"profile", wrong};
  }
  Settings settings;
  Backing backing;
  if (const Failure failure = set_up<HostFile>(options, settings, backing)) {
    return failure;
  }
  auto& board = make_once<Board>(backing, settings);
  if (const char* wrong = board.samples.fill(profile)) {
    return {"profile", wrong};
  }

  running = &board;
  board.machine.app.start();
  start_interrupts();
  if (board.uart.start(kClock_Hz, kUart0_bits_per_s) != hal::Error::none ||
      board.timer.start(profile.sample_period_us()) != hal::Error::none) {
    return {nullptr, "UART 0 or SysTick does not start"};
  }
  poll_until(board, hal::seconds(options.seconds));
  __asm__ volatile("cpsid i" ::: "memory");
  if (board.machine.app.stop() != hal::Error::none) {
    return {nullptr, "the last save failed"};
  }
  return write_summary<HostFile>(options, board.machine);
}

}  // namespace boards::qemu_mps2
