#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "firmware/app/config.hpp"
#include "firmware/app/intake.hpp"
#include "firmware/app/keeper.hpp"
#include "firmware/app/life_book.hpp"
#include "firmware/app/models.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "firmware/protocol/uds/device.hpp"
#include "lifemodel/estimator.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace app {

/// The node as its diagnostic server sees it (protocol::uds::Device).
template <std::size_t kTendons, class Devices, class LayoutT>
class Node {
 public:
  using Store = typename Devices::Store;
  using Estimator = lifemodel::Estimator<kTendons, LayoutT>;

  Node(Devices& devices, const Config& config, LifeBook<kTendons>& book,
       Keeper<kTendons, Store>& keeper, Intake<kTendons, LayoutT>& intake, Estimator& estimator,
       std::array<ParameterState, kTendons>& parameters)
      : devices_(devices),
        config_(config),
        book_(book),
        keeper_(keeper),
        intake_(intake),
        estimator_(estimator),
        parameters_(parameters) {}

  [[nodiscard]] protocol::uds::Identity identity() const {
    return {config_.serial, protocol::schema::kSchemaVersion, kFirmwareVersion};
  }
  [[nodiscard]] std::uint8_t tendons() const { return kTendons; }
  [[nodiscard]] storage::LifeRecord read_life(std::uint8_t tendon) const {
    storage::LifeRecord life = book_.records()[tendon];
    life.sequence = devices_.store.sequence();
    return life;
  }
  [[nodiscard]] std::uint32_t configuration(std::uint8_t tendon) const {
    return book_.records()[tendon].configuration;
  }
  [[nodiscard]] protocol::uds::ParameterReport parameters(std::uint8_t tendon) const {
    const ParameterState& state = parameters_[tendon];
    return {static_cast<std::uint8_t>(state.source), static_cast<std::uint8_t>(state.refusal.fault),
            state.refusal.effect, state.refusal.covariate, state.refusal.crc};
  }
  [[nodiscard]] std::uint32_t storage_counter() const { return devices_.store.sequence(); }
  hal::Error random(std::span<std::byte> out) { return devices_.entropy.fill(out); }

  hal::Error log(storage::Event event, std::uint8_t tendon, std::uint32_t detail) {
    storage::LogEntry entry;
    entry.sequence = devices_.store.sequence();
    entry.event = event;
    entry.tendon = tendon;
    entry.epoch = tendon < kTendons ? book_.records()[tendon].epoch : std::uint16_t{0};
    entry.detail = detail;
    return devices_.store.append(entry);
  }
  [[nodiscard]] std::optional<storage::LogEntry> log_entry(std::uint32_t number) const {
    return devices_.store.log(number);
  }

  /// A new wire: its epoch begins at the last reading, its flags, peak and
  /// break with the next sample. Cycles of a
  /// sheath are those of its wire.
  hal::Error open_epoch(std::uint8_t tendon) {
    auto records = book_.records();
    if (records[tendon].epoch == std::numeric_limits<std::uint16_t>::max()) {
      return hal::Error::full;
    }
    records[tendon] = book_.next_epoch(tendon);
    const hal::Error error = keeper_.save(devices_.clock.now(), records);
    if (error == hal::Error::none) {
      book_.open(tendon, records[tendon]);
      devices_.hold.hold();
      estimator_.forget_flags(tendon);
      devices_.hold.release();
      intake_.begin_wire(tendon);
      if constexpr (ExtendingSensor<typename Devices::Sensor>) {
        devices_.sensor.start_at(tendon, 0);  // the sheath is changed with the wire
      }
    }
    return error;
  }

  /// Whether the board can count with a model. Where not, the state of the tendon says why.
  bool accepts(std::uint8_t tendon, const lifemodel::ExtendedParameters& model, std::uint32_t crc) {
    parameters_[tendon].refusal = refusal_of(model, parameters_[tendon].evaluates, crc);
    return parameters_[tendon].refusal.fault == ParameterFault::none;
  }
  void refuse_parameters(std::uint8_t tendon, const lifemodel::ExtendedBlockError& error,
                         std::uint32_t crc) {
    parameters_[tendon].refusal = {.fault = fault_of(error), .crc = crc};
  }
  /// Takes effect at the next start: what is counted now continues under the parameters under which
  /// it began.
  hal::Error load_parameters(std::uint8_t tendon, const lifemodel::ExtendedBlock& block) {
    const hal::Error error = devices_.store.save_parameters(tendon, block);
    if (error == hal::Error::none) {
      // Raises the storage counter. Where it fails, the next save does.
      (void)keeper_.save(devices_.clock.now(), book_.records());
    }
    return error;
  }

 private:
  Devices& devices_;
  const Config& config_;
  LifeBook<kTendons>& book_;
  Keeper<kTendons, Store>& keeper_;
  Intake<kTendons, LayoutT>& intake_;
  Estimator& estimator_;
  std::array<ParameterState, kTendons>& parameters_;
};

}  // namespace app
