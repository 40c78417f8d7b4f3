#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// Between the loop of the monitor, which offers views, and the threads that send them. Keeps the
/// newest view and the last few changes, whatever the number and speed of the readers.
class Hub {
 public:
  /// At most one view is taken in this time.
  static constexpr std::chrono::milliseconds kInterval{200};
  /// A reader that is further behind is given a whole view.
  static constexpr std::size_t kKept = 8;

  struct Message {
    std::uint64_t version = 0;  ///< of the view that a reader has after it
    bool whole = false;
    std::shared_ptr<const std::string> json;  ///< none: nothing new
  };

  Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;
  ~Hub();

  /// Copies the view where one is due, and returns at once.
  void offer(const FleetView& view);

  /// The newest view, or none yet.
  [[nodiscard]] std::shared_ptr<const FleetView> view() const;
  /// How long ago the newest view came, or since the start.
  [[nodiscard]] std::chrono::milliseconds age() const;

  /// A reader joins and leaves; without any no text is made.
  void join();
  void leave();
  /// What brings a reader from `version` (0: has nothing) to the newest view, or further on the way
  /// to it. Waits for it up to `most`.
  Message next(std::uint64_t version, std::chrono::milliseconds most);

  void close();
  [[nodiscard]] bool closed() const { return closed_; }

 private:
  struct Change {
    std::uint64_t version = 0;
    std::shared_ptr<const std::string> json;
  };
  void run();
  void take(std::shared_ptr<const FleetView> view);
  [[nodiscard]] Message message_after(std::uint64_t version);

  mutable std::mutex offer_mutex_;
  std::condition_variable offered_;
  std::shared_ptr<const FleetView> offer_;
  std::chrono::steady_clock::time_point offer_time_ = std::chrono::steady_clock::now();
  bool any_offer_ = false;

  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::atomic<bool> closed_ = false;
  std::size_t readers_ = 0;
  std::uint64_t version_ = 0;
  std::shared_ptr<const FleetView> view_;
  nlohmann::json json_;  ///< of view_, where there are readers; else null
  std::shared_ptr<const std::string> whole_;
  std::deque<Change> changes_;
  std::thread thread_;
};

/// The server-sent events of one reader (HTML Living Standard, 9.2): `whole` with a view, then
/// `change` with {"patch": merge patch, "events": ..}, comments where nothing comes.
class EventStream {
 public:
  explicit EventStream(Hub& hub);
  EventStream(const EventStream&) = delete;
  EventStream& operator=(const EventStream&) = delete;
  ~EventStream();

  /// The next piece of the stream; empty where the hub is closed. Waits no longer than until a
  /// comment is due.
  std::string next();

 private:
  Hub& hub_;
  std::uint64_t version_ = 0;
  bool started_ = false;
};

}  // namespace host_sim::monitor
