#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "firmware/storage/store.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/faults.hpp"

namespace app {

/// A store that outlives the application but not the test; each save can fail by plan.
class RamStore {
 public:
  explicit RamStore(const hal::fake::Clock& clock) : clock_(clock) {}

  std::optional<storage::LifeRecord> load(std::size_t tendon) const {
    const auto found = records_.find(tendon);
    return found == records_.end() ? std::nullopt : std::optional(found->second);
  }
  [[nodiscard]] bool past_lost() const { return lost; }
  hal::Error save(std::span<const storage::LifeRecord> records) {
    if (const auto fault = faults.next(clock_.now())) {
      return *fault;
    }
    ++sequence_;
    for (storage::LifeRecord record : records) {
      record.sequence = sequence_;
      records_[record.tendon] = record;
    }
    saved_at.push_back(clock_.now());
    return hal::Error::none;
  }
  [[nodiscard]] std::uint32_t sequence() const { return sequence_; }
  std::optional<lifemodel::ExtendedBlock> load_parameters(std::size_t tendon) const {
    const auto found = blocks_.find(tendon);
    return found == blocks_.end() ? std::nullopt : std::optional(found->second);
  }
  hal::Error save_parameters(std::size_t tendon, const lifemodel::ExtendedBlock& block) {
    blocks_[tendon] = block;
    return hal::Error::none;
  }
  hal::Error append(const storage::LogEntry& entry) {
    log_.push_back(entry);
    log_.back().number = static_cast<std::uint32_t>(log_.size() - 1);
    return hal::Error::none;
  }
  std::optional<storage::LogEntry> log(std::uint32_t i) const {
    return i < log_.size() ? std::optional(log_[i]) : std::nullopt;
  }

  [[nodiscard]] bool parameters_torn(std::size_t) const { return torn; }

  bool lost = false;
  bool torn = false;
  hal::fake::Faults<hal::Error> faults;
  std::vector<hal::Time> saved_at;

 private:
  const hal::fake::Clock& clock_;
  std::map<std::size_t, storage::LifeRecord> records_;
  std::map<std::size_t, lifemodel::ExtendedBlock> blocks_;
  std::vector<storage::LogEntry> log_;
  std::uint32_t sequence_ = 0;
};

static_assert(storage::Store<RamStore>);

}  // namespace app
