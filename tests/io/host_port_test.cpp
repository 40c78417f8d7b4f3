#include "host_sim/io/host_port.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace {

using host_sim::host_port_of;
using host_sim::HostPort;

TEST(HostPort, HasAPortWhereItIsTold) {
  struct Case {
    std::string text;
    std::string host;
    std::optional<std::uint16_t> port;
  };
  const std::array cases = {Case{"localhost", "localhost", {}},
                            Case{"127.0.0.1:8080", "127.0.0.1", 8080},
                            Case{"h:0", "h", 0},
                            Case{"h:65535", "h", 65535},
                            Case{"[::1]", "::1", {}},
                            Case{"[fe80::1%eth0]:1", "fe80::1%eth0", 1}};
  for (const Case& one : cases) {
    const std::optional<HostPort> found = host_port_of(one.text);
    ASSERT_TRUE(found) << one.text;
    EXPECT_EQ(found->host, one.host);
    EXPECT_EQ(found->port, one.port) << one.text;
  }
}

TEST(HostPort, IsNothingElse) {
  for (const char* text : {"", ":", ":80", "h:", "h:65536", "h:-1", "h:+1", "h: 1", "h:1x", "h:1:2",
                           "::1", "::1:80", "[", "[]", "[]:80", "[::1", "[::1]80", "[::1]x:80"}) {
    EXPECT_FALSE(host_port_of(text)) << text;
  }
}

}  // namespace
