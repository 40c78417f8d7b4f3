#include "host_sim/command_line/completion.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

std::string script_for(const std::string& shell, const command_line::Command& program) {
  if (shell == "bash") {
    return command_line::bash_completion(program);
  }
  return shell == "zsh" ? command_line::zsh_completion(program)
                        : command_line::fish_completion(program);
}

}  // namespace

void add_completion(CLI::App& app, int&) {
  auto shell = std::make_shared<std::string>();
  CLI::App* verb =
      app.add_subcommand("completion", "A script that teaches a shell this command line");
  verb->add_option("SHELL", *shell, "The shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  verb->footer(
      "A package installs it. Without one, for the shell that runs now:\n"
      "Example: eval \"$(host_sim completion bash)\"\n"
      "         host_sim completion zsh > _host_sim\n"
      "         host_sim completion fish > host_sim.fish");
  verb->callback(
      [&app, shell] { std::cout << script_for(*shell, command_line::read_command(app)); });
}

}  // namespace host_sim
