// Whatever becomes of the frames of a controller on their way, lost, doubled, out of order, played
// again later or among the others: what is shown of its present wire is never less than what was
// reported of that wire with a record after it, and the state never less grave; and without any of
// it one controller is no two. What no record follows cannot be distinguished from what came before
// it.
//
// Input: for each 100 ms of the controller a byte of what happens to it and a byte of what becomes
// of its frames.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host_sim/monitor/fleet/fleet.hpp"
#include "tests/fuzz/io/require.hpp"
#include "tests/monitor/fleet/sender.hpp"

namespace {

using host_sim::fuzz::require;
using host_sim::monitor::Fleet;
using host_sim::monitor::NodeView;
using host_sim::monitor::SeenFrame;
using host_sim::monitor::test::kMs;
using protocol::LifeState;

constexpr protocol::Node kNode = 3;

LifeState state_at(std::uint32_t damage_ppb) {
  return damage_ppb >= 800'000   ? LifeState::worn
         : damage_ppb >= 400'000 ? LifeState::replace
         : damage_ppb >= 200'000 ? LifeState::inspect
                                 : LifeState::normal;
}

struct Sent {
  SeenFrame frame;
  std::size_t number = 0;  ///< in the order of sending
  int wire = 0;
  std::uint32_t damage_ppb = 0;
  bool of_tendon = false;
  bool has_damage = false;
  bool has_record = false;  ///< neither: the boot-up message, which proves nothing
};

/// As the firmware does: records go forward, a new wire is recorded at once, and no more is unsaved
/// than was reported before.
class Controller {
 public:
  void step(std::uint8_t what) {
    const std::size_t begin = sent.size();
    now_ns_ += 100 * kMs;
    const std::uint32_t argument = what >> 3;
    switch (what & 7) {
      case 0:
        wear(argument);
        break;
      case 1:
        wear(20 * argument);
        break;
      case 2:
        wear(20'000 * argument);
        break;
      case 3:
        save();
        break;
      case 4:
        if (argument == 0) {
          ++wire_;
          damage_ppb_ = 0;
          save();
        }
        break;
      case 5:
        if (argument == 0) {
          cut_power();
        }
        break;
      case 6:
        if (worst_unsaved_ppb_ <
            kMostReported_ppb) {  // a store that takes no record is reported first
          worst_unsaved_ppb_ = kMostReported_ppb;
          report_record_ = true;
        } else {
          damage_ppb_ += 10'000 * argument;
        }
        break;
      default:
        break;
    }
    report();
    for (std::size_t i = 0; i < sent.size() - begin; ++i) {
      sent[begin + i].number = begin + i;
    }
  }

  std::vector<Sent> sent;

 private:
  static constexpr std::uint32_t kMostUnsaved_ppb = 1'000;
  static constexpr std::uint32_t kMostReported_ppb = 0xff'ffff;

  void wear(std::uint32_t damage_ppb) {
    damage_ppb_ += damage_ppb;
    if (damage_ppb_ - saved_ppb_ >= kMostUnsaved_ppb) {
      save();
    }
  }
  void save() {
    saved_ppb_ = damage_ppb_;
    ++sequence_;
  }
  void cut_power() {
    damage_ppb_ = saved_ppb_;
    sender_ = host_sim::monitor::test::Sender(kNode);
    now_ns_ += 700 * kMs;
    worst_unsaved_ppb_ = 0;
    turn_ = 0;
    sent.push_back({.frame = sender_.heartbeat(now_ns_, protocol::NmtState::boot_up)});
  }
  void report() {
    sent.push_back({.frame = sender_.status(now_ns_, {.state = state_at(damage_ppb_),
                                                      .damage_ppb = damage_ppb_,
                                                      .storage_ok = true,
                                                      .sensor_ok = true}),
                    .wire = wire_,
                    .damage_ppb = damage_ppb_,
                    .has_damage = true});
    switch (turn_++ % 3) {
      case 0:
        report_record_ = true;
        break;
      case 1:
        sent.push_back(
            {.frame = sender_.page(
                 now_ns_ + 20 * kMs,
                 protocol::detail::TendonDamage{
                     .tendon = 0, .damage_ppb = damage_ppb_, .state = state_at(damage_ppb_)}),
             .wire = wire_,
             .damage_ppb = damage_ppb_,
             .of_tendon = true,
             .has_damage = true});
        break;
      default:
        break;
    }
    if (report_record_) {
      report_record_ = false;
      const std::uint32_t bound_ppb = std::max(worst_unsaved_ppb_, kMostUnsaved_ppb);
      sent.push_back({.frame = sender_.page(now_ns_ + 40 * kMs,
                                            protocol::detail::Storage{sequence_, bound_ppb}),
                      .has_record = true});
    }
  }

  host_sim::monitor::test::Sender sender_{kNode};
  std::int64_t now_ns_ = 0;
  int wire_ = 0;
  std::uint32_t damage_ppb_ = 0;
  std::uint32_t saved_ppb_ = 0;
  std::uint32_t worst_unsaved_ppb_ = 0;
  std::uint32_t sequence_ = 1;
  unsigned turn_ = 0;
  bool report_record_ = false;
};

/// What was reported of the newest wire that was reported, and taken.
class Truth {
 public:
  void see(const Sent& sent) {
    if (sent.has_damage) {
      if (Reported& reported = reported_[sent.of_tendon ? 1 : 0]; sent.wire > reported.wire) {
        reported = {sent.wire, 0};
      }
      waiting_.push_back(sent);
    }
    if (!sent.has_record) {
      return;
    }
    const auto later = std::partition(waiting_.begin(), waiting_.end(),
                                      [&](const Sent& one) { return one.number < sent.number; });
    std::for_each(waiting_.begin(), later, [this](const Sent& one) { keep(one); });
    waiting_.erase(waiting_.begin(), later);
  }
  void require_shown(const NodeView& node) {
    fall(shown_[0], node.highest_damage_ppb, false);
    if (node.status) {
      require(node.highest_damage_ppb >= reported_[0].damage_ppb);
      require(node.life_state() >= state_at(reported_[0].damage_ppb));
    }
    if (const auto tendon = node.tendons.find(0); tendon != node.tendons.end()) {
      fall(shown_[1], tendon->second.value.damage_ppb, true);
      require(tendon->second.value.damage_ppb >= reported_[1].damage_ppb);
      require(tendon->second.value.state >= state_at(reported_[1].damage_ppb));
    }
  }

