#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "firmware/protocol/uds/device.hpp"
#include "lifemodel/support/bytes.hpp"

namespace protocol::testing {

/// What a command under authority may change.
struct ModelLife {
  std::vector<storage::LifeRecord> records;
  std::vector<lifemodel::ExtendedBlock> blocks;
  std::uint32_t counter = 41;

  friend bool operator==(const ModelLife&, const ModelLife&) = default;
};

/// A node in memory. The faults are what its parts answer.
class ModelDevice {
 public:
  explicit ModelDevice(std::uint8_t tendons) {
    for (std::uint8_t i = 0; i < tendons; ++i) {
      storage::LifeRecord record;
      record.sequence = 40;
      record.tendon = i;
      record.flags = 0x08;
      record.epoch = static_cast<std::uint16_t>(1 + i);
      // 2^103 and 3 * 2^103 steps of 2^-104: half a life, and one and a half.
      record.epoch_damage = lifemodel::Damage::from_words({0, 0, 0, 0x80});
      record.lifetime_damage = lifemodel::Damage::from_words({0, 0, 0, 0x180});
      record.epoch_cycles = 0x1'0000'0002;
      record.configuration = 0xc0ffee00u + i;
      life.records.push_back(record);
      life.blocks.push_back({});
      reports.push_back({.source = 1});
    }
  }

  protocol::uds::Identity identity() {
    protocol::uds::Identity identity{.schema = 1, .firmware = 0x23};
    for (std::size_t i = 0; i < identity.serial.size(); ++i) {
      identity.serial[i] = static_cast<std::byte>(0xe0 + i);
    }
    return identity;
  }
  std::uint8_t tendons() { return static_cast<std::uint8_t>(life.records.size()); }
  storage::LifeRecord read_life(std::uint8_t tendon) { return life.records.at(tendon); }
  std::uint32_t configuration(std::uint8_t tendon) { return life.records.at(tendon).configuration; }
  std::uint32_t storage_counter() { return life.counter; }

  hal::Error random(std::span<std::byte> out) {
    if (random_fault != hal::Error::none) {
      return random_fault;
    }
    if (!stuck_random) {
      ++nonces;
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = static_cast<std::byte>(nonces >> (8 * (i % 4)));
    }
    return hal::Error::none;
  }

  hal::Error log(storage::Event event, std::uint8_t tendon, std::uint32_t detail) {
    if (log_fault != hal::Error::none) {
      return log_fault;
    }
    if (lines.size() >= log_capacity) {
      return hal::Error::full;
    }
    lines.push_back({.number = static_cast<std::uint32_t>(lines.size()),
                     .sequence = life.counter,
                     .event = event,
                     .tendon = tendon,
                     .epoch = life.records.at(tendon).epoch,
                     .detail = detail});
    return hal::Error::none;
  }
  std::optional<storage::LogEntry> log_entry(std::uint32_t i) {
    return i < lines.size() ? std::optional(lines[i]) : std::nullopt;
  }

  hal::Error open_epoch(std::uint8_t tendon) {
    lines_at_deed = lines.size();
    if (deed_fault != hal::Error::none) {
      return deed_fault;
    }
    storage::LifeRecord& record = life.records.at(tendon);
    ++record.epoch;
    record.epoch_damage = {};
    record.epoch_cycles = 0;
    ++life.counter;
    return hal::Error::none;
  }
  protocol::uds::ParameterReport parameters(std::uint8_t tendon) { return reports.at(tendon); }
  bool accepts(std::uint8_t tendon, const lifemodel::ExtendedParameters& model, std::uint32_t crc) {
    last_sample_period_us = model.nominal.sample_period_us;
    if (refused_effects & model.extension.effects) {
      reports.at(tendon) = {
          .source = 1, .fault = 5, .effect = 11, .covariate = 4, .refused_crc = crc};
      return false;
    }
    reports.at(tendon) = {.source = 1};
    return true;
  }
  void refuse_parameters(std::uint8_t tendon, const lifemodel::ExtendedBlockError& error,
                         std::uint32_t crc) {
    reports.at(tendon) = {.source = 1,
                          .fault = static_cast<std::uint8_t>(
                              error.extension != lifemodel::ExtensionError::none ? 3 : 2),
                          .refused_crc = crc};
  }
  hal::Error load_parameters(std::uint8_t tendon, const lifemodel::ExtendedBlock& block) {
    lines_at_deed = lines.size();
    if (deed_fault != hal::Error::none) {
      return deed_fault;
    }
    life.blocks.at(tendon) = block;
    life.records.at(tendon).configuration = block.crc();
    ++life.counter;
    return hal::Error::none;
  }

  ModelLife life;
  std::vector<storage::LogEntry> lines;
  std::vector<protocol::uds::ParameterReport> reports;
  std::uint32_t refused_effects = 0;  ///< a bit each, of effects that it cannot evaluate
  std::size_t log_capacity = 1000;
  std::size_t lines_at_deed = 0;
  std::uint32_t last_sample_period_us = 0;
  std::uint32_t nonces = 0;
  bool stuck_random = false;
  hal::Error random_fault = hal::Error::none;
  hal::Error log_fault = hal::Error::none;
  hal::Error deed_fault = hal::Error::none;
};

static_assert(protocol::uds::Device<ModelDevice>);

}  // namespace protocol::testing
