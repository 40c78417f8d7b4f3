#include "hal/files/toml_depth.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <toml++/toml.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/toml_table.hpp"
#include "tests/io/support.hpp"

namespace {

using hal::files::kMostTomlDepth;
using hal::files::TomlDepth;
using host_sim::test::complaint_of;

static_assert(kMostTomlDepth == 32, "the texts below are made for it");

std::string times(std::size_t count, std::string_view part) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += part;
  }
  return text;
}

/// 31 levels below the first one.
std::string more(std::string_view part) {
  return times(31, part);
}

std::string place_of(std::string_view text) {
  const auto at = TomlDepth(text).first_too_deep();
  return at ? fmt::format("{}:{}", at->line, at->column) : "";
}

TEST(TomlDepth, CountsEachLevelAndSaysWhereItIsOneTooMany) {
  // A column each: `[a.a` has its dots in 3, 5 ...; 32 of them would be 33 levels.
  EXPECT_EQ(place_of("[a" + more(".a") + "]\n"), "");
  EXPECT_EQ(place_of("[a" + more(".a") + ".a]\n"), "1:65");
  EXPECT_EQ(place_of("[[a" + times(30, ".a") + "]]\n"), "");
  EXPECT_EQ(place_of("\n[[a" + more(".a") + "]]\n"), "2:64");
  EXPECT_EQ(place_of("a" + more(".a") + " = 1"), "");
  EXPECT_EQ(place_of("a" + more(".a") + ".a = 1"), "1:64");
  EXPECT_EQ(place_of("a = " + more("[") + "1" + more("]")), "");
  EXPECT_EQ(place_of("a = " + more("[") + "[1]" + more("]")), "1:36");
  EXPECT_EQ(place_of("a = " + more("{b=") + "1" + more("}")), "");
  EXPECT_EQ(place_of("a = " + more("{b=") + "{b=1}" + more("}")), "1:99");
}

TEST(TomlDepth, LevelsOfATableItsKeysAndTheirValuesAddUp) {
  const std::string table = "[" + times(9, "a.") + "a]\n";  // 10
  const std::string key = times(9, "b.") + "b = ";          // 20
  EXPECT_EQ(place_of(table + key + times(12, "[") + times(12, "]")), "");
  EXPECT_EQ(place_of(table + "x = 1\n" + key + times(13, "[") + times(13, "]")), "3:35");
  EXPECT_EQ(place_of(table + key + "{" + times(11, "c.") + "c = 1}"), "");
  EXPECT_EQ(place_of(table + key + "{" + times(12, "c.") + "c = 1}"), "2:47");
  EXPECT_EQ(place_of(table + key + "{c = 1, " + times(12, "c.") + "d = 1}"), "2:54");
  EXPECT_EQ(place_of(table + key + "1\n[c]\n" + times(30, "d.") + "d = 1\n"), "");
}

TEST(TomlDepth, WhatIsTextIsNoLevel) {
  const std::string deep = times(40, "[a.{");
  for (const std::string& text :
       {"# " + deep + "\na = 1", "a = \"" + deep + "\\\"" + deep + "\"", "a = '" + deep + "\\'",
        "a = \"\"\"" + deep + "\n\"\"" + deep + "\\\"\"\"" + deep + "\"\"\"\"\"",
        "a = '''" + deep + "\n''" + deep + "'''''", "\"" + deep + "\".b = 1", "['" + deep + "']",
        "a = [\n# " + deep + "\n1.5, 2.5,\n3.5e-1.5\n]", "a = \"\" # " + deep,
        times(40, "a = 1.5\n[b.c]\n[[d]]\n")}) {
    EXPECT_EQ(place_of(text), "") << text;
  }
}

TEST(TomlDepth, AStringThatEndsIsLeftBehind) {
  const std::string deep = more("[") + "[";
  for (const std::string text : {"''", "\"\"", "'a'", "\"\\\\\"", "\"\"\"\"\"\"",
                                 "\"\"\"a\"\"\"\"\"", "'''a''''", "\"\"\"\\\"\"\"\"", "''''''"}) {
    EXPECT_NE(place_of("a = " + text + "\nb = " + deep), "") << text;
    EXPECT_NE(place_of("a = [" + text + ", " + deep), "") << text;
  }
}

