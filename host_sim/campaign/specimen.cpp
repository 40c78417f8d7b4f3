#include "host_sim/campaign/campaign.hpp"

namespace host_sim {

double Campaign::Specimen::cycles() const {
  double sum = 0;
  for (const Block& block : blocks) {
    sum += block.cycles;
  }
  return sum;
}

}  // namespace host_sim
