#include "host_sim/model/model.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/model/model_tables.hpp"
#include "tests/io/support.hpp"

namespace host_sim {
namespace {

using testing::StartsWith;

constexpr std::string_view kGood = R"(schema = 1
[cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
[drive]
torque_constant_Nm_per_A = 0.0325
gear_ratio = 9.0
gear_efficiency = 0.88
spool_radius_mm = 12.5
current_offset_A = -0.25
[counting]
sample_rate_Hz = 1000.0
hysteresis_N = 0.2
[life]
mean_stress = "gerber"
ipl_scale = 1.53e5
ipl_exponent = 1.38
weibull_shape = 5.94
)";

std::string with(std::string_view from, std::string_view to) {
  std::string text(kGood);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string model_complaint(std::string_view text) {
  return test::complaint_of([&] { parse_model(text, "m.toml"); });
}

TEST(Model, ReadsEveryValue) {
  const Model model = parse_model(kGood, "m.toml");
  EXPECT_EQ(model.cable.diameter_mm, 0.457);
  EXPECT_EQ(model.cable.ultimate_tension_N, 177.4);
  EXPECT_EQ(model.sheath.friction_coefficient, 0.128);
  EXPECT_EQ(model.sheath.bend_angle_deg, 270.0);
  ASSERT_TRUE(model.drive.has_value());
  EXPECT_EQ(model.drive->torque_constant_Nm_per_A, 0.0325);
  EXPECT_EQ(model.drive->gear_ratio, 9.0);
  EXPECT_EQ(model.drive->gear_efficiency, 0.88);
  EXPECT_EQ(model.drive->spool_radius_mm, 12.5);
  EXPECT_EQ(model.drive->current_offset_A, -0.25);
  EXPECT_EQ(model.counting.sample_rate_Hz, 1000.0);
  EXPECT_EQ(model.counting.hysteresis_N, 0.2);
  EXPECT_EQ(model.life.mean_stress, Model::MeanStress::kGerber);
  EXPECT_EQ(model.life.ipl_scale, 1.53e5);
  EXPECT_EQ(model.life.ipl_exponent, 1.38);
  EXPECT_EQ(model.life.weibull_shape, 5.94);
}

TEST(Model, DoesWithoutADriveAndTakesIntegers) {
  std::string text = with("bend_angle_deg = 270.0", "bend_angle_deg = 270");
  const std::size_t drive = text.find("[drive]");
  text.erase(drive, text.find("[counting]") - drive);
  const Model model = parse_model(text, "m.toml");
  EXPECT_FALSE(model.drive.has_value());
  EXPECT_EQ(model.sheath.bend_angle_deg, 270.0);
}

constexpr std::string_view kWatch = R"([watch]
minimum_tension_N = 1.5
broken_tension_N = 4.0
broken_travel_mm = 25.0
slack_travel_mm = 3.0
horizon_h = 24.0
advice_risk = 0.05
advice_until_h = 1000.0
)";

TEST(Model, ReadsWhatIsWatched) {
  EXPECT_FALSE(parse_model(kGood, "m.toml").watch.has_value());
  const auto watch = parse_model(std::string(kGood) + std::string(kWatch), "m.toml").watch;
  ASSERT_TRUE(watch.has_value());
  EXPECT_EQ(*watch, (Model::Watch{1.5, 4, 25, 3, 24, 0.05, 1000}));
}

TEST(Model, WhatIsNotWatchedIsOff) {
  const auto watch = parse_model(std::string(kGood) + "[watch]\n", "m.toml").watch;
  ASSERT_TRUE(watch.has_value());
  EXPECT_EQ(*watch, (Model::Watch{0, 0, 0, 0, 8, 0, 0}));
  EXPECT_EQ(model_complaint(std::string(kGood) + "[watch]\nminimum_tension_N = 177.3\n"), "");
}

// The table begins in line 22.
TEST(Model, AWatchThatCannotBeIsRefusedWithPlaceFoundAndAccepted) {
  const auto complaint = [](std::string_view from, std::string_view to) {
    std::string text = std::string(kGood) + std::string(kWatch);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return model_complaint(text.replace(at, from.size(), to));
  };
  EXPECT_EQ(complaint("horizon_h = 24.0", "horizon_h = 0"),
            "m.toml:27:1: horizon_h is 0; accepted: horizon_h 0.001..87600");
  EXPECT_EQ(complaint("advice_risk = 0.05", "advice_risk = 1.0"),
            "m.toml:28:1: advice_risk is 1.0; accepted: advice_risk 0..0.99");
  EXPECT_EQ(complaint("advice_risk = 0.05\n", ""),
            "m.toml:28:1: advice_until_h is 1000 without advice_risk; accepted: advice_risk above "
            "0 too, or advice_until_h = 0");
  EXPECT_EQ(complaint("advice_until_h = 1000.0", "advice_until_h = 0"),
            "m.toml:28:1: advice_risk is 0.05 without advice_until_h; accepted: advice_until_h "
            "above 0 too, or advice_risk = 0");
  EXPECT_EQ(complaint("broken_travel_mm = 25.0\n", ""),
            "m.toml:24:1: broken_tension_N is 4 without broken_travel_mm; accepted: "
            "broken_travel_mm above 0 too, or broken_tension_N = 0");
  EXPECT_EQ(complaint("minimum_tension_N = 1.5\n", ""),
            "m.toml:25:1: slack_travel_mm is 3 without minimum_tension_N; accepted: "
            "minimum_tension_N above 0 too, or slack_travel_mm = 0");
  EXPECT_EQ(complaint("broken_tension_N = 4.0", "broken_tension_N = 177.4"),
            "m.toml:24:1: broken_tension_N is 177.4; accepted: less than ultimate_tension_N, which "
            "is 177.4");
  EXPECT_EQ(complaint("slack_travel_mm", "slack_travel_m"),
            "m.toml:26:1: unknown unit 'm' of key 'slack_travel_m'; accepted: slack_travel_mm "
            "0..1000000");
  EXPECT_EQ(complaint("slack_travel_mm", "colour"),
            "m.toml:26:1: unknown key 'colour' in [watch]; accepted: minimum_tension_N, "
            "broken_tension_N, broken_travel_mm, slack_travel_mm, horizon_h, advice_risk, "
            "advice_until_h");
}

constexpr std::string_view kSure = R"([life.interval]
level = 0.95
ipl_scale = [9e4, 2.6e5]
ipl_exponent = [1.25, 1.5]
weibull_shape = [4.9, 7.1]
pivot_tension_N = 50.0
life_at_pivot = [660, 725]
)";

std::string sure_with(std::string_view from, std::string_view to) {
  std::string text = std::string(kGood) + std::string(kSure);
  const std::size_t at = text.find(from, kGood.size());
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ModelInterval, IsReadWhereItIsThere) {
  EXPECT_FALSE(parse_model(kGood, "m.toml").life.interval.has_value());
  const auto interval = parse_model(sure_with("", ""), "m.toml").life.interval;
  ASSERT_TRUE(interval.has_value());
  EXPECT_EQ(interval->level, 0.95);
  EXPECT_EQ(interval->ipl_scale.low, 9e4);
  EXPECT_EQ(interval->ipl_scale.high, 2.6e5);
  EXPECT_EQ(interval->ipl_exponent.low, 1.25);
  EXPECT_EQ(interval->ipl_exponent.high, 1.5);
  EXPECT_EQ(interval->weibull_shape.low, 4.9);
  EXPECT_EQ(interval->weibull_shape.high, 7.1);
  EXPECT_EQ(interval->pivot_tension_N, 50);
  EXPECT_EQ(interval->life_at_pivot.low, 660);
  EXPECT_EQ(interval->life_at_pivot.high, 725);
}

TEST(ModelInterval, MayTouchItsNumber) {
  EXPECT_EQ(model_complaint(sure_with("[1.25, 1.5]", "[1.38, 1.38]")), "");
}

// 1.53e5 / 50^1.38 = 692.011.
TEST(ModelInterval, IsRefusedWithPlaceFoundAndAccepted) {
  const auto complaint = [](std::string_view from, std::string_view to) {
    return model_complaint(sure_with(from, to));
  };
  const std::string exponent =
      "accepted: ipl_exponent = [low, high], each above 0 up to 1e+300, with 1.38 between";
  EXPECT_EQ(complaint("[1.25, 1.5]", "[1.4, 1.5]"),
            "m.toml:25:1: ipl_exponent is [1.4, 1.5]; " + exponent);
  EXPECT_EQ(complaint("[1.25, 1.5]", "[1.5, 1.25]"),
            "m.toml:25:1: ipl_exponent is [1.5, 1.25]; " + exponent);
  EXPECT_EQ(complaint("[1.25, 1.5]", "[-1, 1.5]"),
            "m.toml:25:17: ipl_exponent holds -1; " + exponent);
  EXPECT_EQ(complaint("[1.25, 1.5]", "[1.25, inf]"),
            "m.toml:25:23: ipl_exponent holds inf; " + exponent);
  EXPECT_EQ(complaint("[1.25, 1.5]", "[1.25, \"a\"]"),
            "m.toml:25:23: ipl_exponent holds 'a'; " + exponent);
  EXPECT_EQ(complaint("[1.25, 1.5]", "[1.25, 1.5, 2]"),
            "m.toml:25:1: ipl_exponent has 3 numbers; " + exponent);
  EXPECT_EQ(complaint("[1.25, 1.5]", "1.5"), "m.toml:25:1: ipl_exponent is 1.5; " + exponent);
  EXPECT_EQ(complaint("ipl_exponent = [1.25, 1.5]\n", ""),
            "m.toml:22:7: no key ipl_exponent in [life.interval]; " + exponent);
  EXPECT_EQ(complaint("[660, 725]", "[700, 725]"),
            "m.toml:28:1: life_at_pivot is [700, 725]; accepted: life_at_pivot = [low, high], each "
            "above 0 up to 1e+300, with 692.011 between");
  EXPECT_EQ(complaint("[4.9, 7.1]", "[6, 7.1]"),
            "m.toml:26:1: weibull_shape is [6, 7.1]; accepted: weibull_shape = [low, high], each "
            "above 0 up to 1e+300, with 5.94 between");
  EXPECT_EQ(complaint("2.6e5", "1.5e5"),
            "m.toml:24:1: ipl_scale is [90000, 150000]; accepted: ipl_scale = [low, high], each "
            "above 0 up to 1e+300, with 153000 between");
  EXPECT_EQ(complaint("0.95", "1.0"),
            "m.toml:23:1: level is 1; accepted: level above 0 and below 1");
  EXPECT_EQ(complaint("0.95", "0"), "m.toml:23:1: level is 0; accepted: level above 0 up to 1");
  EXPECT_EQ(complaint("50.0", "0"),
            "m.toml:27:1: pivot_tension_N is 0; accepted: pivot_tension_N above 0 up to 1000000");
  EXPECT_EQ(complaint("level", "levle"),
            "m.toml:23:1: unknown key 'levle' in [life.interval]; accepted: level, "
            "pivot_tension_N, ipl_scale, ipl_exponent, weibull_shape, life_at_pivot");
  EXPECT_EQ(model_complaint(with("weibull_shape = 5.94", "weibull_shape = 5.94\ninterval = 1")),
            "m.toml:22:1: interval is 1; accepted: a table [life.interval]");
}

struct BadModel {
  std::string name;
  std::string_view from;
  std::string_view to;
  std::string complaint;
};

void PrintTo(const BadModel& bad, std::ostream* out) {
  *out << bad.name;
}

class BadModels : public testing::TestWithParam<BadModel> {};

TEST_P(BadModels, AreRefusedWithPlaceFoundAndAccepted) {
  const BadModel& bad = GetParam();
  EXPECT_EQ(model_complaint(with(bad.from, bad.to)), "m.toml" + bad.complaint);
}

const std::vector<BadModel> kBadModels{
    {"UnknownKey", "gear_ratio = 9.0", "gear_ratio = 9.0\n  colour = 3",
     ":11:3: unknown key 'colour' in [drive]; accepted: torque_constant_Nm_per_A, gear_ratio, "
     "gear_efficiency, spool_radius_mm, current_offset_A"},
    {"UnknownKeyOfLife", "ipl_scale", "ipl_scala",
     ":19:1: unknown key 'ipl_scala' in [life]; accepted: ipl_scale, ipl_exponent, weibull_shape, "
     "mean_stress, interval"},
    {"OtherUnit", "ultimate_tension_N = 177.4", "ultimate_tension_kN = 0.1774",
     ":4:1: unknown unit 'kN' of key 'ultimate_tension_kN'; accepted: ultimate_tension_N "
     "1..1000000"},
    {"NoUnit", "ultimate_tension_N", "ultimate_tension",
     ":4:1: key 'ultimate_tension' without its unit; accepted: ultimate_tension_N 1..1000000"},
    {"UnitWhereThereIsNone", "gear_ratio", "gear_ratio_percent",
     ":10:1: unknown unit 'percent' of key 'gear_ratio_percent'; accepted: gear_ratio "
     "0.001..10000"},
    {"UnknownTable", "[life]", "[extension.heat]\nx = 1\n[life]",
     ":17:2: unknown table 'extension'; accepted: schema, cable, sheath, drive, counting, life, "
     "watch"},
    {"UnknownKeyAtTop", "schema = 1", "schema = 1\nname = \"a\"",
     ":2:1: unknown key 'name'; accepted: schema, cable, sheath, drive, counting, life, "
     "watch"},
    {"TableThatIsAValue", "schema = 1", "schema = 1\nlif = 1",
     ":2:1: unknown key 'lif'; accepted: schema, cable, sheath, drive, counting, life, "
     "watch"},
    {"MissingKey", "weibull_shape = 5.94\n", "",
     ":17:2: no key weibull_shape in [life]; accepted: weibull_shape 0.5..50"},
    {"MissingKeyOfDrive", "gear_efficiency = 0.88\n", "",
     ":8:2: no key gear_efficiency in [drive]; accepted: gear_efficiency 0.01..1"},
    {"MissingMeanStress", "mean_stress = \"gerber\"\n", "",
     ":17:2: no key mean_stress in [life]; accepted: mean_stress \"gerber\""},
    {"MissingTable", "[sheath]\nfriction_coefficient = 0.128\nbend_angle_deg = 270.0\n", "",
     ": no table [sheath]; accepted: [sheath] with friction_coefficient"},
    {"MissingSchema", "schema = 1\n", "", ": no key schema; accepted: schema = 1"},
    {"OtherSchema", "schema = 1", "schema = 2", ":1:1: schema is 2; accepted: schema = 1"},
    {"SchemaOfWrongType", "schema = 1", "schema = 1.0",
     ":1:1: schema is 1.0; accepted: schema = 1"},
    {"Text", "diameter_mm = 0.457", "diameter_mm = \"thin\"",
     ":3:1: diameter_mm is 'thin'; accepted: diameter_mm 0.01..200"},
    {"Boolean", "diameter_mm = 0.457", "diameter_mm = true",
     ":3:1: diameter_mm is true; accepted: diameter_mm 0.01..200"},
    {"Array", "diameter_mm = 0.457", "diameter_mm = [0.457]",
     ":3:1: diameter_mm is an array; accepted: diameter_mm 0.01..200"},
    {"TableAsValue", "diameter_mm = 0.457", "diameter_mm = {}",
     ":3:1: diameter_mm is a table; accepted: diameter_mm 0.01..200"},
    {"NotANumber", "diameter_mm = 0.457", "diameter_mm = nan",
     ":3:1: diameter_mm is nan; accepted: diameter_mm 0.01..200"},
    {"Infinite", "ipl_scale = 1.53e5", "ipl_scale = inf",
     ":19:1: ipl_scale is inf; accepted: ipl_scale above 0 up to 1e+300"},
    {"Zero", "ipl_scale = 1.53e5", "ipl_scale = 0.0",
     ":19:1: ipl_scale is 0.0; accepted: ipl_scale above 0 up to 1e+300"},
    {"MeanStress", "\"gerber\"", "\"goodman\"",
     ":18:1: mean_stress is 'goodman'; accepted: mean_stress \"gerber\""},
    {"MeanStressOfWrongType", "\"gerber\"", "1",
     ":18:1: mean_stress is 1; accepted: mean_stress \"gerber\""},
};

INSTANTIATE_TEST_SUITE_P(Model, BadModels, testing::ValuesIn(kBadModels),
                         [](const auto& bad) { return bad.param.name; });

TEST(Model, RefusesAHysteresisOfTheUltimateTension) {
  std::string text = with("ultimate_tension_N = 177.4", "ultimate_tension_N = 50");
  text.replace(text.find("hysteresis_N = 0.2"), 18, "hysteresis_N = 50");
  EXPECT_EQ(model_complaint(text),
            "m.toml:16:1: hysteresis_N is 50; accepted: less than ultimate_tension_N, which is 50");
}

TEST(Model, RefusesATableThatIsAValue) {
  std::string text(kGood);
  const std::size_t drive = text.find("[drive]");
  text.erase(drive, text.find("[counting]") - drive);
  text.replace(0, 10, "schema = 1\ndrive = \"on\"");
  EXPECT_EQ(model_complaint(text), "m.toml:2:1: drive is 'on'; accepted: a table [drive]");
}

TEST(Model, RefusesWhatIsNotToml) {
  EXPECT_THAT(model_complaint(with("gear_ratio = 9.0", "gear_ratio = ")), StartsWith("m.toml:10:"));
  EXPECT_THAT(model_complaint(with("gear_ratio", "gear_ratio = 9.0\ngear_ratio")),
              StartsWith("m.toml:11:"));
  EXPECT_THAT(model_complaint("\x01"), StartsWith("m.toml:1:1: "));
  EXPECT_EQ(model_complaint(""), "m.toml: no key schema; accepted: schema = 1");
  EXPECT_EQ(model_complaint("a = \"\n\x1b[2J").find('\x1b'), std::string::npos);
}

// Each number at the ends of its range and just outside; the ranges are those of the format.
struct Range {
  std::string_view key;
  double minimum;
  double maximum;
};

constexpr std::array<Range, 13> kRanges{{
    {"diameter_mm", 0.01, 200},
    {"ultimate_tension_N", 1, 1e6},
    {"friction_coefficient", 0, 1},
    {"bend_angle_deg", 0, 1800},
    {"torque_constant_Nm_per_A", 1e-6, 100},
    {"gear_ratio", 0.001, 10000},
    {"gear_efficiency", 0.01, 1},
    {"spool_radius_mm", 0.1, 1000},
    {"current_offset_A", -100, 100},
    {"sample_rate_Hz", 0.1, 100000},
    {"hysteresis_N", 0, 1e5},
    {"ipl_exponent", 1, 12},
    {"weibull_shape", 0.5, 50},
}};

/// A hysteresis needs a wire that is stronger.
std::string with_value(std::string_view key, double value) {
  std::string text(kGood);
  if (key == "hysteresis_N") {
    constexpr std::string_view kStrength = "ultimate_tension_N = 177.4";
    text.replace(text.find(kStrength), kStrength.size(), "ultimate_tension_N = 1e6");
  }
  const std::size_t at = text.find(key);
  const std::size_t end = text.find('\n', at);
  return text.replace(at, end - at, fmt::format("{} = {:.17e}", key, value));
}

TEST(Model, AcceptsTheEndsOfEachRangeAndNothingBeyond) {
  for (const Range& range : kRanges) {
    SCOPED_TRACE(range.key);
    EXPECT_EQ(model_complaint(with_value(range.key, range.minimum)), "");
    EXPECT_EQ(model_complaint(with_value(range.key, range.maximum)), "");
    const double below = std::nextafter(range.minimum, -HUGE_VAL);
    const double above = std::nextafter(range.maximum, HUGE_VAL);
    EXPECT_NE(model_complaint(with_value(range.key, below)).find(range.key), std::string::npos);
    EXPECT_NE(model_complaint(with_value(range.key, above)).find(range.key), std::string::npos);
  }
  EXPECT_EQ(model_complaint(with_value("ipl_scale", 1e300)), "");
  EXPECT_EQ(model_complaint(with_value("ipl_scale", 5e-324)), "");
  EXPECT_NE(model_complaint(with_value("ipl_scale", 1.0001e300)), "");
}

TEST(ModelKeys, NameTheirUnits) {
  for (const ModelKey& key : model_keys()) {
    EXPECT_TRUE(key.unit.empty() || key.key.ends_with(fmt::format("_{}", key.unit))) << key.key;
  }
}

TEST(ModelFile, RefusesMissingDirectoryAndEndless) {
  const test::TemporaryFolder folder;
  const std::string missing = (folder / "none.toml").string();
  const auto complaint_about = [](const std::string& path) {
    return test::complaint_of([&] { read_model(path); });
  };
  EXPECT_EQ(complaint_about(missing),
            missing +
                ": cannot be opened: No such file or directory; accepted: a model file "
                "(TOML) of at most 1 MiB");
  EXPECT_THAT(complaint_about((folder / "").string()), testing::HasSubstr(": is a directory; "));
  EXPECT_THAT(complaint_about("/dev/zero"), StartsWith("/dev/zero: larger than 1 MiB; "));
}

TEST(ModelFile, HasALimitedSize) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "m.toml").string();
  const std::size_t limit = std::size_t{1} << 20;
  std::string text(kGood);
  text += "#" + std::string(limit - text.size() - 1, 'x');
  test::write_text(path, text);
  EXPECT_EQ(read_model(path).life.ipl_exponent, 1.38);
  test::write_text(path, text + "x");
  EXPECT_THAT(test::complaint_of([&] { read_model(path); }),
              StartsWith(path + ": larger than 1 MiB; accepted: "));
}

