// make_lifemodel_seeds CORPUS: writes seeds for the fuzz targets of lifemodel.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <vector>

#include "lifemodel/estimator.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "tests/lifemodel/support.hpp"

namespace {

namespace fs = std::filesystem;
using namespace lifemodel;

void write(const fs::path& path, std::span<const std::byte> bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

std::vector<std::byte> signal(int samples, int step, int settles) {
  std::vector<std::byte> bytes{std::byte{9}, std::byte{0}};
  for (int i = 0; i < samples; ++i) {
    const int value = (i % 2 == 0 ? 1 : -1) * (i * step % 30000) + 500;
    bytes.push_back(static_cast<std::byte>(value));
    bytes.push_back(static_cast<std::byte>(value >> 8));
    bytes.push_back(static_cast<std::byte>(settles + (i % 16 == 0 ? 0 : 4)));
  }
  return bytes;
}

std::vector<std::byte> bulk_signal(int samples, int step, int parts) {
  std::vector<std::byte> bytes{std::byte{9}, std::byte{20}, static_cast<std::byte>(parts)};
  for (int i = 0; i < samples; ++i) {
    const int value = (i % 2 == 0 ? 1 : -1) * (i * step % 15000) + 15500;
    bytes.push_back(static_cast<std::byte>(value));
    bytes.push_back(static_cast<std::byte>(value >> 8));
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_lifemodel_seeds CORPUS\n";
    return 2;
  }
  const fs::path corpus = argv[1];
  const Parameters model = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  write(corpus / "fuzz_parameter_block" / "paper", encode(model));
  auto watched_constants = lifemodel_test::paper_constants();
  watched_constants.intervals = {.ipl_exponent = {1.2, 1.6},
                                 .weibull_shape = {5.2, 6.7},
                                 .pivot_tension_N = 50,
                                 .life_at_pivot = {660, 720}};
  watched_constants.watch = {.minimum_tension_N = 1,
                             .broken_tension_N = 4,
                             .broken_travel_mm = 25,
                             .slack_travel_mm = 3,
                             .horizon_h = 24,
                             .advice_risk = 0.05,
                             .advice_until_h = 1000};
  const Parameters watched = lifemodel_test::parameters_of(watched_constants);
  write(corpus / "fuzz_parameter_block" / "watched", encode(watched));
  ExtendedParameters extended{model, {}};
  extended.extension.current_offset.offset = 838861;
  extended.extension.add(extension::Effect::current_offset);
  extended.extension.friction_load = {53687091, 1823548758, {1342177280, 31}};
  extended.extension.add(extension::Effect::friction_load);
  std::vector<std::byte> block(kMostExtendedBytes);
  write(corpus / "fuzz_extended_block" / "paper", encode(extended, block));
  extended.nominal = watched;
  write(corpus / "fuzz_extended_block" / "watched", encode(extended, block));

  Estimator<1> estimator({model});
  std::vector<std::byte> buffer(Estimator<1>::kSnapshotBytes);
  write(corpus / "fuzz_snapshot" / "empty", estimator.snapshot(buffer));
  for (int i = 0; i < 40; ++i) {
    estimator.push(0, Tension::from_raw((i % 2 == 0 ? 200 - i : i) << 20));
    if (i == 20) {
      (void)estimator.reading(0);
    }
  }
  write(corpus / "fuzz_snapshot" / "nested", estimator.snapshot(buffer));
  for (int i = 0; i < 80; ++i) {
    estimator.push(0, Tension::from_raw((i % 2 == 0 ? i : 300 - i) << 20));
  }
  write(corpus / "fuzz_snapshot" / "overrun", estimator.snapshot(buffer));

  write(corpus / "fuzz_bulk" / "growing", bulk_signal(400, 70, 3));
  write(corpus / "fuzz_bulk" / "mixed", bulk_signal(600, 7919, 7));
  write(corpus / "fuzz_bulk" / "quantised", bulk_signal(600, 8192, 0));

  write(corpus / "fuzz_differential" / "growing", signal(60, 400, 1));
  write(corpus / "fuzz_differential" / "mixed", signal(200, 7919, 3));
  write(corpus / "fuzz_differential" / "late", signal(200, 7919, 0));
}
