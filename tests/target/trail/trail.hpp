#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/boards/qemu_mps2/text.hpp"
#include "lifemodel/estimator.hpp"
#include "lifemodel/extension/corrector.hpp"
#include "lifemodel/extension/life.hpp"
#include "lifemodel/support/bytes.hpp"
#include "tests/target/model/paper_model.hpp"
#include "tests/target/signals.hpp"

namespace target {

/// A line of damage words, counts and digests for every stretch of many signals, of a recording and
/// of every kind of input. The lines are the same wherever the estimator computes the same.
///
/// `Files` gives write(const char*) for the lines, and read(std::span<std::int32_t>) for the
/// samples of the recording, raw values of lifemodel::Tension: as many as asked for, fewer only at
/// its end.
template <class Files>
class Trail {
 public:
  explicit Trail(Files& files) : files_(files) {}

  void write() {
    for (const Signal& each : kSignals) {
      signal(each);
    }
    recording();
    conversions();
    extended();
  }

 private:
  using Estimator = lifemodel::Estimator<2>;
  using Tension = lifemodel::Tension;
  using Line = boards::qemu_mps2::Text<240>;

  void signal(const Signal& signal) {
    Estimator estimator(paper_parameters<2>());
    signal.fill(samples_);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      estimator.push(0, Tension::from_raw(samples_[i]));
      // The second tendon is settled too late, again and again.
      estimator.push(1, Tension::from_raw(samples_[samples_.size() - 1 - i]));
      if (i % 61 == 0) {
        while (estimator.settle()) {
        }
      }
      if (i % 500 == 499) {
        line(signal.name, estimator);
      }
    }
  }

  void recording() {
    Estimator estimator(paper_parameters<2>());
    std::array<std::int32_t, 256> chunk{};
    std::size_t size = 0;
    do {
      size = files_.read(chunk);
      for (const std::int32_t sample : std::span(chunk).first(size)) {
        estimator.push(0, Tension::from_raw(sample));
        estimator.push(1, Tension::from_raw(sample / 2));
        while (estimator.settle()) {
        }
      }
      line("recording", estimator);
    } while (size == chunk.size());
  }

  /// Motor current, output tension and missing samples.
  void conversions() {
    Estimator estimator(paper_parameters<2>());
    Random random(6);
    for (std::uint32_t i = 0; i < 4000; ++i) {
      estimator.push(0, lifemodel::MotorCurrent::from_raw(
                            static_cast<std::int32_t>(random.next() >> 1) - (1 << 30)));
      const auto output = Tension::from_raw(random.below(100 * kNewton));
      const auto bend = lifemodel::Angle::from_raw(random.below(lifemodel::Angle::highest().raw()));
      const auto direction =
          i % 3 == 0 ? lifemodel::Direction::releasing : lifemodel::Direction::pulling;
      estimator.push(1, output, direction, bend);
      if (i % 97 == 0) {
        estimator.push_missing(1);
      }
      while (estimator.settle()) {
      }
      if (i % 500 == 499) {
        line("conversions", estimator);
      }
    }
  }

  /// Every effect of an extension: tendon 0 by its motor current, tendon 1 by its output tension.
  void extended() {
    using lifemodel::extension::Covariates;
    const lifemodel::ExtendedParameters model = extended_again();
    using Life = lifemodel::extension::ExtendedLife<lifemodel::DefaultLayout>;
    const auto life = lifemodel::extension::life_parameters(model.nominal, model.extension);
    lifemodel::Estimator<2, Life> estimator({life, life});
    lifemodel::extension::Corrector drive(model.nominal, model.extension);
    lifemodel::extension::Corrector sheath(model.nominal, model.extension);
    sheath.start_at(700);
    Random random(7);
    for (std::uint32_t i = 0; i < 8000; ++i) {
      const std::int32_t swing = lifemodel::numeric::sine(i * 40'000'003u);
      Covariates at;
      at.velocity = lifemodel::Velocity::from_raw(swing >> 9);
      at.rotor.raw = std::int64_t{lifemodel::numeric::cosine(i * 40'000'003u)} * 13;
      at.sheath = lifemodel::extension::Temperature::from_raw((20 << 16) + random.below(1 << 21));
      at.winding = lifemodel::extension::Temperature::from_raw((20 << 16) + random.below(1 << 22));
      const auto current = lifemodel::MotorCurrent::from_raw(random.below(4 << 24));
      const auto output = Tension::from_raw(random.below(60 * kNewton));
      const auto bend = lifemodel::Angle::from_raw(random.below(5 << 26));
      estimator.push(0, drive.input_tension(lifemodel::extension::DriveSample{current, at},
                                            estimator.input_flags(0)));
      estimator.push(1, sheath.input_tension(lifemodel::extension::SheathSample{output, bend, at},
                                             estimator.input_flags(1)));
      if (i % 97 == 0) {
        sheath.gap();
      }
      while (estimator.settle()) {
      }
      if (i % 500 == 499) {
        line("extended", estimator);
      }
    }
  }

  /// The extended model as a controller reads it from its block.
  static lifemodel::ExtendedParameters extended_again() {
    std::array<std::byte, lifemodel::kMostExtendedBytes> block{};
    const auto decoded = lifemodel::decode_extended(encode(extended_paper_model(), block));
    return decoded ? *decoded : lifemodel::ExtendedParameters{};
  }

  static void append(Line& line, const lifemodel::Damage& damage) {
    for (std::size_t i = damage.words().size(); i-- > 0;) {
      line.hex(damage.words()[i]);
    }
    line << " ";
  }

  static void append(Line& line, std::uint64_t value) {
    line.hex(static_cast<std::uint32_t>(value >> 32)).hex(static_cast<std::uint32_t>(value));
    line << " ";
  }

  template <class EstimatorT>
  void line(const char* name, EstimatorT& estimator) {
    // Without the CRC at its end, with which every snapshot has the same CRC.
    const auto stored = estimator.snapshot(snapshot_);
    const std::uint32_t digest = lifemodel::crc32(stored.first(stored.size() - 4));
    for (std::size_t tendon = 0; tendon < Estimator::tendons(); ++tendon) {
      // Read from a copy, so that the work left for settle() stays as it was.
      EstimatorT copy = estimator;
      const lifemodel::Reading reading = copy.reading(tendon);
      Line text;
      text << name << " " << static_cast<std::uint32_t>(tendon) << " ";
      append(text, reading.closed);
      append(text, reading.open);
      append(text, reading.total);
      append(text, reading.closed_cycles.raw());
      append(text, reading.open_half_cycles.raw());
      text.hex(reading.flags.bits()) << " ";
      text.hex(copy.parameters(tendon).life.survival(reading.total).raw()) << " ";
      text.hex(digest) << "\n";
      files_.write(text.c_str());
    }
  }

  Files& files_;
  std::array<std::int32_t, 4000> samples_{};
  std::array<std::byte, Estimator::kSnapshotBytes> snapshot_{};
};

}  // namespace target