TEST(TomlDepth, AColumnIsOneOfCharacters) {
  EXPECT_EQ(place_of("'\xc3\xa4' = " + more("[") + "["), "1:38");
}

std::size_t levels_of(const toml::node& node) {
  std::size_t deepest = 0;
  if (const auto* const table = node.as_table()) {
    for (const auto& [key, value] : *table) {
      deepest = std::max(deepest, 1 + levels_of(value));
    }
  } else if (const auto* const array = node.as_array()) {
    deepest = 1;  // a place in it, be it taken or not
    for (const toml::node& value : *array) {
      deepest = std::max(deepest, 1 + levels_of(value));
    }
  }
  return deepest;
}

/// TOML by chance: each key has another name.
class RandomToml {
 public:
  explicit RandomToml(unsigned seed) : chance_(seed) {}

  std::string document() {
    std::string text;
    for (int i = below(5); i >= 0; --i) {
      const std::string name = key();
      const std::string line[] = {"[" + name + "]", "[[" + name + "]]",
                                  name + " = " + value(below(40))};
      text += line[below(3)] + one_of({"\n", " # [ {.\n", "\r\n"});
    }
    return text;
  }

 private:
  int below(int end) { return std::uniform_int_distribution(0, end - 1)(chance_); }

  std::string one_of(const std::vector<std::string>& texts) {
    return texts[static_cast<std::size_t>(below(static_cast<int>(texts.size())))];
  }

  std::string name() {
    const std::string name = fmt::format("k{}", ++names_);
    return one_of({name, "'" + name + " . [ { #'", "\"" + name + " \\\" . [\""});
  }

  std::string key() {
    std::string text = name();
    for (int i = below(14); i > 0; --i) {
      text += one_of({".", " . "}) + name();
    }
    return text;
  }

  std::string value(int levels) {
    if (levels <= 0) {
      return one_of({"1.5", "''", "\"\"", "'[.'", "\"{\\\"[\"", "'''\n[''[.''''",
                     "\"\"\"\n\\\"\"\"[.\"\"\"\"\"", "[]", "{}", "1979-05-27T07:32:00.5Z", "true"});
    }
    const std::string flat = value(below(2));
    const std::string deep = value(levels - 1);
    return below(2) == 0 ? "[ # [[.\n" + flat + ", " + deep + "\n, ]"
                         : "{" + name() + " = " + flat + ", " + key() + " = " + deep + "}";
  }

  std::mt19937 chance_;
  int names_ = 0;
};

TEST(TomlDepth, IsThatOfTheParsedText) {
  rc::check([] {
    const std::string text = RandomToml(*rc::gen::arbitrary<unsigned>()).document();
    const toml::table parsed = toml::parse(text);
    RC_ASSERT((levels_of(parsed) > kMostTomlDepth) == !place_of(text).empty());
  });
}

TEST(TomlDepth, NothingThatIsParsedAfterItIsDeep) {
  // Whatever the bytes, a parser that is given them gets no deeper before it ends.
  rc::check([] {
    const auto text = *rc::gen::container<std::string>(
        rc::gen::element('a', '.', '[', ']', '{', '}', '=', ',', '"', '\'', '\n', '#', '\\', ' '));
    if (place_of(text).empty()) {
      try {
        RC_ASSERT(levels_of(toml::parse(text)) <= kMostTomlDepth);
      } catch (const toml::parse_error&) {
      }
    }
  });
}

TEST(ParseToml, RefusesWhatIsTooDeepBeforeItIsParsed) {
  const std::string deep = "# a comment\n[" + times(200'000, "a.") + "a]\n";
  EXPECT_EQ(complaint_of([&] { hal::files::parse_toml(deep, "m.toml"); }),
            "m.toml:2:65: more than 32 levels; accepted: TOML of at most 32 levels");
}

}  // namespace
