#pragma once

#include <stdexcept>

namespace host_sim {

/// The user has asked the program to stop.
class Interruption : public std::runtime_error {
 public:
  Interruption() : std::runtime_error("interrupted; no output was written") {}
};

/// Lets SIGINT and SIGTERM be noticed by stop_if_interrupted() instead of ending the program at
/// once, so that files half-written are removed. A signal half a second after the first or later
/// ends it at once.
void watch_for_interruption();

/// @throws Interruption after such a signal
void stop_if_interrupted();

}  // namespace host_sim
