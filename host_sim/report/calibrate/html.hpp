#pragma once

#include <iosfwd>
#include <string_view>

#include "host_sim/calibrate/result.hpp"

namespace host_sim {

/// Writes one self-contained HTML page: no network, no other file. Equal results give equal bytes.
/// Every plot has its numbers in tables too; what could not be computed is said in words. Bytes of
/// names that are not UTF-8 become U+FFFD. The state of `out` shows whether writing succeeded.
void write_calibrate_report(std::ostream& out, const calibrate::CalibrateResult& result,
                            std::string_view program_version);

}  // namespace host_sim
