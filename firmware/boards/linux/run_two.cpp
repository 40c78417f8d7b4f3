#include "firmware/boards/linux/run_tendons.hpp"

template board::Report board::run_tendons<2>(const Setup&, const std::atomic<bool>&);
