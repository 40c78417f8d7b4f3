#include "firmware/boards/linux/run_tendons.hpp"

template board::Report board::run_tendons<4>(const Setup&, const std::atomic<bool>&);
