// Instructions that every effect of an extension takes together: the worst of a sample and of the
// damage of a cycle. Argument 1 is the JSON file to write.

#include <algorithm>
#include <cstdint>
#include <span>

#include "firmware/boards/qemu_mps2/measurement.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"
#include "firmware/boards/qemu_mps2/text.hpp"
#include "tests/target/extended/entry.hpp"
#include "tests/target/model/paper_model.hpp"
#include "tests/target/signals.hpp"

namespace board = boards::qemu_mps2;

namespace {

constexpr int kSamples = 4'000;

struct Worst {
  std::uint32_t drive = 0;
  std::uint32_t sheath = 0;
  std::uint32_t cycle = 0;
};

lifemodel::extension::Covariates drawn(target::Random& random) {
  lifemodel::extension::Covariates at;
  at.velocity = lifemodel::Velocity::from_raw(random.below(1 << 23) - (1 << 22));
  at.rotor.raw = std::int64_t{random.below(1 << 30)} * 64;
  at.sheath = lifemodel::extension::Temperature::from_raw(random.below(80 << 16));
  at.winding = lifemodel::extension::Temperature::from_raw(random.below(150 << 16));
  return at;
}

Worst measured() {
  const lifemodel::ExtendedParameters model = target::extended_paper_model();
  lifemodel::extension::Corrector drive(model.nominal, model.extension);
  lifemodel::extension::Corrector sheath(model.nominal, model.extension);
  const auto law = lifemodel::extension::life_parameters(model.nominal, model.extension).law;
  const board::InstructionCounter counter;
  target::Random random(8);
  Worst worst;
  for (int i = 0; i < kSamples; ++i) {
    lifemodel::extension::DriveSample current;
    current.current = lifemodel::MotorCurrent::from_raw(random.below(8 << 24));
    current.at = drawn(random);
    worst.drive = std::max(worst.drive, counter.count({correct_drive, &drive, &current}));
    lifemodel::extension::SheathSample output;
    output.tension = lifemodel::Tension::from_raw(random.below(150 * target::kNewton));
    output.bend = lifemodel::Angle::from_raw(random.below(10 << 26));
    output.at = drawn(random);
    worst.sheath = std::max(worst.sheath, counter.count({correct_sheath, &sheath, &output}));
    const std::int32_t from = random.below(150 * target::kNewton);
    const std::int32_t to = from + 1 + random.below(20 * target::kNewton);
    worst.cycle = std::max(worst.cycle, counter.count({damage_of_cycle, &law, from, to}));
  }
  return worst;
}

}  // namespace

int main() {
  const board::Arguments arguments;
  if (arguments.count() != 2) {
    return 2;
  }
  const Worst worst = measured();
  board::Text<200> json;
  json << "{\"sample_drive\": " << worst.drive << ", \"sample_sheath\": " << worst.sheath
       << ", \"cycle\": " << worst.cycle << "}\n";
  board::write(json.c_str());
  board::HostFile file(arguments[1], board::HostFile::Mode::write);
  const bool written =
      file.is_open() && file.write(std::as_bytes(std::span(json.c_str(), json.size())));
  return written ? 0 : 1;
}
