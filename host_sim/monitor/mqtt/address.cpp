#include "host_sim/monitor/mqtt/address.hpp"

#include "host_sim/io/host_port.hpp"

namespace host_sim::monitor {
namespace {

bool is_host(std::string_view text) {
  return !text.empty() && text.size() < 254 &&
         text.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_:%") ==
             std::string_view::npos;
}

}  // namespace

std::optional<BrokerAddress> broker_address_of(std::string_view text) {
  const std::optional<HostPort> found = host_port_of(text);
  if (!found || !is_host(found->host) || found->port == 0) {
    return std::nullopt;
  }
  BrokerAddress address;
  address.host = found->host;
  address.port = found->port.value_or(address.port);
  return address;
}

}  // namespace host_sim::monitor
