#pragma once

#include "host_sim/monitor/http/live_page.hpp"
#include "host_sim/monitor/watch/observer.hpp"

namespace host_sim::monitor {

/// Shows what is known on the live page, and keeps it there when a log is at its end.
class PageObserver final : public Observer {
 public:
  /// @throws InputError
  explicit PageObserver(const LivePageOptions& options) : page_(options) {}

  void update(const FleetView& view) override { page_.publish(view); }
  [[nodiscard]] bool outlives_log() const override { return true; }
  [[nodiscard]] const LivePage& page() const { return page_; }

 private:
  LivePage page_;
};

}  // namespace host_sim::monitor
