#pragma once

#include <string>

#include "host_sim/report/replay/report_data.hpp"

/// The tables of the page, as HTML with all texts escaped.
namespace host_sim::tables {

[[nodiscard]] std::string key_numbers(const ReplayReport& report);

/// The classes of the range-mean matrix that do the most damage, at most ten.
[[nodiscard]] std::string worst_classes(const RangeMeanMatrix& matrix);

[[nodiscard]] std::string reference(const ReplayReport& report);
[[nodiscard]] std::string constants(const ReplayReport& report);

}  // namespace host_sim::tables

/// Parts of the page as HTML with all texts escaped. A plot that has nothing to show becomes a
/// sentence that says why.
namespace host_sim::sections {

[[nodiscard]] std::string tiles(const ReplayReport& report);
[[nodiscard]] std::string flags(const ReplayReport& report);
[[nodiscard]] std::string wire_tiles(const ReplayReport& report);
[[nodiscard]] std::string tension_chart(const ReplayReport& report);
[[nodiscard]] std::string range_mean_chart(const ReplayReport& report);
[[nodiscard]] std::string trajectory_chart(const ReplayReport& report);
[[nodiscard]] std::string life_chart(const ReplayReport& report);

/// What lets the wire last until a date; empty where it was not asked for.
[[nodiscard]] std::string until_date(const ReplayReport& report);

}  // namespace host_sim::sections
