#include "host_sim/monitor/mqtt/address.hpp"

#include <charconv>

namespace host_sim::monitor {
namespace {

bool is_host(std::string_view text) {
  return !text.empty() && text.size() < 254 &&
         text.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_:%") ==
             std::string_view::npos;
}

bool read_port(std::string_view text, std::uint16_t& port) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && stop == text.data() + text.size() && port != 0;
}

}  // namespace

std::optional<BrokerAddress> broker_address_of(std::string_view text) {
  BrokerAddress address;
  std::string_view host = text;
  std::string_view rest;
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    host = text.substr(1, end - 1);
    rest = text.substr(end + 1);
  } else if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    host = text.substr(0, colon);
    rest = text.substr(colon);
  }
  const bool port_is_sound =
      rest.empty() || (rest.starts_with(':') && read_port(rest.substr(1), address.port));
  if (!is_host(host) || !port_is_sound) {
    return std::nullopt;
  }
  address.host = host;
  return address;
}

}  // namespace host_sim::monitor
