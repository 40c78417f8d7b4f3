#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "host_sim/command_line/completion.hpp"
#include "host_sim/command_line/quote.hpp"

namespace host_sim::command_line {
namespace {

constexpr std::string_view kFishHead = R"fish(# fish completion for @NAME@: @NAME@ completion fish

# Whether the words begin with these verbs.
function _@FUNCTION@_after
    set -l words (commandline -opc)
    test (count $words) -gt (count $argv)
    or return 1
    set -l verbs $words[2..(math 1 + (count $argv))]
    test "$verbs" = "$argv"
end

# Whether the words are these verbs and no more.
function _@FUNCTION@_at
    set -l words (commandline -opc)
    test "$words[2..]" = "$argv"
end

# The CAN interfaces there are.
function _@FUNCTION@_interfaces
    for type in /sys/class/net/*/type
        if test (cat $type 2>/dev/null; or echo none) = 280
            basename (dirname $type)
        end
    end
end

# These words, after what stands before the last comma.
function _@FUNCTION@_list
    set -l before (string match -r '.*,' -- (commandline -ct))
    printf "$before%s\n" $argv
end

complete -c @NAME@ -f
)fish";

/// One word for fish, whose backslash means something between apostrophes too.
std::string quoted(const std::string& text) {
  return fmt::format("'{}'", replace_all(replace_all(text, "\\", "\\\\"), "'", "\\'"));
}

std::string value_arguments(const Value& value) {
  switch (value.kind) {
    case ValueKind::file:
      return " -F";
    case ValueKind::folder:
      return " -f -a '(__fish_complete_directories)'";
    case ValueKind::interface:
      return " -f -a '(_@FUNCTION@_interfaces)'";
    case ValueKind::choice:
      return value.separator == ','
                 ? fmt::format(" -f -a '(_@FUNCTION@_list {})'", fmt::join(value.choices, " "))
                 : fmt::format(" -f -a '{}'", fmt::join(value.choices, " "));
    case ValueKind::other:
      return " -f";
  }
  return " -f";
}

std::string name_arguments(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += name.rfind("--", 0) == 0 ? fmt::format(" -l {}", name.substr(2))
                                     : fmt::format(" -s {}", name.substr(1));
  }
  return text;
}

std::string condition(const char* what, const std::string& path) {
  return fmt::format("complete -c @NAME@ -n '_@FUNCTION@_{}{}'", what, path);
}

std::string lines_of(const Command& command, const std::string& path) {
  std::string text;
  for (const Command& verb : command.verbs) {
    text +=
        fmt::format("{} -a {} -d {}\n", condition("at", path), verb.name, quoted(verb.description));
  }
  for (const Option& option : command.options) {
    text += condition(command.verbs.empty() ? "after" : "at", path) + name_arguments(option.names) +
            (option.has_value ? " -r" : "") +
            (option.has_value ? value_arguments(option.value) : "") + " -d " +
            quoted(option.description) + "\n";
  }
  for (const Positional& positional : command.positionals) {
    text += condition("after", path) + value_arguments(positional.value) + "\n";
  }
  for (const Command& verb : command.verbs) {
    text += lines_of(verb, path + " " + verb.name);
  }
  return text;
}

}  // namespace

std::string fish_completion(const Command& program) {
  std::string text = std::string(kFishHead) + lines_of(program, "");
  text = replace_all(text, "@FUNCTION@", function_name(program.name));
  return replace_all(text, "@NAME@", program.name);
}

}  // namespace host_sim::command_line
