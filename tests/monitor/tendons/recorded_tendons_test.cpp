#include "host_sim/monitor/tendons/recorded_tendons.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/files/input_error.hpp"
#include "tests/monitor/fleet/sender.hpp"

namespace {

using hal::files::InputError;
using host_sim::monitor::recorded_tendons;
using host_sim::monitor::RecordedTendon;
using host_sim::monitor::SeenFrame;
using host_sim::monitor::test::kS;
using host_sim::monitor::test::Sender;
using protocol::LifeState;
using protocol::detail::TendonDamage;
using protocol::detail::WireHistory;

constexpr std::int64_t kMin = 60 * kS;
constexpr std::int64_t kHour = 60 * kMin;

/// A controller whose frames are kept.
class Recorded {
 public:
  explicit Recorded(protocol::Node node) : sender_(node) {}

  struct Growth {
    std::uint8_t tendon;
    std::uint32_t from_ppb;
    std::uint32_t to_ppb;
  };

  void boot(std::int64_t time_ns) {
    frames.push_back(sender_.heartbeat(time_ns, protocol::NmtState::boot_up));
    status(time_ns, {.state = LifeState::normal});
  }
  /// Reports damages each minute, that grow evenly.
  void run(std::int64_t begin_ns, std::int64_t end_ns, const std::vector<Growth>& tendons) {
    const std::int64_t steps = (end_ns - begin_ns) / kMin;
    for (std::int64_t i = 0; i <= steps; ++i) {
      for (const Growth& growth : tendons) {
        const std::int64_t grown =
            (static_cast<std::int64_t>(growth.to_ppb) - growth.from_ppb) * i / steps;
        page(begin_ns + i * kMin,
             TendonDamage{growth.tendon, static_cast<std::uint32_t>(growth.from_ppb + grown),
                          LifeState::normal});
      }
    }
  }
  template <class Page>
  void page(std::int64_t time_ns, const Page& page) {
    frames.push_back(sender_.page(time_ns, page));
  }
  void status(std::int64_t time_ns, const protocol::LifeStatus& status) {
    frames.push_back(sender_.status(time_ns, status));
  }

  std::vector<SeenFrame> frames;

