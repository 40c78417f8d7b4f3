#include "tests/virtual_g431/board/core.hpp"

#include <unicorn/unicorn.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace virtual_g431 {
namespace {

constexpr std::uint32_t kVectors = 0x08000000;
constexpr std::uint32_t kFlashEnd = 0x08020000;
constexpr std::uint32_t kSystem = 0xE000E000;
constexpr unsigned kNone = 256;  ///< below every priority
constexpr std::uint16_t kWfi = 0xBF30;

void check(uc_err error, const char* what) {
  if (error != UC_ERR_OK) {
    throw std::runtime_error(std::string(what) + ": " + uc_strerror(error));
  }
}

}  // namespace

Core::Core(Agenda& agenda, Rules& rules, Device device)
    : agenda_(agenda), rules_(rules), device_(std::move(device)) {
  check(uc_open(UC_ARCH_ARM, static_cast<uc_mode>(UC_MODE_THUMB | UC_MODE_MCLASS), &engine_),
        "unicorn");
  check(uc_ctl_set_cpu_model(engine_, UC_CPU_ARM_CORTEX_M4), "cortex-m4");
  const auto hook = [this](int type, void* function, std::uint64_t begin, std::uint64_t end) {
    uc_hook handle = 0;
    check(uc_hook_add(engine_, &handle, type, function, this, begin, end), "hook");
  };
  hook(UC_HOOK_BLOCK, reinterpret_cast<void*>(&block_hook), 1, 0);
  hook(UC_HOOK_INTR, reinterpret_cast<void*>(&exception_hook), 1, 0);
  hook(UC_HOOK_MEM_UNMAPPED | UC_HOOK_MEM_PROT, reinterpret_cast<void*>(&fault_hook), 1, 0);
  map_device(kSystem, 0x1000);
}

Core::~Core() {
  uc_close(engine_);
}

void Core::map_code(std::uint32_t address, std::uint8_t* bytes, std::size_t size) {
  check(uc_mem_map_ptr(engine_, address, size, UC_PROT_READ | UC_PROT_EXEC, bytes), "code");
  memories_.push_back({address, bytes, size, std::vector<BlockCost>(size / 2)});
}
void Core::map_ram(std::uint32_t address, std::uint8_t* bytes, std::size_t size) {
  check(uc_mem_map_ptr(engine_, address, size, UC_PROT_ALL, bytes), "memory");
  memories_.push_back({address, bytes, size, std::vector<BlockCost>(size / 2)});
}
void Core::map_device(std::uint32_t address, std::size_t size) {
  windows_.push_back(std::make_unique<Window>(Window{this, address}));
  check(uc_mmio_map(engine_, address, size, &window_read, windows_.back().get(), &window_write,
                    windows_.back().get()),
        "window");
}

std::uint64_t Core::window_read(uc_struct*, std::uint64_t offset, unsigned size, void* window) {
  const auto& [core, base] = *static_cast<Window*>(window);
  const std::uint32_t address = base + static_cast<std::uint32_t>(offset);
  if (base != kSystem) {
    return core->device_.read(address, size);
  }
  const std::uint32_t word = core->system_read(static_cast<std::uint32_t>(offset) & ~3u);
  return word >> (8 * (offset & 3));
}

void Core::window_write(uc_struct*, std::uint64_t offset, unsigned size, std::uint64_t value,
                        void* window) {
  const auto& [core, base] = *static_cast<Window*>(window);
  const auto word = static_cast<std::uint32_t>(value);
  if (base != kSystem) {
    return core->device_.write(base + static_cast<std::uint32_t>(offset), size, word);
  }
  if (size != 4) {
    core->rules_.broken("system control: written in less than words");
  }
  core->system_write(static_cast<std::uint32_t>(offset), word);
}

