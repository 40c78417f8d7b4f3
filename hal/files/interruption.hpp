#pragma once

#include <chrono>
#include <stdexcept>

namespace hal::files {

/// The user has asked the program to stop.
class Interruption : public std::runtime_error {
 public:
  Interruption() : std::runtime_error("interrupted; no output was written") {}
};

/// Lets SIGINT, SIGTERM and SIGHUP (unless it is ignored: nohup) be noticed by the functions below
/// instead of ending the program at once, so that files half-written are removed. A signal half a
/// second after the first or later ends it at once. What SIGPIPE and SIGXFSZ would end fails to
/// write instead.
void watch_for_interruption();

/// @throws Interruption after such a signal
void stop_if_interrupted();

/// Waits until reading, or writing of PIPE_BUF bytes, would not block; so that no signal is lost in
/// a call that does. In whatever thread.
/// @throws Interruption after such a signal, and with one, where it would
void wait_to_read(int descriptor);
void wait_to_write(int descriptor);

/// The same as sleeping.
void wait_for(std::chrono::milliseconds time);

}  // namespace hal::files
