#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firmware/storage/life_record.hpp"
#include "hal/can_port.hpp"
#include "hal/error.hpp"
#include "hal/linux/loop.hpp"
#include "hal/linux/socketcan.hpp"

namespace boards::linux_controller {

/// How a run ended.
struct Report {
  unsigned node = 0;
  std::uint64_t periods = 0;  ///< of the control loop
  std::uint64_t missed_deadlines = 0;
  std::uint64_t p99_jitter_us = 0;
  std::uint64_t worst_jitter_us = 0;
  std::vector<storage::LifeRecord> lives;  ///< one a tendon, as they were saved
  hal::Error saved = hal::Error::none;
  std::string store_problem;  ///< why the last save failed
  std::uint32_t sequence = 0;
  std::uint32_t worst_unsaved_ppb = 0;
  hal::CanStatus bus;
  hal::linux_os::SocketCanCounts counts;  ///< zeros without a bus
};

/// The report as JSON, ending in a line end.
std::string to_json(const Report& report);

/// The same for people, one line a tendon.
std::string to_text(const Report& report);

}  // namespace boards::linux_controller
