#include "host_sim/monitor/http/merge_patch.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace host_sim::monitor {
namespace {

using nlohmann::json;

TEST(MergePatch, HoldsWhatChangedAlone) {
  EXPECT_EQ(merge_patch(json::parse(R"({"a": 1, "b": {"c": 2, "d": 3}, "e": [1], "f": 4})"),
                        json::parse(R"({"a": 1, "b": {"c": 5, "d": 3}, "e": [1, 2], "g": 6})")),
            json::parse(R"({"b": {"c": 5}, "e": [1, 2], "f": null, "g": 6})"));
}

TEST(MergePatch, OfEqualsIsEmpty) {
  const json value = json::parse(R"({"a": {"b": [1, 2]}})");
  EXPECT_EQ(merge_patch(value, value), json::object());
}

json any_value(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 0 ? 5 : 4);
  switch (kind) {
    case 0:
      return *rc::gen::inRange(0, 3);
    case 1:
      return *rc::gen::arbitrary<bool>();
    case 2:
      return *rc::gen::element<std::string>("x", "y");
    case 3:
      return json::array({*rc::gen::inRange(0, 2)});
    default: {
      json object = json::object();
      for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
        object[*rc::gen::element<std::string>("a", "b", "c", "d")] = any_value(depth - 1);
      }
      return object;
    }
  }
}

json any_object() {
  return json{{"k", any_value(3)}, {"m", any_value(2)}};
}

RC_GTEST_PROP(MergePatchProperty, LeadsFromOneToTheOther, ()) {
  const json before = any_object();
  const json after = any_object();
  json changed = before;
  changed.merge_patch(merge_patch(before, after));
  RC_ASSERT(changed == after);
}

}  // namespace
}  // namespace host_sim::monitor
