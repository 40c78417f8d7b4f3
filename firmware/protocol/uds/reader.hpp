#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/protocol/authority/gate.hpp"
#include "firmware/protocol/uds/data.hpp"
#include "firmware/protocol/uds/device.hpp"
#include "firmware/protocol/uds/nrc.hpp"
#include "firmware/protocol/uds/table.hpp"
#include "hal/clock.hpp"

namespace protocol::uds {

inline constexpr std::uint8_t kReadData = 0x22;
/// Identifiers in one request at most.
inline constexpr std::size_t kMostIdentifiers = 8;

/// ReadDataByIdentifier (ISO 14229-1, 11.2). Of several identifiers, those that are not there are
/// left out of the answer.
template <Device DeviceT>
class Reader {
 public:
  Reader(DeviceT& device, authority::Gate& gate) : device_(device), gate_(gate) {}

  Nrc handle(std::span<const std::byte> request, hal::Time now, const AuthorityCounts& counts,
             Answer& answer) {
    if (request.size() < 3 || request.size() % 2 == 0 ||
        request.size() > 1 + 2 * kMostIdentifiers) {
      return Nrc::wrong_length;
    }
    answer.u8(kReadData + kPositive);
    for (std::size_t at = 1; at < request.size(); at += 2) {
      const auto identifier = static_cast<std::uint16_t>((static_cast<unsigned>(request[at]) << 8) |
                                                         static_cast<unsigned>(request[at + 1]));
      const DataRow* row = find(identifier);
      if (row == nullptr) {
        continue;
      }
      if (answer.room() < 2u + row->bytes) {
        return Nrc::response_too_long;
      }
      answer.identifier(identifier);
      const Nrc nrc = write(*row, identifier - row->first, now, counts, answer);
      if (nrc != Nrc::none) {
        return nrc;
      }
    }
    return answer.size() > 1 ? Nrc::none : Nrc::request_out_of_range;
  }

 private:
  /// The row of what is there under the identifier.
  const DataRow* find(std::uint16_t identifier) {
    for (const DataRow& row : kDataTable) {
      if (identifier >= row.first && identifier <= row.last) {
        const std::uint32_t index = identifier - row.first;
        return is_there(row, index) ? &row : nullptr;
      }
    }
    return nullptr;
  }
  bool is_there(const DataRow& row, std::uint32_t index) {
    if (row.first == kLog.first) {
      return device_.log_entry(index).has_value();
    }
    return row.first == row.last || index < device_.tendons();
  }

  Nrc write(const DataRow& row, std::uint32_t index, hal::Time now, const AuthorityCounts& counts,
            Answer& answer) {
    const auto tendon = static_cast<std::uint8_t>(index);
    switch (row.first) {
      case kLife.first:
        write_life(answer, device_.read_life(tendon));
        return Nrc::none;
      case kConfiguration.first:
        answer.u32(device_.configuration(tendon));
        return Nrc::none;
      case kParameters.first:
        write_parameters(answer, device_.parameters(tendon));
        return Nrc::none;
      case kStorageCounter.first:
        gate_.note_read(device_.storage_counter(), now);
        answer.u32(device_.storage_counter());
        return Nrc::none;
      case kNonce.first:
        return write_nonce(now, answer);
      case kAuthority.first:
        write_authority(answer, gate_, counts, now);
        return Nrc::none;
      case kLog.first:
        if (const auto entry = device_.log_entry(index)) {
          write_log(answer, *entry);
          return Nrc::none;
        }
        return Nrc::conditions_not_correct;
      case kSerial.first:
        answer.bytes(device_.identity().serial);
        return Nrc::none;
      default: {
        const Identity identity = device_.identity();
        answer.u8(identity.schema);
        answer.u8(identity.firmware);
        return Nrc::none;
      }
    }
  }

  /// A source that fails or repeats itself issues nothing.
  Nrc write_nonce(hal::Time now, Answer& answer) {
    authority::Nonce nonce{};
    if (device_.random(nonce) != hal::Error::none ||
        !gate_.issue(nonce, device_.storage_counter(), now)) {
      return Nrc::conditions_not_correct;
    }
    answer.bytes(nonce);
    return Nrc::none;
  }

  DeviceT& device_;
  authority::Gate& gate_;
};

}  // namespace protocol::uds
