#include "hal/linux/real_time.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>

namespace hal::linux_os {

std::string lock_memory() {
  if (::mlockall(MCL_CURRENT | MCL_FUTURE) == 0) {
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

}  // namespace hal::linux_os
