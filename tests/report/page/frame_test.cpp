#include "host_sim/report/page/frame.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>

namespace host_sim {
namespace {

std::string filled(std::string_view page, const Slots& slots) {
  std::ostringstream out;
  fill_template(out, page, slots);
  return out.str();
}

TEST(PageTemplate, FillsEverySlotOnce) {
  EXPECT_EQ(filled("{{a}}-{{b}}{{a}}.", {{"a", "1"}, {"b", ""}}), "1-1.");
  EXPECT_EQ(filled("plain", {}), "plain");
}

TEST(PageTemplate, DoesNotReadInsertedText) {
  EXPECT_EQ(filled("{{a}}", {{"a", "{{b}}"}, {"b", "no"}}), "{{b}}");
}

TEST(PageTemplate, RefusesASlotWithoutTextOrEnd) {
  EXPECT_THROW(filled("{{a}}", {}), std::logic_error);
  EXPECT_THROW(filled("{{a", {{"a", "1"}}), std::logic_error);
}

}  // namespace

}  // namespace host_sim