std::uint32_t Core::read_register(int id) {
  std::uint32_t value = 0;
  check(uc_reg_read(engine_, id, &value), "register");
  return value;
}
void Core::write_register(int id, std::uint32_t value) {
  check(uc_reg_write(engine_, id, &value), "register");
}
std::uint32_t Core::stack_pointer() {
  return read_register(UC_ARM_REG_SP);
}
void Core::set_stack_pointer(std::uint32_t value) {
  write_register(UC_ARM_REG_SP, value);
}
void Core::hang_at(std::uint32_t address) {
  constexpr std::array<std::uint8_t, 2> kJumpToItself{0xFE, 0xE7};
  const Memory* memory = memory_at(address, 2);
  if (memory == nullptr || !active_.empty()) {
    throw std::runtime_error("no thread, or no memory at " + hex(address));
  }
  for (std::size_t i = 0; i + 2 <= memory->size; i += 2) {
    if (std::memcmp(memory->bytes + i, kJumpToItself.data(), 2) == 0) {
      sleeping_ = false;
      return write_register(UC_ARM_REG_PC, (memory->base + static_cast<std::uint32_t>(i)) | 1);
    }
  }
  throw std::runtime_error("no jump to itself");
}
Core::Memory* Core::memory_at(std::uint32_t address, std::size_t size) {
  for (Memory& memory : memories_) {
    if (address >= memory.base && address - memory.base + size <= memory.size) {
      return &memory;
    }
  }
  return nullptr;
}
std::uint32_t Core::load(std::uint32_t address) {
  const Memory* memory = memory_at(address, 4);
  if (memory == nullptr) {
    throw std::runtime_error("no memory at " + hex(address));
  }
  std::uint32_t value = 0;
  std::memcpy(&value, memory->bytes + (address - memory->base), 4);
  return value;
}

void Core::reset() {
  active_.clear();
  enabled_.reset();
  latched_.reset();
  priorities_ = {};
  vtor_ = shcsr_ = cfsr_ = hfsr_ = 0;
  mpu_ctrl_ = mpu_number_ = 0;
  mpu_rbar_ = mpu_rasr_ = {};
  reset_requested_ = sleeping_ = guard_hit_ = false;
  for (Memory& memory : memories_) {
    std::fill(memory.costs.begin(), memory.costs.end(), BlockCost{});
  }
  for (const int id :
       {UC_ARM_REG_BASEPRI, UC_ARM_REG_PRIMASK, UC_ARM_REG_FAULTMASK, UC_ARM_REG_CONTROL}) {
    write_register(id, 0);
  }
  // What the other registers are is unknown (DDI 0403E B1.5.5).
  for (int id = UC_ARM_REG_R0; id <= UC_ARM_REG_R12; ++id) {
    write_register(id, 0xDEAD0000u + static_cast<std::uint32_t>(id));
  }
  write_register(UC_ARM_REG_XPSR, 0x01000000);
  write_register(UC_ARM_REG_SP, load(kVectors));
  write_register(UC_ARM_REG_LR, 0xFFFFFFFF);
  write_register(UC_ARM_REG_PC, load(kVectors + 4));
}

std::uint32_t Core::count_instructions(std::uint32_t address, std::uint32_t size) {
  Memory* memory = memory_at(address, size);
  if (memory == nullptr) {
    return 1;  // the fetch fails
  }
  const std::uint32_t offset = address - memory->base;
  BlockCost& cost = memory->costs[offset / 2];
  if (cost.size == size) {
    return cost.instructions;
  }
  cost = {size, 0};
  const std::uint8_t* bytes = memory->bytes + offset;
  for (std::uint32_t i = 0; i < size;) {
    std::uint16_t half = 0;
    std::memcpy(&half, bytes + i, 2);
    i += (half & 0xF800) >= 0xE800 ? 4 : 2;
    ++cost.instructions;
  }
  return cost.instructions;
}

void Core::pass_cycles(Ticks half_cycles) {
  agenda_.advance_to(agenda_.now() + device_.hclk() * half_cycles / 2);
}

