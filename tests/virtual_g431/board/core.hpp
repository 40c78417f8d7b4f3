#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/virtual_g431/board/agenda.hpp"
#include "tests/virtual_g431/board/peripheral.hpp"

struct uc_struct;

namespace virtual_g431 {

/// Numbers of exceptions, DDI 0403E B1.5.2.
namespace exception {
inline constexpr unsigned kNmi = 2, kHardFault = 3, kMemoryFault = 4, kPendSv = 14,
                          kInterrupt0 = 16;
}

/// Cortex-M4: Unicorn runs its instructions; exceptions, NVIC and the system control block are
/// here, for Unicorn has none (DDI 0403E B1.5, B3.2, B3.4, B3.5).
///
/// Every instruction takes 1.5 cycles, an exception 12 in and 10 out. Interrupts are taken between
/// blocks of instructions without a jump.
class Core {
 public:
  static constexpr unsigned kInterrupts = 102;

  /// What the core asks of the device around it.
  struct Device {
    std::function<Ticks()> hclk;
    unsigned interrupt;          ///< the one that is connected
    std::function<bool()> line;  ///< its level
    std::function<bool()> nmi;   ///< level of the NMI
    std::function<bool()> flash_busy;
    std::function<std::uint32_t(std::uint32_t address, unsigned size)> read;
    std::function<void(std::uint32_t address, unsigned size, std::uint32_t value)> write;
  };

  Core(Agenda& agenda, Rules& rules, Device device);
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;
  ~Core();

  void map_code(std::uint32_t address, std::uint8_t* bytes, std::size_t size);
  void map_ram(std::uint32_t address, std::uint8_t* bytes, std::size_t size);
  /// A window through which accesses go to Device.
  void map_device(std::uint32_t address, std::size_t size);

  /// Starts at the vectors of the flash, at address 0x08000000.
  void reset();
  /// Runs until that time, or until stop() is called.
  void run_until(Ticks time);
  void stop() { stopping_ = true; }
  [[nodiscard]] bool stopped() const { return stopping_; }
  /// At the next boundary of blocks.
  void request_reset() { reset_requested_ = true; }
  std::function<void()> on_reset_request = [] {};

  /// Called when an exception is entered and, with its instructions, when it ends.
  std::function<void(unsigned)> on_entry = [](unsigned) {};
  struct Count {
    std::uint64_t calls = 0, total = 0, worst = 0;
  };
  /// Instructions of each exception, without those of what interrupted it.
  [[nodiscard]] const Count& instructions(unsigned number) const { return counts_[number]; }
  void forget_counts() { counts_ = {}; }
  [[nodiscard]] std::uint64_t faults() const { return faults_; }

  [[nodiscard]] bool in_thread() const { return active_.empty(); }
  /// In a WFI: the next access to the stack is the frame of an exception.
  [[nodiscard]] bool asleep() const { return sleeping_; }
  [[nodiscard]] std::uint32_t stack_pointer();
  void set_stack_pointer(std::uint32_t value);
  /// The thread goes on at a jump to itself, which is looked for in the memory at `address`.
  void hang_at(std::uint32_t address);
  /// The region that the protection unit shuts for all, as start and size; size 0 without one.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> guarded() const;
  /// Watches the guarded region, which slows every access down.
  void enforce_guard();
  /// Reads of the code's pages while the flash is busy break a rule: they would stall. Slow too;
  /// before the power comes.
  void watch_reads_of_code();

 private:
  struct Active {
    unsigned number;
    std::uint64_t instructions = 0;
  };
  struct BlockCost {
    std::uint32_t size = 0, instructions = 0;
  };
  struct Memory {
    std::uint32_t base;
    std::uint8_t* bytes;
    std::size_t size;
    std::vector<BlockCost> costs;  ///< of blocks, by their first halfword
  };

  static void block_hook(uc_struct*, std::uint64_t address, std::uint32_t size, void* self);
  static bool fault_hook(uc_struct*, int type, std::uint64_t address, int size, std::int64_t value,
                         void* self);
  static void code_hook(uc_struct*, int type, std::uint64_t address, int size, std::int64_t value,
                        void* self);
  static void guard_hook(uc_struct*, int type, std::uint64_t address, int size, std::int64_t value,
                         void* self);
  static void exception_hook(uc_struct*, std::uint32_t number, void* self);
  static std::uint64_t window_read(uc_struct*, std::uint64_t offset, unsigned size, void* window);
  static void window_write(uc_struct*, std::uint64_t offset, unsigned size, std::uint64_t value,
                           void* window);

  void block(std::uint32_t address, std::uint32_t size);
  void pass_cycles(Ticks half_cycles);
  std::uint32_t count_instructions(std::uint32_t address, std::uint32_t size);
  void refresh();
  /// The exception to take now; 0 for none. `wakes` asks what would end a WFI.
  unsigned next_exception(bool wakes);
  [[nodiscard]] unsigned priority(unsigned number) const;
  void enter(unsigned number);
  void leave();
  void fault(unsigned number, const std::string& what);

  std::uint32_t system_read(std::uint32_t offset);
  void system_write(std::uint32_t offset, std::uint32_t value);
  std::uint32_t read_register(int id);
  void write_register(int id, std::uint32_t value);
  /// Null where no memory holds all of it.
  Memory* memory_at(std::uint32_t address, std::size_t size);
  std::uint32_t load(std::uint32_t address);

  struct Window {
    Core* core;
    std::uint32_t address;
  };

  Agenda& agenda_;
  Rules& rules_;
  Device device_;
  uc_struct* engine_ = nullptr;
  std::vector<std::unique_ptr<Window>> windows_;
  std::vector<Memory> memories_;

  std::vector<Active> active_;
  std::array<Count, 16 + kInterrupts> counts_{};
  std::uint64_t faults_ = 0;
  std::bitset<16 + kInterrupts> enabled_, latched_;
  std::array<std::uint8_t, 16 + kInterrupts> priorities_{};
  std::uint32_t vtor_ = 0, shcsr_ = 0, cfsr_ = 0, hfsr_ = 0, ccr_ = 0x200;
  std::uint32_t mpu_ctrl_ = 0, mpu_number_ = 0;
  std::array<std::uint32_t, 8> mpu_rbar_{}, mpu_rasr_{};

  Ticks until_ = 0;
  std::uint64_t thread_instructions_ = 0;
  bool stopping_ = false, halted_ = false, returned_ = false, sleeping_ = false;
  bool reset_requested_ = false, guard_hit_ = false, enforced_ = false;
  std::string bad_access_;
};

}  // namespace virtual_g431
