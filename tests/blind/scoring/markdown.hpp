#pragma once

#include <string>
#include <string_view>

#include "tests/blind/scoring/scores.hpp"

namespace blind {

/// Share of campaigns with one effect whose first candidate has to be the truth.
inline constexpr double kFirstGoal = 0.92;

/// The scores as tables of Markdown, each with its goal where there is one, met or missed by the
/// value itself and not by its interval.
std::string markdown_of(const Scores& scores, std::string_view title,
                        double first_goal = kFirstGoal);

/// What a terminal shows at the end of a run.
std::string summary_of(const Scores& scores, double first_goal = kFirstGoal);

/// `text` with what stands between the lines `<!-- blind-table-NAME:begin -->` and
/// `<!-- blind-table-NAME:end -->` replaced. @throws std::runtime_error where they are not there
std::string with_tables(const std::string& text, std::string_view name, const std::string& tables);

}  // namespace blind
