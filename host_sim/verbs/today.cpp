#include "host_sim/verbs/today.hpp"

#include <CLI/CLI.hpp>
#include <chrono>

namespace host_sim {

fleet::Date today_of(const std::string& text) {
  if (text.empty()) {
    return std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  }
  const auto date = fleet::parse_date(text);
  if (!date) {
    throw CLI::ValidationError(
        "--today", "'" + text + "' is none; accepted: " + std::string(fleet::kDateAccepted));
  }
  return *date;
}

}  // namespace host_sim
