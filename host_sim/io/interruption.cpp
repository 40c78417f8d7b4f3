#include "host_sim/io/interruption.hpp"

#include <signal.h>
#include <time.h>

#include <atomic>
#include <cstdint>

namespace host_sim {
namespace {

// timeout(1) sends its signal to the program and to its group: one wish to stop, told twice.
constexpr std::int64_t kOneWish_ns = 500'000'000;
constexpr std::int64_t kNever = 0;

std::atomic<std::int64_t> asked_at_ns{kNever};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

extern "C" void note_interruption(int signal) {
  const std::int64_t now = now_ns();
  std::int64_t first = kNever;
  if (asked_at_ns.compare_exchange_strong(first, now) || now - first < kOneWish_ns) {
    return;
  }
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

}  // namespace

void watch_for_interruption() {
  struct sigaction action {};
  action.sa_handler = note_interruption;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM}) {
    sigaction(signal, &action, nullptr);
  }
}

void stop_if_interrupted() {
  if (asked_at_ns != kNever) {
    throw Interruption();
  }
}

}  // namespace host_sim
