#include "tests/blind/report/markdown.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace blind {
namespace {

using Rows = std::vector<std::array<std::string, 3>>;

std::string percent(double value) {
  return fmt::format("{:.1f} %", 100 * value);
}

Rows rows_of(const Scores& scores) {
  return {
      {"named something where nothing is hidden", text_of(scores.none_named), "<= 0.4 %"},
      {"any alarm where nothing is hidden", text_of(scores.none_alarmed), ""},
      {"one effect, right first, over all", text_of(scores.one.first), ">= 92 %"},
      {"the same, a class of equivalent causes counted as one", text_of(scores.one.of_class), ""},
      {"where an oracle sees it at 3 sigma", text_of(scores.one_at_3.first), ""},
      {"where an oracle sees it at 5 sigma", text_of(scores.one_at_5.first), ">= 98 %"},
      {"the same, by class", text_of(scores.one_at_5.of_class), ""},
      {"right when named", text_of(scores.named_right), ">= 99 %"},
      {"expected calibration error", fmt::format("{:.3f}", scores.calibration.error()), "<= 0.02"},
      {"95 % set: holds the truth", text_of(scores.covered), "94 .. 99 %"},
      {"95 % set: mean size", fmt::format("{:.2f}", scores.set_size), "<= 1.2"},
      {"two at once, both right", text_of(scores.two_first), ">= 90 %"},
      {"where an oracle sees both at 5 sigma", text_of(scores.two_first_at_5), ""},
      {"two at once, both named", text_of(scores.two_named), ""},
      {"outside the catalogue: unknown", text_of(scores.outside_unknown), ">= 95 %"},
      {"outside the catalogue: falsely named", text_of(scores.outside_named), "<= 1 %"},
      {"parameters: median error", percent(quantile(scores.parameter_errors, 0.5)), "<= 5 %"},
      {"parameters: 95 % intervals that hold the truth", text_of(scores.parameters_covered),
       "93 .. 97 %"},
      {"campaigns refused", fmt::format("{}", scores.refused), "0"},
  };
}

std::string effects_table(const Scores& scores) {
  std::string text = "\n| hidden | right first | by class |\n|---|---|---|\n";
  for (const auto& [id, detection] : scores.effects) {
    text += fmt::format("| {} | {} | {} |\n", id, text_of(detection.first),
                        text_of(detection.of_class));
  }
  for (const auto& [id, proportion] : scores.outside) {
    text += fmt::format("| outside: {} | unknown {} | |\n", id, text_of(proportion));
  }
  return text;
}

std::string reliability_table(const Scores& scores) {
  std::string text =
      "\n| probability of the first candidate | answers | mean probability | right |\n"
      "|---|---|---|---|\n";
  double low = 0;
  for (const Calibration::Bin& bin : scores.calibration.bins()) {
    if (bin.answers > 0) {
      text += fmt::format("| {:.1f} .. {:.1f} | {} | {:.3f} | {} |\n", low, low + 0.1, bin.answers,
                          bin.sum_of_probabilities / static_cast<double>(bin.answers),
                          text_of(Proportion{bin.right, bin.answers}));
    }
    low += 0.1;
  }
  return text;
}

std::string confusion_table(const Scores& scores) {
  std::string text = "\n| hidden | first candidate, campaigns |\n|---|---|\n";
  std::string last;
  for (const auto& [pair, count] : scores.confusion) {
    const auto& [truth, first] = pair;
    text += truth == last ? ", " : fmt::format("{}| {} | ", last.empty() ? "" : " |\n", truth);
    text += fmt::format("{} {}", first, count);
    last = truth;
  }
  return last.empty() ? text : text + " |\n";
}

}  // namespace

std::string markdown_of(const Scores& scores, std::string_view title) {
  std::string text = fmt::format("\n**{}**\n\n| score | reached | goal |\n|---|---|---|\n", title);
  for (const auto& [score, reached, goal] : rows_of(scores)) {
    text += fmt::format("| {} | {} | {} |\n", score, reached, goal);
  }
  return text + effects_table(scores) + reliability_table(scores) + confusion_table(scores);
}

std::string summary_of(const Scores& scores) {
  std::string text;
  for (const auto& [score, reached, goal] : rows_of(scores)) {
    fmt::format_to(std::back_inserter(text), "{:<56} {:<34} {}\n", score, reached, goal);
  }
  for (const auto& [id, detection] : scores.effects) {
    fmt::format_to(std::back_inserter(text), "  {:<54} {:<34} class {}\n", id,
                   text_of(detection.first), text_of(detection.of_class));
  }
  for (const auto& [id, proportion] : scores.outside) {
    fmt::format_to(std::back_inserter(text), "  outside: {:<45} {}\n", id, text_of(proportion));
  }
  return text;
}

std::string with_tables(const std::string& text, std::string_view name, const std::string& tables) {
  const std::string begin_mark = fmt::format("<!-- blind-table-{}:begin -->\n", name);
  const std::string end_mark = fmt::format("<!-- blind-table-{}:end -->", name);
  const std::size_t begin = text.find(begin_mark);
  const std::size_t end = text.find(end_mark);
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    throw std::runtime_error(fmt::format("no marks {}{}", begin_mark, end_mark));
  }
  return text.substr(0, begin + begin_mark.size()) + tables + text.substr(end);
}

}  // namespace blind
