#include "host_sim/monitor/http/gate.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hal/files/input_error.hpp"

namespace host_sim::monitor {

using hal::files::InputError;

namespace {

const std::string kToken = "0123456789abcdef";

TEST(Address, ReadsHostAndPort) {
  EXPECT_EQ(parse_address("127.0.0.1:8080").host, "127.0.0.1");
  EXPECT_EQ(parse_address("127.0.0.1:8080").port, 8080);
  EXPECT_EQ(parse_address("[::1]:65535").host, "::1");
  EXPECT_EQ(parse_address("[::1]:65535").port, 65535);
  EXPECT_EQ(parse_address("localhost:0").text(), "localhost:0");
  EXPECT_EQ(parse_address("[::1]:80").text(), "[::1]:80");
}

TEST(Address, RefusesWhatIsNone) {
  for (const char* text :
       {"", "8080", ":8080", "127.0.0.1", "127.0.0.1:", "127.0.0.1:65536", "127.0.0.1:-1",
        "127.0.0.1:80x", "::1:80", "[::1]", "[::1]80", "[]:80"}) {
    EXPECT_THROW(parse_address(text), InputError) << text;
  }
}

TEST(Address, KnowsLoopback) {
  for (const char* host : {"127.0.0.1", "127.9.8.7", "::1", "localhost"}) {
    EXPECT_TRUE(is_loopback(host)) << host;
  }
  for (const char* host : {"0.0.0.0", "::", "192.168.1.2", "128.0.0.1", "localhost.evil.org",
                           "127.0.0.1.evil.org", ""}) {
    EXPECT_FALSE(is_loopback(host)) << host;
  }
}

TEST(Address, KnowsLoopbackInAHostHeader) {
  for (const char* header : {"127.0.0.1:8080", "localhost", "localhost:1", "[::1]:8080", "[::1]"}) {
    EXPECT_TRUE(is_loopback_header(header)) << header;
  }
  for (const char* header :
       {"evil.org", "evil.org:8080", "127.0.0.1.evil.org", "", "[::1", "::1"}) {
    EXPECT_FALSE(is_loopback_header(header)) << header;
  }
}

TEST(Token, IsEqualOnlyToItself) {
  EXPECT_TRUE(equal_in_constant_time(kToken, kToken));
  EXPECT_FALSE(equal_in_constant_time("", kToken));
  EXPECT_FALSE(equal_in_constant_time(kToken, ""));
  EXPECT_FALSE(equal_in_constant_time(kToken + kToken, kToken));
  EXPECT_FALSE(equal_in_constant_time(kToken.substr(1), kToken));
  for (std::size_t i = 0; i < kToken.size(); ++i) {
    std::string other = kToken;
    other[i] = 'x';
    EXPECT_FALSE(equal_in_constant_time(other, kToken)) << i;
  }
}

TEST(Token, IsFoundAmongCookies) {
  EXPECT_EQ(cookie_of("a=1; b=2;c=3", "a"), "1");
  EXPECT_EQ(cookie_of("a=1; b=2;c=3", "b"), "2");
  EXPECT_EQ(cookie_of("a=1; b=2;c=3", "c"), "3");
  EXPECT_EQ(cookie_of("aa=1; ba=2", "a"), "");
  EXPECT_EQ(cookie_of("a=x=y", "a"), "x=y");
  EXPECT_EQ(cookie_of("; ;a", "a"), "");
  EXPECT_EQ(cookie_of("", "a"), "");
}

TEST(Token, IsLongAndPlain) {
  EXPECT_NO_THROW(check_token(kToken));
  EXPECT_THROW(check_token(kToken.substr(1)), InputError);
  EXPECT_THROW(check_token(std::string(257, 'a')), InputError);
  for (const char* end : {" ", ";", "\n", "\"", ",", "\x80"}) {
    EXPECT_THROW(check_token(kToken + end), InputError) << end;
  }
}

TEST(Gate, NeedsATokenOffLoopback) {
  EXPECT_THROW(Gate({"0.0.0.0", 80}, {}), InputError);
  EXPECT_THROW(Gate({"::", 80}, {}), InputError);
  EXPECT_THROW(Gate({"robot.local", 80}, {}), InputError);
  EXPECT_NO_THROW(Gate({"0.0.0.0", 80}, kToken));
  EXPECT_NO_THROW(Gate({"127.0.0.1", 80}, {}));
}

TEST(Gate, OnLoopbackAnswersToItsNameAlone) {
  const Gate gate({"127.0.0.1", 80}, {});
  EXPECT_EQ(gate.ask({.host = "127.0.0.1:80"}), Gate::Answer::open);
  EXPECT_EQ(gate.ask({.host = "evil.org:80"}), Gate::Answer::wrong_host);
  EXPECT_EQ(gate.ask({}), Gate::Answer::wrong_host);
}

TEST(Gate, TakesTheTokenByHeaderCookieAndQuery) {
  Gate gate({"0.0.0.0", 0}, kToken);
  gate.listens_at(8080);
  EXPECT_EQ(gate.ask({.authorization = "Bearer " + kToken}), Gate::Answer::open);
  EXPECT_EQ(gate.ask({.cookie = "tendonlife_8080=" + kToken}), Gate::Answer::open);
  EXPECT_EQ(gate.ask({.query_token = kToken}), Gate::Answer::open_by_query);
  EXPECT_EQ(gate.ask({}), Gate::Answer::no_token);
  EXPECT_EQ(gate.ask({.host = "127.0.0.1"}), Gate::Answer::no_token);
  EXPECT_EQ(gate.ask({.authorization = kToken}), Gate::Answer::no_token);
  EXPECT_EQ(gate.ask({.authorization = "Bearer "}), Gate::Answer::no_token);
  EXPECT_EQ(gate.ask({.cookie = "tendonlife_8081=" + kToken}), Gate::Answer::no_token);
  EXPECT_EQ(gate.ask({.query_token = kToken + "0"}), Gate::Answer::no_token);
  EXPECT_EQ(gate.set_cookie(), "tendonlife_8080=" + kToken + "; Path=/; HttpOnly; SameSite=Lax");
}

}  // namespace
}  // namespace host_sim::monitor
