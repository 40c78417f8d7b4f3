// Any bytes, and any words in a snapshot whose CRC fits: either refused with the state as it was,
// or taken up, and then counting continues and the state comes back as the same snapshot.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "lifemodel/estimator.hpp"
#include "tests/lifemodel/support.hpp"

namespace {

using namespace lifemodel;
using One = Estimator<1>;

std::vector<std::byte> snapshot_of(const One& estimator) {
  std::vector<std::byte> buffer(One::kSnapshotBytes);
  buffer.resize(estimator.snapshot(buffer).size());
  return buffer;
}

void check(std::span<const std::byte> bytes) {
  One estimator({lifemodel_test::parameters_of(lifemodel_test::paper_constants())});
  estimator.push(0, Tension::from_raw(1 << 26));
  estimator.push(0, Tension::from_raw(1 << 28));
  const auto before = snapshot_of(estimator);
  if (estimator.restore(bytes, ModelChange::allow) != SnapshotError::none) {
    if (snapshot_of(estimator) != before) {
      std::abort();
    }
    return;
  }
  const auto after = snapshot_of(estimator);
  // The digest of the model is that of the estimator, the rest is what was stored.
  if (after.size() != bytes.size() ||
      !std::equal(after.begin() + 20, after.end() - 4, bytes.begin() + 20)) {
    std::abort();
  }
  Damage last = estimator.reading(0).closed;
  for (const std::int32_t raw : {1 << 27, 1 << 20, 1 << 28, 0, -(1 << 26), 1 << 25, 1 << 29}) {
    estimator.push(0, Tension::from_raw(raw));
    while (estimator.settle()) {
    }
    const Reading now = estimator.reading(0);
    if (now.closed < last) {
      std::abort();
    }
    last = now.closed;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  check(bytes);
  if (size >= kSnapshotHeaderBytes + 4) {
    std::vector<std::byte> framed(bytes.begin(), bytes.end());
    ByteWriter head(framed);
    head.u32(kSnapshotMagic);
    head.u32(kSnapshotVersion);
    head.u32(static_cast<std::uint32_t>(size));
    head.u32(1);
    ByteWriter(std::span(framed).last(4)).u32(crc32(std::span(framed).first(size - 4)));
    check(framed);
  }
  return 0;
}
