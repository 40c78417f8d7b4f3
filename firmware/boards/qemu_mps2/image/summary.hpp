#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/boards/qemu_mps2/image/format.hpp"
#include "firmware/boards/qemu_mps2/image/source.hpp"
#include "firmware/boards/qemu_mps2/text.hpp"
#include "firmware/storage/life_record.hpp"
#include "lifemodel/damage/damage.hpp"

namespace firmware::qemu_mps2 {

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
         << std::uint32_t{machine_.brake.asserted()} << " light " << machine_.light.changes()
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

}  // namespace firmware::qemu_mps2
