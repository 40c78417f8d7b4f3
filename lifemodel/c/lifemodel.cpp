#include "lifemodel/c/lifemodel.h"

#include <algorithm>
#include <new>
#include <span>

#include "lifemodel/estimator.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/life/conditional.hpp"

namespace {

using lifemodel::Damage;
using lifemodel::Estimator;
using One = Estimator<1>;

static_assert(sizeof(One) <= sizeof(lm_estimator));
static_assert(alignof(One) <= alignof(lm_estimator));
static_assert(One::kSnapshotBytes <= LM_SNAPSHOT_BYTES);
static_assert(lifemodel::kWatchedBlockBytes == LM_PARAMETER_BLOCK_BYTES);

One& estimator_of(lm_estimator* memory) {
  return *std::launder(reinterpret_cast<One*>(memory->storage));
}
const One& estimator_of(const lm_estimator* memory) {
  return *std::launder(reinterpret_cast<const One*>(memory->storage));
}

lm_damage words_of(const Damage& damage) {
  lm_damage result{};
  std::copy(damage.words().begin(), damage.words().end(), result.words);
  return result;
}

Damage damage_of(const lm_damage& words) {
  Damage::Words result{};
  std::copy(std::begin(words.words), std::end(words.words), result.begin());
  return Damage::from_words(result);
}

lifemodel::WeibullShape shape_of(const lm_estimator* estimator) {
  return estimator_of(estimator).parameters(0).life.shape;
}

Damage damage_at_risk(const lm_estimator* estimator, const lm_damage& used,
                      std::uint32_t risk_q30) {
  lifemodel::Flags saturated;
  return lifemodel::further_damage(shape_of(estimator), damage_of(used),
                                   lifemodel::Ratio::saturated(risk_q30, saturated));
}

}  // namespace

const char* lm_init(lm_estimator* estimator, const void* block, size_t block_bytes) {
  const std::span bytes(static_cast<const std::byte*>(block), block_bytes);
  const auto parameters = lifemodel::decode(bytes);
  if (!parameters) {
    const auto front = lifemodel::block_bytes(bytes);
    if (front && bytes.size() >= *front + 4 &&
        lifemodel::ByteReader(bytes.subspan(*front)).u32() == lifemodel::kExtensionMagic) {
      return "it has an extension, which the C interface does not evaluate: pack a model without";
    }
    return lifemodel::to_string(parameters.error());
  }
  new (estimator->storage) One({*parameters});
  return nullptr;
}

bool lm_push_tension(lm_estimator* estimator, int32_t tension_q29) {
  One& one = estimator_of(estimator);
  return one.push(0, lifemodel::Tension::saturated(tension_q29, one.input_flags(0)));
}

bool lm_push_tension_mN(lm_estimator* estimator, int32_t tension_mN) {
  One& one = estimator_of(estimator);
  return one.push(0, one.parameters(0).scale.tension(tension_mN, one.input_flags(0)));
}

bool lm_push_current_mA(lm_estimator* estimator, int32_t current_mA) {
  One& one = estimator_of(estimator);
  return one.push(0, lifemodel::MotorCurrent::from_milli(current_mA, one.input_flags(0)));
}

void lm_push_missing(lm_estimator* estimator) {
  estimator_of(estimator).push_missing(0);
}

bool lm_settle(lm_estimator* estimator) {
  return estimator_of(estimator).settle();
}

void lm_read(lm_estimator* estimator, lm_reading* reading) {
  One& one = estimator_of(estimator);
  const lifemodel::Reading r = one.reading(0);
  reading->closed = words_of(r.closed);
  reading->open = words_of(r.open);
  reading->total = words_of(r.total);
  reading->closed_cycles = r.closed_cycles.raw();
  reading->open_half_cycles = r.open_half_cycles.raw();
  reading->flags = r.flags.bits();
  reading->survival_q30 = one.parameters(0).life.survival(r.total).raw();
  reading->damage_ppb = r.total.parts_per_billion();
}

uint32_t lm_repeats_to_b10(const lm_estimator* estimator, const lm_damage* used,
                           const lm_damage* each) {
  return lifemodel::remaining_repeats(damage_of(*used), damage_of(*each),
                                      estimator_of(estimator).parameters(0).life.b10);
}

void lm_further_damage(const lm_estimator* estimator, const lm_damage* used, uint32_t risk_q30,
                       lm_damage* further) {
  *further = words_of(damage_at_risk(estimator, *used, risk_q30));
}

uint32_t lm_break_risk_q30(const lm_estimator* estimator, const lm_damage* used,
                           const lm_damage* further) {
  return lifemodel::break_risk(shape_of(estimator), damage_of(*used), damage_of(*further)).raw();
}

uint32_t lm_repeats_to_risk(const lm_estimator* estimator, const lm_damage* used,
                            const lm_damage* each, uint32_t risk_q30) {
  return lifemodel::repeats_within(damage_at_risk(estimator, *used, risk_q30), damage_of(*each));
}

size_t lm_snapshot(const lm_estimator* estimator, void* out) {
  return estimator_of(estimator).snapshot({static_cast<std::byte*>(out), LM_SNAPSHOT_BYTES}).size();
}

const char* lm_restore(lm_estimator* estimator, const void* snapshot, size_t snapshot_bytes) {
  const auto error =
      estimator_of(estimator).restore({static_cast<const std::byte*>(snapshot), snapshot_bytes});
  return error == lifemodel::SnapshotError::none ? nullptr : lifemodel::to_string(error);
}
