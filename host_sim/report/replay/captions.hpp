#pragma once

#include <string>
#include <string_view>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// What the replay found, in one sentence for people (plain text, UTF-8).
[[nodiscard]] std::string verdict(const ReplayReport& report);

}  // namespace host_sim

/// The sentences under the headings of the page: plain text, not yet escaped.
namespace host_sim::captions {

[[nodiscard]] std::string origin(const ReplayReport& report);
[[nodiscard]] std::string tension(const ReplayReport& report);
[[nodiscard]] std::string range_mean(const ReplayReport& report);
[[nodiscard]] std::string trajectory(const ReplayReport& report);
[[nodiscard]] std::string life(const ReplayReport& report);
[[nodiscard]] std::string reference(const ReplayReport& report);
[[nodiscard]] std::string constants(const ReplayReport& report);
[[nodiscard]] std::string footer(const ReplayReport& report);

}  // namespace host_sim::captions
