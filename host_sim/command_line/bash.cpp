#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "host_sim/command_line/completion.hpp"
#include "host_sim/command_line/quote.hpp"

namespace host_sim::command_line {
namespace {

// @NAME@ is the program, @FUNCTION@ the function that completes it. A path is the verbs that were
// given, each with a blank before it.
constexpr std::string_view kMachinery = R"bash(
# Words that $1 stands at the beginning of, with $2 before each.
@FUNCTION@_words() {
  mapfile -t COMPREPLY < <(compgen -P "$2" -W "$3" -- "$1")
}

# Names of the CAN interfaces there are.
@FUNCTION@_interfaces() {
  local type
  for type in /sys/class/net/*/type; do
    if [[ -r $type && $(< "$type") == 280 ]]; then
      type=${type%/type}
      printf '%s ' "${type##*/}"
    fi
  done
}

# Completes the word $1 as a value of kind $2, which is one of the words $3.
@FUNCTION@_complete() {
  case $2 in
    file) compopt -o default ;;
    folder) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$1") ;;
    interface) @FUNCTION@_words "$1" '' "$(@FUNCTION@_interfaces)" ;;
    choice) @FUNCTION@_words "$1" '' "$3" ;;
    list)
      local before=''
      [[ $1 == *,* ]] && before=${1%,*},
      @FUNCTION@_words "${1##*,}" "$before" "$3"
      ;;
  esac
}

@FUNCTION@() {
  COMPREPLY=()
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  # bash takes --option=value apart at the sign.
  if [[ $current == = ]]; then
    current=''
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  local path='' position=1 at word before kind choices verbs options
  for ((at = 1; at < COMP_CWORD; at++)); do
    word=${COMP_WORDS[at]}
    before=${COMP_WORDS[at - 1]}
    @FUNCTION@_verb "$path"
    @FUNCTION@_value "$path" "$before"
    if [[ -n $kind || $before == = || $word == -* || $word == = ]]; then
      continue
    elif [[ " $verbs " == *" $word "* ]]; then
      path+=" $word"
    else
      position=$((position + 1))
    fi
  done
  @FUNCTION@_verb "$path"
  @FUNCTION@_value "$path" "$previous"
  if [[ -n $kind ]]; then
    @FUNCTION@_complete "$current" "$kind" "$choices"
  elif [[ $current == -* ]]; then
    @FUNCTION@_words "$current" '' "$options"
  elif [[ -n $verbs ]]; then
    @FUNCTION@_words "$current" '' "$verbs"
  else
    @FUNCTION@_value "$path" "#$position"
    @FUNCTION@_complete "$current" "$kind" "$choices"
  fi
}

complete -F @FUNCTION@ @NAME@
)bash";

std::string_view kind_of(const Value& value) {
  switch (value.kind) {
    case ValueKind::file:
      return "file";
    case ValueKind::folder:
      return "folder";
    case ValueKind::interface:
      return "interface";
    case ValueKind::choice:
      return value.separator == ',' ? "list" : "choice";
    case ValueKind::other:
      return "other";
  }
  return "other";
}

std::string verb_case(const Command& command, const std::string& path) {
  std::vector<std::string> verbs;
  for (const Command& verb : command.verbs) {
    verbs.push_back(verb.name);
  }
  std::vector<std::string> options;
  for (const Option& option : command.options) {
    options.insert(options.end(), option.names.begin(), option.names.end());
  }
  std::string text = fmt::format("    {}) verbs={} options={} ;;\n", shell_quoted(path),
                                 shell_quoted(fmt::format("{}", fmt::join(verbs, " "))),
                                 shell_quoted(fmt::format("{}", fmt::join(options, " "))));
  for (const Command& verb : command.verbs) {
    text += verb_case(verb, path + " " + verb.name);
  }
  return text;
}

std::string value_case(const std::string& path, const std::string& word, const Value& value,
                       const std::string& pattern = "") {
  return fmt::format("    {}{}) kind={} choices={} ;;\n", shell_quoted(path + ":" + word), pattern,
                     kind_of(value),
                     shell_quoted(fmt::format("{}", fmt::join(value.choices, " "))));
}

std::string value_cases(const Command& command, const std::string& path) {
  std::string text;
  for (const Option& option : command.options) {
    if (option.has_value) {
      for (const std::string& name : option.names) {
        text += value_case(path, name, option.value);
      }
    }
  }
  for (std::size_t i = 0; i < command.positionals.size(); ++i) {
    const Positional& positional = command.positionals[i];
    // One that repeats is at every place that no other has.
    text += positional.repeats ? value_case(path, "#", positional.value, "*")
                               : value_case(path, fmt::format("#{}", i + 1), positional.value);
  }
  for (const Command& verb : command.verbs) {
    text += value_cases(verb, path + " " + verb.name);
  }
  return text;
}

constexpr std::string_view kTables = R"bash(# bash completion for @NAME@: @NAME@ completion bash

# Sets verbs and options, those that may follow the path $1.
@FUNCTION@_verb() {
  case $1 in
@VERBS@    *) verbs='' options='' ;;
  esac
}

# Sets kind and choices of what follows the option $2 of the path $1; of the first positional, $2 is #1.
@FUNCTION@_value() {
  case $1:$2 in
@VALUES@    *) kind='' choices='' ;;
  esac
}
)bash";

}  // namespace

std::string bash_completion(const Command& program) {
  std::string text = std::string(kTables) + std::string(kMachinery);
  text = replace_all(text, "@VERBS@", verb_case(program, ""));
  text = replace_all(text, "@VALUES@", value_cases(program, ""));
  text = replace_all(text, "@FUNCTION@", function_name(program.name));
  return replace_all(text, "@NAME@", program.name);
}

}  // namespace host_sim::command_line
