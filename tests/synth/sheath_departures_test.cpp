#include <algorithm>

#include "tests/synth/support.hpp"

namespace host_sim::synth::test {

using hal::files::kInputTensionColumn;
using hal::files::kOutputTensionColumn;
using hal::files::kSheathTemperature;
using hal::files::kTendonVelocity;

namespace {

double position_m(std::size_t i) {
  return -kStroke_m * std::cos(kRate_rad_s * time_of(i));
}

TEST(SynthFriction, WearGrowsWithAPowerOfTheCycles) {
  const Channels channels = session(kRecordings +
                                    "start_cycles = 400\n[effects.friction_wear]\nchange = 0.3\n"
                                    "reference_cycles = 100\nexponent = 0.5\n");
  expect_residuals(channels, 1e-12, [](std::size_t i, double s) {
    return -kFull * s * 0.3 * std::sqrt((400 + 0.5 * time_of(i)) / 100);
  });
}

TEST(SynthFriction, RunInFades) {
  const Channels channels =
      session(kRecordings +
              "start_cycles = 100\n[effects.friction_wear]\nlaw = \"run_in\"\nchange = 0.5\n"
              "reference_cycles = 100\n");
  expect_residuals(channels, 1e-12, [](std::size_t i, double s) {
    return -kFull * s * 0.5 * std::exp(-(100 + 0.5 * time_of(i)) / 100);
  });
}

TEST(SynthFriction, TemperatureFollowsItsSurroundings) {
  const Channels channels = session(kRecordings +
                                    "sheath_ambients_C = 60\n[thermal]\nsheath_time_constant_s = "
                                    "2\n[effects.friction_temperature]\nslope_1_K = 0.004\n");
  const auto warmer_K = [](std::size_t i) { return 40 * (1 - std::exp(-time_of(i) / 2)); };
  expect_residuals(channels, 1e-10,
                   [&](std::size_t i, double s) { return -kFull * s * 0.004 * warmer_K(i); });
  EXPECT_NEAR(channels[kSheathTemperature][400], 20 + 40 * (1 - std::exp(-1)), 1e-9);
}

TEST(SynthFriction, StribeckAndViscousFrictionGoWithTheSpeed) {
  const Channels channels = session(kRecordings +
                                    "[effects.friction_velocity]\nstatic_coefficient = 0.2\n"
                                    "stribeck_velocity_mm_s = 10\nviscous_s_m = 0.5\n");
  expect_residuals(channels, 1e-12, [](std::size_t i, double s) {
    const double speed = std::abs(kStroke_m * kRate_rad_s * std::sin(kRate_rad_s * time_of(i)));
    return -s * kPhi_rad * ((0.2 - kMu) * std::exp(-speed / 0.01) + 0.5 * speed);
  });
}

TEST(SynthFriction, PreslidingGrowsWithTheTravelSinceAReversal) {
  const Channels channels = session(kRecordings + "[effects.presliding]\nlength_mm = 2\n");
  // The first reversal is the start, after letting go; dz/dx = (1 - z s) / x0.
  expect_residuals(channels, 1e-8, [](std::size_t i, double s) {
    const double from_m = s > 0 ? -kStroke_m : kStroke_m;
    const double z = s * (1 - 2 * std::exp(-std::abs(position_m(i) - from_m) / 0.002));
    return kFull * (s - z);
  });
}

TEST(SynthFriction, LoadDependenceIsIntegratedAlongTheSheath) {
  const Channels channels =
      session(kRecordings + "[effects.friction_load]\nexponent = 0.3\nreference_N = 25\n");
  // dT/dphi = mu T0^k T^(1-k) s: T^k grows linearly along the angle.
  for (std::size_t i = 1; i < 800; ++i) {
    const double s = channels[kTendonVelocity][i] > 0 ? 1 : -1;
    if (std::abs(channels[kTendonVelocity][i]) < 1e-9) {
      continue;
    }
    const double power =
        std::pow(channels[kOutputTensionColumn][i], 0.3) + 0.3 * kFull * std::pow(25, 0.3) * s;
    ASSERT_NEAR(channels[kInputTensionColumn][i], std::pow(power, 1 / 0.3), 1e-3) << i;
  }
}

TEST(SynthFriction, NoLoadDependenceIsTheCapstanLaw) {
  const Channels channels =
      session(kRecordings + "[effects.friction_load]\nexponent = 0\nreference_N = 25\n");
  expect_residuals(channels, 1e-12, [](std::size_t, double) { return 0.0; });
}

TEST(SynthFriction, PreloadIsAForceAgainstTheMotion) {
  const Channels with = session(kRecordings + "[effects.friction_preload]\nforce_N = 3\n");
  const Channels without = session(kRecordings);
  const std::vector<double> s = directions(with);
  for (std::size_t i = 0; i < s.size(); ++i) {
    ASSERT_NEAR(with[kInputTensionColumn][i] - without[kInputTensionColumn][i], 3 * s[i], 1e-11);
  }
}

TEST(SynthFriction, ATendonDoesNotPush) {
  const Channels channels = session(kRecordings + "[effects.friction_preload]\nforce_N = 20\n");
  EXPECT_EQ(
      *std::min_element(channels[kInputTensionColumn].begin(), channels[kInputTensionColumn].end()),
      0.0);
}

TEST(SynthFriction, ATightPlaceIsPassedAtItsPosition) {
  const Channels channels = session(
      kRecordings + "[effects.friction_position]\nchange = 0.4\ncentre_mm = 5\nwidth_mm = 3\n");
  expect_residuals(channels, 1e-12, [](std::size_t i, double s) {
    const double from = (position_m(i) - 0.005) / 0.003;
    return -kFull * s * 0.4 * std::exp(-from * from / 2);
  });
}

TEST(SynthFriction, SlackIsTakenUpAfterEachReversal) {
  const Channels channels =
      session(kRecordings + "[effects.slack]\ndead_zone_mm = 1.5\nheld_share = 0.8\n");
  std::size_t loose = 0;
  expect_residuals(channels, 1e-12, [&](std::size_t i, double s) {
    const double from_m = s > 0 ? -kStroke_m : kStroke_m;
    const double travel_m = std::abs(position_m(i) - from_m);
    const bool in_gap = travel_m > 1e-12 && travel_m < 0.0015;
    loose += in_gap ? 1 : 0;
    return in_gap ? -std::log(0.8) : 0.0;
  });
  // 1.5 mm of the cosine's first: acos(1 - 1.5 / 20) / pi s = 24.7 samples after each of 4.
  EXPECT_NEAR(static_cast<double>(loose), 4 * 24.7, 4);
}

TEST(SynthFriction, AStretchedTendonFollowsItsSpringUntilItSlides) {
  const Channels channels = session(kRecordings + "[effects.compliance]\nstiffness_N_mm = 4\n");
  const double low_N = 20 * std::exp(-kFull);
  bool slides = false;
  for (std::size_t i = 0; i < 200; ++i) {
    const double stretched_N = low_N + 4000 * (position_m(i) + kStroke_m);
    const double sliding_N = channels[kOutputTensionColumn][i] * std::exp(kFull);
    slides = slides || stretched_N > sliding_N;
    ASSERT_NEAR(channels[kInputTensionColumn][i], slides ? sliding_N : stretched_N, 1e-6) << i;
  }
  EXPECT_TRUE(slides);
}

TEST(SynthFriction, AStiffTendonIsTheCapstanLaw) {
  const Channels channels =
      session(kRecordings + "[effects.compliance]\nstiffness_N_mm = 100000\n");
  const std::vector<double> r = residuals(channels);
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (i % 200 > 2) {
      ASSERT_NEAR(r[i], 0, 1e-9) << i;
    }
  }
}

TEST(SynthFriction, SpringAndPreslidingActInSeries) {
  const Channels channels =
      session(kRecordings +
              "[effects.compliance]\nstiffness_N_mm = 8\n[effects.presliding]\nlength_mm = 2\n");
  // Travel is stretch and slide; the slide gives the state, the state the tension.
  const double low_N = 20 * std::exp(-kFull);
  for (std::size_t i = 1; i < 200; ++i) {
    const double tension_N = channels[kInputTensionColumn][i];
    const double slide_m = position_m(i) + kStroke_m - (tension_N - low_N) / 8000;
    const double z = 1 - 2 * std::exp(-slide_m / 0.002);
    ASSERT_NEAR(tension_N, channels[kOutputTensionColumn][i] * std::exp(kFull * z), 0.02) << i;
  }
}

}  // namespace

}  // namespace host_sim::synth::test
