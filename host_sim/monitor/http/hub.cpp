#include "host_sim/monitor/http/hub.hpp"

#include <utility>

#include "host_sim/monitor/http/view_json.hpp"

namespace host_sim::monitor {
namespace {

constexpr std::chrono::seconds kHeartbeat{2};

}  // namespace

Hub::Hub() : thread_([this] { run(); }) {}

Hub::~Hub() {
  close();
  thread_.join();
}

void Hub::offer(const FleetView& view) {
  const auto now = std::chrono::steady_clock::now();
  {
    const std::lock_guard lock(offer_mutex_);
    if (any_offer_ && now - offer_time_ < kInterval) {
      return;
    }
  }
  auto copy = std::make_shared<const FleetView>(view);
  {
    const std::lock_guard lock(offer_mutex_);
    offer_.swap(copy);
    offer_time_ = now;
    any_offer_ = true;
  }
  offered_.notify_one();
}

std::shared_ptr<const FleetView> Hub::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

std::chrono::milliseconds Hub::age() const {
  const std::lock_guard lock(offer_mutex_);
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() -
                                                               offer_time_);
}

void Hub::join() {
  const std::lock_guard lock(mutex_);
  ++readers_;
}

void Hub::leave() {
  const std::lock_guard lock(mutex_);
  if (--readers_ == 0) {
    json_ = nullptr;
    changes_.clear();
  }
}

void Hub::run() {
  for (;;) {
    std::shared_ptr<const FleetView> view;
    {
      std::unique_lock lock(offer_mutex_);
      offered_.wait(lock, [this] { return offer_ || closed(); });
      view = std::move(offer_);
    }
    if (closed()) {
      return;
    }
    take(std::move(view));
    news_.notify_all();
  }
}

void Hub::take(std::shared_ptr<const FleetView> view) {
  const std::lock_guard lock(mutex_);
  ++version_;
  whole_.reset();
  if (readers_ > 0) {
    nlohmann::json json = fleet_json(*view);
    if (json_.is_null()) {
      changes_.clear();
    } else {
      const nlohmann::json change = {{"patch", merge_patch(json_, json)},
                                     {"events", new_events(*view_, *view)}};
      changes_.push_back({version_, std::make_shared<const std::string>(json_text(change))});
    }
    if (changes_.size() > kKept) {
      changes_.pop_front();
    }
    json_ = std::move(json);
  }
  view_ = std::move(view);
}

Hub::Message Hub::message_after(std::uint64_t version) {
  for (const Change& change : changes_) {
    if (change.version == version + 1) {
      return {change.version, false, change.json};
    }
  }
  if (json_.is_null()) {
    json_ = fleet_json(*view_);
  }
  if (!whole_) {
    whole_ = std::make_shared<const std::string>(json_text(json_));
  }
  return {version_, true, whole_};
}

Hub::Message Hub::next(std::uint64_t version, std::chrono::milliseconds most) {
  std::unique_lock lock(mutex_);
  news_.wait_for(lock, most, [&] { return closed_ || (view_ && version_ != version); });
  if (closed_ || !view_ || version_ == version) {
    return {version, false, nullptr};
  }
  return message_after(version);
}

void Hub::close() {
  {
    const std::scoped_lock lock(offer_mutex_, mutex_);
    closed_ = true;
  }
  offered_.notify_all();
  news_.notify_all();
}

EventStream::EventStream(Hub& hub) : hub_(hub) {
  hub_.join();
}

EventStream::~EventStream() {
  hub_.leave();
}

std::string EventStream::next() {
  if (!started_) {
    started_ = true;
    return "retry: 1000\n\n";
  }
  const Hub::Message message = hub_.next(version_, kHeartbeat);
  if (hub_.closed()) {
    return {};
  }
  if (!message.json) {
    return ": still here\n\n";
  }
  version_ = message.version;
  std::string text = message.whole ? "event: whole\ndata: " : "event: change\ndata: ";
  return text + *message.json + "\n\n";
}

}  // namespace host_sim::monitor
