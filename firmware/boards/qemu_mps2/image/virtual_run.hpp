#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/boards/qemu_mps2/image/machine.hpp"
#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "firmware/boards/qemu_mps2/image/run_files.hpp"
#include "hal/byte_stream.hpp"
#include "hal/clock.hpp"
#include "hal/error.hpp"
#include "hal/qemu_mps2/virtual_devices.hpp"
#include "hal/slcan/port.hpp"
#include "lifemodel/support/bytes.hpp"

namespace boards::qemu_mps2 {

/// A serial line with a scripted host at the other end: what the node writes is passed to `Line`,
/// what it reads is what the script types.
template <hal::ByteStream Line>
class ScriptedLine {
 public:
  explicit ScriptedLine(Line& line) : line_(line) {}

  /// False, and nothing has happened, where the node has not read enough of what came before.
  [[nodiscard]] bool type(std::span<const std::byte> text) {
    if (text.size() > typed_.free()) {
      return false;
    }
    typed_.push(text);
    return true;
  }
  void set_stalled(bool stalled) { stalled_ = stalled; }

  std::size_t try_read(std::span<std::byte> out) {
    std::size_t count = 0;
    while (count < out.size() && !typed_.empty()) {
      out[count++] = typed_.front().front();
      typed_.pop(1);
    }
    return count;
  }
  std::size_t try_write(std::span<const std::byte> in) {
    return stalled_ ? 0 : line_.try_write(in);
  }

 private:
  Line& line_;
  hal::slcan::ByteQueue<512> typed_;
  bool stalled_ = false;
};

/// Plays a recording to the machine in virtual time, so that a run is the same each time and
/// everywhere: a sample, what is due to settle, and each millisecond a poll.
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
    const bool due = machine_.app.isr_sample();
    for (std::size_t i = 0; due && i < kTendons && machine_.app.settle(); ++i) {
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

/// Plays the profile of the options in virtual time, with what the script says besides; every frame
/// goes to `line` as SLCAN, the channel open from the start.
template <class File, class SensorT = PlayedCurrent, hal::ByteStream Line, class ScriptT>
Failure play_profile(const Options& options, Line& line, ScriptT& script) {
  using Clock = hal::qemu_mps2::VirtualClock;
  using Host = ScriptedLine<Line>;

  File file(options.profile, File::Mode::read);
  if (!file.is_open()) {
    return {"profile", "cannot be opened"};
  }
  auto& profile = make_once<Profile<File>>(file);
  if (const char* wrong = profile.open()) {
    return {"profile", wrong};
  }
  Settings settings;
  settings.channel = hal::slcan::Channel::open;
  FileBacking<File> backing;
  if (const Failure failure = set_up<File>(options, settings, backing)) {
    return failure;
  }

  Clock clock;
  Host host(line);
  hal::NoHold hold;
  auto& machine = make_once<Machine<Host, Clock, FileBacking<File>, hal::NoHold, SensorT>>(
      host, clock, backing, hold, settings);
  if (const char* wrong = Player(machine, clock, host, profile, script).play()) {
    return {nullptr, wrong};
  }
  return write_summary<File>(options, machine);
}

/// The same with the events of the options.
template <class File, class SensorT = PlayedCurrent, hal::ByteStream Line>
Failure run_in_virtual_time(const Options& options, Line& line) {
  if (options.events == nullptr) {
    Script<File> nothing(nullptr);
    return play_profile<File, SensorT>(options, line, nothing);
  }
  File events(options.events, File::Mode::read);
  if (!events.is_open()) {
    return {"events", "cannot be opened"};
  }
  Script script(&events);
  return play_profile<File, SensorT>(options, line, script);
}

}  // namespace boards::qemu_mps2
