#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "host_sim/monitor/fleet/watch.hpp"

struct mosquitto;

namespace host_sim::monitor {

/// Where a broker listens.
struct BrokerAddress {
  std::string host;
  std::uint16_t port = 1883;  ///< that of MQTT (IANA)
};

/// HOST, HOST:PORT, or [IPV6]:PORT; nothing where it is none.
std::optional<BrokerAddress> broker_address_of(std::string_view text);

/// Publishes every node to an MQTT broker: status_json() retained under tendonlife/NODE/status,
/// once a second, and at once where its state changes, it turns stale, vanishes or comes back.
///
/// tendonlife/monitor holds whether anyone keeps this up: {"online": true}, and false as the last
/// will and at the end, where every status is published once more as stale. A broker that is lost
/// is tried again for as long as it takes.
class MqttObserver final : public Observer {
 public:
  /// @throws std::runtime_error where the library cannot be used
  explicit MqttObserver(const BrokerAddress& broker);
  ~MqttObserver() override;

  void update(const FleetView& view) override;
  [[nodiscard]] std::string trouble() const override;

 private:
  using Clock = std::chrono::steady_clock;

  struct Published {
    std::string_view state = {};
    bool stale = false;
    bool vanished = false;
    Clock::time_point at{};
    std::string json;
  };

  void stay_connected(const std::stop_token& stop);
  static void connected(::mosquitto* client, void* self, int result);
  static void acknowledged(::mosquitto* client, void* self, int message);
  static void disconnected(::mosquitto* client, void* self, int result);
  void publish(const std::string& topic, const std::string& payload);
  void publish_status(const NodeView& node, Clock::time_point now);
  void end();

  BrokerAddress broker_;
  std::map<protocol::Node, Published> published_;
  std::atomic<bool> connected_ = false;
  std::atomic<int> unacknowledged_ = 0;
  std::atomic<bool> publish_all_ = false;  ///< a broker has forgotten what it was sent
  std::unique_ptr<::mosquitto, void (*)(::mosquitto*)> client_;
  std::jthread thread_;
};

}  // namespace host_sim::monitor
