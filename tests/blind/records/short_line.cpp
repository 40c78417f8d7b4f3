#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tests/blind/records/record.hpp"
#include "tests/blind/records/verdict_words.hpp"

namespace blind {
namespace {

std::vector<std::string> sorted_ids(const Scenario& truth) {
  std::vector<std::string> ids;
  for (const HiddenEffect& effect : truth.hidden) {
    ids.push_back(effect.id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace

std::string answer_of(const Scenario& truth) {
  switch (truth.kind) {
    case Kind::none:
      return "none";
    case Kind::outside:
      return "unknown";
    case Kind::one:
    case Kind::two:
      break;
  }
  return fmt::format("{}", fmt::join(sorted_ids(truth), "+"));
}

std::string short_line_of(const Record& record) {
  constexpr std::size_t kShown = 3;
  const auto& findings = record.findings;
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < std::min(kShown, findings.candidates.size()); ++i) {
    shown.push_back(
        fmt::format("{} {:.3f}", findings.candidates[i].id, findings.candidates[i].probability));
  }
  const bool outside = record.truth.kind == Kind::outside;
  const std::string truth =
      outside ? "outside:" + record.truth.hidden.front().id : answer_of(record.truth);
  const std::string design =
      record.truth.data == Data::lives
          ? fmt::format("lives {}", record.truth.specimens)
          : fmt::format("{} {}", word_of(record.truth.design), word_of(record.truth.input));
  return fmt::format("{} {} z=[{:.1f}] {} -> {} | {} | {:.1f} s{}", record.truth.seed, design,
                     fmt::join(record.visibility, ", "), truth, verdict_word(findings.verdict),
                     fmt::join(shown, ", "), record.seconds,
                     record.error.empty() ? "" : " | " + record.error);
}

}  // namespace blind
