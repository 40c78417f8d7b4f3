// Any stream of requests at a server; without the key nothing of the node changes, and every
// request has a well-formed answer. Some requests are signed, so that what lies behind the code is
// reached.
//
// Input: one request after another. Each begins with a byte: how many bytes follow in the low 7
// bits. Its high bit says that the last 12 bytes of a start request are replaced by the counter
// and a valid code over what was asked; then, and only then, may something change.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "firmware/protocol/uds/server.hpp"
#include "tests/protocol/services/model_device.hpp"

namespace {

using protocol::testing::ModelDevice;
using protocol::testing::ModelLife;
namespace authority = protocol::authority;
namespace uds = protocol::uds;

constexpr protocol::Node kNode = 5;
constexpr authority::Key kKey{std::byte{1}, std::byte{2}};
constexpr std::size_t kHead = uds::kRoutineHeadBytes;

using Message = std::array<std::byte, uds::kMostMessageBytes>;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

class Session {
 public:
  Session() { server_.start(now_); }

  void ask(std::span<std::byte> request, bool sign) {
    now_ = now_ + hal::milliseconds(300);
    const bool is_signed = sign && request.size() >= kHead + uds::kProofBytes;
    if (is_signed) {
      put_proof(request);
    }
    const ModelLife before = device_.life;
    const std::size_t lines = device_.lines.size();
    const std::size_t size = server_.handle(request, now_, response_);
    require_answer(request, size);
    note_transfer(request, size);
    require(device_.lines.size() <= lines + 2);
    require_lifetime(before);
    if (!is_signed) {
      require(device_.life == before);
    }
    if (device_.life != before) {
      require(device_.lines.size() == lines + 1);
      require(server_.gate().failures() == 0);
    }
  }

 private:
  void put_proof(std::span<std::byte> request) {
    std::array<std::byte, 3> read{std::byte{0x22}, std::byte{0x02}, std::byte{0x41}};
    require(server_.handle(read, now_, response_) == 19);
    authority::Nonce nonce{};
    std::copy_n(response_.begin() + 3, nonce.size(), nonce.begin());
    const auto proof = request.last(uds::kProofBytes);
    const std::uint32_t counter = device_.storage_counter();
    lifemodel::ByteWriter(proof).u32(counter);
    const auto routine = static_cast<std::uint16_t>((static_cast<unsigned>(request[2]) << 8) |
                                                    static_cast<unsigned>(request[3]));
    const auto code = authority::mac(
        kKey, kNode,
        {.routine = routine,
         .arguments = request.subspan(kHead, request.size() - kHead - uds::kProofBytes),
         .transferred = routine == uds::kLoadTransferred.routine
                            ? std::span<const std::byte>(transferred_)
                            : std::span<const std::byte>{},
         .storage_counter = counter},
        nonce);
    std::ranges::copy(code, proof.begin() + 4);
  }

  void require_answer(std::span<const std::byte> request, std::size_t size) const {
    if (size == 0) {
      require(request.empty() || (static_cast<unsigned>(request[1]) & 0x80u) != 0);
    } else if (response_[0] == std::byte{0x7f}) {
      require(size == 3 && response_[1] == request[0] && response_[2] != std::byte{0});
    } else {
      require(size <= response_.size() && response_[0] == (request[0] | std::byte{0x40}));
    }
  }

  /// What the node must have of a block, from what it has taken.
  void note_transfer(std::span<const std::byte> request, std::size_t size) {
    if (size == 0 || response_[0] == std::byte{0x7f}) {
      return;
    }
    if (request[0] == std::byte{uds::kRequestDownload}) {
      transferred_.clear();
      part_ = std::byte{0};
    } else if (request[0] == std::byte{uds::kTransferData} &&
               (request[1] != part_ || transferred_.empty())) {
      const auto bytes = request.subspan(2);
      transferred_.insert(transferred_.end(), bytes.begin(), bytes.end());
      part_ = request[1];
      require(transferred_.size() <= lifemodel::kMostExtendedBytes);
    }
  }

  void require_lifetime(const ModelLife& before) const {
    for (std::size_t i = 0; i < before.records.size(); ++i) {
      require(device_.life.records[i].lifetime_damage == before.records[i].lifetime_damage);
      require(device_.life.records[i].epoch >= before.records[i].epoch);
    }
  }

  hal::Time now_{};
  ModelDevice device_{2};
  uds::Server<ModelDevice> server_{device_, kNode, kKey};
  Message response_{};
  std::vector<std::byte> transferred_;
  std::byte part_{};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::span data(bytes, size);
  Session session;
  while (!data.empty()) {
    const std::uint8_t head = data[0];
    data = data.subspan(1);
    Message request{};
    const std::size_t length = std::min<std::size_t>(head & 0x7fu, data.size());
    std::copy_n(std::as_bytes(data).begin(), length, request.begin());
    data = data.subspan(length);
    session.ask(std::span(request).first(length), (head & 0x80) != 0);
  }
  return 0;
}
