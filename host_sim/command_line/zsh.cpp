#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "host_sim/command_line/completion.hpp"
#include "host_sim/command_line/quote.hpp"

namespace host_sim::command_line {
namespace {

constexpr std::string_view kZshHead = R"zsh(#compdef @NAME@
# zsh completion for @NAME@: @NAME@ completion zsh

# The CAN interfaces there are.
@FUNCTION@_interfaces() {
  local -a names expl
  local type
  for type in /sys/class/net/*/type(N); do
    [[ "$(< $type)" == 280 ]] && names+=(${type:h:t})
  done
  _wanted interfaces expl 'CAN interface' compadd -a names
}
)zsh";

// The file is the body of the function where zsh loads it by name.
constexpr std::string_view kZshTail = R"zsh(
if [[ ${funcstack[1]} == @FUNCTION@ ]]; then
  @FUNCTION@ "$@"
else
  compdef @FUNCTION@ @NAME@
fi
)zsh";

/// Text inside of [...] or between the colons of _arguments.
std::string escaped(std::string text) {
  for (const char* special : {"\\", "[", "]", ":"}) {
    text = replace_all(text, special, std::string("\\") + special);
  }
  return text;
}

std::string action_of(const Value& value) {
  switch (value.kind) {
    case ValueKind::file:
      return "_files";
    case ValueKind::folder:
      return "_files -/";
    case ValueKind::interface:
      return "@FUNCTION@_interfaces";
    case ValueKind::choice:
      return value.separator == ','
                 ? fmt::format("_values -s , {} {}", value.name, fmt::join(value.choices, " "))
                 : fmt::format("({})", fmt::join(value.choices, " "));
    case ValueKind::other:
      return " ";
  }
  return " ";
}

std::string value_spec(const Value& value) {
  return fmt::format(":{}:{}", escaped(value.name), action_of(value));
}

/// The specification of an option by each of its names; given one, the others are offered no more.
std::string option_specs(const Option& option) {
  std::string text;
  for (const std::string& name : option.names) {
    std::string spec = option.repeats ? "*" : fmt::format("({})", fmt::join(option.names, " "));
    spec += name;
    if (option.has_value && name.rfind("--", 0) == 0) {
      spec += "=";
    }
    spec += fmt::format("[{}]", escaped(option.description));
    if (option.has_value) {
      spec += value_spec(option.value);
    }
    text += fmt::format(" \\\n    {}", shell_quoted(spec));
  }
  return text;
}

std::string arguments_of(const Command& command) {
  std::string text;
  for (const Option& option : command.options) {
    text += option_specs(option);
  }
  std::size_t place = 0;
  for (const Positional& positional : command.positionals) {
    const std::string where = positional.repeats ? "*" : std::to_string(++place);
    text += fmt::format(" \\\n    {}", shell_quoted(where + value_spec(positional.value)));
  }
  return text;
}

std::string leaf_function(const Command& command, const std::string& function) {
  return fmt::format("\n{}() {{\n  _arguments -s{}\n}}\n", function, arguments_of(command));
}

/// Offers the verbs, and hands the words after one to its function.
std::string branch_function(const Command& command, const std::string& function) {
  std::string names;
  std::string cases;
  for (const Command& verb : command.verbs) {
    names += fmt::format("        {}\n",
                         shell_quoted(fmt::format("{}:{}", escaped(verb.name), verb.description)));
    cases += fmt::format("        {}) {}{} ;;\n", verb.name, function, function_name(verb.name));
  }
  return fmt::format(
      "\n{0}() {{\n"
      "  local state line curcontext=\"$curcontext\"\n"
      "  typeset -A opt_args\n"
      "  _arguments -C -s{1} \\\n    '1: :->verb' '*:: :->words' && return\n"
      "  case $state in\n"
      "    verb)\n"
      "      local -a verbs=(\n{2}      )\n"
      "      _describe verb verbs\n"
      "      ;;\n"
      "    words)\n"
      "      case ${{line[1]}} in\n{3}      esac\n"
      "      ;;\n"
      "  esac\n"
      "}}\n",
      function, arguments_of(command), names, cases);
}

std::string functions_of(const Command& command, const std::string& function) {
  if (command.verbs.empty()) {
    return leaf_function(command, function);
  }
  std::string text;
  for (const Command& verb : command.verbs) {
    text += functions_of(verb, function + function_name(verb.name));
  }
  return text + branch_function(command, function);
}

}  // namespace

std::string zsh_completion(const Command& program) {
  const std::string function = function_name(program.name);
  std::string text =
      std::string(kZshHead) + functions_of(program, function) + std::string(kZshTail);
  text = replace_all(text, "@FUNCTION@", function);
  return replace_all(text, "@NAME@", program.name);
}

}  // namespace host_sim::command_line
