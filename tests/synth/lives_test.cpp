#include "host_sim/synth/campaign/lives.hpp"

#include <functional>
#include <map>
#include <set>

#include "host_sim/campaign/campaign_files.hpp"
#include "host_sim/synth/campaign/make.hpp"
#include "host_sim/synth/life_departures.hpp"
#include "host_sim/synth/specimen.hpp"
#include "tests/synth/support.hpp"

namespace host_sim::synth::test {

using hal::files::memory_source;

namespace {

using OneLife = std::vector<std::unique_ptr<LifePart>>;

/// Straight sheath, so that input is output tension; life 1e6 / T_eff^2.
constexpr LifeModel kModelOfLife{{0.457, 200.0}, 0.128, {Model::MeanStress::kGerber, 1e6, 2, 3}};

constexpr LifeLoad kLoad{.output_mean_N = 50, .output_amplitude_N = 30, .frequency_Hz = 1};

OneLife part(std::string_view id, const std::function<void(Values&)>& fill) {
  Values values;
  fill(values);
  OneLife parts;
  for (const auto kinds : {life_kinds(), outside_life_kinds()}) {
    for (const LifeKind& kind : kinds) {
      if (kind.id == id) {
        parts.push_back(kind.make(values));
        parts.back()->begin({}, 1);
      }
    }
  }
  EXPECT_EQ(parts.size(), 1U) << id;
  return parts;
}

/// Fully reversed loads, where T_eff is the amplitude.
LifeLoad reversed(double amplitude_N, double frequency_Hz = 1) {
  return {.output_mean_N = 0, .output_amplitude_N = amplitude_N, .frequency_Hz = frequency_Hz};
}

TEST(SynthLife, GerberAndTheCapstanLaw) {
  // 30 / (1 - (50 / 200)^2) = 32.
  EXPECT_NEAR(effective_tension_N(kModelOfLife, kLoad, {}), 32, 1e-12);
  LifeLoad bent = kLoad;
  bent.bend_angle_deg = 180;
  const double eta = std::exp(-0.128 * std::numbers::pi);
  const double high_N = 80 / eta;
  const double low_N = 20 * eta;
  const double mean_N = (high_N + low_N) / 2;
  EXPECT_NEAR(effective_tension_N(kModelOfLife, bent, {}),
              (high_N - low_N) / 2 / (1 - mean_N * mean_N / 4e4), 1e-9);
}

TEST(SynthLife, FailsAtItsLifeOrIsSuspendedBefore) {
  // 1e6 / 100^2 = 100 cycles, times 1.5.
  const std::vector<LifeStep> steps{{reversed(100), 1000}};
  const LifeResult failed = run_specimen(kModelOfLife, steps, 1.5, 2, {});
  EXPECT_TRUE(failed.failed);
  EXPECT_EQ(failed.cycles, std::vector<double>{150});
  EXPECT_NEAR(failed.days, 2 + 150 / 86400.0, 1e-12);
  const std::vector<LifeStep> short_steps{{reversed(100), 149}};
  const LifeResult suspended = run_specimen(kModelOfLife, short_steps, 1.5, 0, {});
  EXPECT_FALSE(suspended.failed);
  EXPECT_EQ(suspended.cycles, std::vector<double>{149});
}

double effective_with(const OneLife& parts) {
  return effective_tension_N(kModelOfLife, kLoad, parts);
}

OneLife mean_stress(std::string_view law, double walker = 0.65) {
  return part("mean_stress", [&](Values& values) {
    values.choose("law", law);
    values.set("walker_exponent", {walker});
  });
}

TEST(SynthLife, LawsOfMeanStress) {
  EXPECT_NEAR(effective_with(mean_stress("goodman")), 30 / (1 - 0.25), 1e-12);
  EXPECT_NEAR(effective_with(mean_stress("swt")), std::sqrt(80.0 * 30), 1e-12);
  EXPECT_NEAR(effective_with(mean_stress("walker", 0.5)), std::sqrt(80.0 * 30), 1e-12);
  EXPECT_NEAR(effective_with(mean_stress("walker", 1)), 30, 1e-12);
  EXPECT_NEAR(effective_with(mean_stress("walker", 0)), 80, 1e-12);
}

TEST(SynthLife, BendingAddsAPulsatingTension) {
  const OneLife parts = part("bending_fatigue", [](Values& values) {
    values.set("modulus_GPa", {200});
    values.set("metal_area_mm2", {0.1});
    values.set("share", {0.05});
  });
  EXPECT_NEAR(effective_with(parts), 32, 1e-12) << "no bend ratio, no bending";
  LifeLoad bent = kLoad;
  bent.wire_to_bend_ratio = 0.02;
  // 0.05 * 200,000 N/mm2 * 0.1 mm2 * 0.02 = 20 N: 60 +- 40 N.
  EXPECT_NEAR(effective_tension_N(kModelOfLife, bent, parts), 40 / (1 - 0.09), 1e-12);
}

OneLife endurance(double limit_N, double log_sd) {
  return part("endurance_limit", [&](Values& values) {
    values.set("limit_N", {limit_N});
    values.set("log_sd", {log_sd});
  });
}

TEST(SynthLife, BelowTheEnduranceLimitNothingFails) {
  const OneLife parts = endurance(50, 0);
  const std::vector<LifeStep> above{{reversed(60), 1e6}};
  EXPECT_EQ(run_specimen(kModelOfLife, above, 1, 0, parts).cycles.front(), 10'000);
  const std::vector<LifeStep> at{{reversed(50), 1e6}};
  const LifeResult result = run_specimen(kModelOfLife, at, 1, 0, parts);
  EXPECT_FALSE(result.failed);
  EXPECT_EQ(result.cycles.front(), 1e6);
}

TEST(SynthLife, EachSpecimenHasItsOwnEnduranceLimit) {
  const OneLife parts = endurance(50, 0.1);
  double sum = 0;
  double squares = 0;
  constexpr std::size_t kSpecimens = 4000;
  for (std::size_t i = 0; i < kSpecimens; ++i) {
    parts.front()->begin({.number = i}, 1);
    const double deviation = std::log((100 - parts.front()->damaging_tension_N(100)) / 50);
    sum += deviation;
    squares += deviation * deviation;
  }
  EXPECT_NEAR(sum / kSpecimens, 0, 5 * 0.1 / std::sqrt(kSpecimens));
  EXPECT_NEAR(std::sqrt(squares / kSpecimens), 0.1, 5 * 0.1 / std::sqrt(2.0 * kSpecimens));
}

/// Half of the life of 1000 cycles, then on at a load with 100.
std::vector<LifeStep> low_high() {
  return {{reversed(std::sqrt(1000)), 500}, {reversed(100), 1e6}};
}

TEST(SynthLife, MinersRuleAddsShares) {
  EXPECT_EQ(run_specimen(kModelOfLife, low_high(), 1, 0, {}).cycles,
            (std::vector<double>{500, 50}));
}

TEST(SynthLife, TheSequenceCountsByMansonAndHalford) {
  const OneLife parts =
      part("load_sequence", [](Values& values) { values.set("exponent", {0.4}); });
  // 1 - 0.5^(10^0.4) = 0.8247; from high to low 1 - 0.5^(0.1^0.4) = 0.2411.
  EXPECT_EQ(run_specimen(kModelOfLife, low_high(), 1, 0, parts).cycles,
            (std::vector<double>{500, 82}));
  const std::vector<LifeStep> high_low{{reversed(100), 50}, {reversed(std::sqrt(1000)), 1e6}};
  EXPECT_EQ(run_specimen(kModelOfLife, high_low, 1, 0, parts).cycles,
            (std::vector<double>{50, 241}));
}

TEST(SynthLife, TheModeThatComesFirstDecides) {
  const OneLife parts = part("second_mode", [](Values& values) {
    values.set("life_cycles", {150});
    values.set("reference_N", {100});
    values.set("exponent", {8});
    values.set("shape", {50});
  });
  const double at_100 = parts.front()->other_life_cycles(100);
  EXPECT_NEAR(at_100, 150, 30);
  EXPECT_NEAR(parts.front()->other_life_cycles(200), at_100 / 256, 1e-9);
  const std::vector<LifeStep> strong{{reversed(100), 1e6}};
  EXPECT_EQ(run_specimen(kModelOfLife, strong, 10, 0, parts).cycles.front(), std::round(at_100));
  EXPECT_EQ(run_specimen(kModelOfLife, strong, 0.5, 0, parts).cycles.front(), 50);
}

TEST(SynthLife, ALotSharesItsFrailty) {
  const OneLife parts = part("lot_frailty", [](Values& values) { values.set("log_sd", {0.3}); });
  double squares = 0;
  constexpr std::size_t kLots = 4000;
  for (std::size_t lot = 0; lot < kLots; ++lot) {
    parts.front()->begin({.number = 1, .lot = lot}, 1);
    const double factor = parts.front()->life_factor();
    parts.front()->begin({.number = 2, .lot = lot}, 1);
    ASSERT_EQ(parts.front()->life_factor(), factor);
    squares += std::log(factor) * std::log(factor);
  }
  EXPECT_NEAR(std::sqrt(squares / kLots), 0.3, 5 * 0.3 / std::sqrt(2.0 * kLots));
}

TEST(SynthLife, AgeingIsTheIntegralOverTheDays) {
  const Calendar calendar{0.1, 10, 2};
  EXPECT_NEAR(calendar.days_of(172'800), 1, 1e-12);
  // From day 10 to day 15 at 172,800 cycles a day.
  EXPECT_NEAR(calendar.aged_cycles(5 * 172'800), 172'800 * (std::exp(1.5) - std::exp(1)) / 0.1,
              1e-3);
  EXPECT_NEAR(calendar.cycles_for(calendar.aged_cycles(12'345)), 12'345, 1e-6);
  EXPECT_EQ((Calendar{0, 10, 2}.aged_cycles(7)), 7);
}

TEST(SynthLife, ASpecimenAgesInStoreAndUnderTest) {
  const OneLife parts = part("ageing", [](Values& values) { values.set("rate_1_day", {0.1}); });
  // 1e6 cycles of life at 1 cycle in 86.4 s, 1000 a day: e^(0.1 d) - 1 = 100.
  const std::vector<LifeStep> steps{{reversed(1, 1 / 86.4), 1e12}};
  const LifeResult fresh = run_specimen(kModelOfLife, steps, 1, 0, parts);
  EXPECT_NEAR(fresh.cycles.front(), 1000 * std::log(101) / 0.1, 1);
  const LifeResult stored = run_specimen(kModelOfLife, steps, 1, 20, parts);
  EXPECT_NEAR(stored.cycles.front(), 1000 * std::log(1 + 100 * std::exp(-2)) / 0.1, 1);
  EXPECT_NEAR(stored.days, 20 + stored.cycles.front() / 1000, 1e-6);
}

TEST(SynthLife, EverySecondRigPullsHarder) {
  const OneLife parts = part("rig_bias", [](Values& values) { values.set("share", {0.1}); });
  EXPECT_NEAR(effective_with(parts), 32, 1e-12);
  parts.front()->begin({.rig = 1}, 1);
  EXPECT_NEAR(effective_with(parts), 33 / (1 - 0.275 * 0.275), 1e-12);
}

TEST(SynthLife, AShareDiesEarly) {
  const OneLife parts = part("early_deaths", [](Values& values) {
    values.set("share", {0.2});
    values.set("life_left", {0.05});
  });
  std::size_t early = 0;
  for (std::size_t i = 0; i < 4000; ++i) {
    parts.front()->begin({.number = i}, 1);
    const double factor = parts.front()->life_factor();
    ASSERT_TRUE(factor == 1 || factor == 0.05);
    early += factor < 1 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(early), 800, 5 * std::sqrt(4000 * 0.16));
}

const std::string kLives = R"(
[lives]
lots = 3
[[lives.level]]
bend_angle_deg = 0
output_tension_mean_N = 30
output_tension_amplitude_N = 30
specimens = 2000
[[lives.level]]
bend_angle_deg = 90
output_tension_mean_N = 40
output_tension_amplitude_N = 20
specimens = 6
role = "validation"
suspend_at_cycles = 10
)";

Campaign campaign_of(const SynthPlan& plan, const LifeTexts& texts) {
  std::vector<BlockRow> blocks;
  if (!texts.blocks.empty()) {
    blocks = parse_blocks(memory_source(texts.blocks), "blocks.csv");
  }
  return assemble(parse_campaign_file(campaign_text(plan), "campaign.toml"),
                  parse_specimens(memory_source(texts.specimens), "specimens.csv"), blocks);
}

TEST(SynthLives, LivesAreThoseOfTheWeibullLaw) {
  const auto specimens = run_lives(plan_of(kLives), 1);
  // T_eff = 30 / (1 - (30 / 177.4)^2) = 30.883; 1.53e5 / T^1.38 = 1346; 63.2 % fail before.
  constexpr double kScale = 1346;
  std::size_t before = 0;
  double sum = 0;
  for (std::size_t i = 0; i < 2000; ++i) {
    ASSERT_TRUE(specimens[i].result.failed);
    const double cycles = specimens[i].result.cycles.front();
    before += cycles < kScale ? 1 : 0;
    sum += std::log(cycles / kScale);
  }
  EXPECT_NEAR(static_cast<double>(before) / 2000, 0.632, 5 * std::sqrt(0.632 * 0.368 / 2000));
  // Mean of ln: -0.5772 / beta, sd 1.283 / beta.
  EXPECT_NEAR(sum / 2000, -0.5772 / 5.94, 5 * 1.283 / 5.94 / std::sqrt(2000));
}

TEST(SynthLives, TheFilesAreACampaign) {
  const SynthPlan plan = plan_of(kLives);
  const Campaign campaign = campaign_of(plan, life_texts(plan, 1));
  ASSERT_EQ(campaign.specimens.size(), 2006U);
  EXPECT_EQ(campaign.name, "small");
  const auto& last = campaign.specimens.back();
  EXPECT_EQ(last.status, Campaign::Status::suspended);
  EXPECT_EQ(last.role, Campaign::Role::validation);
  EXPECT_EQ(last.cycles(), 10);
  EXPECT_EQ(last.blocks.front().load.bend_angle_deg, 90);
  EXPECT_EQ(last.lot, "lot3");
  EXPECT_FALSE(last.days);
}

const std::string kSeenOtherwise = R"(
[lives]
[[lives.level]]
bend_angle_deg = 0
output_tension_mean_N = 30
output_tension_amplitude_N = 30
specimens = 40
inspect_every_cycles = 300
[[lives.level]]
bend_angle_deg = 90
output_tension_mean_N = 40
output_tension_amplitude_N = 20
specimens = 12
trim_low = 1
trim_high = 2
)";

TEST(SynthLives, AreInspectedAndTrimmedAsPlanned) {
  const SynthPlan plan = plan_of(kSeenOtherwise);
  const Campaign campaign = campaign_of(plan, life_texts(plan, 1));
  const auto lives = run_lives(plan, 1);
  using Status = Campaign::Status;
  std::map<Status, int> count;
  double lowest = HUGE_VAL;
  double highest = 0;
  for (std::size_t i = 0; i < lives.size(); ++i) {
    const Campaign::Specimen& specimen = campaign.specimens[i];
    const double life = lives[i].result.cycles.front();
    ++count[specimen.status];
    if (i < 40) {
      EXPECT_LE(life, specimen.cycles());
      EXPECT_GT(life, specimen.from_cycles);
      EXPECT_EQ(specimen.cycles() - specimen.from_cycles, 300);
      EXPECT_EQ(specimen.status == Status::left, life <= 300);
    } else if (specimen.status == Status::failed) {
      lowest = std::min(lowest, life);
      highest = std::max(highest, life);
    }
  }
  EXPECT_EQ(count[Status::trimmed_low], 1);
  EXPECT_EQ(count[Status::trimmed_high], 2);
  EXPECT_EQ(count[Status::failed], 9);
  for (std::size_t i = 40; i < lives.size(); ++i) {
    const double life = lives[i].result.cycles.front();
    const Status status = campaign.specimens[i].status;
    EXPECT_TRUE(status != Status::trimmed_low || life <= lowest);
    EXPECT_TRUE(status != Status::trimmed_high || life >= highest);
  }
}

TEST(SynthLives, WhatCannotBeTrimmedIsRefused) {
  const auto complaint = [](std::string_view from, std::string_view to) {
    std::string text = kSeenOtherwise;
    text.replace(text.find(from), from.size(), to);
    return complaint_of([&] { plan_of(text); });
  };
  EXPECT_NE(complaint("trim_low = 1", "trim_low = 10").find("12 of 12 specimens are dropped"),
            std::string::npos);
  EXPECT_NE(complaint("trim_low = 1", "trim_low = 1\nsuspend_at_cycles = 500")
                .find("trim_low beside suspend_at_cycles"),
            std::string::npos);
  EXPECT_NE(complaint("trim_low = 1", "inspect_every_cycles = 50")
                .find("trim_high beside inspect_every_cycles"),
            std::string::npos);
}

TEST(SynthLives, ProgramsGoFromLevelToLevel) {
  const SynthPlan plan =
      plan_of(kLives + "[[lives.program]]\nlevels = [1, 2]\ncycles = [100]\nspecimens = 4\n");
  const Campaign campaign = campaign_of(plan, life_texts(plan, 1));
  const auto& last = campaign.specimens.back();
  ASSERT_EQ(last.blocks.size(), 2U);
  EXPECT_EQ(last.blocks[0].cycles, 100);
  EXPECT_EQ(last.blocks[1].cycles, 10);
  EXPECT_EQ(last.blocks[1].load.bend_angle_deg, 90);
}

TEST(SynthLives, LotsAreCrossedWithLevelsOrNested) {
  const auto pairs = [](const std::string& text) {
    std::set<std::pair<std::size_t, std::size_t>> found;
    for (const LifeSpecimen& specimen : run_lives(plan_of(text), 1)) {
      found.emplace(specimen.levels.front(), specimen.place.lot);
    }
    return found.size();
  };
  EXPECT_EQ(pairs(kLives), 6U);
  std::string nested = kLives;
  nested.replace(nested.find("lots = 3"), 8, "lots = 3\nlots_by = \"level\"");
  EXPECT_EQ(pairs(nested), 2U);
}

TEST(SynthLives, RigsAreCrossedWithLots) {
  std::string text = kLives;
  text.replace(text.find("lots = 3"), 8, "lots = 3\nrigs = 2");
  std::map<std::pair<std::size_t, std::size_t>, int> count;
  for (const LifeSpecimen& specimen : run_lives(plan_of(text), 1)) {
    ++count[{specimen.place.lot, specimen.place.rig}];
  }
  EXPECT_EQ(count.size(), 6U);
  const LifeTexts texts = life_texts(plan_of(text), 1);
  EXPECT_NE(texts.specimens.find(",rig2\n"), std::string::npos);
}

TEST(SynthLives, RecordsWhatIsAskedFor) {
  std::string text = kLives;
  text.replace(text.find("lots = 3"), 8, "storage_days = [5, 9]\nrecord_days = true");
  text.replace(text.find("bend_angle_deg = 0"), 18,
               "bend_angle_deg = 0\nwire_to_bend_ratio = 0.04");
  const SynthPlan plan = plan_of(text);
  const Campaign campaign = campaign_of(plan, life_texts(plan, 1));
  EXPECT_GE(*campaign.specimens[0].days, 5);
  EXPECT_LT(*campaign.specimens[0].days, 5.1);
  EXPECT_GE(*campaign.specimens[1].days, 9);
  EXPECT_EQ(campaign.specimens[0].wire_to_bend_ratio, 0.04);
  EXPECT_FALSE(campaign.specimens.back().wire_to_bend_ratio);
}

TEST(SynthLives, DependOnTheSeedAlone) {
  const SynthPlan plan = plan_of(kLives);
  EXPECT_EQ(life_texts(plan, 4).specimens, life_texts(plan, 4).specimens);
  EXPECT_NE(life_texts(plan, 4).specimens, life_texts(plan, 5).specimens);
}

}  // namespace

}  // namespace host_sim::synth::test
