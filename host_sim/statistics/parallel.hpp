#pragma once

#include <cstddef>
#include <functional>

namespace host_sim::statistics {

/// Calls work(i) for each i below `count`, on all cores (or on `threads` of them). An exception of
/// one call ends the rest and is thrown here. Results belong into places of their own, so that they
/// do not depend on the number of threads.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work,
                  unsigned threads = 0);

}  // namespace host_sim::statistics
