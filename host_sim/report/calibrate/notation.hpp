#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "host_sim/calibrate/result.hpp"
#include "host_sim/report/page/chart.hpp"

/// How levels look and are called in all plots and tables of the page, and numbers of a calibration
/// in words: plain text, not yet escaped.
namespace host_sim::calibrate_page {

/// What a level is to the law.
enum class LevelKind { fitted, validation, left_out };
[[nodiscard]] LevelKind kind_of(const calibrate::LevelResult& level);

/// circle, diamond or cross.
[[nodiscard]] std::string_view shape_of(LevelKind part);

/// A colour of its own for each of the first six levels; grey where it is left out.
[[nodiscard]] std::string colour_of(const calibrate::CalibrateResult& result, std::size_t level);

/// The name with what the level is where it is not fitted: "540 deg, 99.7 N (left out)".
[[nodiscard]] std::string title_of(const calibrate::LevelResult& level);

/// A specimen of the sample with its level: "wire 7, 540 deg, 99.7 N".
[[nodiscard]] std::string specimen_text(const calibrate::LevelResult& level, std::size_t specimen);

/// Whether the Weibull fit has numbers.
[[nodiscard]] bool has_fit(const calibrate::LevelResult& level);

/// Whether a specimen is drawn as a point: its life is known, or it was suspended as is asked for.
/// Lives that were dropped are nowhere; those of specimens found broken are bars.
[[nodiscard]] bool is_point(const statistics::Observation& specimen, bool failed);

/// Bars for the lives that lie between two inspections, or below the first.
[[nodiscard]] Layer found_broken_bars();

/// Points for the specimens that failed, or for the suspended: open, with an arrow where they point
/// beyond.
[[nodiscard]] Layer specimen_points(LevelKind part, bool failed, std::string_view colour);

/// "315°".
[[nodiscard]] std::string angle_text(double angle_deg);

/// Significant digits of what is read off a life test.
constexpr int kDigits = 4;

/// "830 to 920"; an end that does not exist is "no limit".
[[nodiscard]] std::string interval_text(statistics::Interval interval, int significant = kDigits);

/// The interval of a Weibull scale, which is the life at which 63.2 % have failed, read off the
/// band of the quantiles: straight between its points on probability paper. None where the band
/// does not reach there.
[[nodiscard]] std::optional<statistics::Interval> scale_interval(
    const statistics::QuantileBand& band);

}  // namespace host_sim::calibrate_page
