#include "host_sim/batch/run_batch.hpp"

#include <algorithm>
#include <iostream>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "hal/files/output_file.hpp"
#include "hal/files/text.hpp"
#include "host_sim/batch/deal.hpp"
#include "host_sim/io/progress.hpp"

namespace host_sim::batch {

using hal::files::InputError;
using hal::files::Interruption;
using hal::files::OutputError;
using hal::files::printable;
using hal::files::stop_if_interrupted;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Answer, row, json, error, found)

namespace {

/// One progress bar for pieces of work that several threads do.
class SharedProgress {
 public:
  /// @param pieces of all ranks
  /// @param own of this rank, one at least, which are the whole of its bar
  /// @param shown whether there is a bar
  SharedProgress(std::string_view label, std::size_t pieces, std::size_t own, bool shown)
      : shares_(pieces), own_(static_cast<double>(own)) {
    if (shown) {
      bar_.emplace(label);
    }
  }

  /// Says that `share`, 0 .. 1, of a piece is done. For any thread.
  void set(std::size_t piece, double share) {
    const std::lock_guard lock(mutex_);
    done_ += share - shares_[piece];
    shares_[piece] = share;
    if (bar_) {
      bar_->update_share(done_ / own_);
    }
  }

 private:
  std::mutex mutex_;
  std::vector<double> shares_;
  double own_;
  double done_ = 0;
  std::optional<Progress> bar_;
};

/// What to do, found out by rank 0, on every rank. Nothing where rank 0 cannot continue; the error
/// is thrown there.
std::vector<std::string> pieces_for_all(Ranks& ranks, const Batch& batch) {
  if (ranks.rank() != 0) {
    return unpacked(ranks.broadcast({}));
  }
  const auto call_off = [&ranks] {
    ranks.broadcast({});
    ranks.leave();
  };
  try {
    std::vector<std::string> pieces = batch.list();
    ranks.broadcast(packed(pieces));
    return pieces;
  } catch (const InputError&) {
    call_off();
    throw;
  } catch (const OutputError&) {
    call_off();
    throw;
  }
}

Answer answer_for(const Batch& batch, const std::string& piece, const Means& means) {
  try {
    return batch.work(piece, means);
  } catch (const Interruption&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return batch.refuse(piece, error);
  }
}

std::vector<std::string> deal_pieces(Ranks& ranks, const Batch& batch,
                                     const std::vector<std::string>& pieces) {
  const std::size_t threads = threads_of(ranks, batch.threads);
  const std::size_t own = (pieces.size() + ranks.count() - 1) / ranks.count();
  const auto threads_each = static_cast<unsigned>(std::max<std::size_t>(1, threads / own));
  SharedProgress progress(batch.label, pieces.size(), own, ranks.rank() == 0);
  return deal(ranks, pieces.size(), static_cast<unsigned>(threads), [&](std::size_t i) {
    const Means means{threads_each, [&progress, i](double share) {
                        stop_if_interrupted();
                        progress.set(i, share);
                      }};
    const Answer answer = answer_for(batch, pieces[i], means);
    progress.set(i, 1);
    return nlohmann::json(answer).dump();
  });
}

int run(Ranks& ranks, const Batch& batch) {
  const std::vector<std::string> pieces = pieces_for_all(ranks, batch);
  if (pieces.empty()) {
    return 0;
  }
  const std::vector<std::string> texts = deal_pieces(ranks, batch, pieces);
  if (ranks.rank() != 0) {
    return 0;
  }
  std::vector<Answer> answers;
  answers.reserve(texts.size());
  for (const std::string& text : texts) {
    answers.push_back(nlohmann::json::parse(text).get<Answer>());
  }
  return batch.report(answers);
}

}  // namespace

int run_batch(Ranks& ranks, const Batch& batch) {
  try {
    return run(ranks, batch);
  } catch (const std::exception& error) {
    // The other ranks are ended with this one, before anybody else can report why.
    if (ranks.count() > 1 && !ranks.has_left()) {
      std::cerr << "host_sim: " << error.what() << std::endl;
    }
    throw;
  }
}

std::string error_line(const std::exception& error, const std::string& place) {
  const auto* const input = dynamic_cast<const InputError*>(&error);
  return input != nullptr ? input->what() : printable(place + ": " + error.what());
}

}  // namespace host_sim::batch
