#include "host_sim/monitor/mqtt/mqtt_observer.hpp"

#include <mosquitto.h>

#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "host_sim/io/host_port.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"
#include "host_sim/monitor/mqtt/status_json.hpp"

namespace host_sim::monitor {
namespace {

constexpr std::chrono::seconds kPublishAgain{1};
constexpr std::chrono::milliseconds kMostAtEnd{1000};
constexpr std::chrono::milliseconds kTryAgain{1000};
constexpr int kMostWait_ms = 100;
constexpr int kKeepAlive_s = 10;
constexpr int kAtLeastOnce = 1;
constexpr const char* kMonitorTopic = "tendonlife/monitor";
constexpr std::string_view kOnline = R"({"online": true})";
constexpr std::string_view kOffline = R"({"online": false})";

void require(int result, const char* what) {
  if (result != MOSQ_ERR_SUCCESS) {
    throw std::runtime_error(std::string("MQTT: ") + what + ": " + ::mosquitto_strerror(result));
  }
}

/// Waits; false where it waited in full.
bool stopped_within(const std::stop_token& stop, std::chrono::milliseconds most) {
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  return stopped.wait_for(lock, stop, most, [&] { return stop.stop_requested(); });
}

std::string topic_of(protocol::Node node) {
  return "tendonlife/" + std::to_string(node) + "/status";
}

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

MqttObserver::MqttObserver(const BrokerAddress& broker)
    : broker_(broker), client_(nullptr, ::mosquitto_destroy) {
  require(::mosquitto_lib_init(), "the library cannot be used");
  client_.reset(::mosquitto_new(nullptr, true, this));
  if (!client_) {
    throw std::runtime_error("MQTT: no memory for a client");
  }
  ::mosquitto_connect_callback_set(client_.get(), connected);
  ::mosquitto_publish_callback_set(client_.get(), acknowledged);
  ::mosquitto_disconnect_callback_set(client_.get(), disconnected);
  require(::mosquitto_threaded_set(client_.get(), true), "its threads");
  require(::mosquitto_will_set(client_.get(), kMonitorTopic, static_cast<int>(kOffline.size()),
                               kOffline.data(), kAtLeastOnce, true),
          "the last will");
  thread_ = std::jthread([this](const std::stop_token& stop) { stay_connected(stop); });
}

MqttObserver::~MqttObserver() {
  end();
  ::mosquitto_disconnect(client_.get());
  thread_.request_stop();
  thread_.join();
  client_.reset();
  ::mosquitto_lib_cleanup();
}

// The library's own thread gives up where the first connection of all is refused.
void MqttObserver::stay_connected(const std::stop_token& stop) {
  (void)::mosquitto_connect_async(client_.get(), broker_.host.c_str(), broker_.port, kKeepAlive_s);
  while (!stop.stop_requested()) {
    if (::mosquitto_loop(client_.get(), kMostWait_ms, 1) != MOSQ_ERR_SUCCESS) {
      connected_ = false;
      if (stopped_within(stop, kTryAgain)) {
        return;
      }
      (void)::mosquitto_reconnect_async(client_.get());
    }
  }
}

void MqttObserver::connected(::mosquitto* /*client*/, void* self, int result) {
  auto& observer = *static_cast<MqttObserver*>(self);
  observer.connected_ = result == 0;
  if (result == 0) {
    observer.publish(kMonitorTopic, std::string(kOnline));
    observer.publish_all_ = true;
  }
}

void MqttObserver::acknowledged(::mosquitto* /*client*/, void* self, int /*message*/) {
  --static_cast<MqttObserver*>(self)->unacknowledged_;
}

void MqttObserver::disconnected(::mosquitto* /*client*/, void* self, int /*result*/) {
  static_cast<MqttObserver*>(self)->connected_ = false;
}

void MqttObserver::publish(const std::string& topic, const std::string& payload) {
  ++unacknowledged_;
  if (::mosquitto_publish(client_.get(), nullptr, topic.c_str(), static_cast<int>(payload.size()),
                          payload.data(), kAtLeastOnce, true) != MOSQ_ERR_SUCCESS) {
    --unacknowledged_;
  }
}

void MqttObserver::update(const FleetView& view) {
  if (!connected_) {
    return;
  }
  if (publish_all_.exchange(false)) {
    published_.clear();
  }
  const Clock::time_point now = Clock::now();
  for (const auto& [number, node] : view.nodes) {
    if (node.status) {
      publish_status(node, now);
    }
  }
}

void MqttObserver::publish_status(const NodeView& node, Clock::time_point now) {
  const auto [entry, is_new] = published_.try_emplace(node.node);
  Published& last = entry->second;
  const bool changed = is_new || last.state != state_name(node) ||
                       last.stale != node.status->stale || last.vanished != node.vanished;
  if (!changed && now - last.at < kPublishAgain) {
    return;
  }
  std::string json = status_json(node);
  if (json != last.json) {
    publish(topic_of(node.node), json);
  }
  last = {state_name(node), node.status->stale, node.vanished, now, std::move(json)};
}

void MqttObserver::end() {
  if (!connected_) {
    return;
  }
  constexpr std::string_view kFresh = R"("stale":false)";
  for (auto& [number, last] : published_) {
    if (const std::size_t at = last.json.find(kFresh); at != std::string::npos) {
      publish(topic_of(number), last.json.replace(at, kFresh.size(), R"("stale":true)"));
    }
  }
  publish(kMonitorTopic, std::string(kOffline));
  const Clock::time_point latest = Clock::now() + kMostAtEnd;
  while (connected_ && unacknowledged_ > 0 && Clock::now() < latest) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

std::string MqttObserver::trouble() const {
  return connected_ ? std::string()
                    : "MQTT: not connected to " + broker_.host + ":" + std::to_string(broker_.port);
}

}  // namespace host_sim::monitor
