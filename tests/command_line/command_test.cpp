#include "host_sim/command_line/command.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "host_sim/command_line/manual_page.hpp"
#include "tests/command_line/small_program.hpp"

namespace {

using namespace host_sim::command_line;
using Words = std::vector<std::string>;

class ReadCommand : public testing::Test {
 protected:
  const Option& option(const std::string& name) const {
    const auto& options = program_.verbs.at(0).options;
    const auto found = std::find_if(options.begin(), options.end(), [&](const Option& option) {
      return std::find(option.names.begin(), option.names.end(), name) != option.names.end();
    });
    return found == options.end() ? throw std::out_of_range(name) : *found;
  }

  host_sim_test::SmallProgram small_;
  Command program_ = read_command(small_.app);
};

TEST_F(ReadCommand, HasTheVerbsInTheirOrderWithTheirOwn) {
  EXPECT_EQ(program_.name, "gear-box");
  EXPECT_EQ(program_.description, "Makes gears");
  ASSERT_EQ(program_.verbs.size(), 2U);
  EXPECT_EQ(program_.verbs[0].name, "cut");
  ASSERT_EQ(program_.verbs[1].verbs.size(), 1U);
  EXPECT_EQ(program_.verbs[1].verbs[0].name, "many");
}

TEST_F(ReadCommand, HasAllNamesOfAnOption) {
  EXPECT_EQ(option("--out").names, (Words{"-o", "--out"}));
  EXPECT_EQ(option("--help").names, (Words{"-h", "--help"}));
  EXPECT_EQ(program_.options.at(1).names, Words{"--version"});
}

TEST_F(ReadCommand, AFlagHasNoValue) {
  EXPECT_FALSE(option("--dry").has_value);
  EXPECT_FALSE(option("--help").has_value);
  EXPECT_TRUE(option("--log").has_value);
}

TEST_F(ReadCommand, TellsTheKindsOfValues) {
  EXPECT_EQ(option("--log").value.kind, ValueKind::file);
  EXPECT_EQ(option("--out").value.kind, ValueKind::folder);
  EXPECT_EQ(option("--bus").value.kind, ValueKind::interface);
  EXPECT_EQ(option("--metal").value.kind, ValueKind::choice);
  EXPECT_EQ(option("--depth").value.kind, ValueKind::other);
  EXPECT_EQ(option("--to").value.kind, ValueKind::other);
}

TEST_F(ReadCommand, NamesValuesForPeople) {
  EXPECT_EQ(option("--log").value.name, "FILE");
  EXPECT_EQ(option("--depth").value.name, "NUMBER");
  EXPECT_EQ(option("--to").value.name, "HOST:PORT");
  EXPECT_EQ(program_.verbs[0].positionals.at(0).value.name, "BLANK");
  EXPECT_EQ(program_.verbs[0].positionals.at(0).value.kind, ValueKind::file);
}

TEST_F(ReadCommand, TellsWhatIsAcceptedInWords) {
  EXPECT_EQ(option("--metal").value.choices, (Words{"steel", "brass"}));
  EXPECT_EQ(option("--depth").value.accepted, "0.5 to 4");
  EXPECT_EQ(option("--depth").value.preset, "2.5");
  EXPECT_EQ(option("--teeth").value.accepted, "above 0");
  EXPECT_EQ(option("--log").value.accepted, "");
}

TEST_F(ReadCommand, TellsListsRequiredAndVariables) {
  EXPECT_EQ(option("--check").value.separator, ',');
  EXPECT_TRUE(option("--check").repeats);
  EXPECT_FALSE(option("--metal").repeats);
  EXPECT_TRUE(option("--out").required);
  EXPECT_FALSE(option("--log").required);
  EXPECT_EQ(option("--to").environment, "GEAR_TO");
}

TEST_F(ReadCommand, ExamplesAreTheMarkedLineAndThoseIndentedAfterIt) {
  EXPECT_EQ(examples_of(program_.verbs[0].footer),
            (Words{"gear-box cut a.bar --out there", "gear-box cut b.bar"}));
  EXPECT_TRUE(examples_of("         indented but after nothing").empty());
}

}  // namespace
