#include "host_sim/batch/ranks.hpp"

namespace host_sim::batch {

Ranks::Ranks() = default;

Ranks::~Ranks() = default;

std::string Ranks::broadcast(std::string text) {
  return text;
}

std::vector<std::string> Ranks::gather(const std::string& text) {
  return {text};
}

}  // namespace host_sim::batch
