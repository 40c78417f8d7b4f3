#include "host_sim/batch/deal.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include "hal/files/interruption.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::batch {

using hal::files::Interruption;
using hal::files::stop_if_interrupted;

namespace {

/// The first byte of what a rank hands in: packed answers, or why there are none.
enum class Outcome : char { answers = 'a', interrupted = 'i', failed = 'f' };

std::size_t pieces_of(std::size_t rank, std::size_t ranks, std::size_t count) {
  return (count + ranks - 1 - rank) / ranks;
}

std::string work_of(const Ranks& ranks, std::size_t count, unsigned threads,
                    const std::function<std::string(std::size_t)>& work) {
  std::vector<std::string> answers(pieces_of(ranks.rank(), ranks.count(), count));
  statistics::parallel_for(
      answers.size(),
      [&](std::size_t i) {
        stop_if_interrupted();
        answers[i] = work(ranks.rank() + i * ranks.count());
      },
      threads_of(ranks, threads));
  return static_cast<char>(Outcome::answers) + packed(answers);
}

/// A rank that fails hands in why, so that the others do not wait for it.
std::string outcome_of(const Ranks& ranks, std::size_t count, unsigned threads,
                       const std::function<std::string(std::size_t)>& work) {
  try {
    return work_of(ranks, count, threads, work);
  } catch (const Interruption&) {
    return {static_cast<char>(Outcome::interrupted)};
  } catch (const std::exception& error) {
    return static_cast<char>(Outcome::failed) + std::string(error.what());
  }
}

void throw_failures(const std::vector<std::string>& outcomes) {
  for (const std::string& outcome : outcomes) {
    if (outcome.front() == static_cast<char>(Outcome::interrupted)) {
      throw Interruption();
    }
  }
  for (const std::string& outcome : outcomes) {
    if (outcome.front() == static_cast<char>(Outcome::failed)) {
      throw std::runtime_error(outcome.substr(1));
    }
  }
}

}  // namespace

unsigned threads_of(const Ranks& ranks, unsigned threads) {
  if (threads != 0) {
    return threads;
  }
  const auto ranks_here = static_cast<unsigned>(ranks.on_this_machine());
  return std::max(1U, std::thread::hardware_concurrency() / ranks_here);
}

std::vector<std::string> deal(Ranks& ranks, std::size_t count, unsigned threads,
                              const std::function<std::string(std::size_t)>& work) {
  const std::vector<std::string> outcomes = ranks.gather(outcome_of(ranks, count, threads, work));
  ranks.leave();
  throw_failures(outcomes);
  std::vector<std::string> answers(outcomes.empty() ? 0 : count);
  for (std::size_t rank = 0; rank < outcomes.size(); ++rank) {
    std::size_t i = rank;
    for (std::string& answer : unpacked(std::string_view(outcomes[rank]).substr(1))) {
      answers[i] = std::move(answer);
      i += outcomes.size();
    }
  }
  return answers;
}

using Size = std::uint64_t;

std::string packed(std::span<const std::string> texts) {
  std::string bytes;
  for (const std::string& text : texts) {
    const Size size = text.size();
    std::array<char, sizeof size> head{};
    std::memcpy(head.data(), &size, sizeof size);
    bytes.append(head.data(), head.size());
    bytes += text;
  }
  return bytes;
}

std::vector<std::string> unpacked(std::string_view bytes) {
  std::vector<std::string> texts;
  while (!bytes.empty()) {
    Size size = 0;
    std::memcpy(&size, bytes.data(), sizeof size);
    texts.emplace_back(bytes.substr(sizeof size, size));
    bytes.remove_prefix(sizeof size + size);
  }
  return texts;
}

}  // namespace host_sim::batch
