#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "host_sim/monitor/fleet/watch.hpp"
#include "host_sim/monitor/http/gate.hpp"
#include "host_sim/monitor/record/frame_archive.hpp"

namespace host_sim::monitor {

struct LivePageOptions {
  Address address;
  const FrameArchive& archive;            ///< what there is of the past; outlives the page
  std::optional<std::string> token = {};  ///< asked for, if given; needed off loopback
};

/// Serves the fleet to browsers, by threads of its own:
///   /                    the page; its parts under /assets/
///   /events              server-sent events
///   /api/fleet           what is known now, as JSON
///   /api/node/N          the same of a node, with its history
///   /api/times           moments of the past that can be asked for
///   /api/moment/T        what the frames recorded until then say of it; T in microseconds
///   /api/moment/T/N      the same, with the history of a node
///   /export/N.csv        its damage curve
///   /export/N.candump    its recorded frames; /export/all.candump those of all
///   /healthz             200 while views come, else 503; needs no token
class LivePage final : public Observer {
 public:
  /// @throws InputError where it cannot listen or must not
  explicit LivePage(const LivePageOptions& options);
  ~LivePage() override;

  /// Takes a view where one is due, five times a second at most, and never waits for a reader. To
  /// be called on, also where nothing has come, for the page takes silence for a stopped monitor.
  void update(const FleetView& view) override;
  /// It stays when a log is at its end.
  [[nodiscard]] bool outlives_log() const override { return true; }

  /// Where the page is, without the token: "http://127.0.0.1:8080/".
  [[nodiscard]] std::string url() const;
  [[nodiscard]] std::uint16_t port() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace host_sim::monitor
