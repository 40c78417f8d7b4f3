#include "host_sim/io/natural_order.hpp"

#include <algorithm>

namespace host_sim {
namespace {

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}

/// The digits at the front of `text`, without leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto end =
      static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
  std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

std::strong_ordering compare_numbers(std::string_view a, std::string_view b) {
  return a.size() != b.size() ? a.size() <=> b.size() : a <=> b;
}

std::strong_ordering compare_values(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    std::strong_ordering order = std::strong_ordering::equal;
    if (is_digit(a.front()) && is_digit(b.front())) {
      order = compare_numbers(take_number(a), take_number(b));
    } else {
      order = a.substr(0, 1) <=> b.substr(0, 1);
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
    if (order != 0) {
      return order;
    }
  }
  return a.size() <=> b.size();
}

}  // namespace

std::strong_ordering compare_naturally(std::string_view a, std::string_view b) {
  const std::strong_ordering order = compare_values(a, b);
  return order != 0 ? order : a <=> b;
}

bool naturally_before(const std::filesystem::path& a, const std::filesystem::path& b) {
  return std::lexicographical_compare(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const auto& x, const auto& y) { return compare_naturally(x.native(), y.native()) < 0; });
}

}  // namespace host_sim