void Core::block_hook(uc_struct*, std::uint64_t address, std::uint32_t size, void* self) {
  static_cast<Core*>(self)->block(static_cast<std::uint32_t>(address), size);
}

void Core::block(std::uint32_t address, std::uint32_t size) {
  // Nothing is fetched from a bank that is busy, and what waits for the fetch is not interrupted.
  while (address >= kVectors && address < kFlashEnd && device_.flash_busy() && !reset_requested_ &&
         !stopping_) {
    agenda_.advance_to(agenda_.next());
  }
  refresh();
  if (reset_requested_ || stopping_ || guard_hit_ || agenda_.now() >= until_ ||
      next_exception(false) != 0) {
    halted_ = true;
    uc_emu_stop(engine_);
    return;
  }
  const std::uint32_t count = count_instructions(address, size);
  (active_.empty() ? thread_instructions_ : active_.back().instructions) += count;
  pass_cycles(3 * count);
}

bool Core::fault_hook(uc_struct*, int type, std::uint64_t address, int, std::int64_t, void* self) {
  auto& core = *static_cast<Core*>(self);
  const char* what = type == UC_MEM_FETCH_UNMAPPED || type == UC_MEM_FETCH_PROT   ? "fetch from "
                     : type == UC_MEM_WRITE_UNMAPPED || type == UC_MEM_WRITE_PROT ? "write to "
                                                                                  : "read from ";
  core.bad_access_ = what + hex(static_cast<std::uint32_t>(address));
  return false;
}

void Core::guard_hook(uc_struct* engine, int, std::uint64_t address, int, std::int64_t,
                      void* self) {
  auto& core = *static_cast<Core*>(self);
  const auto [start, size] = core.guarded();
  if (address - start < size) {
    core.guard_hit_ = true;
    uc_emu_stop(engine);
  }
}

void Core::code_hook(uc_struct*, int, std::uint64_t address, int, std::int64_t, void* self) {
  auto& core = *static_cast<Core*>(self);
  if (core.device_.flash_busy()) {
    core.rules_.broken("read of code while the flash is busy, at " +
                       hex(static_cast<std::uint32_t>(address)));
  }
}

void Core::exception_hook(uc_struct* engine, std::uint32_t number, void* self) {
  auto& core = *static_cast<Core*>(self);
  constexpr std::uint32_t kExceptionReturn = 8;
  if (number == kExceptionReturn) {
    core.returned_ = true;
  } else {
    core.bad_access_ =
        "an instruction that raises exception " + std::to_string(number) + " of the emulator";
  }
  uc_emu_stop(engine);
}

/// The interrupt line is a level: what is asserted and not being handled is pending.
void Core::refresh() {
  const unsigned number = exception::kInterrupt0 + device_.interrupt;
  if (enabled_.test(number) && !latched_.test(number) && device_.line() &&
      std::none_of(active_.begin(), active_.end(),
                   [number](const Active& active) { return active.number == number; })) {
    latched_.set(number);
  }
}

unsigned Core::priority(unsigned number) const {
  // NMI and hard fault stand above the others; -2 and -1 are kept as 0 and 1, others from 2 on.
  return number == exception::kNmi         ? 0
         : number == exception::kHardFault ? 1
                                           : 2u + priorities_[number];
}

unsigned Core::next_exception(bool wakes) {
  unsigned running = kNone + 2;
  bool in_nmi = false;
  for (const Active& active : active_) {
    running = std::min(running, priority(active.number));
    in_nmi = in_nmi || active.number == exception::kNmi;
  }
  if (device_.nmi() && !in_nmi) {
    return exception::kNmi;
  }
  if (latched_.none()) {
    return 0;
  }
  unsigned best = 0;
  unsigned best_priority = running;
  for (unsigned number = 1; number < latched_.size(); ++number) {
    const bool ready =
        latched_.test(number) && (number < exception::kInterrupt0 || enabled_.test(number));
    if (ready && priority(number) < best_priority) {
      best = number;
      best_priority = priority(number);
    }
  }
  if (best == 0) {
    return 0;
  }
  const std::uint32_t base = read_register(UC_ARM_REG_BASEPRI) & 0xF0;
  const bool masked = (read_register(UC_ARM_REG_PRIMASK) & 1) != 0 && !wakes;
  if (masked || (base != 0 && priorities_[best] >= base)) {
    return 0;
  }
  // Inside an IT block the state of the conditions would be lost.
  const std::uint32_t xpsr = read_register(UC_ARM_REG_XPSR);
  return (xpsr & 0x0600FC00u) == 0 ? best : 0;
}

