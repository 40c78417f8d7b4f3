#include "host_sim/diagnose/force/doubts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "host_sim/diagnose/force/diagnose_forces.hpp"
#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {
namespace {

using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using effects::ForceRecord;

/// A tendon in sheaths that turn by 90, 180 and 270 degrees: T_in = T_out exp(0.12 angle sgn v).
std::vector<ForceRecord> pulled(unsigned seed, int sessions = 12) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<ForceRecord> records;
  for (int j = 0; j < sessions; ++j) {
    ForceRecord record;
    record.session = "s" + std::to_string(j);
    record.pulls_alone = true;
    record.rotor_known = true;
    const double angle_rad = std::numbers::pi / 2 * (1 + j % 3);
    const double gain = 1 + 0.01 * normal(engine);
    for (int i = 0; i < 1000; ++i) {
      const double t = 0.01 * i;
      const double omega = 2 * std::numbers::pi * (0.3 + 0.05 * j);
      const double load_N = 20 + 10 * std::sin(1.7 * t + j);
      record.time_s.push_back(t);
      record.position_m.push_back(0.02 * std::sin(omega * t));
      record.velocity_m_s.push_back(0.02 * omega * std::cos(omega * t));
      const double way = record.velocity_m_s.back() < 0 ? -1 : 1;
      record.output_N.push_back(load_N + 0.1 * normal(engine));
      record.output_rate_N_s.push_back(17 * std::cos(1.7 * t + j));
      record.input_N.push_back(gain * load_N * std::exp(0.12 * angle_rad * way) +
                               0.1 * normal(engine));
      record.bend_angle_rad.push_back(angle_rad);
      record.used.push_back(true);
      record.measured.push_back(true);
    }
    records.push_back(std::move(record));
  }
  return records;
}

using Channel = std::vector<double> ForceRecord::*;

void scale(ForceRecord& record, Channel channel, double times) {
  for (double& value : record.*channel) {
    value *= times;
  }
}

std::vector<ForceRecord> scaled(Channel channel, double times) {
  std::vector<ForceRecord> records = pulled(1);
  for (ForceRecord& record : records) {
    scale(record, channel, times);
  }
  return records;
}

/// Session s4 alone.
std::vector<ForceRecord> scaled_once(Channel channel, double times, int sessions = 12) {
  std::vector<ForceRecord> records = pulled(1, sessions);
  scale(records[4], channel, times);
  return records;
}

std::vector<Doubt> doubts(const std::vector<ForceRecord>& records) {
  return doubts_of(records, nominal());
}

Findings diagnosed(const std::vector<ForceRecord>& records) {
  return diagnose_forces(records, nominal(), kWire, {}).findings;
}

TEST(Doubts, AreNoneOfSoundRecordings) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    EXPECT_THAT(doubts(pulled(seed)), IsEmpty());
  }
  EXPECT_THAT(diagnosed(pulled(1)).doubts, IsEmpty());
}

struct Wrong {
  const char* what;
  Channel channel;
  double times;
  const char* column;
  const char* words;
  bool spoils;
};

constexpr double kPerDegree = std::numbers::pi / 180;

const Wrong kWrong[] = {
    {"kN", &ForceRecord::output_N, 0.001, "input_tension_N", "N and kN", true},
    {"pounds", &ForceRecord::input_N, 1 / 4.448, "input_tension_N", "pounds-force", true},
    {"sign", &ForceRecord::input_N, -1, "input_tension_N", "opposite signs", true},
    {"direction", &ForceRecord::velocity_m_s, -1, "tendon_velocity_m_s", "drive the motion", true},
    {"radians", &ForceRecord::bend_angle_rad, kPerDegree, "bend_angle_deg", "in radians", true},
    {"millimetres", &ForceRecord::velocity_m_s, 1000, "motor_angle_rad", "mm and m", true},
    {"radius", &ForceRecord::position_m, 2, "motor_angle_rad", "2 times as far", false},
    {"degrees", &ForceRecord::position_m, 1 / kPerDegree, "motor_angle_rad", "degrees", true},
    {"rpm", &ForceRecord::position_m, 6, "motor_angle_rad", "turns a minute and degrees", true},
    {"4.4 mm", &ForceRecord::position_m, 4.4, "motor_angle_rad", "velocity says: are", true},
};

