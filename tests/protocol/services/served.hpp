#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <span>

#include "firmware/protocol/uds/server.hpp"
#include "tests/protocol/services/bytes.hpp"
#include "tests/protocol/services/model_device.hpp"
#include "tests/protocol/services/requests.hpp"

namespace protocol::testing {

/// A server of two tendons, 100 s after its start.
class ServedTest : public ::testing::Test {
 protected:
  ServedTest() { restart(); }

  void restart(const authority::Key& key = kKey) {
    server_.emplace(device_, kNode, key);
    server_->start(now_);
  }
  Bytes ask(const Bytes& request) {
    Bytes response(uds::kMostMessageBytes);
    response.resize(server_->handle(request, now_, response));
    return response;
  }
  /// Reads nonce and counter, as an honest client does.
  Order fresh_order() {
    const Bytes answer = ask(hex("22 02 41 02 40"));
    Order order;
    std::copy_n(answer.begin() + 3, order.nonce.size(), order.nonce.begin());
    order.counter = lifemodel::ByteReader(std::span(answer).last(4)).u32();
    return order;
  }

  hal::Time now_ = hal::seconds(100);
  ModelDevice device_{2};
  std::optional<uds::Server<ModelDevice>> server_;
};

}  // namespace protocol::testing
