#pragma once

#include <cstddef>
#include <span>

#include "firmware/boards/qemu_mps2/image/machine.hpp"
#include "firmware/boards/qemu_mps2/image/virtual_run.hpp"
#include "hal/qemu_mps2/memory_flash.hpp"
#include "hal/qemu_mps2/virtual_devices.hpp"

/// The application's calls as functions of their own, so that they are measured as they are and not
/// as they would be inlined into the measuring program.
namespace firmware_test {

/// A serial line that takes everything. (hal::ByteStream)
struct NullLine {
  static std::size_t try_read(std::span<std::byte>) { return 0; }
  static std::size_t try_write(std::span<const std::byte> in) { return in.size(); }
};

using Host = boards::qemu_mps2::ScriptedLine<NullLine>;
using Machine =
    boards::qemu_mps2::Machine<Host, hal::qemu_mps2::VirtualClock, hal::qemu_mps2::NoBacking>;
using App = Machine::App;

extern "C" {
void app_isr_sample(App* app, bool* due);
void app_settle(App* app, bool* more);
void app_poll(App* app);
}

}  // namespace firmware_test
