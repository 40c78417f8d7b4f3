#pragma once

#include <cstdint>

#include "firmware/protocol/authority/gate.hpp"
#include "firmware/storage/store.hpp"

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
  transfer_data_suspended = 0x71,
  programming_failure = 0x72,  ///< generalProgrammingFailure
  wrong_block_sequence_counter = 0x73,
};

/// The line of the log for a verdict.
constexpr storage::Event event_of(authority::Verdict verdict) {
  switch (verdict) {
    case authority::Verdict::disabled:
      return storage::Event::disabled;
    case authority::Verdict::locked_out:
      return storage::Event::locked_out;
    case authority::Verdict::nonce_used:
      return storage::Event::nonce_reused;
    case authority::Verdict::nonce_expired:
      return storage::Event::nonce_expired;
    case authority::Verdict::wrong_counter:
      return storage::Event::counter_rolled_back;
    case authority::Verdict::granted:
    case authority::Verdict::wrong_mac:
      break;
  }
  return storage::Event::wrong_mac;
}

/// The answer for a verdict.
constexpr Nrc nrc_of(authority::Verdict verdict) {
  switch (verdict) {
    case authority::Verdict::granted:
      return Nrc::none;
    case authority::Verdict::disabled:
      return Nrc::security_access_denied;
    case authority::Verdict::locked_out:
      return Nrc::time_delay_not_expired;
    case authority::Verdict::nonce_used:
    case authority::Verdict::nonce_expired:
      return Nrc::request_sequence_error;
    case authority::Verdict::wrong_counter:
      return Nrc::conditions_not_correct;
    case authority::Verdict::wrong_mac:
      break;
  }
  return Nrc::invalid_key;
}

}  // namespace protocol::uds
