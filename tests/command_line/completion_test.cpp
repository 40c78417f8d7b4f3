#include "host_sim/command_line/completion.hpp"

#include <gtest/gtest.h>

#include "host_sim/command_line/quote.hpp"
#include "tests/command_line/small_program.hpp"

namespace {

using namespace host_sim::command_line;

class Completion : public testing::Test {
 protected:
  static void expect(const std::string& script, const std::string& part) {
    EXPECT_NE(script.find(part), std::string::npos) << part << "\nis not in\n" << script;
  }

  host_sim_test::SmallProgram small_;
  Command program_ = read_command(small_.app);
};

TEST_F(Completion, NoScriptKeepsAPlaceholder) {
  for (const std::string& script :
       {bash_completion(program_), zsh_completion(program_), fish_completion(program_)}) {
    for (const char* placeholder : {"@NAME@", "@FUNCTION@", "@VERBS@", "@VALUES@"}) {
      EXPECT_EQ(script.find(placeholder), std::string::npos) << placeholder;
    }
  }
}

TEST_F(Completion, BashKnowsVerbsOptionsAndValuesOfEachPath) {
  const std::string script = bash_completion(program_);
  expect(script, "    '') verbs='cut sell' options='-h --help --version' ;;\n");
  expect(script, "    ' sell many') verbs='' options='-h --help' ;;\n");
  expect(script, "    ' cut:-o') kind=folder choices='' ;;\n");
  expect(script, "    ' cut:--check') kind=list choices='teeth bore' ;;\n");
  expect(script, "    ' cut:#1') kind=file choices='' ;;\n");
  expect(script, "    ' sell many:#'*) kind=file choices='' ;;\n");
  EXPECT_EQ(script.find("--dry') kind"), std::string::npos);
  expect(script, "complete -F _gear_box gear-box\n");
}

TEST_F(Completion, ZshEscapesWhatItWouldTakeForItsOwn) {
  const std::string script = zsh_completion(program_);
  expect(script, "#compdef gear-box\n");
  expect(script, R"('cut:Cuts one [slowly]: it'\''s exact')");
  expect(script, R"('(-o --out)--out=[Where to]:FOLDER:_files -/')");
  expect(script, R"('(-o --out)-o[Where to]:FOLDER:_files -/')");
  expect(script, R"('(--to)--to=[Whom]:HOST\:PORT: ')");
  expect(script, R"('*--check=[What to look at]:NAME:_values -s , NAME teeth bore')");
  expect(script, "'*:GEAR:_files'");
  expect(script, "many) _gear_box_sell_many ;;");
}

TEST_F(Completion, FishOffersAnOptionWhereItsVerbIs) {
  const std::string script = fish_completion(program_);
  expect(script,
         R"(complete -c gear-box -n '__gear_box_at' -a cut -d 'Cuts one [slowly]: it\'s exact')");
  expect(script, "-n '__gear_box_after cut' -s o -l out -r -f -a '(__fish_complete_directories)'");
  expect(script, "-n '__gear_box_after cut' -l dry -d 'Only think'\n");
  expect(script, "-n '__gear_box_at sell' -a many -d 'Sells many'\n");
  expect(script, "-n '__gear_box_after cut' -F\n");
}

TEST(Quote, AWordOfAShellMayHoldApostrophes) {
  EXPECT_EQ(shell_quoted("it's"), R"('it'\''s')");
  EXPECT_EQ(replace_all("aaa", "a", "aa"), "aaaaaa");
}

}  // namespace
