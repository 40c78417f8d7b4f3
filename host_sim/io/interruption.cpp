#include "host_sim/io/interruption.hpp"

#include <csignal>

namespace host_sim {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interruption(int) {
  interrupted = 1;
}

}  // namespace

void watch_for_interruption() {
  struct sigaction action {};
  action.sa_handler = note_interruption;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM}) {
    sigaction(signal, &action, nullptr);
  }
}

void stop_if_interrupted() {
  if (interrupted != 0) {
    throw Interruption();
  }
}

}  // namespace host_sim
