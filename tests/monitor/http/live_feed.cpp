// live_feed LOG [PORT [NODES]]
//
// Serves the live page of a made bus for the tests in a browser. The clock of the bus advances by
// commands on standard input alone, as fast as the machine can; each is answered by a line with the
// time of the clock in microseconds. Every frame is written to LOG as well.
//
//   run SECONDS          the nodes send
//   silent NODE 0|1      a node sends nothing
//   corrupt NODE 0|1     its frames are damaged on the way
//   emergency NODE CODE  it reports an emergency
//   epoch NODE           its tendon is new
//   bus-off 0|1          the controller of the monitor is off the bus
//   source STATE         running, lost or ended
//   pass SECONDS         the same, without a trace in the log
//   flood SECONDS RATE   in real time, RATE frames a second
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "hal/files/candump.hpp"
#include "host_sim/monitor/fleet/fleet.hpp"
#include "host_sim/monitor/http/live_page.hpp"
#include "host_sim/monitor/record/frame_archive.hpp"
#include "tests/monitor/fleet/sender.hpp"

namespace host_sim::monitor::test {

using hal::files::candump_line;

namespace {

constexpr double kReplace = 0.4;
constexpr double kWorn = 0.8;
constexpr double kLast = 1.2;
constexpr double kShape = 5.94;
constexpr std::uint32_t kTendons = 4;
constexpr double kStep_h = 0.1 / 3600;

std::uint8_t u8(std::uint32_t value) {
  return static_cast<std::uint8_t>(value);
}

/// A node whose life is made up: its damage grows steadily, and it reports all that a controller
/// reports.
class MadeNode {
 public:
  using Take = std::function<void(const SeenFrame&)>;

  explicit MadeNode(protocol::Node node);

  /// All frames of the 100 ms from `time_ns` on.
  void run(std::int64_t time_ns, const Take& take);

  bool silent = false;
  bool corrupt = false;  ///< a bit of each frame is turned over on the way
  protocol::EmergencyCode emergency = protocol::EmergencyCode::none;
  double damage = 0;  ///< of the worst tendon

 private:
  void send(SeenFrame frame, const Take& take) const;
  void send_page(std::int64_t time_ns, const Take& take);
  [[nodiscard]] std::uint32_t ppb(double share) const;
  [[nodiscard]] std::uint16_t left_dh(double end) const;
  [[nodiscard]] std::uint16_t given_survival_dh(double hazard) const;
  [[nodiscard]] std::uint16_t break_risk() const;
  [[nodiscard]] protocol::LifeState state_at(double share) const;

  protocol::Node node_;
  Sender sender_;
  double rate_per_h_;
  std::uint32_t steps_ = 0;
  std::uint32_t pages_ = 0;
  protocol::EmergencyCode reported_ = protocol::EmergencyCode::none;
};

/// A bus of nodes 1 to `nodes`.
class MadeBus {
 public:
  explicit MadeBus(int nodes);

  /// 100 ms of all nodes, in order of time.
  void run(std::int64_t time_ns, const MadeNode::Take& take);
  MadeNode& node(int number) { return nodes_.at(static_cast<protocol::Node>(number)); }

