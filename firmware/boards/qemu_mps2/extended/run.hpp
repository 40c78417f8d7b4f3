#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "firmware/boards/qemu_mps2/extended/machine.hpp"
#include "firmware/boards/qemu_mps2/image/failure.hpp"
#include "firmware/boards/qemu_mps2/image/file_backing.hpp"
#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/place.hpp"
#include "firmware/boards/qemu_mps2/image/player.hpp"
#include "firmware/boards/qemu_mps2/image/profile.hpp"
#include "firmware/boards/qemu_mps2/image/script.hpp"
#include "firmware/boards/qemu_mps2/image/scripted_line.hpp"
#include "firmware/boards/qemu_mps2/image/set_up.hpp"
#include "lifemodel/block/extended_block.hpp"

namespace firmware::qemu_mps2 {

/// The block of the options, with or without an extension, for all tendons.
template <class File>
Failure read_extended_block(const Options& options, lifemodel::ExtendedParameters& model) {
  if (options.block == nullptr) {
    return {"block", "missing; accepted: block=FILE"};
  }
  File file(options.block, File::Mode::read);
  if (!file.is_open()) {
    return {"block", "cannot be opened"};
  }
  std::array<std::byte, lifemodel::kMostExtendedBytes + 1> bytes{};
  const auto decoded = lifemodel::decode_extended(std::span(bytes).first(file.read(bytes)));
  if (!decoded) {
    return {"block", to_string(decoded.error())};
  }
  model = *decoded;
  return {};
}

/// Plays the profile of the options in virtual time to an ExtendedMachine; every frame goes to
/// `line` as SLCAN, the channel open from the start.
template <class File, hal::ByteStream Line>
Failure run_extended(const Options& options, Line& line) {
  using Clock = hal::qemu_mps2::VirtualClock;
  using Host = ScriptedLine<Line>;

  File file(options.profile, File::Mode::read);
  auto& profile = place<Profile<File>>(file);
  if (const char* wrong = file.is_open() ? profile.open() : "cannot be opened") {
    return {"profile", wrong};
  }
  lifemodel::ExtendedParameters model{};
  if (const Failure failure = read_extended_block<File>(options, model)) {
    return failure;
  }
  Settings settings;
  settings.channel = hal::slcan::Channel::open;
  settings.config = options.config;
  settings.seed = options.seed;
  settings.parameters.fill(model.nominal);
  FileBacking<File> backing;
  if (options.flash != nullptr) {
    if (const char* wrong = backing.open(options.flash, kFlashBytes)) {
      return {"flash", wrong};
    }
  }
  Clock clock;
  Host host(line);
  auto& machine =
      place<ExtendedMachine<Host, Clock, FileBacking<File>>>(host, clock, backing, settings, model);
  Script<File> nothing(nullptr);
  if (const char* wrong = Player(machine, clock, host, profile, nothing).play()) {
    return {nullptr, wrong};
  }
  return write_summary<File>(options, machine);
}

}  // namespace firmware::qemu_mps2
