#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace protocol::generate {

/// `count` times a decimal without exponent, exactly, as such a decimal.
std::string times(std::uint32_t count, std::string_view decimal);

/// The decimal as people read it: 0.000000001 is 1e-9.
std::string readable(std::string_view decimal);

}  // namespace protocol::generate
