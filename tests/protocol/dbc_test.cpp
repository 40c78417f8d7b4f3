#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "firmware/generate/decimal.hpp"
#include "firmware/generate/generate.hpp"

// The rules that third-party readers of DBC files lay down, one test each.
namespace protocol::generate {
namespace {

using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string three_nodes() {
  return dbc(std::array<Node, 3>{1, 7, 127});
}

using Groups = std::vector<std::string>;

/// The groups of every line that matches whole.
std::vector<Groups> matches(const std::vector<std::string>& lines, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<Groups> found;
  for (const std::string& line : lines) {
    std::smatch match;
    if (std::regex_match(line, match, regex)) {
      found.emplace_back(match.begin(), match.end());
    }
  }
  return found;
}

constexpr const char* kSignalLine =
    R"re( SG_ (\w+)( M| m\d+)? : (\d+)\|(\d+)@1\+ \(([0-9.]+),0\) \[0\|([0-9.]+)\] "([\w/]*)" (\w+))re";

TEST(Dbc, IsWhatTheFramePlanSays) {
  const std::vector<std::string> lines = lines_of(three_nodes());
  for (const char* line :
       {"BU_: Node1 Node7 Node127 Host", "BO_ 1793 Heartbeat_1: 1 Node1",
        "BO_ 391 LifeStatus_7: 8 Node7", "BO_ 767 LifeDetail_127: 8 Node127",
        "BO_ 129 Emergency_1: 8 Node1", "BO_ 519 Command_7: 8 Host",
        " SG_ NmtState : 0|8@1+ (1,0) [0|255] \"\" Host",
        " SG_ Damage : 16|32@1+ (0.000000001,0) [0|4.294967295] \"\" Host",
        " SG_ WorstTendon : 48|5@1+ (1,0) [0|31] \"\" Host",
        " SG_ Page M : 12|4@1+ (1,0) [0|15] \"\" Host",
        " SG_ RemainingB50 m5 : 32|16@1+ (0.1,0) [0|6553.5] \"h\" Host",
        " SG_ HoursToRisk10 m9 : 16|16@1+ (0.1,0) [0|6553.5] \"h\" Host",
        " SG_ BreakRisk m10 : 24|12@1+ (0.00025,0) [0|1.02375] \"\" Host",
        " SG_ HoursToRisk10High m10 : 50|14@1+ (0.5,0) [0|8191.5] \"h\" Host",
        " SG_ AdviceTension m12 : 24|12@1+ (0.00025,0) [0|1.02375] \"\" Host",
        " SG_ Argument : 16|8@1+ (1,0) [0|255] \"\" Node127",
        "VAL_ 1793 NmtState 0 \"boot_up\" 4 \"stopped\" 5 \"operational\" ;",
        "BA_ \"GenMsgCycleTime\" BO_ 1799 1000;", "BA_ \"GenMsgCycleTime\" BO_ 385 100;"}) {
    EXPECT_THAT(lines, Contains(line));
  }
  EXPECT_EQ(matches(lines, "BO_ .*").size(), 15u);
  EXPECT_EQ(matches(lines, kSignalLine).size(), 3u * (1 + 14 + 3 + 46 + 5 + 4));
}

TEST(Dbc, EveryLineIsOneOfTheKnownKinds) {
  std::vector<std::regex> kinds;
  for (const char* pattern :
       {"", R"(VERSION "")", "NS_ :", "\t(CM_|BA_DEF_|BA_|VAL_|BA_DEF_DEF_)",
        "BS_:", R"(BU_:( \w+)+)", R"(BO_ \d+ \w+: [18] \w+)", kSignalLine,
        R"(CM_( BO_ \d+| SG_ \d+ \w+)? "[^"\\;]+";)", R"(BA_DEF_  "\w+" STRING ;)",
        R"(BA_DEF_ BO_  "\w+" INT \d+ \d+;)", R"(BA_DEF_DEF_  "\w+" ("\w*"|\d+);)",
        R"(BA_ "\w+" (BO_ \d+ )?("\w+"|\d+);)", R"(VAL_ \d+ \w+( \d+ "\w+")+ ;)"}) {
    kinds.emplace_back(pattern);
  }
  for (const std::string& line : lines_of(three_nodes())) {
    EXPECT_TRUE(std::any_of(kinds.begin(), kinds.end(), [&](const std::regex& kind) {
      return std::regex_match(line, kind);
    })) << line;
  }
}

TEST(Dbc, SimpleMultiplexingOnly) {
  EXPECT_THAT(three_nodes(), Not(HasSubstr("SG_MUL_VAL_")));
  EXPECT_THAT(three_nodes(), Not(ContainsRegex("m[0-9]+M")));
}

TEST(Dbc, TheMultiplexorComesBeforeWhatItSelects) {
  int page_end = -1;
  std::size_t multiplexors = 0;
  for (const std::string& line : lines_of(three_nodes())) {
    std::smatch match;
    if (line.starts_with("BO_ ")) {
      page_end = -1;
    }
    if (!std::regex_match(line, match, std::regex(kSignalLine))) {
      continue;
    }
    const int start = std::stoi(match[3]);
    if (match[2] == " M") {
      EXPECT_EQ(page_end, -1) << line;
      page_end = start + std::stoi(match[4]);
      ++multiplexors;
    } else if (match[2].matched) {
      ASSERT_GE(page_end, 0) << line;
      EXPECT_GE(start, page_end) << line;
    }
  }
  EXPECT_EQ(multiplexors, 3u);
}

TEST(Dbc, CommentsAreOnOneLine) {
  const std::vector<std::string> lines = lines_of(three_nodes());
  std::size_t comments = 0;
  for (const std::string& line : lines) {
    if (line.starts_with("CM_")) {
      ++comments;
      EXPECT_TRUE(std::regex_match(line, std::regex(R"(CM_[^"]* "[^"\\;]+";)"))) << line;
    }
  }
  EXPECT_EQ(comments, 1 + matches(lines, "BO_ .*").size() + matches(lines, kSignalLine).size());
}

