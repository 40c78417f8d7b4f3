#include "host_sim/extension/write.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "host_sim/extension/keys.hpp"
#include "tests/extension/models.hpp"

namespace host_sim {

using hal::files::NumberRange;

namespace {

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

Extension any_extension(const ExtensionKeys& keys) {
  Extension extension{std::string(keys.id), {}};
  for (const ExtensionKey& key : keys.keys) {
    NumberRange range = key.number.range;
    if (key.number.name == "run_in_cycles") {
      range.minimum = 1;  // with an exponent of 0 it may not be less
    }
    std::vector<double> values{*number_in(range)};
    if (key.per_pose) {
      values.push_back(*number_in(key.number.range));
    }
    if (key.number.range.contains(values.front())) {
      extension.values.push_back({std::string(key.number.name), values});
    }
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
