#include "host_sim/report/page/escape.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace host_sim {
namespace {

TEST(HtmlEscape, EscapesWhatEndsTextOrAttribute) {
  EXPECT_EQ(html_escape(R"(<a href="x">&'</a>)"),
            "&lt;a href=&quot;x&quot;&gt;&amp;&#39;&lt;/a&gt;");
}

TEST(HtmlEscape, KeepsLettersOfEveryScript) {
  EXPECT_EQ(html_escape("Überlast 腕 🦾"), "Überlast 腕 🦾");
}

TEST(HtmlEscape, ReplacesWhatIsNoText) {
  EXPECT_EQ(html_escape("a\xff\x01z"), "a\ufffd\ufffdz");
  EXPECT_EQ(html_escape("tab\tline\n"), "tab\tline\n");
}

TEST(ScriptJson, CannotEndItsElement) {
  EXPECT_EQ(script_json("</script><!--&"), "\"\\u003c/script\\u003e\\u003c!--\\u0026\"");
  EXPECT_EQ(nlohmann::json::parse(script_json("</script><!--&")), "</script><!--&");
}

TEST(ScriptJson, HasNullForNumbersThatAreNotFinite) {
  EXPECT_EQ(script_json({{"a", std::numeric_limits<double>::infinity()},
                         {"b", std::numeric_limits<double>::quiet_NaN()}}),
            R"({"a":null,"b":null})");
}

RC_GTEST_PROP(EscapeProperty, NoBytesBreakOut, (const std::string& bytes)) {
  const std::string html = html_escape(bytes);
  RC_ASSERT(html.find_first_of("<>\"'") == std::string::npos);
  const std::string script = script_json(bytes);
  RC_ASSERT(script.find_first_of("<>&") == std::string::npos);
  RC_ASSERT(std::all_of(script.begin(), script.end(), [](char c) { return c >= ' ' && c <= '~'; }));
}

}  // namespace
}  // namespace host_sim
