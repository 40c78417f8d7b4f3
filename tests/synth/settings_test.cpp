#include <map>

#include "tests/synth/support.hpp"

namespace host_sim::synth::test {
namespace {

std::string recordings(const std::string& design) {
  return "[recordings]\nsample_rate_Hz = 200\nduration_s = 4\ntravels_mm = 40\n" + design;
}

std::vector<Setting> settings(const std::string& design, std::uint64_t seed = 1) {
  return settings_of(*plan_of(recordings(design)).recordings, seed);
}

TEST(SynthSettings, CrossedIsEachWithEach) {
  const auto all = settings(
      "bend_angles_deg = [90, 270]\noutput_means_N = [30]\noutput_amplitudes_N = 10\n"
      "frequencies_Hz = [0.5, 1, 2]\nrepeats = 2\n");
  ASSERT_EQ(all.size(), 12U);
  const std::vector<std::pair<double, double>> expected{{90, 0.5},  {90, 1},  {90, 2},
                                                        {270, 0.5}, {270, 1}, {270, 2}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].number, i);
    EXPECT_EQ(all[i].bend_angle_deg, expected[i % 6].first);
    EXPECT_EQ(all[i].frequency_Hz, expected[i % 6].second);
    EXPECT_EQ(all[i].pose, i % 6 / 3);
    EXPECT_EQ(all[i].travel_mm, 40);
    EXPECT_EQ(all[i].sheath_ambient_C, 20);
  }
}

TEST(SynthSettings, ListedGoesDownTheLists) {
  const auto all = settings(
      "design = \"listed\"\nbend_angles_deg = [90, 270]\noutput_means_N = [30, 40]\n"
      "output_amplitudes_N = [10, 35]\nfrequencies_Hz = 0.5\nstart_cycles = [7, 8]\n");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].bend_angle_deg, 90);
  EXPECT_EQ(all[0].output_mean_N, 30);
  EXPECT_EQ(all[0].start_cycle, 7);
  EXPECT_EQ(all[1].bend_angle_deg, 270);
  EXPECT_EQ(all[1].output_amplitude_N, 35);
  EXPECT_EQ(all[1].start_cycle, 8);
  EXPECT_EQ(all[1].frequency_Hz, 0.5);
}

TEST(SynthSettings, BalancedHasEachValueEquallyOftenAndShuffled) {
  const std::string design =
      "design = \"balanced\"\nsessions = 36\nbend_angles_deg = [90, 180, 270]\n"
      "output_means_N = [30, 40]\noutput_amplitudes_N = 10\nfrequencies_Hz = [0.5, 1, 2, 3]\n";
  const auto all = settings(design, 5);
  ASSERT_EQ(all.size(), 36U);
  std::map<double, int> poses, means, frequencies;
  std::map<std::pair<double, double>, int> pairs;
  for (const Setting& setting : all) {
    ++poses[setting.bend_angle_deg];
    ++means[setting.output_mean_N];
    ++frequencies[setting.frequency_Hz];
    ++pairs[{setting.bend_angle_deg, setting.frequency_Hz}];
  }
  EXPECT_EQ(poses, (std::map<double, int>{{90, 12}, {180, 12}, {270, 12}}));
  EXPECT_EQ(means, (std::map<double, int>{{30, 18}, {40, 18}}));
  EXPECT_EQ(frequencies, (std::map<double, int>{{0.5, 9}, {1, 9}, {2, 9}, {3, 9}}));
  EXPECT_GT(pairs.size(), 8U);
  const auto other = settings(design, 6);
  bool same = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    same = same && all[i].bend_angle_deg == other[i].bend_angle_deg;
  }
  EXPECT_FALSE(same);
}

}  // namespace
}  // namespace host_sim::synth::test
