#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/protocol/authority/gate.hpp"
#include "firmware/protocol/uds/data.hpp"
#include "firmware/protocol/uds/device.hpp"
#include "firmware/protocol/uds/journal.hpp"
#include "firmware/protocol/uds/nrc.hpp"
#include "firmware/protocol/uds/reader.hpp"
#include "firmware/protocol/uds/table.hpp"
#include "firmware/protocol/uds/transfer.hpp"
#include "firmware/storage/store.hpp"
#include "hal/clock.hpp"
#include "hal/error.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/inlining.hpp"

namespace protocol::uds {

inline constexpr std::uint8_t kRoutineControl = 0x31;
/// Of a sub-function: no positive answer is wanted (ISO 14229-1, 8.2.2).
inline constexpr std::uint8_t kSuppress = 0x80;

/// RoutineControl, startRoutine (ISO 14229-1, 14.2), in its order of checks. Nothing changes unless
/// the command is proven, its content holds and its line is in the log.
///
///   0x31  unknown routine, no such tendon, or a parameter block that does not hold or that the
///   node
///         cannot evaluate: the data identifier kParameters says why
///   0x33  this node has no key
///   0x12  not startRoutine
///   0x13  wrong length
///   0x37  locked out
///   0x24  the nonce was used or has expired; nothing whole was transferred
///   0x35  wrong code
///   0x22  the storage counter is another, which is no failure, or the log is full
///   0x36  in place of 0x24 and 0x35, where the failure begins a lock
///   0x72  the change, or its line in the log, could not be written
template <Device DeviceT>
class Starter {
 public:
  Starter(DeviceT& device, authority::Gate& gate, Transfer& transfer)
      : device_(device), gate_(gate), transfer_(transfer), log_(device) {}

  void start(hal::Time now) { gate_.resume(log_.start(), now); }

  /// `answer` stays empty where none is wanted.
  /// @pre the request begins with kRoutineControl
  Nrc handle(std::span<const std::byte> request, hal::Time now, Answer& answer) {
    if (request.size() < kRoutineHeadBytes) {
      return refuse(Nrc::wrong_length, storage::Event::rejected, {});
    }
    Target target{.routine = static_cast<std::uint16_t>((static_cast<unsigned>(request[2]) << 8) |
                                                        static_cast<unsigned>(request[3]))};
    const auto sub_function = static_cast<std::uint8_t>(request[1]);
    const Nrc form = check_form(request, sub_function, target);
    if (form != Nrc::none) {
      return form;
    }
    const auto proof = request.last(kProofBytes);
    const auto arguments =
        request.subspan(kRoutineHeadBytes, request.size() - kRoutineHeadBytes - kProofBytes);
    const authority::Verdict verdict =
        gate_.check({.routine = target.routine,
                     .arguments = arguments,
                     .transferred = transferred(target),
                     .storage_counter = lifemodel::ByteReader(proof).u32()},
                    proof.last(authority::kMacBytes), device_.storage_counter(), now);
    if (verdict != authority::Verdict::granted) {
      const bool locks = verdict != authority::Verdict::locked_out && gate_.locked(now);
      return refuse(locks ? Nrc::exceeded_attempts : nrc_of(verdict), event_of(verdict), target);
    }
    const Nrc done = carry_out(target, arguments);
    if (done == Nrc::none && (sub_function & kSuppress) == 0) {
      answer.u8(kRoutineControl + kPositive);
      answer.u8(kStartRoutine);
      answer.identifier(target.routine);
    }
    return done;
  }

  /// A request that did not fit into its link.
  void refuse_transfer() { (void)refuse(Nrc::wrong_length, storage::Event::rejected, {}); }

  [[nodiscard]] AuthorityCounts counts() const {
    return {.granted = granted_, .refused = refused_, .unlogged = log_.unlogged()};
  }

 private:
  struct Target {
    std::uint16_t routine = 0;
    std::uint8_t tendon = 0;
  };