 private:
  std::map<protocol::Node, MadeNode> nodes_;
};

MadeNode::MadeNode(protocol::Node node)
    : damage(0.07 * (node % 13)), node_(node), sender_(node), rate_per_h_(0.25 + 0.07 * node) {}

void MadeNode::send(SeenFrame frame, const Take& take) const {
  if (corrupt) {
    frame.frame.data[frame.frame.length - 1u] ^= std::byte{0x10};
  }
  if (!silent) {
    take(frame);
  }
}

std::uint32_t MadeNode::ppb(double share) const {
  return static_cast<std::uint32_t>(std::lround(1e9 * share));
}

std::uint16_t MadeNode::left_dh(double end) const {
  const double left = std::max(0.0, (end - damage) / rate_per_h_ * 10);
  return static_cast<std::uint16_t>(std::min(left, 65535.0));
}

std::uint16_t MadeNode::given_survival_dh(double hazard) const {
  return left_dh(std::pow(std::pow(damage, kShape) + hazard, 1 / kShape));
}

std::uint16_t MadeNode::break_risk() const {
  const double later = std::pow(damage + 8 * rate_per_h_, kShape);
  return static_cast<std::uint16_t>(
      std::ceil(-4000 * std::expm1(std::pow(damage, kShape) - later)));
}

protocol::LifeState MadeNode::state_at(double share) const {
  using protocol::LifeState;
  return share >= kWorn          ? LifeState::worn
         : share >= kReplace     ? LifeState::replace
         : share >= kReplace / 2 ? LifeState::inspect
                                 : LifeState::normal;
}

void MadeNode::run(std::int64_t time_ns, const Take& take) {
  damage += rate_per_h_ * kStep_h;
  if (steps_++ % 10 == 0) {
    SeenFrame beat = sender_.heartbeat(time_ns);
    if (!silent) {
      take(beat);
    }
  }
  if (emergency != reported_) {
    reported_ = emergency;
    send(sender_.emergency(time_ns + kMs,
                           {.code = emergency,
                            .error_register = u8(reported_ == decltype(reported_)::none ? 0 : 1),
                            .damage_ppm = ppb(damage) / 1000}),
         take);
  }
  send(sender_.status(time_ns + 2 * kMs, {.state = state_at(damage),
                                          .damage_ppb = ppb(damage),
                                          .worst_tendon = u8(node_ % kTendons),
                                          .storage_ok = true,
                                          .sensor_ok = true,
                                          .gap = node_ % 4 == 0}),
       take);
  send_page(time_ns + 50 * kMs, take);
}

void MadeNode::send_page(std::int64_t time_ns, const Take& take) {
  namespace detail = protocol::detail;
  const std::uint32_t turn = pages_ / detail::kPages;
  const auto page = [&](const auto& content) { send(sender_.page(time_ns, content), take); };
  switch (pages_++ % detail::kPages) {
    case detail::Identity::kPage:
      return page(detail::Identity{1, 0x12, 0xc0ffee00u + node_});
    case detail::Cycles::kPage:
      return page(detail::Cycles{123 * steps_, u8(60u + node_)});
    case detail::DamageRate::kPage:
      return page(detail::DamageRate{ppb(rate_per_h_), u8(7u * node_)});
    case detail::TendonDamage::kPage: {
      const std::uint32_t tendon = turn % kTendons;
      const double share = tendon == node_ % kTendons ? damage : damage * (0.3 + 0.1 * tendon);
      return page(detail::TendonDamage{u8(tendon), ppb(share), state_at(share)});
    }
    case detail::RainflowBin::kPage:
      return page(detail::RainflowBin{u8(turn % kTendons), u8(turn / kTendons % 8),
                                      u8(turn / 3 % 8), u8(turn % 4),
                                      10 * (turn + 1) * (1 + turn % 7)});
    case detail::RemainingLife::kPage:
      return page(detail::RemainingLife{left_dh(kReplace), left_dh(kWorn), left_dh(kLast)});
    case detail::Storage::kPage:
      return page(detail::Storage{1000u + turn, 500u * node_});
    case detail::Timing::kPage:
      return page(detail::Timing{u8(100 + node_), u8(20 + node_), u8(turn % 3)});
    case detail::ConditionalLife::kPage:
      return page(detail::ConditionalLife{given_survival_dh(0.105361), given_survival_dh(0.693147),
                                          given_survival_dh(2.302585)});
    case detail::BreakRisk::kPage: {
      const auto low = static_cast<std::uint16_t>(given_survival_dh(0.105361) / 10);
      const auto high =
          static_cast<std::uint16_t>(std::min(given_survival_dh(0.105361) / 3 + 1, 16382));
      return page(detail::BreakRisk{8, break_risk(), low, high});
    }
    case detail::WireHistory::kPage: {
      const auto event = static_cast<protocol::WireEvent>(turn % 4);
      const std::uint32_t tendon = turn / 4 % kTendons;
      return page(detail::WireHistory{
          u8(tendon), node_ == 2 && tendon == 1, node_ == 2 && tendon == 3,
          u8(40u + 3u * node_ + tendon), event,
          static_cast<std::uint16_t>(node_ == 8 ? 16383u : 1000 * tendon + 10 * turn + node_),
          static_cast<std::uint16_t>(7 * turn + tendon)});
    }
    case detail::Advice::kPage: {
      const std::uint32_t tendon = turn % kTendons;
      if (node_ % 3 == 0) {
        return page(detail::Advice{.tendon = u8(tendon)});
      }
      const auto tension = static_cast<std::uint16_t>(900u + 10 * node_ + tendon);
      return page(
          detail::Advice{u8(tendon), protocol::AdviceState::limited, tension,
                         static_cast<std::uint16_t>(2000u + 3 * node_ + (3 * tendon + node_) % 4)});
    }
    default:
      return page(detail::Bus{u8(node_), u8(2u * node_), 1, 3, u8(turn % 5)});
  }
}

MadeBus::MadeBus(int nodes) {
  for (int number = 1; number <= nodes; ++number) {
    nodes_.emplace(number, MadeNode(static_cast<protocol::Node>(number)));
  }
}

void MadeBus::run(std::int64_t time_ns, const MadeNode::Take& take) {
  std::vector<SeenFrame> frames;
  std::int64_t apart_ns = 0;
  for (auto& [number, node] : nodes_) {
    node.run(time_ns + apart_ns, [&](const SeenFrame& frame) { frames.push_back(frame); });
    apart_ns += kMs / 4;
  }
  std::stable_sort(frames.begin(), frames.end(), [](const SeenFrame& one, const SeenFrame& other) {
    return one.time_ns < other.time_ns;
  });
  std::for_each(frames.begin(), frames.end(), take);
}

class Feed {
 public:
  Feed(const std::string& log, std::uint16_t port, int nodes, std::size_t kept)
      : log_(log), archive_("can0", kept), bus_(nodes), page_({{"127.0.0.1", port}, archive_}) {
    fleet_.source_is(FrameSource::State::running, "can0");
    publisher_ = std::jthread([this](const std::stop_token& stop) { publish(stop); });
    fmt::print("{}\n", page_.url());
    std::fflush(stdout);
  }

