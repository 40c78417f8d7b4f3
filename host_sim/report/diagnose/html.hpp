#pragma once

#include <iosfwd>
#include <string_view>

#include "host_sim/diagnose/diagnosis.hpp"

namespace host_sim {

/// Writes one self-contained HTML page: no network, no other file. Equal diagnoses give equal
/// bytes. What could not be computed is said in words. Bytes of names that are not UTF-8 become
/// U+FFFD. The state of `out` says whether writing succeeded.
void write_diagnose_report(std::ostream& out, std::string_view campaign,
                           const diagnose::Diagnosis& diagnosis, std::string_view program_version);

}  // namespace host_sim