  Nrc check_form(std::span<const std::byte> request, std::uint8_t sub_function, Target& target) {
    const auto* row = std::find_if(
        kRoutineTable.begin(), kRoutineTable.end(),
        [&target](const RoutineRow& candidate) { return candidate.routine == target.routine; });
    if (row == kRoutineTable.end()) {
      return refuse(Nrc::request_out_of_range, storage::Event::rejected, target);
    }
    if (!gate_.enabled()) {
      return refuse(Nrc::security_access_denied, storage::Event::disabled, target);
    }
    if ((sub_function & ~kSuppress) != kStartRoutine) {
      return refuse(Nrc::sub_function_not_supported, storage::Event::rejected, target);
    }
    if (request.size() < kRoutineHeadBytes + kProofBytes ||
        !row->takes(request.size() - kRoutineHeadBytes - kProofBytes)) {
      return refuse(Nrc::wrong_length, storage::Event::rejected, target);
    }
    const auto tendon = static_cast<std::uint8_t>(request[kRoutineHeadBytes]);
    if (tendon >= device_.tendons()) {
      return refuse(Nrc::request_out_of_range, storage::Event::rejected, target);
    }
    target.tendon = tendon;
    if (target.routine == kLoadTransferred.routine && transferred(target).empty()) {
      return refuse(Nrc::request_sequence_error, storage::Event::rejected, target);
    }
    return Nrc::none;
  }

  Nrc carry_out(const Target& target, std::span<const std::byte> arguments) {
    if (target.routine == kOpenEpoch.routine) {
      return under_log(storage::Event::epoch_opened, target, device_.configuration(target.tendon),
                       [&] { return device_.open_epoch(target.tendon); });
    }
    const bool by_transfer = target.routine == kLoadTransferred.routine;
    const Nrc done = load(target, by_transfer ? transferred(target) : arguments.subspan(1));
    if (by_transfer) {
      transfer_.clear();
    }
    return done;
  }

  /// What was transferred for a routine that takes it.
  [[nodiscard]] std::span<const std::byte> transferred(const Target& target) const {
    return target.routine == kLoadTransferred.routine ? transfer_.block(target.tendon)
                                                      : std::span<const std::byte>{};
  }

  Nrc load(const Target& target, std::span<const std::byte> bytes) {
    const std::uint32_t crc = lifemodel::ByteReader(bytes.last(4)).u32();
    if (!holds(target, bytes, crc)) {
      return refuse(Nrc::request_out_of_range, storage::Event::parameters_refused, target, crc);
    }
    return under_log(storage::Event::parameters_loaded, target, crc, [&] {
      return device_.load_parameters(target.tendon, lifemodel::ExtendedBlock(bytes));
    });
  }

  /// Whether the node can count with a block.
  LIFEMODEL_ONE_COPY bool holds(const Target& target, std::span<const std::byte> bytes,
                                std::uint32_t crc) {
    lifemodel::ExtendedParameters model{};
    const auto error = lifemodel::read_extended(bytes, model);
    if (error.refuses()) {
      device_.refuse_parameters(target.tendon, error, crc);
      return false;
    }
    return device_.accepts(target.tendon, model, crc);
  }

  /// Does it once its line is in the log.
  template <class Deed>
  Nrc under_log(storage::Event event, const Target& target, std::uint32_t configuration,
                Deed deed) {
    const hal::Error logged = log_.about_to(event, target.tendon, configuration);
    if (logged != hal::Error::none) {
      count(refused_);
      return logged == hal::Error::full ? Nrc::conditions_not_correct : Nrc::programming_failure;
    }
    if (deed() != hal::Error::none) {
      count(refused_);
      log_.not_done(target.tendon, target.routine);
      return Nrc::programming_failure;
    }
    count(granted_);
    return Nrc::none;
  }

  Nrc refuse(Nrc nrc, storage::Event event, const Target& target) {
    return refuse(nrc, event, target, target.routine);
  }
  Nrc refuse(Nrc nrc, storage::Event event, const Target& target, std::uint32_t detail) {
    count(refused_);
    log_.refused(event, target.tendon, detail);
    return nrc;
  }

  DeviceT& device_;
  authority::Gate& gate_;
  Transfer& transfer_;
  Journal<DeviceT> log_;
  std::uint32_t granted_ = 0;
  std::uint32_t refused_ = 0;
};

}  // namespace protocol::uds
