#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/boards/qemu_mps2/image/profile.hpp"
#include "firmware/boards/qemu_mps2/image/script.hpp"
#include "hal/clock.hpp"
#include "hal/error.hpp"
#include "hal/qemu_mps2/virtual_clock.hpp"
#include "lifemodel/support/bytes.hpp"

namespace firmware::qemu_mps2 {

/// Plays a recording to the machine in virtual time, so that a run is the same each time and
/// everywhere: a sample, all that is left to settle, and each millisecond a poll.
template <class MachineT, class LineT, class ProfileT, class ScriptT>
class Player {
 public:
  Player(MachineT& machine, hal::qemu_mps2::VirtualClock& clock, LineT& line, ProfileT& profile,
         ScriptT& script)
      : machine_(machine),
        clock_(clock),
        line_(line),
        profile_(profile),
        script_(script),
        period_(hal::microseconds(profile.sample_period_us())) {}

  /// What went wrong, in words; null where nothing did.
  const char* play() {
    machine_.app.start();
    while (const auto row = profile_.next()) {
      clock_.advance(period_);
      while (const auto event = script_.due(clock_.now())) {
        if (const char* wrong = happen(*event)) {
          return wrong;
        }
      }
      sample(*row);
      poll();
    }
    return machine_.app.stop() == hal::Error::none ? nullptr : "the last save failed";
  }

 private:
  void sample(const Row& row) {
    machine_.sensor.put(row);
    machine_.app.isr_sample();
    while (machine_.app.settle()) {
    }
  }

  void poll() {
    if (clock_.now() >= next_poll_) {
      next_poll_ = next_poll_ + hal::milliseconds(1);
      machine_.app.poll();
    }
  }

  const char* happen(const Event& event) {
    const std::uint32_t word = lifemodel::ByteReader(event.payload).u32();
    switch (event.kind) {
      case EventKind::line: {
        const auto end = std::ranges::find(event.payload, std::byte{});
        const auto size = static_cast<std::size_t>(end - event.payload.begin());
        return line_.type(std::span(event.payload).first(size))
                   ? nullptr
                   : "the script types faster than the node reads";
      }
      case EventKind::emergency_stop:
        machine_.emergency_stop.drive(word != 0);
        return nullptr;
      case EventKind::sensor_failed:
        machine_.sensor.set_failed(word != 0);
        return nullptr;
      case EventKind::missed:
        clock_.advance(hal::microseconds(std::uint64_t{word} * period_.us));
        machine_.app.isr_missed(word);
        next_poll_ = std::max(next_poll_, clock_.now());
        return nullptr;
      case EventKind::stalled:
        line_.set_stalled(word != 0);
        return nullptr;
    }
    return "the script has an event of unknown kind; accepted: 1 .. 5";
  }

  MachineT& machine_;
  hal::qemu_mps2::VirtualClock& clock_;
  LineT& line_;
  ProfileT& profile_;
  ScriptT& script_;
  hal::Time period_;
  hal::Time next_poll_{};
};

}  // namespace firmware::qemu_mps2
