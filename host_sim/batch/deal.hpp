#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
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

/// Texts of any bytes as one text, for ranks of the same machine type.
std::string packed(std::span<const std::string> texts);

/// What packed() has made into one.
std::vector<std::string> unpacked(std::string_view bytes);

}  // namespace host_sim::batch
