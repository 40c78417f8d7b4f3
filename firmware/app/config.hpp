#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "firmware/protocol/messages.hpp"
#include "firmware/storage/store.hpp"
#include "lifemodel/block/parameter_block.hpp"

namespace app {

/// AES-128 key of this node. All zero: nothing that needs authority is allowed.
using Key = std::array<std::byte, 16>;

/// Version of the firmware, major in the high 4 bits, minor in the low.
inline constexpr std::uint8_t kFirmwareVersion = 0x01;

struct Config {
  protocol::Node node = 1;
  Key key{};
  std::array<std::byte, 12> serial{};  ///< of the controller; shorter ones end in zeros
};

template <std::size_t kTendons>
using ParameterSet = std::array<std::optional<lifemodel::Parameters>, kTendons>;

/// The parameters to start with: for each tendon the block that was loaded under authority, else
/// the one that came with the configuration. Nothing where the loaded block is not valid: a life
/// must not continue under other parameters unseen.
template <std::size_t kTendons, storage::Store StoreT>
ParameterSet<kTendons> stored_parameters(StoreT& store, const ParameterSet<kTendons>& configured) {
  ParameterSet<kTendons> result = configured;
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    if (const auto block = store.load_parameters(tendon)) {
      const auto loaded = lifemodel::decode(*block);
      result[tendon] = loaded ? std::optional(*loaded) : std::nullopt;
    }
  }
  return result;
}

/// CRC-32 at the end of the parameter block that these make.
inline std::uint32_t configuration_of(const lifemodel::Parameters& parameters) {
  const lifemodel::ParameterBlock block = lifemodel::encode(parameters);
  return lifemodel::ByteReader(std::span(block).last(4)).u32();
}

}  // namespace app
