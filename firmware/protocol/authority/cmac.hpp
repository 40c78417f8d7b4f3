#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/protocol/authority/aes.hpp"
#include "lifemodel/support/inlining.hpp"

namespace protocol::authority {

/// A block times x in GF(2^128), the first byte highest (RFC 4493, 2.3: how subkeys are made).
constexpr Block doubled(const Block& block) {
  Block result{};
  std::uint32_t carry = 0;
  for (std::size_t i = block.size(); i-- > 0;) {
    carry |= static_cast<std::uint32_t>(block[i]) << 1;
    result[i] = static_cast<std::byte>(carry);
    carry >>= 8;
  }
  result.back() ^= static_cast<std::byte>(carry * 0x87u);
  return result;
}

/// AES-CMAC (RFC 4493, NIST SP 800-38B) over bytes that come in pieces.
class Cmac {
 public:
  constexpr explicit Cmac(const Key& key) : aes_(key) {}

  LIFEMODEL_ONE_COPY constexpr void add(std::byte byte) {
    if (filled_ == last_.size()) {
      chain_ = aes_.encrypt(chained());
      filled_ = 0;
    }
    last_[filled_++] = byte;
  }
  constexpr void add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      add(byte);
    }
  }

  /// The code of all that was added. Ends its use.
  [[nodiscard]] constexpr Block finish() {
    Block subkey = doubled(aes_.encrypt(Block{}));
    if (filled_ < last_.size()) {
      subkey = doubled(subkey);
      last_[filled_++] = std::byte{0x80};
      while (filled_ < last_.size()) {
        last_[filled_++] = std::byte{0};
      }
    }
    Block input = chained();
    for (std::size_t i = 0; i < input.size(); ++i) {
      input[i] ^= subkey[i];
    }
    return aes_.encrypt(input);
  }

 private:
  [[nodiscard]] constexpr Block chained() const {
    Block result = chain_;
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] ^= last_[i];
    }
    return result;
  }

  Aes aes_;
  Block chain_{};
  Block last_{};  ///< kept back, because the last block is treated differently
  std::size_t filled_ = 0;
};

/// Whether two codes of one length are the same, in a time that does not tell where they differ.
constexpr bool equal(std::span<const std::byte> a, std::span<const std::byte> b) {
  std::byte difference{a.size() == b.size() ? std::uint8_t{0} : std::uint8_t{1}};
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    difference |= a[i] ^ b[i];
  }
  return difference == std::byte{0};
}

}  // namespace protocol::authority