void Core::enter(unsigned number) {
  latched_.reset(number);
  const std::uint32_t xpsr = read_register(UC_ARM_REG_XPSR);
  std::uint32_t sp = read_register(UC_ARM_REG_SP);
  const std::uint32_t padding = sp & 4;
  sp -= 32 + padding;
  const std::array<std::uint32_t, 8> frame{
      read_register(UC_ARM_REG_R0), read_register(UC_ARM_REG_R1),     read_register(UC_ARM_REG_R2),
      read_register(UC_ARM_REG_R3), read_register(UC_ARM_REG_R12),    read_register(UC_ARM_REG_LR),
      read_register(UC_ARM_REG_PC), (xpsr & ~bit(9)) | (padding << 7)};
  const auto [guard, guard_size] = guarded();
  const Memory* stack = memory_at(sp, sizeof frame);
  const bool stackable = stack != nullptr;
  if (stackable) {
    std::memcpy(stack->bytes + (sp - stack->base), frame.data(), sizeof frame);
  }
  if (number != exception::kHardFault && number != exception::kMemoryFault &&
      (!stackable || (sp < guard + guard_size && sp + 32 > guard))) {
    cfsr_ |= bit(4);  // MSTKERR
    ++faults_;
    number = exception::kMemoryFault;
  }
  write_register(UC_ARM_REG_SP, sp);
  write_register(UC_ARM_REG_LR, active_.empty() ? 0xFFFFFFF9 : 0xFFFFFFF1);
  write_register(UC_ARM_REG_XPSR, (xpsr & 0xF8000000u) | 0x01000000u | number);
  write_register(UC_ARM_REG_PC, load((vtor_ == 0 ? kVectors : vtor_) + 4 * number));
  active_.push_back({number});
  sleeping_ = false;
  on_entry(number);
  pass_cycles(24);
}

void Core::leave() {
  if (active_.empty()) {
    fault(exception::kHardFault, "return from no exception");
    return;
  }
  const Active ended = active_.back();
  Count& count = counts_[ended.number];
  ++count.calls;
  count.total += ended.instructions;
  count.worst = std::max(count.worst, ended.instructions);
  active_.pop_back();
  const std::uint32_t sp = read_register(UC_ARM_REG_SP);
  std::array<std::uint32_t, 8> frame{};
  for (std::size_t i = 0; i < frame.size(); ++i) {
    frame[i] = load(sp + 4 * static_cast<std::uint32_t>(i));
  }
  constexpr std::array<int, 6> kRegisters{UC_ARM_REG_R0, UC_ARM_REG_R1,  UC_ARM_REG_R2,
                                          UC_ARM_REG_R3, UC_ARM_REG_R12, UC_ARM_REG_LR};
  for (std::size_t i = 0; i < kRegisters.size(); ++i) {
    write_register(kRegisters[i], frame[i]);
  }
  const std::uint32_t xpsr = frame[7];
  rules_.require(field(xpsr, 8, 0) == (active_.empty() ? 0 : active_.back().number),
                 "return to another context");
  write_register(UC_ARM_REG_SP, sp + 32 + ((xpsr & bit(9)) != 0 ? 4 : 0));
  write_register(UC_ARM_REG_XPSR, xpsr & ~bit(9));
  write_register(UC_ARM_REG_PC, frame[6] | 1);
  pass_cycles(20);
}

