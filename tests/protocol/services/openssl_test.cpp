// The same as an independent implementation, on random input.
#include <gtest/gtest.h>
#include <openssl/core_names.h>
#include <openssl/evp.h>

#include <algorithm>
#include <memory>
#include <random>

#include "firmware/protocol/authority/gate.hpp"
#include "tests/protocol/services/bytes.hpp"

namespace protocol::authority {
namespace {

using protocol::testing::Bytes;
using protocol::testing::operator+;

const unsigned char* raw(std::span<const std::byte> bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

Block openssl_encrypt(const Key& key, const Block& plain) {
  const std::unique_ptr<EVP_CIPHER_CTX, decltype(&EVP_CIPHER_CTX_free)> context(
      EVP_CIPHER_CTX_new(), &EVP_CIPHER_CTX_free);
  Block result{};
  int size = 0;
  EXPECT_EQ(EVP_EncryptInit_ex(context.get(), EVP_aes_128_ecb(), nullptr, raw(key), nullptr), 1);
  EXPECT_EQ(EVP_CIPHER_CTX_set_padding(context.get(), 0), 1);
  EXPECT_EQ(EVP_EncryptUpdate(context.get(), reinterpret_cast<unsigned char*>(result.data()), &size,
                              raw(plain), 16),
            1);
  EXPECT_EQ(size, 16);
  return result;
}

Block openssl_cmac(const Key& key, const Bytes& message) {
  const std::unique_ptr<EVP_MAC, decltype(&EVP_MAC_free)> algorithm(
      EVP_MAC_fetch(nullptr, "CMAC", nullptr), &EVP_MAC_free);
  const std::unique_ptr<EVP_MAC_CTX, decltype(&EVP_MAC_CTX_free)> context(
      EVP_MAC_CTX_new(algorithm.get()), &EVP_MAC_CTX_free);
  std::string cipher = "AES-128-CBC";
  const OSSL_PARAM parameters[] = {
      OSSL_PARAM_construct_utf8_string(OSSL_MAC_PARAM_CIPHER, cipher.data(), 0),
      OSSL_PARAM_construct_end()};
  Block result{};
  std::size_t size = 0;
  EXPECT_EQ(EVP_MAC_init(context.get(), raw(key), key.size(), parameters), 1);
  EXPECT_EQ(EVP_MAC_update(context.get(), raw(message), message.size()), 1);
  EXPECT_EQ(EVP_MAC_final(context.get(), reinterpret_cast<unsigned char*>(result.data()), &size,
                          result.size()),
            1);
  EXPECT_EQ(size, result.size());
  return result;
}

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  Bytes bytes(std::size_t size) {
    Bytes result(size);
    std::generate(result.begin(), result.end(),
                  [this] { return static_cast<std::byte>(engine_()); });
    return result;
  }
  Block block() {
    Block result{};
    std::ranges::copy(bytes(result.size()), result.begin());
    return result;
  }

 private:
  std::mt19937 engine_;
};

TEST(AgainstOpenssl, Cipher) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Key key = random.block();
    const Block plain = random.block();
    ASSERT_EQ(Aes(key).encrypt(plain), openssl_encrypt(key, plain)) << i;
  }
}

TEST(AgainstOpenssl, CodeOfEveryLength) {
  Random random(2);
  for (std::size_t size = 0; size < 300; ++size) {
    const Key key = random.block();
    const Bytes message = random.bytes(size);
    Cmac cmac(key);
    cmac.add(message);
    ASSERT_EQ(cmac.finish(), openssl_cmac(key, message)) << size;
  }
}

TEST(AgainstOpenssl, CommandsWithLongArguments) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Key key = random.block();
    const Nonce nonce = random.block();
    const Bytes arguments = random.bytes(85);
    const Mac code =
        mac(key, 127, {.routine = 0x0202, .arguments = arguments, .storage_counter = 0x89abcdef},
            nonce);
    const Bytes message = testing::hex("544c4131 7f 0202 55") + testing::to_bytes(nonce) +
                          testing::hex("efcdab89") + arguments;
    const Block whole = openssl_cmac(key, message);
    ASSERT_TRUE(std::equal(code.begin(), code.end(), whole.begin())) << i;
  }
}

TEST(AgainstOpenssl, CommandsWithWhatWasTransferred) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Key key = random.block();
    const Nonce nonce = random.block();
    const Bytes arguments = random.bytes(1);
    const Bytes transferred = random.bytes(84 + 4 * static_cast<std::size_t>(i));
    const Mac code = mac(key, 5,
                         {.routine = 0x0203,
                          .arguments = arguments,
                          .transferred = transferred,
                          .storage_counter = 0x89abcdef},
                         nonce);
    const Bytes message = testing::hex("544c4131 05 0203 01") + testing::to_bytes(nonce) +
                          testing::hex("efcdab89") + arguments + transferred;
    const Block whole = openssl_cmac(key, message);
    ASSERT_TRUE(std::equal(code.begin(), code.end(), whole.begin())) << i;
  }
}

}  // namespace
}  // namespace protocol::authority