 private:
  struct Reported {
    int wire = -1;
    std::uint32_t damage_ppb = 0;
  };

  /// Where it falls, what no record has followed yet is given up.
  void fall(std::uint32_t& before_ppb, std::uint32_t shown_ppb, bool of_tendon) {
    if (shown_ppb < before_ppb) {
      std::erase_if(waiting_, [&](const Sent& one) { return one.of_tendon == of_tendon; });
    }
    before_ppb = shown_ppb;
  }

  void keep(const Sent& sent) {
    Reported& reported = reported_[sent.of_tendon ? 1 : 0];
    if (sent.wire == reported.wire) {
      reported.damage_ppb = std::max(reported.damage_ppb, sent.damage_ppb);
    }
  }

  std::array<Reported, 2> reported_;
  std::array<std::uint32_t, 2> shown_{};
  std::vector<Sent> waiting_;  ///< for a record that was sent after it
};

/// What arrives of what was sent, with the times at which it arrives.
class Way {
 public:
  explicit Way(const std::vector<Sent>& sent) : sent_(sent) {}

  void pass(std::size_t begin, std::size_t end, std::uint8_t how) {
    const std::size_t argument = how >> 3;
    for (std::size_t i = begin; i < end; ++i) {
      const Sent& frame = sent_[i];
      switch (how & 7) {
        case 1:  // lost
          continue;
        case 2:  // doubled
          arrive(frame, 0);
          arrive(frame, static_cast<std::int64_t>(argument) * kMs);
          continue;
        case 3:  // late, by up to 6 frames
          arrive(frame, 0);
          if (arrived.size() > 1) {
            const std::size_t back = std::min<std::size_t>(argument % 6 + 1, arrived.size() - 1);
            const std::size_t last = arrived.size() - 1;
            std::swap(arrived[last].frame.time_ns, arrived[last - back].frame.time_ns);
            std::swap(arrived[last], arrived[last - back]);
          }
          continue;
        case 4:  // played again, with the others waiting meanwhile
          arrive(frame, 0);
          if (i == begin) {
            play_again(i, 10 * (argument + 1));
          }
          continue;
        case 5:  // played again among the others
          arrive(frame, 0);
          if (i == begin && argument * 8 < i) {
            among_ = i - argument * 8;
          }
          continue;
        default:
          arrive(frame, 0);
      }
    }
    if (among_ < end && among_ < begin) {
      for (std::size_t left = end - begin; left > 0; --left, ++among_) {
        arrive(sent_[among_], 0);
      }
    }
  }

