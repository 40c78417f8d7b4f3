// Any bytes, and any words in an extension whose CRC fits: either refused, or an extension that
// comes back as the same block and that any sample and cycle can be evaluated with.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "lifemodel/estimator.hpp"
#include "lifemodel/extension/corrector.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/extension/life.hpp"
#include "tests/lifemodel/support.hpp"

namespace {

using namespace lifemodel;

constexpr std::int32_t kRaws[] = {0, 1, -1, kInt32Max, -kInt32Max, 1 << 28, 1 << 20, -(1 << 27)};

void evaluate(const ExtendedParameters& model) {
  extension::Corrector corrector(model.nominal, model.extension);
  using Life = extension::ExtendedLife<DefaultLayout>;
  Estimator<1, Life> estimator({extension::life_parameters(model.nominal, model.extension)});
  for (const std::int32_t raw : kRaws) {
    for (const std::int32_t other : kRaws) {
      extension::Covariates at;
      at.velocity = Velocity::from_raw(raw);
      at.rotor.raw = std::int64_t{raw} * other;
      at.sheath = extension::Temperature::from_raw(other);
      at.winding = extension::Temperature::from_raw(raw);
      Flags& flags = estimator.input_flags(0);
      estimator.push(0, corrector.input_tension(
                            extension::DriveSample{MotorCurrent::from_raw(other), at}, flags));
      const Angle bend = Angle::from_raw(other & Angle::highest().raw());
      estimator.push(0, corrector.input_tension(
                            extension::SheathSample{Tension::from_raw(raw), bend, at}, flags));
      corrector.start_at(static_cast<std::uint32_t>(raw));
      while (estimator.settle()) {
      }
    }
  }
  (void)estimator.reading(0);
}

void check(std::span<const std::byte> block) {
  const auto model = decode_extended(block);
  if (!model) {
    if (to_string(model.error()) == to_string(BlockError::none)) {
      std::abort();
    }
    return;
  }
  std::vector<std::byte> buffer(kMostExtendedBytes);
  const auto again = encode(*model, buffer);
  // What knows neither uncertainty nor limits is written in version 1.
  if (again.size() > block.size() ||
      (again.size() == block.size() && !std::ranges::equal(block, again))) {
    std::abort();
  }
  evaluate(*model);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  check(bytes);
  // The words of the section alone, behind a good block of either version and under a CRC that
  // fits.
  const std::size_t words = std::min(size / 4, kMostExtensionBytes / 4 - 5);
  Parameters parameters = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  for (const std::uint32_t horizon_s : {0U, 60U}) {
    parameters.watch.horizon_s = horizon_s;
    const ParameterBlock nominal = encode(parameters);
    std::vector<std::byte> block(nominal.begin(), nominal.end());
    block.resize(nominal.size() + 4 * (words + 5));
    const auto section = std::span(block).subspan(nominal.size());
    ByteWriter out(section);
    out.u32(kExtensionMagic);
    out.u32(kExtensionVersion);
    out.u32(static_cast<std::uint32_t>(section.size()));
    out.u32(ByteReader(std::span(nominal).last(4)).u32());
    std::copy_n(bytes.begin(), 4 * words, section.begin() + 16);
    ByteWriter(section.last(4)).u32(crc32(section.first(section.size() - 4)));
    check(block);
  }
  return 0;
}
