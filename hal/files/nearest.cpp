#include "hal/files/nearest.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <utility>

namespace hal::files {
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

}  // namespace

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known) {
  const std::string_view letters = letters_of(word);
  const std::string* best = nullptr;
  std::size_t least = letters.size();
  for (const std::string& candidate : known) {
    const std::string_view other = letters_of(candidate);
    const bool begins = letters.size() >= kShortestBeginning && other.starts_with(letters);
    const std::size_t longer = std::max(letters.size(), other.size());
    const std::size_t more = longer - std::min(letters.size(), other.size());
    if (!begins && 3 * more > longer) {
      continue;
    }
    const std::size_t differ = begins ? 1 : distance(letters, other);
    if (differ < least && 3 * differ <= longer) {
      least = differ;
      best = &candidate;
    }
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

}  // namespace hal::files
