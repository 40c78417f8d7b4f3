// The datagrams of sd_notify(3).

#include "hal/linux/service_manager.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <cstddef>
#include <string>

#include "tests/io/support.hpp"

namespace hal::linux_os {
namespace {

class Manager : public testing::Test {
 protected:
  void listen(const std::string& path) {
    listener_ = Descriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0));
    ::sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, path.size());
    if (path.front() == '@') {
      address.sun_path[0] = '\0';
    }
    ASSERT_EQ(::bind(listener_.get(), reinterpret_cast<::sockaddr*>(&address),
                     static_cast<socklen_t>(offsetof(::sockaddr_un, sun_path) + path.size())),
              0);
  }
  std::string heard() {
    std::array<char, 256> text{};
    const ssize_t size = ::recv(listener_.get(), text.data(), text.size(), 0);
    return size < 0 ? std::string() : std::string(text.data(), static_cast<std::size_t>(size));
  }

  host_sim::test::TemporaryFolder folder_;
  Descriptor listener_;
};

TEST_F(Manager, HearsOfStartAndEnd) {
  const std::string path = (folder_ / "notify").string();
  listen(path);
  ServiceManager manager(path);
  manager.ready("controlling");
  EXPECT_EQ(heard(), "READY=1\nSTATUS=controlling");
  manager.stopping();
  EXPECT_EQ(heard(), "STOPPING=1");
}

TEST_F(Manager, AnAbstractNameBeginsWithAnAt) {
  const std::string name = "@tendonlife-test-" + std::to_string(::getpid());
  listen(name);
  ServiceManager(name).stopping();
  EXPECT_EQ(heard(), "STOPPING=1");
}

TEST_F(Manager, TheWatchdogIsFedFourTimesWithinItsTime) {
  const std::string path = (folder_ / "notify").string();
  listen(path);
  ServiceManager manager(path, milliseconds(400));
  int fed = 0;
  for (std::uint64_t ms = 0; ms < 400; ++ms) {
    manager.alive(milliseconds(ms));
    const std::string text = heard();
    EXPECT_TRUE(text.empty() || text == "WATCHDOG=1");
    fed += text.empty() ? 0 : 1;
  }
  EXPECT_EQ(fed, 4);
}

TEST_F(Manager, WithoutAWatchdogOrAManagerNothingHappens) {
  const std::string path = (folder_ / "notify").string();
  listen(path);
  ServiceManager(path).alive(seconds(5));
  EXPECT_EQ(heard(), "");
  ServiceManager nobody("");
  nobody.ready("x");
  ServiceManager deaf((folder_ / "missing").string());
  deaf.ready("x");
}

}  // namespace
}  // namespace hal::linux_os
