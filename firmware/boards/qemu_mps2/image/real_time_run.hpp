#pragma once

#include "firmware/boards/qemu_mps2/image/options.hpp"

namespace boards::qemu_mps2 {

/// Plays the samples again and again: SysTick samples, PendSV settles, the idle loop does the rest.
/// The host on UART 0 opens the channel, hears the node and may command it. Ends after
/// options.seconds.
Failure run_in_real_time(const Options& options);

}  // namespace boards::qemu_mps2
