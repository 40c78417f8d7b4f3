// bulk_check RUNS [SEED]: random runs of the bulk replay beside push() and settle() of each sample,
// by each set of instructions that the machine has. For any processor, so without a test framework.
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include "bulk_runs.hpp"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: bulk_check RUNS [SEED]\n";
    return 2;
  }
  const std::uint32_t first = argc > 2 ? static_cast<std::uint32_t>(std::atol(argv[2])) : 1;
  const auto runs = static_cast<std::uint32_t>(std::atol(argv[1]));
  for (const lifemodel::bulk::Instructions* by : lifemodel::bulk::instructions()) {
    std::cout << by->name << '\n';
  }
  for (std::uint32_t run = 0; run < runs; ++run) {
    if (const auto name = lifemodel_test::difference(first + run)) {
      std::cerr << "seed " << first + run << ": another state by " << *name << '\n';
      return 1;
    }
  }
  std::cout << runs << " runs, the same bits\n";
}
