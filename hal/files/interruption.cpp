#include "hal/files/interruption.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>

namespace hal::files {
namespace {

// timeout(1) sends its signal to the program and to its group: one wish to stop, sent twice.
constexpr std::int64_t kOneWish_ns = 500'000'000;
constexpr std::int64_t kNever = 0;

std::atomic<std::int64_t> asked_at_ns{kNever};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

/// Of a pipe that can be read from once it was asked: a signal before a call blocks is seen in it.
std::array<int, 2> wish{-1, -1};

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

extern "C" void note_interruption(int signal) {
  const std::int64_t now = now_ns();
  std::int64_t first = kNever;
  if (asked_at_ns.compare_exchange_strong(first, now)) {
    const int before = errno;
    static_cast<void>(!::write(wish[1], "", 1));
    errno = before;
    return;
  }
  if (now - first < kOneWish_ns) {
    return;
  }
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

constexpr int kNone = -1;
constexpr int kForEver = -1;

void wait(int descriptor, short events, int most_ms) {
  std::array<pollfd, 2> polled{pollfd{descriptor, events, 0}, pollfd{wish[0], POLLIN, 0}};
  while (::poll(polled.data(), polled.size(), most_ms) < 0) {
    if (errno != EINTR) {
      return;  // whoever reads or writes finds out
    }
  }
  if (polled[0].revents == 0) {
    stop_if_interrupted();
  }
}

}  // namespace

void watch_for_interruption() {
  if (wish[0] < 0 && ::pipe2(wish.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    throw std::runtime_error("no descriptors are left");
  }
  struct sigaction action {};
  action.sa_handler = note_interruption;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (signal != SIGHUP || before.sa_handler != SIG_IGN) {
      sigaction(signal, &action, nullptr);
    }
  }
  for (const int signal : {SIGPIPE, SIGXFSZ}) {
    ::signal(signal, SIG_IGN);
  }
}

void stop_if_interrupted() {
  if (asked_at_ns != kNever) {
    throw Interruption();
  }
}

void wait_to_read(int descriptor) {
  wait(descriptor, POLLIN, kForEver);
}

void wait_to_write(int descriptor) {
  wait(descriptor, POLLOUT, kForEver);
}

void wait_for(std::chrono::milliseconds time) {
  wait(kNone, 0, static_cast<int>(time.count()));
}

}  // namespace hal::files
