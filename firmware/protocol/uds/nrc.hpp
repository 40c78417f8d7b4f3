#pragma once

#include <cstdint>

namespace protocol::uds {

/// Negative response codes (ISO 14229-1, annex A.1) that this server gives.
enum class Nrc : std::uint8_t {
  none = 0x00,
  service_not_supported = 0x11,
  sub_function_not_supported = 0x12,
  wrong_length = 0x13,  ///< incorrectMessageLengthOrInvalidFormat
  response_too_long = 0x14,
  conditions_not_correct = 0x22,
  request_sequence_error = 0x24,
  request_out_of_range = 0x31,
  security_access_denied = 0x33,
  invalid_key = 0x35,
  exceeded_attempts = 0x36,  ///< exceedNumberOfAttempts
  time_delay_not_expired = 0x37,
  programming_failure = 0x72,  ///< generalProgrammingFailure
};

}  // namespace protocol::uds
