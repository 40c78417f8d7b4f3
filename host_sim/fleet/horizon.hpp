#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

/// When tendons of a fleet are to be replaced, and what that takes.
namespace host_sim::fleet {

/// A day of the Gregorian calendar.
using Date = std::chrono::sys_days;

inline constexpr std::string_view kDateAccepted = "a date from 1970-01-01 to 9899-12-31";

/// `YYYY-MM-DD`; none for what is no date of 1970 to 9899.
std::optional<Date> parse_date(std::string_view text);

/// `YYYY-MM-DD`. @pre a date of 0 to 9999
std::string date_text(Date date);

/// How far ahead is planned: calendar time, or hours of operation of each tendon.
struct Horizon {
  enum class Kind { calendar, operation };
  Kind kind = Kind::calendar;
  double length = 0;  ///< days, or hours of operation; above 0
  std::string text;   ///< as it was given

  /// Hours that a tendon runs until then.
  [[nodiscard]] double hours(double hours_per_day) const {
    return kind == Kind::calendar ? length * hours_per_day : length;
  }
};

inline constexpr double kLongestHorizon_days = 36525;  // 100 years
inline constexpr std::string_view kHorizonAccepted =
    "days, weeks or months up to 100 years (90d, 12w, 6m), hours of operation (2000h), or a date "
    "after --today (2031-03-01)";

/// `90d`, `12w`, `6m` (of 365.25 / 12 days), `2000h` of operation, or the date until which is
/// planned; none for anything else, for nothing ahead and for more than 100 years.
std::optional<Horizon> parse_horizon(std::string_view text, Date today);

}  // namespace host_sim::fleet
