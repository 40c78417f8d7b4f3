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

std::string headings(int count) {
  std::string body = "<header></header>\n";
  for (int i = 0; i < count; ++i) {
    body +=
        "<h2 id=\"h" + std::to_string(i) + "\">Part " + std::to_string(i) + " &amp; more</h2>\n";
  }
  return body;
}

TEST(Guides, LinkToTheHeadingsOfALongPage) {
  EXPECT_EQ(with_guides(headings(6)), headings(6));
  const std::string guided = with_guides(headings(7));
  EXPECT_EQ(guided.find("<header></header>\n<nav class=\"contents\" aria-label=\"Contents\">"), 0U);
  EXPECT_NE(guided.find("<li><a href=\"#h0\">Part 0 &amp; more</a></li>\n"), std::string::npos);
  EXPECT_NE(guided.find("<li><a href=\"#h6\">Part 6 &amp; more</a></li>\n</ul>"),
            std::string::npos);
}

TEST(Guides, TellOnceHowPlotsAreZoomed) {
  const std::string guided = with_guides(
      "<p></p><div class=\"chart\" data-chart=\"a\"></div><div class=\"chart\" "
      "data-chart=\"b\"></div>");
  const std::size_t hint = guided.find("<p></p><p class=\"hint\" id=\"chart-hint\">");
  EXPECT_NE(hint, std::string::npos);
  EXPECT_EQ(guided.find("id=\"chart-hint\"", guided.find("data-chart")), std::string::npos);
  EXPECT_EQ(with_guides("<p>no plot</p>"), "<p>no plot</p>");
}

}  // namespace

}  // namespace host_sim