TEST(ModelFile, IsRead) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "m.toml", kGood);
  EXPECT_EQ(read_model(folder / "m.toml").life.ipl_exponent, 1.38);
}

// CRC-32 by Python's zlib.crc32 over the text that model_digest() is documented to use.
TEST(ModelDigest, IsTheDocumentedChecksum) {
  EXPECT_EQ(model_digest(parse_model(kGood, "m.toml")), "26657f3c");
  std::string text(kGood);
  const std::size_t drive = text.find("[drive]");
  text.erase(drive, text.find("[counting]") - drive);
  EXPECT_EQ(model_digest(parse_model(text, "m.toml")), "e3428793");
}

// By Python's zlib.crc32 too: the lines of the table follow those of the rest.
TEST(ModelDigest, CoversWhatIsWatched) {
  const std::string text = std::string(kGood) + std::string(kWatch);
  EXPECT_EQ(model_digest(parse_model(text, "m.toml")), "2e54d0d6");
}

TEST(ModelDigest, HoldsTheIntervals) {
  EXPECT_EQ(model_digest(parse_model(sure_with("", ""), "m.toml")), "a428e262");
}

TEST(ModelDigest, DoesNotDependOnFormatting) {
  const std::string reformatted = R"(# The same values in another order
life = { weibull_shape = 594e-2, ipl_exponent = 1.380, ipl_scale = 153_000, mean_stress = 'gerber' }
schema = 0x1
sheath.bend_angle_deg = 270
sheath.friction_coefficient = 0.128
[counting]
hysteresis_N = 0.20
sample_rate_Hz = 1e3
[drive]
gear_ratio = 9
gear_efficiency = 0.88
spool_radius_mm = 12.5
current_offset_A = -0.25
torque_constant_Nm_per_A = 32.5e-3
[cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
)";
  EXPECT_EQ(model_digest(parse_model(reformatted, "m.toml")),
            model_digest(parse_model(kGood, "m.toml")));
}

TEST(ModelDigest, ChangesWithEachValue) {
  const std::string digest = model_digest(parse_model(kGood, "m.toml"));
  for (const ModelKey& key : model_keys()) {
    Model model = parse_model(kGood, "m.toml");
    key.value(model) = std::nextafter(key.value(model), HUGE_VAL);
    EXPECT_NE(model_digest(model), digest) << key.key;
  }
}

TEST(ModelDigest, TakesNegativeZeroForZero) {
  Model model = parse_model(kGood, "m.toml");
  model.drive->current_offset_A = 0.0;
  const std::string digest = model_digest(model);
  model.drive->current_offset_A = -0.0;
  EXPECT_EQ(model_digest(model), digest);
}

}  // namespace
}  // namespace host_sim
