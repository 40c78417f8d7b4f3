#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/batch/ranks.hpp"

namespace host_sim::batch {

/// How many threads a rank uses for `threads`: as many, or for 0 its share of the cores.
unsigned threads_of(const Ranks& ranks, unsigned threads);

/// Deals `count` pieces of work to all ranks and their threads, piece i to rank i modulo the number
/// of ranks. On rank 0 the answers in order of the pieces, on the others nothing; all of them have
/// called leave() then. Bytes of an answer may have any value.
/// @throws Interruption on rank 0 where a rank was interrupted, std::runtime_error where the work
/// of a rank threw anything else
std::vector<std::string> deal(Ranks& ranks, std::size_t count, unsigned threads,
                              const std::function<std::string(std::size_t)>& work);

}  // namespace host_sim::batch
