#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/protocol/uds/data.hpp"
#include "firmware/storage/life_record.hpp"
#include "firmware/storage/store.hpp"
#include "hal/error.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace protocol::uds {

/// Which device this is, and what runs on it.
struct Identity {
  std::array<std::byte, 12> serial{};  ///< of the controller; shorter ones end in zeros
  std::uint8_t schema = 0;             ///< version of the frame plan
  std::uint8_t firmware = 0;           ///< version, major in the high 4 bits, minor in the low
};

/// What the server needs of the node. Tendons count from 0; the server asks for none that is not
/// there.
///
/// read_life(tendon): the life as it is now, not as it was saved last.
/// configuration(tendon): CRC-32 of its parameter block; 0 without one. parameters(tendon): what it
/// counts with, and why not with others.
/// storage_counter(): rises with every committed change, and never falls over restarts.
/// random(out): bytes that nobody can foretell.
/// log(): adds a line that outlives a power cut before it returns none; full, or another Error, and
/// there is no line. log_entry(i): the i-th line from the oldest, nothing past the end.
/// accepts(tendon, model, crc): whether it can count with the model of the block with this CRC;
/// where not, parameters() says why from then on. refuse_parameters(tendon, extension, crc): a
/// block that was proven does not hold, or its extension does not; parameters() says so.
/// open_epoch(tendon), load_parameters(tendon, ...): committed before they return none; otherwise
/// nothing has changed. The block has been checked and accepted. Neither touches the lifetime
/// damage.
template <class T>
concept Device = requires(T& device, std::uint8_t tendon, std::span<std::byte> out,
                          const lifemodel::ExtendedBlock& block,
                          const lifemodel::ExtendedParameters& model, storage::Event event,
                          std::uint32_t number) {
  { device.identity() } -> std::same_as<Identity>;
  { device.tendons() } -> std::same_as<std::uint8_t>;
  { device.read_life(tendon) } -> std::same_as<storage::LifeRecord>;
  { device.configuration(tendon) } -> std::same_as<std::uint32_t>;
  { device.parameters(tendon) } -> std::same_as<ParameterReport>;
  { device.storage_counter() } -> std::same_as<std::uint32_t>;
  { device.random(out) } -> std::same_as<hal::Error>;
  { device.log(event, tendon, number) } -> std::same_as<hal::Error>;
  { device.log_entry(number) } -> std::same_as<std::optional<storage::LogEntry>>;
  { device.open_epoch(tendon) } -> std::same_as<hal::Error>;
  { device.accepts(tendon, model, number) } -> std::same_as<bool>;
  device.refuse_parameters(tendon, lifemodel::ExtendedBlockError{}, number);
  { device.load_parameters(tendon, block) } -> std::same_as<hal::Error>;
};

}  // namespace protocol::uds
