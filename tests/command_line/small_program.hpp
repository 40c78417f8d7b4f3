#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace host_sim_test {

/// A program with one of each kind of option.
struct SmallProgram {
  CLI::App app{"Makes gears"};
  std::string text;
  std::vector<std::string> list;
  double number = 2.5;
  bool flag = false;

  SmallProgram() {
    app.name("gear-box");
    app.set_version_flag("--version", "1.2");
    app.require_subcommand(1);
    CLI::App* cut = app.add_subcommand("cut", "Cuts one [slowly]: it's exact");
    cut->add_option("BLANK", text, "What to cut")->required();
    cut->add_option("-o,--out", text, "Where to")->required()->type_name("FOLDER");
    cut->add_option("--log", text, "Of what is done");
    cut->add_option("--metal", text, "Which")->check(CLI::IsMember({"steel", "brass"}));
    cut->add_option("--check", list, "What to look at")
        ->delimiter(',')
        ->check(CLI::IsMember({"teeth", "bore"}));
    cut->add_option("--depth", number, "How deep")
        ->check(CLI::Range(0.5, 4.0))
        ->capture_default_str();
    cut->add_option("--teeth", number, "How many")->check(CLI::PositiveNumber);
    cut->add_option("--bus", text, "To tell")->type_name("INTERFACE");
    cut->add_option("--to", text, "Whom")->type_name("HOST:PORT")->envname("GEAR_TO");
    cut->add_flag("--dry", flag, "Only think");
    cut->footer("Slow.\nExample: gear-box cut a.bar --out there\n         gear-box cut b.bar\nEnd");
    CLI::App* sell = app.add_subcommand("sell", "Sells");
    sell->require_subcommand(1);
    sell->add_subcommand("many", "Sells many")->add_option("GEAR", list, "What")->required();
    sell->footer("");
  }
};

}  // namespace host_sim_test
