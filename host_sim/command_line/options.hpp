#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace host_sim::command_line {

// Names of types that say what a value is, in the help and to a shell.
inline constexpr const char* kFile = "FILE";
inline constexpr const char* kFolder = "FOLDER";
inline constexpr const char* kInterface = "INTERFACE";

/// Of an option that may be given several times: one value each, so that what follows may be a
/// file.
inline CLI::Option* one_at_a_time(CLI::Option* option) {
  return option->expected(1)->take_all()->allow_extra_args(false);
}

/// Checks of the numbers of all verbs. CLI::Range lets NaN pass, which is neither below nor above
/// anything.

/// `is_good` is asked of finite numbers alone; `description` is for the help.
template <class T, class IsGood>
CLI::Validator number_that(IsGood is_good, const std::string& description,
                           const std::string& accepted) {
  return {[is_good, accepted](const std::string& text) {
            T value{};
            bool good = CLI::detail::lexical_cast(text, value);
            if constexpr (!std::numeric_limits<T>::is_integer) {
              good = good && std::isfinite(value);
            }
            return good && is_good(value) ? std::string() : text + " is not a number " + accepted;
          },
          description};
}

/// Ends included.
template <class T>
CLI::Validator in_range(T low, T high) {
  std::ostringstream range;
  range << "[" << low << " - " << high << "]";
  std::ostringstream words;
  words << "from " << low << " to " << high;
  return number_that<T>([low, high](T value) { return value >= low && value <= high; },
                        CLI::detail::type_name<T>() + std::string(" in ") + range.str(),
                        words.str());
}

inline CLI::Validator above(double least) {
  std::ostringstream text;
  text << least;
  return number_that<double>([least](double value) { return value > least; }, "ABOVE " + text.str(),
                             "above " + text.str());
}

inline CLI::Validator not_negative() {
  return number_that<double>([](double value) { return value >= 0; }, "NONNEGATIVE",
                             "of 0 or more");
}

}  // namespace host_sim::command_line
