#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace host_sim::command_line {

/// What a value is, as far as a shell can help with it.
enum class ValueKind {
  file,       ///< any path
  folder,     ///< a path of a folder
  interface,  ///< a network interface
  choice,     ///< one of a few words
  other       ///< what only the user knows
};

/// What stands after an option, or in place of a positional.
struct Value {
  ValueKind kind = ValueKind::other;
  std::string name;                  ///< for people: FILE, NUMBER, PROFILE
  std::vector<std::string> choices;  ///< of a choice, in the order of the help
  std::string accepted;              ///< which of its kind, in words; empty for all
  std::string preset;                ///< what it is where the user gives none; empty for nothing
  char separator = '\0';             ///< between several in one word; 0 where there is none
};

struct Option {
  std::vector<std::string> names;  ///< --model; -h, --help
  std::string description;
  std::string environment;  ///< the variable that is read where the option is not given
  bool has_value = false;   ///< false for a flag
  bool required = false;
  bool repeats = false;
  Value value;
};

struct Positional {
  std::string description;
  bool required = false;
  bool repeats = false;  ///< takes all words to the end
  Value value;
};

/// The program or one of its verbs, as its command line is.
struct Command {
  std::string name;
  std::string description;
  std::string footer;
  std::vector<Option> options;
  std::vector<Positional> positionals;
  std::vector<Command> verbs;
};

/// What `app` accepts. Where a value is text and nothing is said of it, it is a file.
Command read_command(const CLI::App& app);

}  // namespace host_sim::command_line
