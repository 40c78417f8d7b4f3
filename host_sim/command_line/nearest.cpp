#include "host_sim/command_line/nearest.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>

namespace host_sim::command_line {
namespace {

/// Of the optimal string alignment.
std::size_t distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last(to.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::vector<std::size_t> row(to.size() + 1, i);
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t other = from[i - 1] == to[j - 1] ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + other});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
    before_last = std::move(last);
    last = std::move(row);
  }
  return last.back();
}

std::string_view letters_of(std::string_view word) {
  const std::size_t dashes = word.find_first_not_of('-');
  return word.substr(dashes == std::string_view::npos ? word.size() : dashes);
}

/// Shorter beginnings stand for too much.
constexpr std::size_t kShortestBeginning = 3;

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

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known) {
  const std::string_view letters = letters_of(word);
  const std::string* best = nullptr;
  std::size_t least = letters.size();
  for (const std::string& candidate : known) {
    const std::string_view other = letters_of(candidate);
    const bool begins = letters.size() >= kShortestBeginning && other.starts_with(letters);
    const std::size_t differ = begins ? 1 : distance(letters, other);
    if (differ < least && 3 * differ <= std::max(letters.size(), other.size())) {
      least = differ;
      best = &candidate;
    }
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

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
