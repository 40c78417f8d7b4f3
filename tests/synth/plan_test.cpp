#include <map>

#include "tests/synth/support.hpp"

namespace host_sim::synth::test {
namespace {

std::string complaint(const std::string& text) {
  return complaint_of([&] { plan_of(text); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

const std::string kLevel =
    "[lives]\n[[lives.level]]\nbend_angle_deg = 90\noutput_tension_mean_N = 30\n"
    "output_tension_amplitude_N = 20\nspecimens = 3\n";

struct Bad {
  std::string text;
  std::string complaint;  ///< a part of it
};

void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.complaint;
}

class BadSynthPlan : public testing::TestWithParam<Bad> {};

TEST_P(BadSynthPlan, IsRefusedWithItsPlace) {
  const std::string found = complaint(GetParam().text);
  EXPECT_NE(found.find(GetParam().complaint), std::string::npos) << "it says: " << found;
  EXPECT_EQ(found.rfind("plan:", 0), 0U) << found;
}

const Bad kBad[]{
    {"", "neither recordings nor lives"},
    {"[recording]\n", "unknown table 'recording'"},
    {kRecordings + "speed = 3\n", "unknown key 'speed' in [recordings]"},
    {kRecordings + "start_cycles = [1, -2]\n", "start_cycles holds -2"},
    {kRecordings + "start_cycles = []\n", "start_cycles has 0 numbers"},
    {kRecordings + "repeats = 1.5\n", "repeats is 1.5; accepted: a whole number"},
    {replaced(kRecordings, "travels_mm = 40.0", "travels_m = 0.04"), "unknown unit 'm' of key"},
    {replaced(kRecordings, "travels_mm = 40.0\n", ""), "no key travels_mm"},
    {replaced(kRecordings, "270.0", "\"90\""), "bend_angles_deg is '90'"},
    {replaced(kRecordings, "= 30.0", "= [30.0, 9.0]"), "an amplitude of 10 N with a mean of 9 N"},
    {replaced(kRecordings, "= 30.0", "= nan"), "output_means_N is nan"},
    {kRecordings + "design = \"random\"\n",
     "design is 'random'; accepted: design as one of crossed, listed, balanced"},
    {kRecordings + "design = \"balanced\"\n", "a balanced design without sessions"},
    {kRecordings + "sessions = 4\n", "sessions beside a design that is not balanced"},
    {kRecordings + "design = \"listed\"\nstart_cycles = [1, 2]\nsheath_ambients_C = [1, 2, 3]\n",
     "2 values of start_cycles; accepted: 1 or 3"},
    {kRecordings + "repeats = 1000\nstart_cycles = [1,2,3,4,5,6,7,8,9,10,11]\n",
     "11000 or more sessions"},
    {replaced(kRecordings, "duration_s = 4.0", "duration_s = 0.01"), "2 samples a session"},
    {replaced(kRecordings, "frequencies_Hz = 0.5", "frequencies_Hz = 40") +
         "load_frequency_ratio = 3\n",
     "40 Hz at 200 samples a second"},
    {kRecordings + "pose_sway_deg = 180\nbend_angles_deg2 = 1\n", "unknown unit 'deg2' of key"},
    {replaced(kRecordings, "270.0", "[270.0, 3.0]") + "pose_sway_deg = 4\n",
     "a sway of 4 deg about 3 deg"},
    {kRecordings + "channels = [\"output_tension_N\", \"tendon_velocity_m_s\"]\n",
     "channels that show no friction"},
    {kRecordings + "channels = [\"output_tension\"]\n", "channels holds 'output_tension'"},
    {kRecordings + "channels = [\"output_tension_N\", \"output_tension_N\"]\n", "twice"},
    {kRecordings + "channels = [\"time_s\"]\n", "channels holds 'time_s'"},
    {kRecordings + "[noise]\nar1 = 1\n", "ar1 is 1"},
    {kRecordings + "[noise]\nstudent_t_dof = 2\n", "student_t_dof is 2"},
    {kRecordings + "[noise]\nclock_jitter_s = 0.01\n", "clock_jitter_s is 0.01"},
    {kRecordings + "[noise]\njitter_s = 0.01\n", "jitter_s is 0.01"},
    {kRecordings + "[noise]\ninput_absolute = 0.01\n", "key 'input_absolute' without its unit"},
    {kRecordings + "[noise]\noutput_relative_sd = -1\n", "output_relative_sd is -1"},
    {kRecordings + "[scatter]\ngain_sd = 0.1\n", "unknown key 'gain_sd' in [scatter]"},
    {kRecordings + "[thermal]\nroom_K = 293\n", "unknown unit 'K' of key 'room_K'"},
    {kRecordings + "[effects.friction]\n", "unknown table 'friction' in [effects]"},
    {kRecordings + "[effects]\nslack = 3\n", "slack is 3"},
    {kRecordings + "[effects.slack]\ndead_zone_mm = 1\n", "no key held_share in [effects.slack]"},
    {kRecordings + "[effects.slack]\ndead_zone_mm = 1\nheld_share = 1\n", "held_share is 1"},
    {kRecordings + "[effects.sheath_creep]\nshare = 0.1\n", "unknown table 'sheath_creep'"},
    {kRecordings + "[outside.slack]\ndead_zone_mm = 1\n", "unknown table 'slack' in [outside]"},
    {kRecordings + "[effects.filter_lag]\ntime_constant_ms = 5\nsensor = \"input\"\n",
     "sensor is 'input'"},
    {kRecordings + "[effects.lot_frailty]\nlog_sd = 0.1\n",
     "[effects.lot_frailty] without [lives]"},
    {kLevel + "[effects.friction_preload]\nforce_N = 3\n",
     "[effects.friction_preload] without [recordings]"},
    {kRecordings + "[outside.load_cell_cross_talk]\nsensitivity_N_s_rad = 2\n",
     "without pose_sway_deg"},
    {kLevel + "[outside.rig_bias]\nshare = 0.1\n", "without rigs above 1"},
    {kLevel + "[effects.bending_fatigue]\nmetal_area_mm2 = 0.1\nshare = 0.5\n",
     "without wire_to_bend_ratio"},
    {"[lives]\nlots = 2\n", "no specimens"},
    {"[lives]\nlevel = 3\n", "level is 3"},
    {"[lives]\nlevel = [3]\n", "level holds 3"},
    {replaced(kLevel, "= 20\n", "= 31\n"), "a level of 30 +- 31 N at 90 deg"},
    {replaced(kLevel, "= 90\n", "= 900\n"), "an input tension below the ultimate one"},
    {kLevel + "[[lives.program]]\nlevels = [1, 2]\ncycles = [9]\nspecimens = 1\n",
     "levels holds 2"},
    {kLevel + "[[lives.program]]\nlevels = [1, 1]\ncycles = [9, 9]\nspecimens = 1\n",
     "2 levels with 2 numbers of cycles"},
    {kLevel + "[[lives.program]]\nlevels = [1, 1]\ncycles = 9\n", "no key specimens"},
    {kLevel + "[[lives.program]]\nlevels = [1, 1]\ncycles = 9.5\nspecimens = 1\n",
     "cycles holds 9.5; accepted: whole numbers, 1..1000000000000000"},
    {kLevel + "suspend_at_cycles = 100.5\n",
     "suspend_at_cycles is 100.5; accepted: a whole number, 1..1000000000000000"},
    {kLevel + "role = \"test\"\n", "role is 'test'"},
    {kLevel + "specimens = 1\n", "plan:"},
};

INSTANTIATE_TEST_SUITE_P(All, BadSynthPlan, testing::ValuesIn(kBad));

TEST(SynthPlan, SaysWhereAKeyStands) {
  const std::string found =
      complaint_of([] { parse_synth_plan("[campaign]\nname = \"x\"\n  nme = 3\n", "p.toml"); });
  EXPECT_EQ(found.rfind("p.toml:3:3: unknown key 'nme' in [campaign]", 0), 0U) << found;
}

TEST(SynthPlan, NeedsTheModelThatItsPartsUse) {
  const std::string head =
      "[campaign]\nname = \"x\"\n[model.cable]\ndiameter_mm = 0.4\n"
      "ultimate_tension_N = 100\n";
  EXPECT_NE(complaint_of([&] {
              parse_synth_plan(head + kRecordings, "p");
            }).find("no table [model.sheath]"),
            std::string::npos);
  const std::string sheath = "[model.sheath]\nfriction_coefficient = 0.1\nbend_angle_deg = 90\n";
  EXPECT_NE(complaint_of([&] {
              parse_synth_plan(head + sheath + kLevel, "p");
            }).find("no table [model.life]"),
            std::string::npos);
  EXPECT_NE(complaint_of([&] {
              parse_synth_plan(
                  head + sheath + kRecordings + "[effects.current_offset]\noffset_A = 0.1\n", "p");
            }).find("without [model.drive]"),
            std::string::npos);
  EXPECT_EQ(complaint_of([&] { parse_synth_plan(head + sheath + kRecordings, "p"); }), "");
}

TEST(SynthPlan, NoiseOfBothEndsStandsWhereAnEndHasNoneOfItsOwn) {
  const Noise noise = plan_of(kRecordings +
                              "[noise]\nlog_tension_sd = 0.01\nar1 = 0.5\n"
                              "input_relative_sd = 0.02\noutput_ar1 = 0.0\n"
                              "output_absolute_N = 0.1\ninput_absolute_N = 0.2\n"
                              "input_absolute_A = 0.3\njitter_s = 0.001\n")
                          .noise;
  EXPECT_EQ(noise.output.relative_sd, 0.01);
  EXPECT_EQ(noise.output.absolute_N, 0.1);
  EXPECT_EQ(noise.output.ar1, 0);
  EXPECT_EQ(noise.input.relative_sd, 0.02);
  EXPECT_EQ(noise.input.absolute_N, 0.2);
  EXPECT_EQ(noise.input.absolute_A, 0.3);
  EXPECT_EQ(noise.input.ar1, 0.5);
  EXPECT_EQ(noise.jitter_s, 0.001);
}

TEST(SynthPlan, ReadsWhatIsHiddenInTheOrderOfTheCatalogue) {
  const SynthPlan plan = plan_of(kRecordings +
                                 "[outside.sheath_creep]\nshare = 0.05\ntime_constant_s = 3\n"
                                 "[effects.slack]\ndead_zone_mm = 1\nheld_share = 0.5\n"
                                 "[effects.bend_angle]\nerror_deg = [1, 2]\n");
  ASSERT_EQ(plan.departures.size(), 3U);
  EXPECT_EQ(plan.departures[0].id, "slack");
  EXPECT_EQ(plan.departures[0].values["held_share"], 0.5);
  EXPECT_EQ(plan.departures[1].id, "bend_angle");
  EXPECT_EQ(plan.departures[1].values.list("error_deg"), (std::vector<double>{1, 2}));
  EXPECT_EQ(plan.departures[1].values["sd_deg"], 0);
  EXPECT_EQ(plan.departures[2].id, "sheath_creep");
  EXPECT_TRUE(plan.departures[2].outside);
}

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