TEST(Dbc, FactorsHaveNoSpaceAndNoExponent) {
  for (const std::string& line : lines_of(three_nodes())) {
    if (line.starts_with(" SG_")) {
      EXPECT_TRUE(std::regex_search(line, std::regex(R"( \([0-9.]+,0\) \[0\|[0-9.]+\] )"))) << line;
    }
  }
}

TEST(Dbc, AttributeValuesAreWords) {
  std::size_t attributes = 0;
  for (const std::string& line : lines_of(three_nodes())) {
    if (line.starts_with("BA_ ") || line.starts_with("BA_DEF_DEF_ ")) {
      ++attributes;
      EXPECT_TRUE(std::regex_match(line, std::regex(R"(.* "?[#\w]+"?;)"))) << line;
    }
  }
  EXPECT_EQ(attributes, 2u + 1u + 3u * 3u);
}

TEST(Dbc, CyclicFramesTellTheirCycle) {
  std::map<int, int> cycles;
  for (const Groups& match :
       matches(lines_of(three_nodes()), R"(BA_ "GenMsgCycleTime" BO_ (\d+) (\d+);)")) {
    cycles[std::stoi(match[1])] = std::stoi(match[2]);
  }
  EXPECT_EQ(cycles, (std::map<int, int>{{0x701, 1000},
                                        {0x707, 1000},
                                        {0x77f, 1000},
                                        {0x181, 100},
                                        {0x187, 100},
                                        {0x1ff, 100},
                                        {0x281, 100},
                                        {0x287, 100},
                                        {0x2ff, 100}}));
}

TEST(Dbc, MessageNamesAndIdentifiersAreUnique) {
  std::set<std::string> names;
  std::set<std::string> ids;
  const auto messages = matches(lines_of(three_nodes()), R"(BO_ (\d+) (\w+): .*)");
  for (const Groups& match : messages) {
    names.insert(match[2]);
    ids.insert(match[1]);
    EXPECT_LE(match[2].size(), 32u);
  }
  EXPECT_EQ(names.size(), messages.size());
  EXPECT_EQ(ids.size(), messages.size());
}

// Readers that keep values within the range must not change any.
TEST(Dbc, RangesHoldEveryRawValue) {
  for (const Groups& match : matches(lines_of(three_nodes()), kSignalLine)) {
    const double largest = static_cast<double>((std::uint64_t{1} << std::stoi(match[4])) - 1);
    const double factor = std::strtod(match[5].c_str(), nullptr);
    const double end = std::strtod(match[6].c_str(), nullptr);
    EXPECT_LE(largest * factor, end) << match[1];
    EXPECT_NEAR(largest * factor, end, 1e-9 * end) << match[1];
  }
}

TEST(Dbc, TheTemplateHasOneNodeWithoutItsId) {
  const std::string text = dbc_template();
  const std::vector<std::string> lines = lines_of(text);
  std::map<std::string, int> ids;
  for (const Groups& match : matches(lines, R"(BO_ (\d+) (\w+): .*)")) {
    ids[match[2]] = std::stoi(match[1]);
  }
  EXPECT_EQ(ids, (std::map<std::string, int>{{"Heartbeat", 0x700},
                                             {"LifeStatus", 0x180},
                                             {"LifeDetail", 0x280},
                                             {"Emergency", 0x080},
                                             {"Command", 0x200}}));
  EXPECT_THAT(lines, Contains("BU_: Node Host"));
  EXPECT_THAT(text, HasSubstr("mask identifiers with 0x780"));
}

TEST(Decimal, IsExact) {
  EXPECT_EQ(times(4'294'967'295, "0.000000001"), "4.294967295");
  EXPECT_EQ(times(65535, "0.1"), "6553.5");
  EXPECT_EQ(times(10, "0.1"), "1");
  EXPECT_EQ(times(7, "1"), "7");
  EXPECT_EQ(times(3, "2.50"), "7.5");
  EXPECT_EQ(times(0, "0.001"), "0");
  EXPECT_EQ(times(100, "1"), "100");
  EXPECT_EQ(readable("0.000000001"), "1e-9");
  EXPECT_EQ(readable("0.1"), "0.1");
  EXPECT_EQ(readable("0.0025"), "25e-4");
}

}  // namespace
}  // namespace protocol::generate
