#include "host_sim/extension/model_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/effects/life_effect.hpp"
#include "host_sim/model/model.hpp"
#include "tests/extension/models.hpp"
#include "tests/io/support.hpp"

namespace host_sim {

using hal::files::NumberRange;

namespace {

using extension_test::model_with;
using testing::ElementsAre;
using testing::HasSubstr;

std::string complaint(std::string_view tables) {
  return test::complaint_of([&] { model_with(tables); });
}

TEST(ExtensionRead, WithoutTablesTheModelHasNone) {
  EXPECT_TRUE(model_with("").extensions.empty());
}

TEST(ExtensionRead, TakesValuesInTheOrderOfTheCatalogue) {
  const Model model = model_with(
      "[extension.friction_velocity]\n"
      "stribeck_velocity_m_s = 0.02\nviscous_friction_s_m = 1\nstribeck_friction = -0.03\n"
      "[extension.current_offset]\ncurrent_offset_A = 0.05\n");
  ASSERT_EQ(model.extensions.size(), 2u);
  EXPECT_EQ(model.extensions[0].id, "current_offset");
  EXPECT_EQ(value_of(model.extensions[0], "current_offset_A"), 0.05);
  const Extension& velocity = model.extensions[1];
  ASSERT_EQ(velocity.values.size(), 3u);
  EXPECT_EQ(velocity.values[0].name, "stribeck_friction");
  EXPECT_THAT(velocity.values[0].values, ElementsAre(-0.03));
  EXPECT_EQ(velocity.values[2].name, "stribeck_velocity_m_s");
}

TEST(ExtensionRead, FillsInTheReferenceTemperature) {
  const Model model =
      model_with("[extension.friction_temperature]\ntemperature_coefficient_1_K = 0.005\n");
  EXPECT_EQ(value_of(model.extensions[0], "sheath_reference_C"), 20);
}

TEST(ExtensionRead, LeavesOutWhatNobodyKnows) {
  const Model model =
      model_with("[extension.bending_fatigue]\nbending_share = 1\nbending_N = 400\n");
  EXPECT_FALSE(value_if(model.extensions[0], "wire_to_bend_ratio"));
}

TEST(ExtensionRead, BendAnglesOfSeveralPoses) {
  const Model model = model_with(
      "[extension.bend_angle]\nbend_angle_error_rad = [0.1, -0.2]\nbend_angles_deg = [90, 270]\n");
  EXPECT_THAT(values_of(model.extensions[0], "bend_angle_error_rad"), ElementsAre(0.1, -0.2));
  EXPECT_THAT(values_of(model.extensions[0], "bend_angles_deg"), ElementsAre(90, 270));
}

TEST(ExtensionRead, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(complaint("[extension.friction_war]\n"), HasSubstr("unknown table 'friction_war'"));
  EXPECT_THAT(complaint("[extension.friction_load]\n"), HasSubstr("no key load_exponent"));
  EXPECT_EQ(complaint("[extension.friction_load]\nload_exponent = 2\n"),
            "m.toml:23:1: load_exponent is 2; accepted: load_exponent -1..1");
  EXPECT_THAT(complaint("[extension.current_offset]\ncurrent_offset_mA = 5\n"),
              HasSubstr("unknown unit 'mA' of key 'current_offset_mA'"));
  EXPECT_THAT(complaint("[extension.filter_lag]\nlag_s = \"5 ms\"\n"), HasSubstr("lag_s is"));
  EXPECT_THAT(complaint("[[extension]]\n"), HasSubstr("a table [extension]"));
  EXPECT_THAT(complaint("[extension.friction_load]\nload_exponent = nan\n"),
              HasSubstr("m.toml:23:1"));
  EXPECT_THAT(complaint("[extension.friction_load]\nload_exponent = 0.2\nother = 1\n"),
              HasSubstr("unknown key 'other' in [extension.friction_load]"));
}

TEST(ExtensionRead, AFileHoldsWhatIsWithinBounds) {
  EXPECT_TRUE(is_within_bounds({"load_cell_zero", {{"zero_N", {-1e6}}}}));
  EXPECT_FALSE(is_within_bounds({"load_cell_zero", {{"zero_N", {-1.1e6}}}}));
  const auto poses = [](std::size_t count) {
    Extension extension{"bend_angle", {{"bend_angle_error_rad", {}}, {"bend_angles_deg", {}}}};
    for (std::size_t i = 0; i < count; ++i) {
      extension.values[0].values.push_back(0.1);
      extension.values[1].values.push_back(30.0 * static_cast<double>(i));
    }
    return extension;
  };
  EXPECT_TRUE(is_within_bounds(poses(8)));
  EXPECT_FALSE(is_within_bounds(poses(9)));
}

TEST(ExtensionRead, SaysWhatIsWrongWithPoses) {
  const std::string head = "[extension.bend_angle]\n";
  EXPECT_THAT(complaint(head + "bend_angle_error_rad = [0.1]\nbend_angles_deg = [90, 180]\n"),
              HasSubstr("as many as bend_angles_deg: 2"));
  EXPECT_THAT(complaint(head + "bend_angle_error_rad = [0.1, 0.1]\nbend_angles_deg = [90, 90]\n"),
              HasSubstr("do not rise"));
  EXPECT_THAT(complaint(head + "bend_angle_error_rad = [0.1, 1.3]\nbend_angles_deg = [90, 95]\n"),
              HasSubstr("m.toml:23:30: bend_angle_error_rad holds 1.3"));
  EXPECT_THAT(complaint(head + "bend_angle_error_rad = [0.1]\n"),
              HasSubstr("bend_angle_error_rad is an array"));
  EXPECT_THAT(complaint(head + "bend_angle_error_rad = []\nbend_angles_deg = []\n"),
              HasSubstr("1..8 numbers"));
}

TEST(ExtensionRead, AWearWithoutALawIsRefused) {
  EXPECT_THAT(complaint("[extension.friction_wear]\nwear_coefficient = 0.3\nwear_exponent = 0\n"
                        "run_in_cycles = 0\n"),
              HasSubstr("run_in_cycles 1 or more"));
  EXPECT_EQ(complaint("[extension.friction_wear]\nwear_coefficient = 0.3\nwear_exponent = 0.5\n"
                      "run_in_cycles = 0\n"),
            "");
}

/// A factor of mu is held to 7.
TEST(ExtensionRead, FrictionIsUpToSevenTimesAsHighWhenNew) {
  const auto with = [](const std::string& coefficient) {
    return complaint("[extension.friction_wear]\nwear_coefficient = " + coefficient +
                     "\nwear_exponent = 0\nrun_in_cycles = 300\n");
  };
  EXPECT_EQ(with("6"), "");
  EXPECT_THAT(with("6.1"), HasSubstr("wear_coefficient -1..6"));
}

TEST(ExtensionRead, FrictionOfVelocityIsOneLawOrTheOther) {
  const Model model = model_with("[extension.friction_velocity]\nviscous_N_s_m = 30\n");
  ASSERT_EQ(model.extensions[0].values.size(), 1u);
  EXPECT_EQ(value_of(model.extensions[0], "viscous_N_s_m"), 30);
  EXPECT_THAT(complaint("[extension.friction_velocity]\n"),
              HasSubstr("m.toml:22:12: no key in [extension.friction_velocity]; accepted: "
                        "viscous_N_s_m"));
  EXPECT_THAT(complaint("[extension.friction_velocity]\nstribeck_friction = 0.1\n"),
              HasSubstr("m.toml:23:1: stribeck_friction without its velocity; accepted: "
                        "stribeck_velocity_m_s"));
  EXPECT_THAT(complaint("[extension.friction_velocity]\nviscous_N_s_m = -1\n"),
              HasSubstr("accepted: viscous_N_s_m 0..1000000"));
}

TEST(ExtensionRead, PreslidingNeedsItsLength) {
  EXPECT_THAT(complaint("[extension.presliding]\n"), HasSubstr("no key presliding_length_m"));
  EXPECT_THAT(complaint("[extension.presliding]\npresliding_length_m = 0\n"),
              HasSubstr("m.toml:23:1: presliding_length_m is 0"));
  EXPECT_EQ(complaint("[extension.presliding]\npresliding_length_m = 0.02\n"), "");
}

std::string correction_of(std::string_view rest) {
  return "[extension.empirical]\n" + std::string(rest);
}

TEST(ExtensionRead, ACorrectionIsATableOverOneCovariate) {
  const Model model =
      model_with(correction_of("letting_go_N = [-1, 0, 1.5]\nposition_m = [-0.1, 0, 0.2]\n"
                               "pulling_N = [1, 2, 3]\n"));
  ASSERT_EQ(model.extensions.size(), 1u);
  EXPECT_EQ(model.extensions[0].id, "empirical");
  EXPECT_THAT(values_of(model.extensions[0], "position_m"), ElementsAre(-0.1, 0, 0.2));
  EXPECT_THAT(values_of(model.extensions[0], "pulling_N"), ElementsAre(1, 2, 3));
  EXPECT_THAT(values_of(model.extensions[0], "letting_go_N"), ElementsAre(-1, 0, 1.5));
}

TEST(ExtensionRead, SaysWhatIsWrongWithACorrection) {
  const std::string forces = "pulling_N = [1, 2]\nletting_go_N = [1, 2]\n";
  EXPECT_THAT(complaint(correction_of(forces)),
              HasSubstr("m.toml:22:12: no covariate in [extension.empirical]; accepted: exactly "
                        "one of output_tension_N, position_m, speed_m_s, travel_m"));
  EXPECT_THAT(complaint(correction_of("travel_m = [0, 1]\nspeed_m_s = [0, 1]\n" + forces)),
              HasSubstr("m.toml:23:1: travel_m beside speed_m_s"));
  EXPECT_THAT(complaint(correction_of("travel_m = [0, 0.1, 0.1]\n" + forces)),
              HasSubstr("m.toml:23:1: travel_m do not rise"));
  EXPECT_THAT(complaint(correction_of("travel_m = [0, 0.1, 0.2]\n" + forces)),
              HasSubstr("m.toml:24:1: pulling_N has 2 numbers; accepted: as many as travel_m: 3"));
  EXPECT_THAT(complaint(correction_of("travel_m = [0, 0.1]\npulling_N = [1, 2]\n")),
              HasSubstr("no key letting_go_N"));
  EXPECT_THAT(complaint(correction_of("travel_m = [0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16]\n")),
              HasSubstr("m.toml:23:1: travel_m has 17 numbers; accepted: travel_m an array of "
                        "1..16 numbers, each 0..1000"));
  EXPECT_THAT(complaint(correction_of("travel_m = []\n")), HasSubstr("travel_m has 0 numbers"));
  EXPECT_THAT(complaint(correction_of("travel_m = 3\n")), HasSubstr("travel_m is 3"));
  EXPECT_THAT(complaint(correction_of("travel_m = [-1, 1]\n")),
              HasSubstr("m.toml:23:13: travel_m holds -1"));
  EXPECT_THAT(
      complaint(correction_of("travel_m = [0, 1]\npulling_N = [1, 178]\nletting_go_N = [1, 2]\n")),
      HasSubstr("m.toml:24:1: pulling_N is 178; accepted: up to ultimate_tension_N, 177.4"));
  EXPECT_THAT(complaint(correction_of("travel_m = [0, 1]\nother_N = [1]\n")),
              HasSubstr("unknown key 'other_N' in [extension.empirical]"));
}

TEST(ExtensionRead, AForceBeyondTheUltimateTensionIsRefused) {
  EXPECT_THAT(complaint("[extension.friction_preload]\npreload_N = 178\n"),
              HasSubstr("m.toml:23:1: preload_N is 178; accepted: up to ultimate_tension_N"));
  EXPECT_THAT(complaint("[extension.load_cell_zero]\nzero_N = -178\n"),
              HasSubstr("m.toml:23:1: zero_N is -178"));
}

TEST(ExtensionRead, WhoEvaluatesNoExtensionsRefusesThem) {
  const std::string text =
      std::string(extension_test::kNominal) + "[extension.friction_load]\nload_exponent = 0.2\n";
  EXPECT_THAT(test::complaint_of([&] { parse_model(text, "m.toml"); }),
              HasSubstr("unknown table 'extension'"));
}

TEST(ExtensionRead, EveryEffectOfTheCatalogueHasItsKeys) {
  // All but the delay of a channel, which is no part of a model; and the empirical correction.
  EXPECT_EQ(extension_keys().size(),
            effects::tension_effects().size() - 1 + effects::life_effects().size() + 1);
  EXPECT_NE(extension_keys("empirical"), nullptr);
  EXPECT_EQ(extension_keys("channel_delay"), nullptr);
  for (const effects::TensionEffect* const effect : effects::tension_effects()) {
    if (!effect->table.empty()) {
      ASSERT_NE(extension_keys(effect->id), nullptr) << effect->id;
      EXPECT_EQ(extension_keys(effect->id)->keys.size(), effect->table.size());
    }
  }
  EXPECT_EQ(extension_keys("undersampling"), nullptr);
}

TEST(ExtensionRead, TheUnitOfAKeyIsItsSuffix) {
  for (const ExtensionKeys& keys : extension_keys()) {
    for (const effects::TableKey& key : keys.keys) {
      if (!key.number.unit.empty()) {
        const std::size_t unit_at = key.number.name.size() - key.number.unit.size();
        EXPECT_EQ(key.number.name.substr(unit_at), key.number.unit);
        EXPECT_EQ(key.number.name[unit_at - 1], '_') << key.number.name;
      }
    }
  }
}

TEST(ExtensionRead, TheDigestTellsExtendedModelsApart) {
  const Model nominal = model_with("");
  EXPECT_EQ(model_digest(nominal), model_digest(parse_model(extension_test::kNominal, "m.toml")));
  const Model one = model_with("[extension.filter_lag]\nlag_s = 0.005\n");
  const Model other = model_with("[extension.filter_lag]\nlag_s = 0.006\n");
  EXPECT_NE(model_digest(one), model_digest(nominal));
  EXPECT_NE(model_digest(one), model_digest(other));
}

TEST(ExtensionWrite, WritesATableForEachEffect) {
  const std::vector<Extension> extensions{
      {"bend_angle", {{"bend_angle_error_rad", {0.1, -0.25}}, {"bend_angles_deg", {90, 270}}}},
      {"friction_load", {{"load_exponent", {0.2}}}}};
  EXPECT_EQ(toml_text(extensions),
            "[extension.bend_angle]\n"
            "bend_angle_error_rad = [0.1, -0.25]\n"
            "bend_angles_deg = [90.0, 270.0]\n"
            "\n"
            "[extension.friction_load]\n"
            "load_exponent = 0.2\n");
  EXPECT_EQ(toml_text({}), "");
}

TEST(ExtensionWrite, OnePoseIsAnArrayOfOne) {
  const std::vector<Extension> extensions{
      {"bend_angle", {{"bend_angle_error_rad", {0.1}}, {"bend_angles_deg", {90}}}}};
  EXPECT_EQ(extension_test::model_with(toml_text(extensions)).extensions.size(), 1u);
}

rc::Gen<double> number_in(const NumberRange& range) {
  return rc::gen::map(
      rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 53), [range](std::int64_t share) {
        return std::lerp(range.minimum, range.maximum, std::ldexp(static_cast<double>(share), -53));
      });
}

Extension any_correction() {
  const std::string covariate(kEmpiricalCovariates[*rc::gen::inRange<std::size_t>(0, 4)].name);
  Extension extension{"empirical", {{covariate, {}}, {"pulling_N", {}}, {"letting_go_N", {}}}};
  const int knots = *rc::gen::inRange(1, 17);
  for (int i = 0; i < knots; ++i) {
    extension.values[0].values.push_back(i + *number_in({0, 0.9}));
    extension.values[1].values.push_back(*number_in({-177, 177}));
    extension.values[2].values.push_back(*number_in({-177, 177}));
  }
  return extension;
}

Extension any_extension(const ExtensionKeys& keys) {
  if (keys.id == "empirical") {
    return any_correction();
  }
  Extension extension{std::string(keys.id), {}};
  for (const effects::TableKey& key : keys.keys) {
    NumberRange range = key.number.range;
    if (key.number.name == "run_in_cycles") {
      range.minimum = 1;  // with an exponent of 0 it may not be less
    } else if (key.number.name == "preload_N" || key.number.name == "zero_N") {
      range = {0, 177};  // no more than the wire bears
    }
    std::vector<double> values{*number_in(range)};
    if (key.per_pose) {
      values.push_back(*number_in(key.number.range));
    }
    if (!range.contains(values.front())) {
      values.front() = range.maximum;
    }
    extension.values.push_back({std::string(key.number.name), values});
    if (key.per_pose) {
      extension.values.push_back({"bend_angles_deg", {90, 180.5}});
    }
  }
  return extension;
}

RC_GTEST_PROP(ExtensionWrite, ComesBackToTheLastBit, ()) {
  std::vector<Extension> extensions;
  for (const ExtensionKeys& keys : extension_keys()) {
    if (*rc::gen::arbitrary<bool>()) {
      extensions.push_back(any_extension(keys));
    }
  }
  const std::vector<Extension> read = extension_test::model_with(toml_text(extensions)).extensions;
  RC_ASSERT(read.size() == extensions.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    RC_ASSERT(read[i].id == extensions[i].id);
    RC_ASSERT(read[i].values.size() == extensions[i].values.size());
    for (std::size_t k = 0; k < read[i].values.size(); ++k) {
      RC_ASSERT(read[i].values[k].name == extensions[i].values[k].name);
      RC_ASSERT(read[i].values[k].values == extensions[i].values[k].values);
    }
  }
}

}  // namespace

}  // namespace host_sim
