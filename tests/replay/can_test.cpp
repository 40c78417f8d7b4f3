#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "hal/files/candump.hpp"
#include "tests/replay/program.hpp"

namespace {

using host_sim_test::contents;

struct Sent {
  std::uint64_t time_us;
  hal::CanFrame frame;
};

/// The life of one pass of a profile, as it was reported on the bus.
class ReplayToBus : public host_sim_test::Program {
 protected:
  std::vector<Sent> log(const std::string& name) {
    hal::files::CandumpReader reader(folder_ / name);
    std::vector<Sent> frames;
    while (const auto line = reader.next()) {
      const auto frame = line->classic();
      EXPECT_TRUE(frame) << "only data frames are sent";
      frames.push_back({line->time_us, frame.value_or(hal::CanFrame{})});
    }
    return frames;
  }

  template <class Message>
  std::vector<Message> all(const std::vector<Sent>& frames) {
    std::vector<Message> messages;
    for (const Sent& sent : frames) {
      if (const auto message = protocol::decode<Message>(sent.frame)) {
        messages.push_back(*message);
      }
    }
    return messages;
  }

  nlohmann::json result() { return nlohmann::json::parse(contents(folder_ / "r.json")); }

  std::uint32_t damage_ppb() {
    return static_cast<std::uint32_t>(std::floor(result()["damage"]["total"].get<double>() * 1e9));
  }

