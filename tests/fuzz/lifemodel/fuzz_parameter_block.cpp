// Any bytes, and any words in a block whose CRC fits: either refused, or parameters that come back
// as the same block and that can be counted with.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/estimator.hpp"

namespace {

using namespace lifemodel;

void check(std::span<const std::byte> block) {
  const auto parameters = decode(block);
  if (!parameters) {
    if (to_string(parameters.error()) == to_string(BlockError::none)) {
      std::abort();
    }
    return;
  }
  const ParameterBlock again = encode(*parameters);
  // What knows neither uncertainty nor limits is written in version 1.
  if (again.size() == block.size()
          ? !std::ranges::equal(block, again)
          : !std::ranges::equal(block.subspan(8, 72), std::span(again).subspan(8, 72))) {
    std::abort();
  }
  Estimator<1> estimator({*parameters});
  for (const std::int32_t raw : {0, kInt32Max, -kInt32Max, 1 << 28, 1, 1 << 29, -(1 << 27)}) {
    estimator.push(0, Tension::from_raw(raw));
    estimator.push(0, MotorCurrent::from_raw(raw));
    estimator.push(0, Tension::from_raw(raw), Direction::pulling, Angle::highest());
    while (estimator.settle()) {
    }
  }
  const Reading reading = estimator.reading(0);
  (void)parameters->life.survival(reading.total);
  (void)remaining_repeats(reading.closed, reading.open, parameters->life.b10);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  check(bytes);
  for (const std::uint32_t version : {kBlockVersion, kWatchedBlockVersion}) {
    std::vector<std::byte> block(bytes.begin(), bytes.end());
    block.resize(ParameterBlock(version).size());
    ByteWriter head(block);
    head.u32(kBlockMagic);
    head.u32(version);
    ByteWriter(std::span(block).last(4)).u32(crc32(std::span(block).first(block.size() - 4)));
    check(block);
  }
  return 0;
}