TEST(Doubts, NameTheColumnAndTheUnit) {
  for (const Wrong& wrong : kWrong) {
    const std::vector<Doubt> all = doubts(scaled(wrong.channel, wrong.times));
    const auto doubt = std::ranges::find_if(all, [&](const Doubt& one) {
      return one.column == wrong.column && one.words.find(wrong.words) != std::string::npos;
    });
    ASSERT_NE(doubt, all.end()) << wrong.what;
    EXPECT_THAT(doubt->sessions, IsEmpty()) << wrong.what;
    EXPECT_EQ(doubt->spoils, wrong.spoils) << wrong.what;
  }
}

TEST(Doubts, NameTheSessionThatIsUnlikeTheOthers) {
  for (const Wrong& wrong : kWrong) {
    const std::vector<Doubt> all = doubts(scaled_once(wrong.channel, wrong.times));
    ASSERT_THAT(all, SizeIs(testing::Ge(1U))) << wrong.what;
    for (const Doubt& doubt : all) {
      // How fast or how far a tendon moves is no matter of other sessions.
      EXPECT_TRUE(doubt.sessions == std::vector<std::string>{"s4"} ||
                  doubt.words.find("would move at up to") != std::string::npos)
          << wrong.what << ": " << doubt.words;
    }
  }
}

TEST(Doubts, OfFewSessionsNoneIsUnlikeTheOthers) {
  EXPECT_THAT(doubts(scaled_once(&ForceRecord::velocity_m_s, -1, 10)), SizeIs(1));
  EXPECT_THAT(doubts(scaled_once(&ForceRecord::velocity_m_s, -1, 9)), IsEmpty());
}

TEST(Doubts, AskForMillimetresWhereNoAngleIsKnown) {
  std::vector<ForceRecord> records = scaled(&ForceRecord::velocity_m_s, 1000);
  for (ForceRecord& record : records) {
    record.rotor_known = false;
    scale(record, &ForceRecord::position_m, 1000);
  }
  const std::vector<Doubt> all = doubts(records);
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_EQ(all[0].column, "tendon_velocity_m_s");
  EXPECT_THAT(all[0].words, HasSubstr("mm/s"));
}

TEST(Doubts, AskWhetherForcesOfBothSignsAreOfOneTendon) {
  std::vector<ForceRecord> records = pulled(1);
  for (ForceRecord& record : records) {
    for (std::size_t i = 0; i < record.samples(); ++i) {
      record.input_N[i] -= 22;
      record.output_N[i] -= 20;
    }
  }
  const std::vector<Doubt> all = doubts(records);
  ASSERT_THAT(all, SizeIs(2));
  EXPECT_THAT(all[0].words, HasSubstr("two_sided = true"));
  for (ForceRecord& record : records) {
    record.pulls_alone = false;
  }
  EXPECT_THAT(doubts(records), IsEmpty());
}

/// In each of them the log stops for 40 s, in which the drive runs on.
TEST(Doubts, APauseOfTheLogIsNoMotion) {
  std::vector<ForceRecord> records = pulled(1);
  for (ForceRecord& record : records) {
    for (std::size_t i = record.samples() / 3; i < record.samples(); ++i) {
      record.time_s[i] += 40;
      record.position_m[i] += 1;
    }
  }
  EXPECT_THAT(doubts(records), IsEmpty());
}

TEST(Doubts, AskForAnAngleThatCountsOn) {
  constexpr double kTurn_rad = 2 * std::numbers::pi;
  std::vector<ForceRecord> records = pulled(1);
  for (ForceRecord& record : records) {
    for (double position_m : record.position_m) {
      const double angle_rad = position_m / 0.002;  // ten radians either way
      record.rotor_rad.push_back(angle_rad);
    }
  }
  EXPECT_THAT(doubts(records), IsEmpty());
  ForceRecord& wrapped = records[4];
  for (std::size_t i = 0; i < wrapped.samples(); ++i) {
    wrapped.rotor_rad[i] -= kTurn_rad * std::floor(wrapped.rotor_rad[i] / kTurn_rad);
    wrapped.position_m[i] = 0.002 * wrapped.rotor_rad[i];
  }
  const std::vector<Doubt> all = doubts(records);
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_THAT(all[0].sessions, ElementsAre("s4"));
  EXPECT_EQ(all[0].column, "motor_angle_rad");
  EXPECT_THAT(all[0].words, HasSubstr("jumps by whole turns"));
  EXPECT_TRUE(all[0].spoils);
}

