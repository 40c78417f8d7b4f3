#include "host_sim/report/page/table.hpp"

#include <gtest/gtest.h>

namespace host_sim {
namespace {

TEST(Table, NamesRowsAndColumnsForScreenReaders) {
  Table table("Lives", {"Level", "Mean"});
  table.row("a", {"1"});
  EXPECT_EQ(table.html(),
            "<div class=\"table\" tabindex=\"0\" role=\"region\" aria-label=\"Lives\">\n"
            "<table>\n<thead><tr><th scope=\"col\">Level</th>"
            "<th scope=\"col\" class=\"number\">Mean</th></tr></thead>\n<tbody>\n"
            "<tr><th scope=\"row\">a</th><td class=\"number\">1</td></tr>\n"
            "</tbody>\n</table>\n</div>\n");
}

TEST(Table, LetsTextsBreak) {
  Table table("Lives", {"Level", "Lives"}, Table::Cells::texts);
  table.row("b", {"one, two"});
  EXPECT_EQ(table.html().find("class=\"number\""), std::string::npos);
  EXPECT_NE(table.html().find("<th scope=\"row\">b</th><td>one, two</td>"), std::string::npos);
}

TEST(Table, EscapesEveryText) {
  Table table("<a>", {"<b>", "<c>"});
  table.row("<d>", {"<e>"});
  EXPECT_EQ(table.html().find("<d>"), std::string::npos);
  EXPECT_NE(table.html().find("&lt;e&gt;"), std::string::npos);
  EXPECT_NE(table.html().find("aria-label=\"&lt;a&gt;\""), std::string::npos);
}

}  // namespace
}  // namespace host_sim
