#include "host_sim/command_line/unknown_word.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "hal/files/nearest.hpp"

namespace host_sim::command_line {

using hal::files::nearest;

namespace {

std::vector<std::string> verbs_of(const Command& command) {
  std::vector<std::string> names;
  for (const Command& verb : command.verbs) {
    names.push_back(verb.name);
  }
  return names;
}

/// Those of whole words.
std::vector<std::string> options_of(const Command& command) {
  std::vector<std::string> names;
  for (const Option& option : command.options) {
    std::ranges::copy_if(option.names, std::back_inserter(names),
                         [](const std::string& name) { return name.starts_with("--"); });
  }
  return names;
}

const Option* option_named(const Command& command, const std::string& name) {
  const auto found = std::ranges::find_if(command.options, [&](const Option& option) {
    return std::ranges::find(option.names, name) != option.names.end();
  });
  return found == command.options.end() ? nullptr : &*found;
}

}  // namespace

std::optional<UnknownWord> first_unknown(const Command& program,
                                         std::span<const std::string> words) {
  const Command* command = &program;
  std::string path;
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    if (name.starts_with("--")) {
      const Option* option = option_named(*command, name);
      if (option == nullptr) {
        const auto known = options_of(*command);
        return UnknownWord{name, path, known, nearest(name, known)};
      }
      if (option->has_value && name == words[i]) {
        ++i;
      }
    } else if (!name.starts_with('-') && !command->verbs.empty()) {
      const auto verb = std::ranges::find(command->verbs, words[i], &Command::name);
      if (verb == command->verbs.end()) {
        const auto known = verbs_of(*command);
        return UnknownWord{words[i], path, known, nearest(words[i], known)};
      }
      command = &*verb;
      path += (path.empty() ? "" : " ") + verb->name;
    }
  }
  return std::nullopt;
}

}  // namespace host_sim::command_line
