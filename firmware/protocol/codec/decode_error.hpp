#pragma once

#include <cstdint>

namespace protocol {

/// Why a frame is not the message that was asked for.
enum class [[nodiscard]] DecodeError : std::uint8_t{
    other_frame,     ///< another identifier, or that of no node
    wrong_length,    ///< not the number of bytes that the frame has
    other_page,      ///< another page of the frame
    reserved_bit,    ///< a bit is set that has no meaning
    reserved_value,  ///< a value that has no meaning
};

}  // namespace protocol
