#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/protocol/isotp/link.hpp"
#include "firmware/protocol/uds/server.hpp"
#include "firmware/protocol/uds/table.hpp"
#include "hal/can_frame.hpp"
#include "hal/clock.hpp"

namespace protocol::uds {

/// The server of a node on the bus.
///
///   endpoint.start(now);              // once
///   endpoint.on_frame(frame, now);    // each frame that was received
///   endpoint.poll(now);               // at leisure: answers a request that is whole
///   endpoint.next_frame(now);         // when the node may send one, and keeps it until it is sent
template <Device DeviceT>
class Endpoint {
 public:
  using Link = isotp::Link<kMostMessageBytes>;

  Endpoint(DeviceT& device, Node node, const authority::Key& key)
      : link_(isotp::Address::to_tester(node)), server_(device, node, key) {}

  void start(hal::Time now) { server_.start(now); }

  void on_frame(const hal::CanFrame& frame, hal::Time now) { link_.on_frame(frame, now); }
  [[nodiscard]] bool ready(hal::Time now) const { return link_.ready(now); }
  [[nodiscard]] std::optional<hal::CanFrame> next_frame(hal::Time now) {
    return link_.next_frame(now);
  }

  /// Takes as long as what the device is asked to do.
  void poll(hal::Time now) {
    if (link_.counts().oversized != oversized_) {
      oversized_ = link_.counts().oversized;
      server_.refuse_transfer();
    }
    if (link_.sending() || link_.received().empty()) {
      return;
    }
    std::array<std::byte, kMostMessageBytes> response{};
    const std::size_t size = server_.handle(link_.received(), now, response);
    link_.clear();
    if (size != 0) {
      // Neither busy nor too long, so it is taken.
      (void)link_.send(std::span(response).first(size));
    }
  }

  [[nodiscard]] const isotp::Counts& counts() const { return link_.counts(); }
  [[nodiscard]] const Server<DeviceT>& server() const { return server_; }

 private:
  Link link_;
  Server<DeviceT> server_;
  std::uint32_t oversized_ = 0;
};

}  // namespace protocol::uds
