#pragma once

namespace host_sim {

/// Reads the decimal number at `position`, which must lie before `end`, correctly rounded; a
/// leading
/// `+` is accepted. Moves `position` behind it and returns true, or returns false if there is no
/// number or if a double cannot hold it. `inf` and `nan` are read as such: check the value.
bool parse_number(const char*& position, const char* end, double& value);

}  // namespace host_sim
