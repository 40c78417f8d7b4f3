#pragma once

#include "firmware/protocol/authority/gate.hpp"
#include "firmware/protocol/uds/nrc.hpp"
#include "firmware/storage/store.hpp"

namespace protocol::uds {

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
