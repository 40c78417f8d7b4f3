#include "host_sim/fleet/horizon.hpp"

#include <fmt/format.h>

#include <charconv>

#include "hal/files/text.hpp"

namespace host_sim::fleet {
namespace {

constexpr double kDaysPerWeek = 7;
constexpr double kDaysPerMonth = 365.25 / 12;
constexpr double kHoursInDay = 24;

/// Digits alone.
std::optional<unsigned> whole_number(std::string_view text) {
  unsigned value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && stop == text.data() + text.size();
  return whole ? std::optional(value) : std::nullopt;
}

/// The length in days or hours and of which of both; none for another unit.
std::optional<Horizon> in_unit(char unit, double number) {
  switch (unit) {
    case 'd':
      return Horizon{Horizon::Kind::calendar, number, {}};
    case 'w':
      return Horizon{Horizon::Kind::calendar, number * kDaysPerWeek, {}};
    case 'm':
      return Horizon{Horizon::Kind::calendar, number * kDaysPerMonth, {}};
    case 'h':
      return Horizon{Horizon::Kind::operation, number, {}};
    default:
      return std::nullopt;
  }
}

std::optional<Horizon> of_length(std::string_view text) {
  const char* position = text.data();
  const char* const end = position + text.size();
  double number = 0;
  if (!hal::files::parse_number(position, end, number) || end - position != 1) {
    return std::nullopt;
  }
  return in_unit(*position, number);
}

}  // namespace

std::optional<Date> parse_date(std::string_view text) {
  constexpr std::size_t kLength = 10;
  if (text.size() != kLength || text[4] != '-' || text[7] != '-') {
    return std::nullopt;
  }
  const auto year = whole_number(text.substr(0, 4));
  const auto month = whole_number(text.substr(5, 2));
  const auto day = whole_number(text.substr(8, 2));
  if (!year || !month || !day || *year < 1970 || *year > 9899) {
    return std::nullopt;
  }
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(*year)),
                                         std::chrono::month(*month), std::chrono::day(*day)};
  return date.ok() ? std::optional(Date(date)) : std::nullopt;
}

std::string date_text(Date date) {
  const std::chrono::year_month_day day(date);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()),
                     static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
}

std::optional<Horizon> parse_horizon(std::string_view text, Date today) {
  std::optional<Horizon> horizon;
  if (const auto until = parse_date(text)) {
    horizon = Horizon{Horizon::Kind::calendar, static_cast<double>((*until - today).count()), {}};
  } else {
    horizon = of_length(text);
  }
  if (!horizon) {
    return std::nullopt;
  }
  const double longest =
      kLongestHorizon_days * (horizon->kind == Horizon::Kind::operation ? kHoursInDay : 1);
  if (!(horizon->length > 0 && horizon->length <= longest)) {
    return std::nullopt;
  }
  horizon->text = text;
  return horizon;
}

}  // namespace host_sim::fleet