void Core::fault(unsigned number, const std::string& what) {
  ++faults_;
  if (what.size() != 0) {
    rules_.broken(what + " at " + hex(read_register(UC_ARM_REG_PC)));
  }
  for (const Active& active : active_) {
    if (active.number == exception::kHardFault || active.number == exception::kMemoryFault) {
      throw std::runtime_error("lock-up of the core: " + what);
    }
  }
  const bool own = number == exception::kMemoryFault && (shcsr_ & bit(16)) != 0;
  enter(own ? number : exception::kHardFault);
}

void Core::run_until(Ticks time) {
  until_ = time;
  stopping_ = false;
  while (!stopping_ && agenda_.now() < until_) {
    if (reset_requested_) {
      on_reset_request();
      continue;
    }
    refresh();
    if (sleeping_ && next_exception(true) == 0) {
      agenda_.advance_to(std::min(agenda_.next(), until_));
      continue;
    }
    sleeping_ = false;
    if (const unsigned number = next_exception(false)) {
      enter(number);
      continue;
    }
    halted_ = returned_ = false;
    bad_access_.clear();
    const std::uint32_t from = read_register(UC_ARM_REG_PC);
    const uc_err error = uc_emu_start(engine_, from | 1, 0, 0, 0);
    if (guard_hit_) {
      guard_hit_ = false;
      fault(exception::kMemoryFault, "");
    } else if (returned_) {
      leave();
    } else if (error != UC_ERR_OK || !bad_access_.empty()) {
      fault(exception::kHardFault, bad_access_.empty() ? uc_strerror(error) : bad_access_);
    } else if (!halted_) {
      std::uint16_t last = 0;
      check(uc_mem_read(engine_, read_register(UC_ARM_REG_PC) - 2, &last, 2), "code");
      if (last != kWfi) {
        throw std::runtime_error("stopped without a reason at " +
                                 hex(read_register(UC_ARM_REG_PC)));
      }
      sleeping_ = true;
    }
  }
}

std::pair<std::uint32_t, std::uint32_t> Core::guarded() const {
  for (std::size_t i = 0; i < mpu_rbar_.size(); ++i) {
    const bool on =
        (mpu_ctrl_ & 1) != 0 && (mpu_rasr_[i] & 1) != 0 && field(mpu_rasr_[i], 26, 24) == 0;
    if (on) {
      return {mpu_rbar_[i] & ~31u, 2u << field(mpu_rasr_[i], 5, 1)};
    }
  }
  return {0, 0};
}

void Core::enforce_guard() {
  if (!enforced_) {
    enforced_ = true;
    uc_hook handle = 0;
    check(uc_hook_add(engine_, &handle, UC_HOOK_MEM_WRITE | UC_HOOK_MEM_READ,
                      reinterpret_cast<void*>(&guard_hook), this, 0x20000000, 0x20005FFF),
          "guard");
    // Code that was translated before does not ask.
    check(uc_ctl_remove_cache(engine_, 0x08000000, 0x08015000), "cache");
    check(uc_ctl_remove_cache(engine_, 0x10000000, 0x10003000), "cache");
  }
}

void Core::watch_reads_of_code() {
  uc_hook handle = 0;
  check(uc_hook_add(engine_, &handle, UC_HOOK_MEM_READ, reinterpret_cast<void*>(&code_hook), this,
                    kVectors, kFlashEnd - 1),
        "reads");
}

