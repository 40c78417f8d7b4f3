#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "firmware/protocol/isotp/link.hpp"
#include "firmware/protocol/uds/server.hpp"
#include "tests/protocol/services/bytes.hpp"
#include "tests/protocol/services/channel.hpp"

namespace protocol::testing {

/// A client and a node on one bus, with their own time.
template <uds::Device DeviceT>
class Tester {
 public:
  Tester(DeviceT& device, Node node, const authority::Key& key)
      : client_(isotp::Address::to_node(node)), node_(device, node, key) {
    node_.start(now_);
  }

  /// Asks, and waits for the answer for three seconds.
  std::optional<Bytes> ask(const Bytes& request) {
    client_.clear();
    if (client_.send(request) != hal::Error::none) {
      return std::nullopt;
    }
    for (int i = 0; i < 3000 && client_.received().empty(); ++i) {
      step(hal::milliseconds(1));
    }
    if (client_.received().empty()) {
      return std::nullopt;
    }
    return to_bytes(client_.received());
  }

  void step(hal::Time time) {
    now_ = now_ + time;
    if (const auto frame = client_.next_frame(now_)) {
      to_node.put(*frame);
    }
    if (const auto frame = node_.next_frame(now_)) {
      to_client.put(*frame);
    }
    while (const auto frame = to_node.take()) {
      node_.on_frame(*frame, now_);
    }
    while (const auto frame = to_client.take()) {
      client_.on_frame(*frame, now_);
    }
    node_.poll(now_);
  }

  [[nodiscard]] const uds::Endpoint<DeviceT>& node() const { return node_; }

  Channel to_node;
  Channel to_client;

 private:
  hal::Time now_ = hal::seconds(1);
  isotp::Link<200> client_;
  uds::Endpoint<DeviceT> node_;
};

}  // namespace protocol::testing
