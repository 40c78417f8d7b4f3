#include "hal/linux/loop.hpp"

#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>

namespace hal::linux_os {

std::string lock_memory() {
  ::mallopt(M_TRIM_THRESHOLD, -1);
  ::mallopt(M_MMAP_MAX, 0);
  if (::mlockall(MCL_CURRENT) == 0) {
    return {};
  }
  return std::string("memory cannot be locked: ") + std::strerror(errno) +
         " (needs CAP_IPC_LOCK or a larger LimitMEMLOCK)";
}

std::string schedule_fifo(int priority) {
  ::sched_param parameter{};
  parameter.sched_priority = priority;
  const int error = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameter);
  if (error == 0) {
    return {};
  }
  return "SCHED_FIFO at priority " + std::to_string(priority) +
         " is refused: " + std::strerror(error) + " (needs CAP_SYS_NICE or LimitRTPRIO)";
}

void schedule_normally() {
  const ::sched_param parameter{};
  ::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &parameter);
}

}  // namespace hal::linux_os
