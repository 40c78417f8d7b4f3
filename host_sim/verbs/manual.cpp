#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "host_sim/command_line/manual_page.hpp"
#include "host_sim/verbs/manual_prose.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {

void add_manual(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand("manual", "The manual page, as roff");
  verb->footer("Example: host_sim manual | man -l -");
  verb->callback([&app] {
    const std::string documents = TENDONLIFE_DOCUMENTS;
    std::cout << command_line::manual_page(
        command_line::read_command(app), {std::string(kProgramVersion), TENDONLIFE_RELEASE_DATE},
        manual_prose(documents), "host_sim/examples", documents + "/examples");
  });
}

}  // namespace host_sim
