#pragma once

#include <array>
#include <cstddef>

#include "firmware/boards/qemu_mps2/image/failure.hpp"
#include "firmware/boards/qemu_mps2/image/machine.hpp"
#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/summary.hpp"
#include "lifemodel/block/parameter_block.hpp"

namespace firmware::qemu_mps2 {

/// Reads the parameter block for all tendons. Without one they have none.
template <class File>
Failure read_block(const Options& options, app::ParameterSet<kTendons>& parameters) {
  if (options.block == nullptr) {
    return {};
  }
  File file(options.block, File::Mode::read);
  std::array<std::byte, lifemodel::kBlockBytes + 1> bytes{};
  if (!file.is_open()) {
    return {"block", "cannot be opened"};
  }
  const std::size_t size = file.read(bytes);
  const auto decoded = lifemodel::decode(std::span(bytes).first(size));
  if (!decoded) {
    return {"block", lifemodel::to_string(decoded.error())};
  }
  parameters.fill(*decoded);
  return {};
}

/// Settings and flash after the options.
template <class File, class Backing>
Failure set_up(const Options& options, Settings& settings, Backing& backing) {
  settings.config = options.config;
  settings.seed = options.seed;
  if (const Failure failure = read_block<File>(options, settings.parameters)) {
    return failure;
  }
  if (options.flash != nullptr) {
    if (const char* wrong = backing.open(options.flash, kFlashBytes)) {
      return {"flash", wrong};
    }
  }
  return {};
}

/// Writes how the run has ended, where that is wanted.
template <class File, class MachineT>
Failure write_summary(const Options& options, const MachineT& machine) {
  if (options.summary == nullptr) {
    return {};
  }
  File file(options.summary, File::Mode::write);
  if (!file.is_open() || !Summary(machine, file).write()) {
    return {"summary", "cannot be written"};
  }
  return {};
}

}  // namespace firmware::qemu_mps2
