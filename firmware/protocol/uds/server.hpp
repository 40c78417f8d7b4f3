#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/protocol/authority/gate.hpp"
#include "firmware/protocol/isotp/link.hpp"
#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/uds/data.hpp"
#include "firmware/protocol/uds/device.hpp"
#include "firmware/protocol/uds/nrc.hpp"
#include "firmware/protocol/uds/reader.hpp"
#include "firmware/protocol/uds/starter.hpp"
#include "firmware/protocol/uds/table.hpp"
#include "firmware/protocol/uds/transfer.hpp"
#include "hal/can_frame.hpp"
#include "hal/clock.hpp"

namespace protocol::uds {

inline constexpr std::uint8_t kTesterPresent = 0x3e;
inline constexpr std::uint8_t kNegativeResponse = 0x7f;
inline constexpr std::size_t kNegativeBytes = 3;
/// The longest answer but for data that are read.
inline constexpr std::size_t kShortAnswerBytes = 4;

/// A server of the Unified Diagnostic Services (ISO 14229-1) in its default session:
/// ReadDataByIdentifier, RoutineControl (startRoutine), the transfer of a parameter block, and
/// TesterPresent. table.hpp has what can be
/// read and started, authority/ who may start it. Requests come to one node; the frame plan has no
/// functional address.
template <Device DeviceT>
class Server {
 public:
  Server(DeviceT& device, Node node, const authority::Key& key)
      : gate_(node, key),
        reader_(device, gate_),
        starter_(device, gate_, transfer_),
        device_(device) {}
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Takes up the failures that are in the log. Before all else.
  void start(hal::Time now) { starter_.start(now); }

  /// Answers a request; gives the length of the answer, 0 where there is none.
  /// @pre `response` has at least kShortAnswerBytes
  std::size_t handle(std::span<const std::byte> request, hal::Time now,
                     std::span<std::byte> response) {
    if (request.empty()) {
      return 0;
    }
    Answer answer(response);
    const Nrc nrc = dispatch(request, now, answer);
    return nrc == Nrc::none ? answer.size() : refuse(request[0], nrc, response);
  }

  /// A request was too long for its link.
  void refuse_transfer() { starter_.refuse_transfer(); }

  [[nodiscard]] AuthorityCounts counts() const { return starter_.counts(); }
  [[nodiscard]] const authority::Gate& gate() const { return gate_; }

 private:
  Nrc dispatch(std::span<const std::byte> request, hal::Time now, Answer& answer) {
    switch (static_cast<std::uint8_t>(request[0])) {
      case kReadData:
        return reader_.handle(request, now, counts(), answer);
      case kRoutineControl:
        return starter_.handle(request, now, answer);
      case kRequestDownload:
        return gate_.enabled() ? transfer_.request(request, device_.tendons(), answer)
                               : Nrc::security_access_denied;
      case kTransferData:
        return transfer_.take(request, answer);
      case kTransferExit:
        return transfer_.exit(request, answer);
      case kTesterPresent:
        return tester_present(request, answer);
      default:
        return Nrc::service_not_supported;
    }
  }

  static Nrc tester_present(std::span<const std::byte> request, Answer& answer) {
    if (request.size() < 2) {
      return Nrc::wrong_length;
    }
    const auto sub_function = static_cast<std::uint8_t>(request[1]);
    if ((sub_function & ~kSuppress) != 0) {
      return Nrc::sub_function_not_supported;
    }
    if (request.size() != 2) {
      return Nrc::wrong_length;
    }
    if (sub_function == 0) {
      answer.u8(kTesterPresent + kPositive);
      answer.u8(0);
    }
    return Nrc::none;
  }

  static std::size_t refuse(std::byte service, Nrc nrc, std::span<std::byte> response) {
    response[0] = std::byte{kNegativeResponse};
    response[1] = service;
    response[2] = static_cast<std::byte>(nrc);
    return kNegativeBytes;
  }

  authority::Gate gate_;
  Transfer transfer_;
  Reader<DeviceT> reader_;
  Starter<DeviceT> starter_;
  DeviceT& device_;
};

/// The server of a node on the bus.
///
///   endpoint.start(now);              // once
///   endpoint.on_frame(frame, now);    // each frame that was received
///   endpoint.poll(now);               // at leisure: answers a request that is whole
///   endpoint.next_frame(now);         // when the node may send one, and keeps it until it is sent
template <Device DeviceT>
class Endpoint {
 public:
  using Link = isotp::Link<kMostMessageBytes>;

  Endpoint(DeviceT& device, Node node, const authority::Key& key)
      : link_(isotp::Address::to_tester(node)), server_(device, node, key) {}

  void start(hal::Time now) { server_.start(now); }

  void on_frame(const hal::CanFrame& frame, hal::Time now) { link_.on_frame(frame, now); }
  [[nodiscard]] bool ready(hal::Time now) const { return link_.ready(now); }
  [[nodiscard]] std::optional<hal::CanFrame> next_frame(hal::Time now) {
    return link_.next_frame(now);
  }

  /// Takes as long as what the device is asked to do.
  void poll(hal::Time now) {
    if (link_.counts().oversized != oversized_) {
      oversized_ = link_.counts().oversized;
      server_.refuse_transfer();
    }
    if (link_.sending() || link_.received().empty()) {
      return;
    }
    std::array<std::byte, kMostMessageBytes> response{};
    const std::size_t size = server_.handle(link_.received(), now, response);
    link_.clear();
    if (size != 0) {
      // Neither busy nor too long, so it is taken.
      (void)link_.send(std::span(response).first(size));
    }
  }

  [[nodiscard]] const isotp::Counts& counts() const { return link_.counts(); }
  [[nodiscard]] const Server<DeviceT>& server() const { return server_; }

 private:
  Link link_;
  Server<DeviceT> server_;
  std::uint32_t oversized_ = 0;
};

}  // namespace protocol::uds
