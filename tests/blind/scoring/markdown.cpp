#include "tests/blind/scoring/markdown.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

namespace blind {
namespace {

/// What a score has to reach. Without a caption there is no goal.
struct Goal {
  std::string caption = {};
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

struct Row {
  std::string_view score;
  std::string reached;
  double value = 0;
  Goal goal;
};

std::string_view met_or_missed(double value, const Goal& goal) {
  if (goal.caption.empty() || std::isnan(value)) {
    return "";
  }
  return value >= goal.low && value <= goal.high ? "met" : "missed";
}

Row share(std::string_view score, const Proportion& proportion, const Goal& goal = {}) {
  return {score, text_of(proportion), proportion.value(), goal};
}

Row number(std::string_view score, const std::string& reached, double value, const Goal& goal) {
  return {score, reached, value, goal};
}

Goal at_least(std::string_view caption, double low) {
  return {.caption = std::string(caption), .low = low};
}

Goal at_most(std::string_view caption, double high) {
  return {.caption = std::string(caption), .high = high};
}

Goal goal_of_each_effect() {
  return at_least(">= 90 %", 0.9);
}

std::vector<Row> rows_of(const Scores& scores, double first_goal) {
  const std::string first_caption = fmt::format(">= {:.0f} %", 100 * first_goal);
  const double error = scores.calibration.error();
  const double parameter_error = quantile(scores.parameter_errors, 0.5);
  const auto refused = static_cast<double>(scores.refused);
  return {
      share("named something where nothing is hidden", scores.none_named,
            at_most("<= 0.4 %", 0.004)),
      share("any alarm where nothing is hidden", scores.none_alarmed),
      share("one effect, right first, over all", scores.one.first,
            at_least(first_caption, first_goal)),
      share("the same, a class of equivalent causes counted as one", scores.one.of_class),
      share("where an oracle sees it at 3 sigma", scores.one_at_3.first),
      share("where an oracle sees it at 5 sigma", scores.one_at_5.first, at_least(">= 98 %", 0.98)),
      share("the same, by class", scores.one_at_5.of_class),
      share("the same, named right", scores.one_named_at_5),
      share("right when named", scores.named_right, at_least(">= 99 %", 0.99)),
      number("expected calibration error", fmt::format("{:.3f}", error), error,
             at_most("<= 0.02", 0.02)),
      share("95 % set: holds the truth", scores.covered, {"94 .. 99 %", 0.94, 0.99}),
      number("95 % set: mean size", fmt::format("{:.2f}", scores.set_size), scores.set_size,
             at_most("<= 1.2", 1.2)),
      share("two at once, both right", scores.two_first, at_least(">= 90 %", 0.9)),
      share("where an oracle sees both at 5 sigma", scores.two_first_at_5),
      share("two at once, both named", scores.two_named),
      share("three at once, all right", scores.three_first),
      share("three at once, all named", scores.three_named),
      share("outside the catalogue: unknown", scores.outside_unknown, at_least(">= 95 %", 0.95)),
      share("outside the catalogue: falsely named", scores.outside_named, at_most("<= 1 %", 0.01)),
      share("of these, held back from tuning: unknown", scores.held_back_unknown),
      share("of these, held back from tuning: falsely named", scores.held_back_named),
      number("parameters: median error", fmt::format("{:.1f} %", 100 * parameter_error),
             parameter_error, at_most("<= 5 %", 0.05)),
      share("parameters: 95 % intervals that hold the truth", scores.parameters_covered,
            {"93 .. 97 %", 0.93, 0.97}),
      share("the same where several effects are hidden", scores.parameters_covered_of_several,
            {"93 .. 97 %", 0.93, 0.97}),
      number("campaigns refused", fmt::format("{}", scores.refused), refused, at_most("0", 0)),
  };
}

std::string effects_table(const Scores& scores) {
  const Goal goal = goal_of_each_effect();
  std::string text = fmt::format(
      "\n| hidden | right first | by class | goal {} |\n|---|---|---|---|\n", goal.caption);
  for (const auto& [id, detection] : scores.effects) {
    text +=
        fmt::format("| {} | {} | {} | {} |\n", id, text_of(detection.first),
                    text_of(detection.of_class), met_or_missed(detection.of_class.value(), goal));
  }
  for (const auto& [id, proportion] : scores.outside) {
    text += fmt::format("| outside: {} | unknown {} | | |\n", id, text_of(proportion));
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

std::string markdown_of(const Scores& scores, std::string_view title, double first_goal) {
  std::string text =
      fmt::format("\n**{}**\n\n| score | reached | goal | |\n|---|---|---|---|\n", title);
  for (const Row& row : rows_of(scores, first_goal)) {
    text += fmt::format("| {} | {} | {} | {} |\n", row.score, row.reached, row.goal.caption,
                        met_or_missed(row.value, row.goal));
  }
  return text + effects_table(scores) + reliability_table(scores) + confusion_table(scores);
}

std::string summary_of(const Scores& scores, double first_goal) {
  std::string text;
  for (const Row& row : rows_of(scores, first_goal)) {
    fmt::format_to(std::back_inserter(text), "{:<56} {:<34} {:<10} {}\n", row.score, row.reached,
                   row.goal.caption, met_or_missed(row.value, row.goal));
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