  std::vector<Sent> arrived;

 private:
  void arrive(const Sent& sent, std::int64_t later_ns) {
    arrived.push_back(sent);
    latest_ns_ = std::max(latest_ns_, sent.frame.time_ns + shift_ns_) + later_ns;
    arrived.back().frame.time_ns = latest_ns_;
  }
  void play_again(std::size_t end, std::size_t count) {
    const std::size_t begin = end - std::min(end, 3 * count);
    const std::int64_t before_ns = latest_ns_;
    if (begin == end) {
      return;
    }
    const std::int64_t offset_ns = latest_ns_ + 50 * kMs - sent_[begin].frame.time_ns;
    for (std::size_t i = begin; i < std::min(end, begin + count); ++i) {
      arrived.push_back(sent_[i]);
      latest_ns_ = std::max(latest_ns_, sent_[i].frame.time_ns + offset_ns);
      arrived.back().frame.time_ns = latest_ns_;
    }
    shift_ns_ += latest_ns_ - before_ns;
  }

  const std::vector<Sent>& sent_;
  std::int64_t latest_ns_ = 0;
  std::int64_t shift_ns_ = 0;
  std::size_t among_ = static_cast<std::size_t>(-1);
};

/// Frames that passed the check of their counter as well: no others are shown.
std::uint64_t taken(const Fleet& fleet) {
  std::uint64_t good = 0;
  for (const auto& [number, node] : fleet.view().nodes) {
    for (const auto& stream : node.streams) {
      good += stream.good;
    }
  }
  return good;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Controller controller;
  std::vector<std::size_t> ends;
  bool disturbed = false;
  for (std::size_t at = 0; at + 2 <= size && at < 2'000; at += 2) {
    controller.step(data[at]);
    ends.push_back(controller.sent.size());
  }
  Way way(controller.sent);
  std::size_t begin = 0;
  for (std::size_t step = 0; step < ends.size(); ++step) {
    const std::uint8_t how = data[2 * step + 1];
    disturbed = disturbed || ((how & 7) >= 1 && (how & 7) <= 5);
    way.pass(begin, ends[step], how);
    begin = ends[step];
  }
  Fleet fleet;
  Truth truth;
  for (const Sent& sent : way.arrived) {
    const std::uint64_t before = taken(fleet);
    fleet.see(sent.frame);
    if (taken(fleet) != before) {
      truth.see(sent);
    }
    if (const auto node = fleet.view().nodes.find(kNode); node != fleet.view().nodes.end()) {
      truth.require_shown(node->second);
      require(disturbed || !node->second.two_controllers);
    }
  }
  return 0;
}
