#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace host_sim::monitor {

/// Where a broker listens.
struct BrokerAddress {
  std::string host;
  std::uint16_t port = 1883;  ///< that of MQTT (IANA)
};

/// HOST, HOST:PORT, or [IPV6]:PORT; nothing where it is none.
std::optional<BrokerAddress> broker_address_of(std::string_view text);

}  // namespace host_sim::monitor