 private:
  Sender sender_;
};

std::vector<RecordedTendon> read(const std::vector<SeenFrame>& frames) {
  std::size_t at = 0;
  return recorded_tendons(
      [&]() -> std::optional<SeenFrame> {
        return at < frames.size() ? std::optional(frames[at++]) : std::nullopt;
      },
      "r1");
}

std::string refusal(const std::vector<SeenFrame>& frames) {
  try {
    read(frames);
    return "read";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(RecordedTendons, HaveDamageRateAndScatterOfEachTendon) {
  Recorded node(3);
  // Two sessions of two hours: 0.02 and 0.04 of damage, 0.01 between them unheard.
  node.boot(kHour);
  node.run(kHour, 3 * kHour, {{1, 100'000'000, 120'000'000}});
  constexpr std::int64_t kAgain = 3 * kHour + kMin;
  node.boot(kAgain);
  node.run(kAgain, kAgain + 2 * kHour, {{1, 130'000'000, 170'000'000}, {0, 0, 2'000'000}});
  const auto tendons = read(node.frames);
  ASSERT_EQ(tendons.size(), 2U);
  EXPECT_EQ(tendons[0].name, "r1/3/0");
  EXPECT_NEAR(tendons[0].damage_per_h, 0.001, 1e-12);
  EXPECT_EQ(tendons[0].rate_log_sd, 0);
  EXPECT_NEAR(tendons[0].age_h.value(), 2, 1e-9);  // new where the record begins
  EXPECT_EQ(tendons[1].name, "r1/3/1");
  EXPECT_NEAR(tendons[1].damage, 0.17, 1e-12);
  EXPECT_NEAR(tendons[1].damage_per_h, 0.06 / 4, 1e-12);
  EXPECT_FALSE(tendons[1].age_h);
  EXPECT_EQ(tendons[1].last_ns, kAgain + 2 * kHour);
  EXPECT_EQ(tendons[1].broken, false);
  EXPECT_FALSE(tendons[1].past_lost);
  // ln 0.01 and ln 0.02 are ln 2 apart: their standard deviation is ln 2 / sqrt 2.
  EXPECT_NEAR(tendons[1].rate_log_sd, std::log(2) / std::sqrt(2), 1e-9);
}

TEST(RecordedTendons, WeighSessionsByTheirHours) {
  Recorded node(3);
  node.boot(0);
  node.run(0, 3 * kHour, {{0, 0, 30'000'000}});  // 0.01 an hour, three hours
  node.boot(10 * kHour);
  node.run(10 * kHour, 11 * kHour, {{0, 30'000'000, 50'000'000}});  // 0.02, one
  node.boot(20 * kHour);
  node.run(20 * kHour, 21 * kHour, {{0, 50'000'000, 50'000'000}});  // rest
  node.boot(30 * kHour);
  node.run(30 * kHour, 30 * kHour + 3 * kMin, {{0, 50'000'000, 90'000'000}});  // too short
  const auto tendons = read(node.frames);
  // Weights 3/4 and 1/4: (3/16 ln^2 2) / (1 - 10/16) = ln^2 2 / 2.
  EXPECT_NEAR(tendons[0].rate_log_sd, std::log(2) / std::sqrt(2), 1e-9);
  EXPECT_NEAR(tendons[0].damage_per_h, 0.09 / 5.05, 1e-9);
}

TEST(RecordedTendons, ASilenceOfTenMinutesEndsASession) {
  Recorded node(3);
  node.boot(0);
  node.run(0, kHour, {{0, 0, 10'000'000}});
  node.run(kHour + 10 * kMin, 2 * kHour, {{0, 12'000'000, 20'000'000}});  // heard on: two hours
  node.run(3 * kHour, 4 * kHour,
           {{0, 80'000'000, 100'000'000}});  // what was before it is not its own
  const auto tendons = read(node.frames);
  EXPECT_NEAR(tendons[0].damage_per_h, 0.04 / 3, 1e-9);
  EXPECT_NEAR(tendons[0].damage, 0.1, 1e-12);
  EXPECT_FALSE(tendons[0].age_h);
}

TEST(RecordedTendons, ANewWireBeginsAnew) {
  using protocol::detail::Storage;
  Recorded node(3);
  node.boot(0);
  node.run(0, kHour, {{0, 500'000'000, 600'000'000}});
  // Without a gap: a record among reports, and a later one among reports of less.
  std::int64_t time_ns = kHour;
  const auto report = [&](std::uint32_t damage_ppb, std::uint32_t sequence) {
    for (int i = 0; i < 5; ++i) {
      node.page(time_ns += kS / 10, TendonDamage{0, damage_ppb, LifeState::normal});
    }
    node.page(time_ns += kS / 10, Storage{sequence, 1'000});
  };
  report(600'000'000, 7);
  report(600'000'000, 7);
  report(0, 8);
  report(0, 8);
  report(0, 8);
  node.run(kHour + kMin, 3 * kHour + kMin, {{0, 0, 20'000'000}});
  const auto tendons = read(node.frames);
  EXPECT_NEAR(tendons[0].damage, 0.02, 1e-12);
  EXPECT_NEAR(tendons[0].age_h.value(), 2, 0.02);
  // That of the joint, with both wires: 0.1 and 0.02 in all that was heard.
  EXPECT_NEAR(tendons[0].damage_per_h, 0.12 / 3, 0.001);
}

TEST(RecordedTendons, NameTheBrokenAndWhatIsNotVouchedFor) {
  Recorded node(3);
  node.boot(0);
  node.run(0, kHour, {{0, 0, 1'000'000}, {1, 0, 1'000'000}});
  node.status(kHour, {.state = LifeState::unknown, .broken = true});
  const auto unsure = read(node.frames);
  EXPECT_EQ(unsure[0].broken, std::nullopt);
  EXPECT_TRUE(unsure[0].past_lost);
  node.page(kHour, WireHistory{.tendon = 0, .broken = false});
  node.page(kHour, WireHistory{.tendon = 1, .broken = true});
  const auto sure = read(node.frames);
  EXPECT_EQ(sure[0].broken, false);
  EXPECT_EQ(sure[1].broken, true);
}

TEST(RecordedTendons, RefuseWhatCannotBePlannedWith) {
  Recorded silent(3);
  silent.boot(0);
  EXPECT_EQ(refusal(silent.frames),
            "r1: no damage of a tendon in this record; accepted: frames of a controller, of which "
            "LifeDetail page 3 has the damage");
  EXPECT_EQ(refusal({}), refusal(silent.frames));
  silent.page(kMin, TendonDamage{0, 5, LifeState::normal});
  EXPECT_EQ(
      refusal(silent.frames),
      "r1: the damage of 'r1/3/0' was heard once only, and its rate never; accepted: a longer "
      "record");
  Recorded hasty(3);  // 0.001 in a ns
  hasty.boot(0);
  hasty.page(kMin, TendonDamage{0, 5'000'000, LifeState::normal});
  hasty.page(kMin + 1, TendonDamage{0, 6'000'000, LifeState::normal});
  EXPECT_EQ(
      refusal(hasty.frames),
      "r1: the damage of 'r1/3/0' rises by 3.6e+09 an hour; accepted: 0..100 an hour, and frames "
      "with the times at which they were sent");
  // Each counts its own frames, and not from the same number.
  Recorded one(4);
  Recorded two(4);
  two.status(0, {.state = LifeState::normal});
  two.status(0, {.state = LifeState::normal});
  std::vector<SeenFrame> both;
  for (std::int64_t time_ns = 0; time_ns < 4 * kS; time_ns += kS / 10) {
    for (Recorded* const each : {&one, &two}) {
      each->status(time_ns, {.state = LifeState::normal, .damage_ppb = 7});
      both.push_back(each->frames.back());
    }
  }
  EXPECT_EQ(refusal(both),
            "r1: two controllers have node id 4; accepted: a record of nodes that each have an id "
            "of their own");
}

}  // namespace