TEST(Doubts, SpoiltSessionsStayWhereTooFewWereLeft) {
  std::vector<ForceRecord> records = pulled(1);
  std::vector<Doubt> some{{{"s1", "s2"}, "", "", true}, {{"s3"}, "", "", false}};
  EXPECT_THAT(sound_of(records, some), SizeIs(10));
  EXPECT_TRUE(some[0].spoils);
  std::vector<Doubt> most{{{"s0", "s1", "s2", "s3", "s4", "s5"}, "", "", true},
                          {{}, "", "of all", true}};
  EXPECT_THAT(sound_of(records, most), SizeIs(12));
  EXPECT_FALSE(most[0].spoils);
  EXPECT_TRUE(most[1].spoils);
}

TEST(Doubts, NameTheSessionWhoseGainIsUnlikeTheOthers) {
  const Findings findings = diagnosed(scaled_once(&ForceRecord::input_N, 1.3));
  ASSERT_THAT(findings.doubts, SizeIs(1));
  EXPECT_THAT(findings.doubts[0].sessions, ElementsAre("s4"));
  // As exactly as the force of a stroke is known beside how friction turns over.
  EXPECT_THAT(findings.doubts[0].words,
              AnyOf(HasSubstr("1.29 times as large"), HasSubstr("1.3 times as large")));
  EXPECT_FALSE(findings.doubts[0].spoils);
}

/// Of 15 N on the average friction takes 8 N, and 14.9 N of one session: that comes near zero one
/// way, as if of a gain of a sixth of the others'.
TEST(Doubts, FrictionAsLargeAsTheLoadIsNoOtherGain) {
  std::vector<ForceRecord> records = pulled(1);
  for (ForceRecord& record : records) {
    const double friction_N = record.session == "s4" ? 14.9 : 8;
    for (std::size_t i = 0; i < record.samples(); ++i) {
      record.output_N[i] = 15 + 0.2 * (record.output_N[i] - 20);
      record.input_N[i] = record.output_N[i] + std::copysign(friction_N, record.velocity_m_s[i]);
    }
  }
  EXPECT_THAT(doubts(records), IsEmpty());
}

void delay(ForceRecord& record, Channel channel, std::ptrdiff_t samples) {
  std::vector<double>& values = record.*channel;
  std::shift_right(values.begin(), values.end(), samples);
  std::fill_n(record.measured.begin(), samples, false);
  std::fill_n(record.used.begin(), samples, false);
}

TEST(Doubts, NameTheChannelThatIsLate) {
  for (const auto& [channel, column] :
       {std::pair(&ForceRecord::velocity_m_s, "tendon_velocity_m_s"),
        std::pair(&ForceRecord::output_N, "output_tension_N")}) {
    std::vector<ForceRecord> records = pulled(1);
    for (ForceRecord& record : records) {
      delay(record, channel, 40);
    }
    const Findings findings = diagnosed(records);
    const auto doubt = std::ranges::find_if(findings.doubts, [](const Doubt& one) {
      return one.words.find("400 ms sooner") != std::string::npos;
    });
    ASSERT_NE(doubt, findings.doubts.end()) << column;
    EXPECT_EQ(doubt->column, column);
    EXPECT_THAT(findings.effects, IsEmpty());
  }
}

TEST(Doubts, NameTheSessionWhoseChannelIsLate) {
  std::vector<ForceRecord> records = pulled(1);
  delay(records[4], &ForceRecord::output_N, 40);
  const Findings findings = diagnosed(records);
  ASSERT_THAT(findings.doubts, SizeIs(1));
  EXPECT_THAT(findings.doubts[0].sessions, ElementsAre("s4"));
  EXPECT_EQ(findings.doubts[0].column, "output_tension_N");
  EXPECT_THAT(findings.doubts[0].words, HasSubstr("400 ms sooner"));
}

TEST(Doubts, AreSentences) {
  EXPECT_EQ(doubt_prose({{"s1"}, "bend_angle_deg", "it is odd", true}),
            "session s1, bend_angle_deg: it is odd (it is left out)");
  EXPECT_EQ(doubt_prose({{"a", "b", "c", "d", "e", "f", "g"}, "", "they are odd", true}),
            "sessions a, b, c, d, e and 2 more: they are odd (they are left out)");
  EXPECT_EQ(doubt_prose({{}, "motor_current_A", "it is odd", true}),
            "motor_current_A: it is odd (nothing is named before that is settled)");
  EXPECT_EQ(doubt_prose({{}, "", "it is odd", false}), "it is odd");
}

}  // namespace
}  // namespace host_sim::diagnose
