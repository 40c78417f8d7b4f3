#include <algorithm>

#include "host_sim/synth/campaign/make.hpp"
#include "host_sim/synth/two_sided/drive.hpp"
#include "tests/synth/support.hpp"

namespace host_sim::synth::test {

using enum hal::files::ProfileColumnId;

namespace {

/// One session of +-40 N over half a turn of a sheath of mu 0.1, at 0.5 Hz and 40 mm, the load at
/// 1.5 Hz.
const std::string kBothWays = R"(
[campaign]
name = "both ways"
two_sided = true
[model.sheath]
friction_coefficient = 0.1
bend_angle_deg = 180.0
[recordings]
bend_angles_deg = 180.0
output_means_N = 0.0
output_amplitudes_N = 40.0
frequencies_Hz = 0.5
travels_mm = 40.0
load_frequency_ratio = 3.0
load_phase_deg = 40.0
sample_rate_Hz = 200.0
duration_s = 4.0
)";

constexpr double kMuPhi = 0.1 * std::numbers::pi;

Channels both_ways(const std::string& hidden) {
  const SynthPlan plan = parse_synth_plan(kBothWays + hidden, "plan");
  return session_channels(plan, settings_of(*plan.recordings, 1).at(0), {}, 1);
}

struct Sample {
  double time_s, input_N, output_N, velocity_m_s, position_m, direction;
};

/// Without those next to a reversal of the motion.
std::vector<Sample> samples(const Channels& channels) {
  std::vector<Sample> result;
  const std::vector<double> s = directions(channels);
  for (std::size_t i = 1; i + 1 < s.size(); ++i) {
    if (s[i - 1] == s[i + 1]) {
      const double time_s = channels[kTime][i];
      result.push_back({time_s, channels[kInputTensionColumn][i], channels[kOutputTensionColumn][i],
                        channels[kTendonVelocity][i], -kStroke_m * std::cos(kRate_rad_s * time_s),
                        s[i]});
    }
  }
  return result;
}

/// |T| (exp(mu phi) - 1) against the motion where that is the way of the force, and
/// |T| (1 - exp(-mu phi)) where it is not.
double capstan_N(double force_N, double direction, double exponent = kMuPhi) {
  return force_N * direction > 0 ? direction * std::abs(force_N) * std::expm1(exponent)
                                 : -direction * std::abs(force_N) * std::expm1(-exponent);
}

template <class Expected>
void expect_input(const std::string& hidden, double tolerance_N, const Expected& expected) {
  const std::vector<Sample> all = samples(both_ways(hidden));
  ASSERT_GT(all.size(), 750U);
  for (const Sample& sample : all) {
    ASSERT_NEAR(sample.input_N, expected(sample), tolerance_N) << sample.time_s;
  }
}

TEST(SynthTwoSided, FrictionOfTheSheathIsThatOfTheSizeOfTheForceAgainstTheMotion) {
  expect_input("", 1e-9, [](const Sample& sample) {
    return sample.output_N + capstan_N(sample.output_N, sample.direction);
  });
  const Channels channels = both_ways("");
  const auto [least, most] = std::minmax_element(channels[kOutputTensionColumn].begin(),
                                                 channels[kOutputTensionColumn].end());
  EXPECT_NEAR(*least, -40, 0.1);
  EXPECT_NEAR(*most, 40, 0.1);
}

TEST(SynthTwoSided, LoadIndependentFriction) {
  expect_input("[effects.friction_preload]\nforce_N = 3\n", 1e-9, [](const Sample& sample) {
    return sample.output_N + capstan_N(sample.output_N, sample.direction) + 3 * sample.direction;
  });
}

// The velocity of the 0.25 ms before a sample is that of 0.125 ms earlier.
TEST(SynthTwoSided, ViscousFriction) {
  expect_input("[effects.friction_velocity]\nviscous_N_s_m = 100\n", 0.01,
               [](const Sample& sample) {
                 return sample.output_N + capstan_N(sample.output_N, sample.direction) +
                        100 * sample.velocity_m_s;
               });
}

// z = s - 2 s exp(-x / l) at a travel x since a reversal, when the friction was full before.
TEST(SynthTwoSided, PreslidingTurnsFrictionOverByTheTravelSinceAReversal) {
  expect_input("[effects.presliding]\nlength_mm = 2\n[effects.friction_preload]\nforce_N = 3\n",
               0.01, [](const Sample& sample) {
                 const double travel_m = kStroke_m + sample.direction * sample.position_m;
                 const double z = sample.direction * (1 - 2 * std::exp(-travel_m / 0.002));
                 return sample.output_N +
                        capstan_N(sample.output_N, z < 0 ? -1 : 1, kMuPhi * std::abs(z)) + 3 * z;
               });
}

/// dT/dphi = mu s (|T| / 20 N)^-k |T| by many small steps.
double through_sheath_N(double force_N, double direction, double k) {
  constexpr int kSteps = 20'000;
  for (int i = 0; i < kSteps; ++i) {
    force_N +=
        kMuPhi / kSteps * direction * std::pow(std::abs(force_N) / 20, -k) * std::abs(force_N);
  }
  return force_N;
}

// A force near zero changes its sign on the way, or grows at once, as k says.
TEST(SynthTwoSided, FrictionThatDependsOnTheLoadIsIntegratedAlongTheSheath) {
  for (const double k : {0.25, -0.25}) {
    const std::vector<Sample> all = samples(both_ways(
        "[effects.friction_load]\nexponent = " + std::to_string(k) + "\nreference_N = 20\n"));
    for (std::size_t i = 0; i < all.size(); i += 20) {
      const double expected_N = through_sheath_N(all[i].output_N, all[i].direction, k);
      ASSERT_NEAR(all[i].input_N, expected_N, 2e-3) << all[i].time_s;
    }
  }
}

TEST(SynthTwoSided, AnExponentOfNextToNothingIsNone) {
  expect_input("[effects.friction_load]\nexponent = 1e-9\nreference_N = 20\n", 1e-6,
               [](const Sample& sample) {
                 return sample.output_N + capstan_N(sample.output_N, sample.direction);
               });
}

TEST(SynthTwoSided, ForcesThatRunAwayAreRefused) {
  const auto complaint = [](const std::string& hidden) {
    return complaint_of([&] { both_ways(hidden); });
  };
  const std::string steep = "[effects.friction_load]\nexponent = -1\nreference_N = 0.1\n";
  EXPECT_EQ(complaint(steep).rfind("plan: in session 1, input_tension_N gets to ", 0), 0U)
      << complaint(steep);
  EXPECT_EQ(complaint(steep + "[effects.compliance]\nstiffness_N_mm = 0.1\n")
                .rfind("plan: in session 1, ", 0),
            0U);
}

TEST(SynthTwoSided, FrictionHasARoughPlace) {
  expect_input(
      "[effects.friction_position]\nchange = 0.5\ncentre_mm = 3\nwidth_mm = 4\n"
      "[effects.friction_preload]\nforce_N = 3\n",
      1e-9, [](const Sample& sample) {
        const double from_centre = (sample.position_m - 0.003) / 0.004;
        const double more = 1 + 0.5 * std::exp(-from_centre * from_centre / 2);
        return sample.output_N + capstan_N(sample.output_N, sample.direction, kMuPhi * more) +
               3 * more * sample.direction;
      });
}

TEST(SynthTwoSided, SlackLeavesNoFrictionBehindAReversal) {
  std::size_t loose = 0;
  expect_input("[effects.slack]\ndead_zone_mm = 5\n", 1e-9, [&](const Sample& sample) {
    const double travel_m = kStroke_m + sample.direction * sample.position_m;
    loose += travel_m < 0.005 ? 1U : 0U;
    return travel_m < 0.005 ? sample.output_N
                            : sample.output_N + capstan_N(sample.output_N, sample.direction);
  });
  EXPECT_GT(loose, 100U);
}

// A spring of 2 N/mm takes up the turn of 6 N in 3 mm of travel, and none of the load, which stands
// still here.
TEST(SynthTwoSided, ComplianceTurnsFrictionOverOnASpring) {
  std::string plan = kBothWays;
  const std::string amplitude = "output_amplitudes_N = 40.0";
  plan.replace(plan.find(amplitude), amplitude.size(), "output_amplitudes_N = 0.0");
  const SynthPlan springy = parse_synth_plan(plan +
                                                 "[effects.friction_preload]\nforce_N = 3\n"
                                                 "[effects.compliance]\nstiffness_N_mm = 2\n",
                                             "plan");
  for (const Sample& sample :
       samples(session_channels(springy, settings_of(*springy.recordings, 1).at(0), {}, 1))) {
    const double travel_m = kStroke_m + sample.direction * sample.position_m;
    const double expected_N = sample.direction * std::min(3.0, -3 + 2000 * travel_m);
    ASSERT_NEAR(sample.input_N, expected_N, 1e-6) << sample.time_s;
  }
}

TEST(SynthTwoSided, TheLoadCellHasAZero) {
  expect_input("[effects.load_cell_zero]\nzero_N = 2\n", 1e-9, [](const Sample& sample) {
    const double force_N = sample.output_N - 2;
    return force_N + capstan_N(force_N, sample.direction);
  });
}

// A lag of 5 ms on -40 cos(3 pi t + 40 deg): smaller by the cosine of atan(3 pi 0.005) and behind
// by that angle, once it has settled.
TEST(SynthTwoSided, ASensorLags) {
  const double rate_rad_s = 3 * kRate_rad_s;
  const double behind_rad = std::atan(rate_rad_s * 0.005);
  const Channels channels = both_ways("[effects.filter_lag]\ntime_constant_ms = 5\n");
  for (std::size_t i = 20; i < 800; ++i) {
    const double expected_N =
        -40 * std::cos(behind_rad) *
        std::cos(rate_rad_s * time_of(i) + 2 * std::numbers::pi / 9 - behind_rad);
    ASSERT_NEAR(channels[kOutputTensionColumn][i], expected_N, 1e-3) << i;
  }
}

// 7 ms at 200 Hz: 1.4 samples. Of a late channel of the drive all that it shows is late.
TEST(SynthTwoSided, AChannelIsLate) {
  const Channels in_time = both_ways("");
  const Channels late = both_ways("[effects.channel_delay]\ndelay_ms = 7\n");
  const double rate_rad_s = 3 * kRate_rad_s;
  for (std::size_t i = 2; i < 800; ++i) {
    const double expected_N =
        -40 * std::cos(rate_rad_s * (time_of(i) - 0.007) + 2 * std::numbers::pi / 9);
    ASSERT_NEAR(late[kOutputTensionColumn][i], expected_N, 1e-3) << i;
  }
  EXPECT_EQ(late[kOutputTensionColumn][1], in_time[kOutputTensionColumn][0]);
  EXPECT_EQ(late[kInputTensionColumn], in_time[kInputTensionColumn]);
  const Channels drive =
      both_ways("[effects.channel_delay]\ndelay_ms = 10\nsensor = \"input_tension\"\n");
  EXPECT_EQ(drive[kOutputTensionColumn], in_time[kOutputTensionColumn]);
  for (std::size_t i = 2; i < 800; ++i) {
    ASSERT_NEAR(drive[kInputTensionColumn][i], in_time[kInputTensionColumn][i - 2], 1e-9) << i;
  }
}

TEST(SynthTwoSided, WhatIsFromOutside) {
  expect_input("[outside.moving_mass]\nmass_kg = 20\n", 1e-9, [](const Sample& sample) {
    return sample.output_N + capstan_N(sample.output_N, sample.direction) -
           20 * kRate_rad_s * kRate_rad_s * sample.position_m;
  });
  expect_input("[outside.one_way_friction]\nshare = 0.5\n", 1e-9, [](const Sample& sample) {
    return sample.output_N + capstan_N(sample.output_N, sample.direction,
                                       sample.direction > 0 ? 1.5 * kMuPhi : kMuPhi);
  });
  expect_input("[outside.sheath_creep]\nshare = 0.1\ntime_constant_s = 2\n", 1e-9,
               [](const Sample& sample) {
                 return (sample.output_N + capstan_N(sample.output_N, sample.direction)) *
                        (1.1 - 0.1 * std::exp(-sample.time_s / 2));
               });
}

TEST(SynthTwoSided, TheCampaignSaysSoAndHidesNoOtherEffects) {
  EXPECT_NE(campaign_text(parse_synth_plan(kBothWays, "plan")).find("two_sided = true\n"),
            std::string::npos);
  const auto complaint = [](const std::string& hidden) {
    return complaint_of([&] { parse_synth_plan(kBothWays + hidden, "plan"); });
  };
  EXPECT_NE(complaint("[effects.friction_wear]\nchange = 1\n").find("unknown table"),
            std::string::npos);
  EXPECT_NE(complaint("[outside.rotor_inertia]\ninertia_g_cm2 = 1\n").find("unknown table"),
            std::string::npos);
}

}  // namespace

}  // namespace host_sim::synth::test
