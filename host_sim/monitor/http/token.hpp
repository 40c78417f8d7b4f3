#pragma once

#include <string>
#include <string_view>

namespace host_sim::monitor {

/// Takes the same time wherever the texts differ first.
bool equal_in_constant_time(std::string_view one, std::string_view other);

/// The value of a cookie in a Cookie header; empty without it.
std::string_view cookie_of(std::string_view header, std::string_view name);

/// A token is 16 to 256 letters, digits and `-._~+/=`, so that it may stand in a header and cookie.
/// @throws InputError
void check_token(std::string_view token);

}  // namespace host_sim::monitor
