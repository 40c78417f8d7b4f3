#include "tests/blind/records/verdict_words.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace blind {
namespace {

using host_sim::diagnose::Verdict;

constexpr std::array<std::pair<Verdict, std::string_view>, 4> kVerdicts{
    {{Verdict::none, "none"},
     {Verdict::named, "named"},
     {Verdict::ambiguous, "ambiguous"},
     {Verdict::unknown, "unknown"}}};

}  // namespace

std::string_view verdict_word(Verdict verdict) {
  for (const auto& [one, word] : kVerdicts) {
    if (one == verdict) {
      return word;
    }
  }
  return "";
}

Verdict verdict_named(const std::string& word) {
  for (const auto& [verdict, text] : kVerdicts) {
    if (text == word) {
      return verdict;
    }
  }
  throw std::runtime_error("a record with the unknown verdict " + word);
}

}  // namespace blind
