#pragma once

#include "firmware/boards/qemu_mps2/image/failure.hpp"
#include "firmware/boards/qemu_mps2/image/file_backing.hpp"
#include "firmware/boards/qemu_mps2/image/machine.hpp"
#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/place.hpp"
#include "firmware/boards/qemu_mps2/image/player.hpp"
#include "firmware/boards/qemu_mps2/image/profile.hpp"
#include "firmware/boards/qemu_mps2/image/script.hpp"
#include "firmware/boards/qemu_mps2/image/scripted_line.hpp"
#include "firmware/boards/qemu_mps2/image/set_up.hpp"

namespace firmware::qemu_mps2 {

/// Plays the profile of the options in virtual time, with what the script says besides; every frame
/// goes to `line` as SLCAN, the channel open from the start.
template <class File, hal::ByteStream Line, class ScriptT>
Failure play_profile(const Options& options, Line& line, ScriptT& script) {
  using Clock = hal::qemu_mps2::VirtualClock;
  using Host = ScriptedLine<Line>;

  File file(options.profile, File::Mode::read);
  if (!file.is_open()) {
    return {"profile", "cannot be opened"};
  }
  auto& profile = place<Profile<File>>(file);
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
  auto& machine =
      place<Machine<Host, Clock, FileBacking<File>>>(host, clock, backing, hold, settings);
  if (const char* wrong = Player(machine, clock, host, profile, script).play()) {
    return {nullptr, wrong};
  }
  return write_summary<File>(options, machine);
}

/// The same with the events of the options.
template <class File, hal::ByteStream Line>
Failure run_in_virtual_time(const Options& options, Line& line) {
  if (options.events == nullptr) {
    Script<File> nothing(nullptr);
    return play_profile<File>(options, line, nothing);
  }
  File events(options.events, File::Mode::read);
  if (!events.is_open()) {
    return {"events", "cannot be opened"};
  }
  Script script(&events);
  return play_profile<File>(options, line, script);
}

}  // namespace firmware::qemu_mps2