  /// Samples at 1 kHz between 5 and 55 N, in the columns of a kind of profile.
  void write_sine(const std::string& name, const std::string& header, double scale,
                  const std::string& rest, int from = 0, int before = 2'000) {
    std::string text = header + "\n";
    for (int i = from; i < before; ++i) {
      text += std::to_string(i) + "e-3," + std::to_string(scale * (30 + 25 * std::sin(i * 0.031))) +
              rest + "\n";
    }
    write(name, text);
  }
};

TEST_F(ReplayToBus, TheLastStatusHasTheDamageOfTheReplayForEachKindOfInput) {
  write("model.toml",
        host_sim_test::with(contents(folder_ / "model.toml"), "sample_rate_Hz", "1000"));
  write_sine("tension.csv", "time_s,input_tension_N", 1, "");
  write_sine("current.csv", "time_s,motor_current_A", 0.05, "");
  write_sine("output.csv", "time_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg", 0.7,
             ",0.01,180");
  for (const std::string kind : {"tension", "current", "output"}) {
    ASSERT_EQ(run("replay " + kind + ".csv --model model.toml --json r.json --can out.log"), 0)
        << err_;
    const auto frames = log("out.log");
    const auto statuses = all<protocol::LifeStatus>(frames);
    ASSERT_FALSE(statuses.empty());
    EXPECT_GT(damage_ppb(), 1'000'000u);
    EXPECT_EQ(statuses.back().damage_ppb, damage_ppb()) << kind;
    EXPECT_EQ(statuses.back().state, protocol::LifeState::normal);
    EXPECT_EQ(statuses.back().quality, protocol::Quality::measured);
    EXPECT_EQ(result()["can_frames"], frames.size());
    for (std::size_t i = 1; i < statuses.size(); ++i) {
      EXPECT_LE(statuses[i - 1].damage_ppb, statuses[i].damage_ppb);
    }
  }
}

TEST_F(ReplayToBus, EveryFrameOfTheExampleIsWholeAndInSequence) {
  ASSERT_EQ(run("replay '" EXAMPLES "/upper_arm.csv' --model '" EXAMPLES
                "/upper_arm.toml' --json r.json --can out.log --node 42"),
            0)
      << err_;
  const auto frames = log("out.log");
  std::map<std::uint32_t, protocol::e2e::Checker> checkers{
      {0x1aa, protocol::e2e::Checker(protocol::e2e::stream_of<protocol::LifeStatus>(42))},
      {0x2aa, protocol::e2e::Checker(protocol::e2e::stream_of<protocol::detail::Identity>(42))}};
  std::vector<std::uint64_t> beats_us;
  std::uint64_t last_us = 0;
  for (const Sent& sent : frames) {
    EXPECT_GE(sent.time_us, last_us);
    last_us = sent.time_us;
    if (sent.frame.id == 0x72a) {
      beats_us.push_back(sent.time_us);
      continue;
    }
    const auto checker = checkers.find(sent.frame.id);
    ASSERT_NE(checker, checkers.end()) << std::hex << sent.frame.id;
    const auto status = checker->second.check(sent.frame);
    EXPECT_TRUE(status == protocol::e2e::Status::ok || status == protocol::e2e::Status::initial);
  }
  // The boot-up message and the first heartbeat at the start, and one for each of 60 seconds.
  ASSERT_EQ(beats_us.size(), 62u);
  for (std::size_t second = 1; second <= 60; ++second) {
    EXPECT_GE(beats_us[second + 1], second * 1'000'000);
    EXPECT_LT(beats_us[second + 1], second * 1'000'000 + 100'000);
  }
  EXPECT_EQ(all<protocol::LifeStatus>(frames).back().damage_ppb, damage_ppb());
  std::set<unsigned> pages;
  for (const Sent& sent : frames) {
    if (sent.frame.id == 0x2aa) {
      pages.insert(std::to_integer<unsigned>(sent.frame.data[1] >> 4));
    }
  }
  EXPECT_EQ(pages.size(), protocol::detail::kPages);
}

TEST_F(ReplayToBus, WhatComesAtTheVeryEndIsToldToo) {
  // By now the bus budget is spent and statuses are late, so that one leaves before the next
  // reading.
  write("late.csv",
        contents(EXAMPLES "/upper_arm.csv") +
            "60.005,10,0.01,270\n60.01,120,0.01,270\n60.015,10,0.01,270\n60.02,120,0.01,270\n");
  ASSERT_EQ(run("replay late.csv --model model.toml --json r.json --can out.log"), 0) << err_;
  EXPECT_EQ(all<protocol::LifeStatus>(log("out.log")).back().damage_ppb, damage_ppb());
}

TEST_F(ReplayToBus, TheSameProfileGivesTheSameBytes) {
  const std::string replay = "replay '" EXAMPLES "/upper_arm.csv' --model model.toml --can ";
  ASSERT_EQ(run(replay + "a.log"), 0) << err_;
  ASSERT_EQ(run(replay + "b.log"), 0) << err_;
  EXPECT_EQ(contents(folder_ / "a.log"), contents(folder_ / "b.log"));
  ASSERT_EQ(run(replay + "-"), 0) << err_;
  EXPECT_EQ(contents(folder_ / "a.log"), out_);
  EXPECT_NE(err_.find("life used"), std::string::npos) << "the summary goes elsewhere";
}

TEST_F(ReplayToBus, TheBusDoesNotChangeTheResult) {
  const std::string replay = "replay '" EXAMPLES "/upper_arm.csv' --model model.toml --json ";
  ASSERT_EQ(run(replay + "a.json"), 0);
  ASSERT_EQ(run(replay + "b.json --can out.log"), 0);
  auto with_bus = nlohmann::json::parse(contents(folder_ / "b.json"));
  EXPECT_EQ(with_bus.erase("can_frames"), 1u);
  EXPECT_EQ(nlohmann::json::parse(contents(folder_ / "a.json")), with_bus);
}

TEST_F(ReplayToBus, AGapIsToldAsOne) {
  write("model.toml",
        host_sim_test::with(contents(folder_ / "model.toml"), "sample_rate_Hz", "1000"));
  write_sine("before.csv", "time_s,input_tension_N", 1, "", 0, 1'000);
  write_sine("after.csv", "time_s,input_tension_N", 1, "", 3'000, 4'000);
  const std::string after = contents(folder_ / "after.csv");
  write("gap.csv", contents(folder_ / "before.csv") + after.substr(after.find('\n') + 1));
  ASSERT_EQ(run("replay gap.csv --model model.toml --json r.json --can out.log"), 0) << err_;
  EXPECT_EQ(result()["missing_samples"], 2'000);
  const auto frames = log("out.log");
  const auto statuses = all<protocol::LifeStatus>(frames);
  EXPECT_FALSE(statuses.front().gap);
  EXPECT_TRUE(statuses.back().gap);
  EXPECT_EQ(statuses.back().quality, protocol::Quality::gaps);
  EXPECT_EQ(statuses.back().damage_ppb, damage_ppb());
  bool late = false;
  for (const auto& emergency : all<protocol::Emergency>(frames)) {
    late = late || emergency.code == protocol::EmergencyCode::deadline;
  }
  EXPECT_TRUE(late) << "the control loop left out periods";
  // Time goes by in the gap too.
  EXPECT_EQ(all<protocol::Heartbeat>(frames).size(), 2u + 3u + 1u);
}

TEST_F(ReplayToBus, AValueBeyondTheSensorIsToldAsSaturated) {
  write("wild.csv", "time_s,input_tension_N\n0,10\n0.005,900\n0.01,10\n");
  ASSERT_EQ(run("replay wild.csv --model model.toml --json r.json --can out.log"), 0) << err_;
  const auto last = all<protocol::LifeStatus>(log("out.log")).back();
  EXPECT_TRUE(last.saturated);
  EXPECT_EQ(last.quality, protocol::Quality::saturated);
  EXPECT_EQ(last.damage_ppb, damage_ppb());
}

TEST_F(ReplayToBus, WrongUsageIsStatusTwo) {
  const auto before = files();
  const std::string replay = "replay good.csv --model model.toml ";
  EXPECT_EQ(run(replay + "--can x --json x"), 2);
  EXPECT_NE(err_.find("two outputs go to"), std::string::npos) << err_;
  EXPECT_EQ(run(replay + "--can - --trajectory -"), 2);
  EXPECT_EQ(run(replay + "--node 3"), 2) << "a node without a bus";
  EXPECT_EQ(run(replay + "--can x --node 0"), 2);
  EXPECT_EQ(run(replay + "--can x --node 128"), 2);
  EXPECT_EQ(files(), before);
}

TEST_F(ReplayToBus, BadInputLeavesNoLogBehind) {
  write("bad.csv", "time_s,input_tension_N\n0,1\n1,x\n");
  const auto before = files();
  EXPECT_EQ(run("replay bad.csv --model model.toml --can out.log"), 1);
  EXPECT_EQ(err_.rfind("bad.csv:3:", 0), 0u) << err_;
  EXPECT_EQ(files(), before);
  EXPECT_EQ(run("replay good.csv --model model.toml --can no/such/out.log"), 1);
  EXPECT_NE(err_.find("no/such/out.log"), std::string::npos) << err_;
}

}  // namespace
