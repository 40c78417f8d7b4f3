#pragma once

#include <string>

namespace hal::linux_os {

/// Locks all memory, now and later, so that no page fault delays a loop (mlockall(2)). Gives an
/// empty text, or what went wrong and what would help.
std::string lock_memory();

/// Puts the calling thread under SCHED_FIFO (sched(7)). Gives an empty text, or what went wrong and
/// what would help. Precondition: 1 <= priority <= 99.
std::string schedule_fifo(int priority);

/// Puts the calling thread under SCHED_OTHER; threads that it started keep theirs.
void schedule_normally();

}  // namespace hal::linux_os
