#include "host_sim/statistics/random.hpp"

#include <Random123/philox.h>

#include <algorithm>

namespace host_sim::statistics {

void Random::fill() {
  using Philox = r123::Philox4x64;
  const Philox::ctr_type block =
      Philox{}(Philox::ctr_type{{blocks_++, number_, 0, 0}}, Philox::key_type{{seed_, stream_}});
  std::copy(block.begin(), block.end(), block_.begin());
  next_ = 0;
}

}  // namespace host_sim::statistics
