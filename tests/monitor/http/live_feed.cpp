// live_feed LOG [PORT [NODES]]
//
// Serves the live page of a made bus for the tests in a browser. The clock of the bus goes on by
// commands on standard input alone, as fast as the machine can; each is answered by a line with the
// time of the clock in microseconds. Every frame is written to LOG as well.
//
//   run SECONDS          the nodes send
//   silent NODE 0|1      a node sends nothing
//   corrupt NODE 0|1     its frames are damaged on the way
//   emergency NODE CODE  it tells an emergency
//   epoch NODE           its tendon is new
//   bus-off 0|1          the controller of the monitor is off the bus
//   source STATE         running, lost or ended
//   pass SECONDS         the same, without a trace in the log
//   flood SECONDS RATE   in real time, RATE frames a second
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>

#include "host_sim/io/candump.hpp"
#include "host_sim/monitor/fleet/fleet.hpp"
#include "host_sim/monitor/http/live_page.hpp"
#include "host_sim/monitor/http/recent_frames.hpp"
#include "tests/monitor/http/made_bus.hpp"

namespace host_sim::monitor::test {
namespace {

class Feed {
 public:
  Feed(const std::string& log, std::uint16_t port, int nodes)
      : log_(log), bus_(nodes), page_({{"127.0.0.1", port}, {}, &archive_}) {
    fleet_.source_is(FrameSource::State::running, "can0");
    publisher_ = std::jthread([this](const std::stop_token& stop) { publish(stop); });
    fmt::print("{}\n", page_.url());
    std::fflush(stdout);
  }

  void obey(const std::string& line) {
    std::istringstream words(line);
    std::string verb;
    words >> verb;
    if (verb == "flood") {
      flood(words);
    } else {
      const std::lock_guard lock(mutex_);
      change(verb, words);
      fleet_.tick(now_ns_);
    }
    fmt::print("{}\n", now_ns_ / 1000);
    std::fflush(stdout);
  }

 private:
  void change(const std::string& verb, std::istringstream& words) {
    int number = 0;
    if (verb == "run" || verb == "pass") {
      double seconds = 0;
      words >> seconds;
      for (int steps = static_cast<int>(10 * seconds); steps > 0; --steps) {
        step(verb == "run");
      }
    } else if (verb == "silent") {
      words >> number >> bus_.node(number).silent;
    } else if (verb == "corrupt") {
      words >> number >> bus_.node(number).corrupt;
    } else if (verb == "emergency") {
      std::uint16_t code = 0;
      words >> number >> std::hex >> code;
      bus_.node(number).emergency = static_cast<protocol::EmergencyCode>(code);
    } else if (verb == "epoch") {
      words >> number;
      bus_.node(number).damage = 0;
    } else if (verb == "bus-off") {
      SeenFrame seen;
      seen.time_ns = now_ns_;
      words >> number;
      seen.error = BusError{.bus_off = number != 0, .restarted = number == 0};
      fleet_.see(seen);
    } else if (verb == "source") {
      std::string state;
      words >> state;
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
  void flood(std::istringstream& words) {
    double seconds = 0;
    double rate = 0;
    words >> seconds >> rate;
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
        page_.publish(fleet_.view());
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  std::mutex mutex_;
  std::int64_t now_ns_ = 1'790'000'000 * kS;
  std::ofstream log_;
  RecentFrames archive_{"can0"};
  MadeBus bus_;
  Fleet fleet_;
  LivePage page_;
  std::jthread publisher_;
};

}  // namespace
}  // namespace host_sim::monitor::test

int main(int argc, char** argv) {
  const auto port = static_cast<std::uint16_t>(argc > 2 ? std::stoi(argv[2]) : 0);
  const int nodes = argc > 3 ? std::stoi(argv[3]) : 8;
  host_sim::monitor::test::Feed feed(argv[1], port, nodes);
  for (std::string line; std::getline(std::cin, line);) {
    feed.obey(line);
  }
}