  void obey(const std::string& line) {
    std::istringstream command(line);
    std::string verb;
    command >> verb;
    if (verb == "flood") {
      flood(command);
    } else {
      const std::lock_guard lock(mutex_);
      change(verb, command);
      fleet_.tick(now_ns_);
    }
    fmt::print("{}\n", now_ns_ / 1000);
    std::fflush(stdout);
  }

 private:
  void change(const std::string& verb, std::istringstream& command) {
    int number = 0;
    if (verb == "run" || verb == "pass") {
      double seconds = 0;
      command >> seconds;
      for (int steps = static_cast<int>(10 * seconds); steps > 0; --steps) {
        step(verb == "run");
      }
    } else if (verb == "silent") {
      command >> number >> bus_.node(number).silent;
    } else if (verb == "corrupt") {
      command >> number >> bus_.node(number).corrupt;
    } else if (verb == "emergency") {
      std::uint16_t code = 0;
      command >> number >> std::hex >> code;
      bus_.node(number).emergency = static_cast<protocol::EmergencyCode>(code);
    } else if (verb == "epoch") {
      command >> number;
      bus_.node(number).damage = 0;
    } else if (verb == "bus-off") {
      SeenFrame seen;
      seen.time_ns = now_ns_;
      command >> number;
      seen.error = BusError{.bus_off = number != 0, .restarted = number == 0};
      fleet_.see(seen);
    } else if (verb == "source") {
      std::string state;
      command >> state;
      using State = FrameSource::State;
      fleet_.source_is(state == "lost"    ? State::lost
                       : state == "ended" ? State::ended
                                          : State::running,
                       state == "lost" ? "can0 is down" : "can0");
    }
  }

  void step(bool logged) {
    bus_.run(now_ns_, [&](const SeenFrame& seen) {
      fleet_.see(seen);
      if (!logged) {
        return;
      }
      archive_.see(seen);
      log_ << candump_line(static_cast<std::uint64_t>(seen.time_ns / 1000), "can0", seen.frame);
    });
    log_.flush();
    now_ns_ += 100 * kMs;
    fleet_.tick(now_ns_);
  }

  /// As the loop of the monitor does: frames, a tick and a view each 10 ms.
  void flood(std::istringstream& command) {
    double seconds = 0;
    double rate = 0;
    command >> seconds >> rate;
    const auto start = std::chrono::steady_clock::now();
    const std::int64_t start_ns = now_ns_;
    std::uint64_t sent = 0;
    for (double past_s = 0; past_s < seconds;) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      past_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      const std::lock_guard lock(mutex_);
      while (static_cast<double>(sent) < past_s * rate) {
        bus_.run(now_ns_, [&](SeenFrame seen) {
          seen.time_ns =
              start_ns + static_cast<std::int64_t>(1e9 * static_cast<double>(sent) / rate);
          fleet_.see(seen);
          ++sent;
        });
      }
      now_ns_ = start_ns + static_cast<std::int64_t>(1e9 * past_s);
      fleet_.tick(now_ns_);
    }
  }

  void publish(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      {
        const std::lock_guard lock(mutex_);
        page_.update(fleet_.view());
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  std::mutex mutex_;
  std::int64_t now_ns_ = 1'790'000'000 * kS;
  std::ofstream log_;
  RecentFrames archive_;
  MadeBus bus_;
  Fleet fleet_;
  LivePage page_;
  std::jthread publisher_;
};

}  // namespace
}  // namespace host_sim::monitor::test

int main(int argc, char** argv) {
  using host_sim::monitor::RecentFrames;
  const auto port = static_cast<std::uint16_t>(argc > 2 ? std::stoi(argv[2]) : 0);
  const int nodes = argc > 3 ? std::stoi(argv[3]) : 8;
  const std::size_t kept = argc > 4 ? std::stoul(argv[4]) << 20 : RecentFrames::kMost;
  host_sim::monitor::test::Feed feed(argv[1], port, nodes, kept);
  for (std::string line; std::getline(std::cin, line);) {
    feed.obey(line);
  }
}
