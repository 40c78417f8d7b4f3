#include "host_sim/report/page/number_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

namespace host_sim {
namespace {

constexpr std::string_view kMinus = "\u2212";
constexpr std::string_view kGroupSpace = "\u202f";
constexpr std::string_view kUnitSpace = "\u00a0";
constexpr int kSmallestPlainExponent = -3;
constexpr int kLargestPlainExponent = 5;
constexpr std::size_t kShortestGrouped = 5;

std::string grouped(std::string_view digits) {
  if (digits.size() < kShortestGrouped) {
    return std::string(digits);
  }
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i != 0 && (digits.size() - i) % 3 == 0) {
      text += kGroupSpace;
    }
    text += digits[i];
  }
  return text;
}

std::string without_trailing_zeros(std::string text) {
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return text;
}

std::string superscript(int exponent) {
  constexpr std::array<std::string_view, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                        "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += kDigits[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

std::string plain_text(double magnitude, int decimals) {
  const std::string text = without_trailing_zeros(fmt::format("{:.{}f}", magnitude, decimals));
  const std::size_t point = text.find('.');
  const std::string whole = grouped(std::string_view(text).substr(0, point));
  return point == std::string::npos ? whole : whole + text.substr(point);
}

std::string magnitude_text(double magnitude, int significant) {
  const std::string rounded = fmt::format("{:.{}e}", magnitude, significant - 1);
  const std::size_t mark = rounded.find('e');
  const char* digits = rounded.data() + mark + (rounded[mark + 1] == '+' ? 2 : 1);
  int exponent = 0;
  std::from_chars(digits, rounded.data() + rounded.size(), exponent);
  if (exponent >= kSmallestPlainExponent && exponent <= kLargestPlainExponent) {
    return plain_text(magnitude, std::max(0, significant - 1 - exponent));
  }
  return without_trailing_zeros(rounded.substr(0, mark)) + "\u00d710" + superscript(exponent);
}

}  // namespace

std::string number_text(double value, int significant) {
  if (std::isnan(value)) {
    return "not defined";
  }
  if (std::isinf(value)) {
    return value > 0 ? "unlimited" : "unlimited below zero";
  }
  if (value == 0) {
    return "0";
  }
  const std::string magnitude = magnitude_text(std::abs(value), significant);
  return value < 0 ? std::string(kMinus) + magnitude : magnitude;
}

std::string count_text(std::uint64_t value) {
  return grouped(std::to_string(value));
}

std::string counted_text(std::uint64_t value, std::string_view noun) {
  constexpr std::uint64_t kFirstRounded = 1'000'000'000;
  const std::string count =
      value < kFirstRounded ? count_text(value) : number_text(static_cast<double>(value));
  return fmt::format("{}{}{}{}", count, kUnitSpace, noun, value == 1 ? "" : "s");
}

std::string quantity_text(double value, std::string_view unit, int significant) {
  std::string text = number_text(value, significant);
  if (std::isfinite(value) && !unit.empty()) {
    text += kUnitSpace;
    text += unit;
  }
  return text;
}

std::string percent_text(double fraction) {
  constexpr double kPercent = 100;
  if (fraction > 0.999 && fraction < 1) {
    return fmt::format(">{0}99.9{0}%", kUnitSpace);
  }
  return quantity_text(kPercent * fraction, "%");
}

std::string duration_text(double duration_s) {
  struct Unit {
    double length_s;
    std::string_view name;
  };
  constexpr std::array kUnits = {Unit{365.25 * 86400, "years"}, Unit{86400, "days"},
                                 Unit{3600, "h"}, Unit{60, "min"}};
  constexpr double kUnitsBeforeChange = 2;
  for (const Unit& unit : kUnits) {
    if (duration_s >= kUnitsBeforeChange * unit.length_s) {
      return quantity_text(duration_s / unit.length_s, unit.name);
    }
  }
  return quantity_text(duration_s, "s");
}

std::string p_text(double p) {
  constexpr double kSmallest = 0.001;
  if (std::isnan(p)) {
    return "not computed";
  }
  return p < kSmallest ? "below 0.001" : number_text(p, 2);
}

}  // namespace host_sim
