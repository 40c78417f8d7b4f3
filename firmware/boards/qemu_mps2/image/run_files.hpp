#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/boards/qemu_mps2/image/machine.hpp"
#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "firmware/boards/qemu_mps2/text.hpp"
#include "firmware/storage/life_record.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/damage/damage.hpp"

namespace boards::qemu_mps2 {

/// Keeps a MemoryFlash in a file, each change at once, so that the end of the emulator is a power
/// cut. Without a file it keeps nothing. (hal::qemu_mps2::Backing)
template <class File>
class FileBacking {
 public:
  /// Opens the file, or makes it; gives what is wrong in words, null where nothing is. A file of
  /// another size than `bytes` is left as it is.
  const char* open(const char* path, std::uint32_t bytes) {
    file_.emplace(path, File::Mode::update);
    if (!file_->is_open()) {
      file_.emplace(path, File::Mode::replace);
      if (!file_->is_open()) {
        file_.reset();
        return "cannot be opened or made";
      }
      return fill(bytes) ? nullptr : "cannot be written";
    }
    if (count() != bytes) {
      file_.reset();
      return "has another size than the flash; accepted: 40960 bytes, or no file";
    }
    return nullptr;
  }

  bool load(std::span<std::byte> out) {
    return file_ && file_->seek(0) && file_->read(out) == out.size();
  }
  bool keep(std::uint32_t address, std::span<const std::byte> in) {
    return !file_ || (file_->seek(address) && file_->write(in));
  }

 private:
  using Chunk = std::array<std::byte, 1'024>;

  bool fill(std::uint32_t bytes) {
    Chunk erased;
    erased.fill(std::byte{0xff});
    for (std::uint32_t left = bytes; left > 0;) {
      const auto size = std::min<std::uint32_t>(left, erased.size());
      if (!file_->write(std::span(erased).first(size))) {
        return false;
      }
      left -= size;
    }
    return true;
  }

  std::uint32_t count() {
    Chunk chunk;
    std::uint32_t sum = 0;
    for (std::size_t size = chunk.size(); size == chunk.size();) {
      size = file_->read(chunk);
      sum += static_cast<std::uint32_t>(size);
    }
    return sum;
  }

  std::optional<File> file_;
};

/// How a run has ended, in lines of text with every bit of the lives.
template <class MachineT, Sink SinkT>
class Summary {
 public:
  Summary(const MachineT& machine, SinkT& sink) : machine_(machine), sink_(sink) {}

  /// False where it could not be written.
  [[nodiscard]] bool write() {
    for (const storage::LifeRecord& life : machine_.app.lives().records()) {
      Line line;
      line << "tendon " << life.tendon << " epoch " << life.epoch << " flags " << life.flags;
      damage(line << " damage ", life.epoch_damage);
      damage(line << " lifetime ", life.lifetime_damage);
      line << " cycles ";
      line.hex(static_cast<std::uint32_t>(life.epoch_cycles >> 32));
      line.hex(static_cast<std::uint32_t>(life.epoch_cycles));
      line << " configuration ";
      line.hex(life.configuration);
      end(line);
    }
    Line line;
    line << "saves " << machine_.store.sequence() << " drive "
         << std::uint32_t{machine_.drive_enable.asserted()} << " brake "
         << std::uint32_t{machine_.brake.asserted()} << " light " << machine_.status_light.changes()
         << " watchdog " << machine_.watchdog.feeds();
    end(line);
    return whole_;
  }

 private:
  using Line = Text<200>;

  static void damage(Line& line, const lifemodel::Damage& damage) {
    for (std::size_t i = damage.words().size(); i-- > 0;) {
      line.hex(damage.words()[i]);
    }
  }

  void end(Line& line) {
    line << "\n";
    whole_ = sink_.write(std::as_bytes(std::span(line.c_str(), line.size()))) && whole_;
  }

  const MachineT& machine_;
  SinkT& sink_;
  bool whole_ = true;
};

/// Reads the parameter block for all tendons, with its extension if it has one. Without a block
/// they have none.
template <class File>
Failure read_block(const Options& options, app::ConfiguredModels<kTendons>& models) {
  if (options.block == nullptr) {
    return {};
  }
  File file(options.block, File::Mode::read);
  std::array<std::byte, lifemodel::kMostExtendedBytes + 1> bytes{};
  if (!file.is_open()) {
    return {"block", "cannot be opened"};
  }
  const std::size_t size = file.read(bytes);
  const auto decoded = lifemodel::decode_extended(std::span(bytes).first(size));
  if (!decoded) {
    return {"block", lifemodel::to_string(decoded.error())};
  }
  models.fill(*decoded);
  return {};
}

/// Settings and flash after the options.
template <class File, class Backing>
Failure set_up(const Options& options, Settings& settings, Backing& backing) {
  settings.config = options.config;
  settings.seed = options.seed;
  if (const Failure failure = read_block<File>(options, settings.models)) {
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

}  // namespace boards::qemu_mps2