std::uint32_t Core::system_read(std::uint32_t offset) {
  const auto bits = [](const auto& set, std::uint32_t word) {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 32 && 32 * word + i < kInterrupts; ++i) {
      value |= set.test(exception::kInterrupt0 + 32 * word + i) ? bit(i) : 0;
    }
    return value;
  };
  if (offset >= 0x100 && offset < 0x110) {
    return bits(enabled_, (offset - 0x100) / 4);
  }
  if (offset >= 0x400 && offset < 0x400 + kInterrupts) {
    std::uint32_t value = 0;
    std::memcpy(&value, &priorities_[exception::kInterrupt0 + offset - 0x400], 4);
    return value;
  }
  switch (offset) {
    case 0xD00:
      return 0x410FC241;
    case 0xD04:
      return (active_.empty() ? 0 : active_.back().number) |
             (latched_.test(exception::kPendSv) ? bit(28) : 0);
    case 0xD08:
      return vtor_;
    case 0xD0C:
      return 0xFA050000;
    case 0xD14:
      return ccr_;
    case 0xD18:
    case 0xD1C:
    case 0xD20: {
      std::uint32_t value = 0;
      std::memcpy(&value, &priorities_[4 + offset - 0xD18], 4);
      return value;
    }
    case 0xD24:
      return shcsr_;
    case 0xD28:
      return cfsr_;
    case 0xD2C:
      return hfsr_;
    case 0xD90:
      return 0x800;
    case 0xD94:
      return mpu_ctrl_;
    default:
      rules_.broken("system control: read of " + hex(kSystem + offset));
      return 0;
  }
}

void Core::system_write(std::uint32_t offset, std::uint32_t value) {
  const auto each = [value](std::uint32_t word, auto what) {
    for (unsigned i = 0; i < 32 && 32 * word + i < kInterrupts; ++i) {
      if ((value >> i & 1) != 0) {
        what(exception::kInterrupt0 + 32 * word + i);
      }
    }
  };
  const auto priorities = [&](unsigned first) {
    for (unsigned i = 0; i < 4; ++i) {
      // The device has the upper 4 bits (RM0440 14.3).
      priorities_[first + i] = static_cast<std::uint8_t>(value >> (8 * i) & 0xF0);
    }
  };
  if (offset >= 0x100 && offset < 0x110) {
    return each((offset - 0x100) / 4, [this](unsigned number) { enabled_.set(number); });
  }
  if (offset >= 0x180 && offset < 0x190) {
    return each((offset - 0x180) / 4, [this](unsigned number) { enabled_.reset(number); });
  }
  if (offset >= 0x280 && offset < 0x290) {
    return each((offset - 0x280) / 4, [this](unsigned number) { latched_.reset(number); });
  }
  if (offset >= 0x400 && offset < 0x400 + kInterrupts) {
    return priorities(exception::kInterrupt0 + offset - 0x400);
  }
  switch (offset) {
    case 0xD04:
      rules_.require((value & ~bit(28)) == 0, "ICSR with " + hex(value));
      latched_.set(exception::kPendSv, latched_.test(exception::kPendSv) || (value & bit(28)) != 0);
      return;
    case 0xD08:
      rules_.require(value % 512 == 0, "VTOR not at a multiple of the size of the table");
      vtor_ = value;
      return;
    case 0xD0C:
      rules_.require(value >> 16 == 0x05FA, "AIRCR without its key");
      reset_requested_ = reset_requested_ || (value >> 16 == 0x05FA && (value & bit(2)) != 0);
      return;
    case 0xD18:
    case 0xD1C:
    case 0xD20:
      return priorities(4 + offset - 0xD18);
    case 0xD24:
      shcsr_ = value;
      return;
    case 0xD94:
      rules_.require((value & 1) == 0 || (value & bit(2)) != 0, "MPU on without the default map");
      mpu_ctrl_ = value;
      return;
    case 0xD98:
      mpu_number_ = value & 7;
      return;
    case 0xD9C:
      rules_.require((value & bit(4)) == 0, "MPU: region by RBAR");
      mpu_rbar_[mpu_number_] = value;
      return;
    case 0xDA0:
      rules_.require((mpu_rbar_[mpu_number_] & ((2u << field(value, 5, 1)) - 1) & ~31u) == 0,
                     "MPU: region not at a multiple of its size");
      mpu_rasr_[mpu_number_] = value;
      return;
    default:
      rules_.broken("system control: write of " + hex(kSystem + offset));
  }
}

}  // namespace virtual_g431
