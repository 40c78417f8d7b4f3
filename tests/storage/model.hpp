#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "firmware/storage/store.hpp"
#include "tests/storage/lives.hpp"

namespace storage_test {

/// What a store has to hold: all that was committed, and what one call that did not end may have
/// left.
template <std::size_t kTendons>
struct Model {
  using Records = std::array<storage::LifeRecord, kTendons>;

  std::array<std::optional<storage::LifeRecord>, kTendons> lives;
  std::array<std::optional<lifemodel::ExtendedBlock>, kTendons> parameters;
  std::vector<storage::LogEntry> log;
  std::array<std::uint16_t, kTendons> epoch{};
  std::array<std::uint32_t, kTendons> opened{};

  std::optional<Records> saving;
  std::optional<std::size_t> loading;  ///< tendon
  lifemodel::ExtendedBlock block{};
  std::optional<storage::LogEntry> appending;

  /// Makes one call: which one follows from the step.
  template <class Store>
  hal::Error call(Store& store, std::uint32_t step) {
    if (step % 7 == 3) {
      return load(store, step);
    }
    if (step % 5 == 4) {
      return append(store, step);
    }
    return save(store, step);
  }

  template <class Store>
  hal::Error load(Store& store, std::uint32_t step) {
    loading = step / 7 % kTendons;
    block = block_of(step, step % 2 == 0 ? lifemodel::kBlockBytes : Store::kLargestBlock);
    const hal::Error error = store.save_parameters(*loading, block);
    if (error == hal::Error::none) {
      parameters[*loading] = block;
      loading.reset();
    }
    return error;
  }

  template <class Store>
  hal::Error append(Store& store, std::uint32_t step) {
    appending = entry_of(step);
    const hal::Error error = store.append(*appending);
    if (error == hal::Error::none) {
      log.push_back(*appending);
    }
    if (error == hal::Error::none || error == hal::Error::full) {
      appending.reset();
    }
    return error;
  }

  template <class Store>
  hal::Error save(Store& store, std::uint32_t step) {
    if (step % 11 == 10) {
      const std::size_t tendon = step / 11 % kTendons;
      ++epoch[tendon];
      opened[tendon] = step;
    }
    saving.emplace();
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      (*saving)[tendon] = record_of(tendon, step, epoch[tendon], opened[tendon]);
    }
    const hal::Error error = store.save(*saving);
    if (error == hal::Error::none) {
      for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
        lives[tendon] = (*saving)[tendon];
        lives[tendon]->sequence = store.sequence();
      }
      saving.reset();
    }
    return error;
  }

  /// Compares with a store that was just opened, and takes over what it holds.
  template <class Store>
  void check(Store& store) {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      check_life(store, tendon);
      check_parameters(store, tendon);
    }
    check_log(store);
    saving.reset();
    loading.reset();
    appending.reset();
  }

  template <class Store>
  void check_life(Store& store, std::size_t tendon) {
    const auto found = store.load(tendon);
    const auto& old = lives[tendon];
    if (old) {
      ASSERT_TRUE(found) << "tendon " << tendon << " lost its record";
      ASSERT_FALSE(found->past_lost);
      if (*found == *old) {
        return;
      }
    }
    if (found) {
      ASSERT_TRUE(saving && same_life(*found, (*saving)[tendon]))
          << "tendon " << tendon << " has neither its old nor its new record";
      ASSERT_GT(found->sequence, old ? old->sequence : 0);
    }
    lives[tendon] = found;
  }

  template <class Store>
  void check_parameters(Store& store, std::size_t tendon) {
    const auto found = store.load_parameters(tendon);
    if (found != parameters[tendon]) {
      ASSERT_TRUE(loading == tendon && found == block) << "tendon " << tendon;
    }
    parameters[tendon] = found;
  }

  template <class Store>
  void check_log(Store& store) {
    for (std::uint32_t i = 0; i < log.size(); ++i) {
      log[i].number = i;
      ASSERT_EQ(store.log(i), log[i]) << "entry " << i;
    }
    const auto last = store.log(static_cast<std::uint32_t>(log.size()));
    if (last) {
      ASSERT_TRUE(appending);
      appending->number = static_cast<std::uint32_t>(log.size());
      ASSERT_EQ(*last, *appending);
      log.push_back(*last);
      ASSERT_FALSE(store.log(static_cast<std::uint32_t>(log.size())));
    }
  }
};

}  // namespace storage_test
