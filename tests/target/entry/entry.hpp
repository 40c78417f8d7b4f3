#pragma once

#include <cstddef>
#include <cstdint>

#include "lifemodel/estimator.hpp"
#include "lifemodel/life/advice.hpp"
#include "lifemodel/quantity/units.hpp"

/// The estimator as functions of C linkage, so that each can be measured, sized and followed as
/// one. They are compiled on their own and never inlined into what measures them.
namespace target {

using One = lifemodel::Estimator<1>;
using Four = lifemodel::Estimator<4>;

struct Wear {
  lifemodel::Damage used;
  lifemodel::Damage each;  ///< of a repeat
};
struct GivenSurvival {
  std::uint32_t repeats_to_10;
  std::uint32_t repeats_to_50;
  std::uint32_t repeats_to_90;
  lifemodel::Ratio break_risk;  ///< within 480 repeats
};

struct Advised {
  lifemodel::Tension peak;  ///< that there was
  lifemodel::Advice advice;
};

}  // namespace target

extern "C" {

bool push_one(target::One* estimator, std::int32_t tension_q29);
bool settle_one(target::One* estimator);
void reading_one(target::One* estimator, lifemodel::Reading* out);
std::size_t snapshot_one(const target::One* estimator, std::byte* out);
bool restore_one(target::One* estimator, const std::byte* bytes, std::size_t size);

bool push_four(target::Four* estimator, std::size_t tendon, std::int32_t tension_q29);
bool settle_four(target::Four* estimator);
void reading_four(target::Four* estimator, std::size_t tendon, lifemodel::Reading* out);

/// Takes a parameter block into use; false where it is refused.
bool decode_block(const std::byte* block, std::size_t size, lifemodel::Parameters* out);

void given_survival(const lifemodel::WeibullShape* shape, const target::Wear* wear,
                    target::GivenSurvival* out);

/// The advice for 480 repeats.
void advised(const lifemodel::Parameters* parameters, const target::Wear* wear,
             target::Advised* out);

}  // extern "C"
