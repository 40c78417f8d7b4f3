#ifndef LIFEMODEL_C_LIFEMODEL_H
#define LIFEMODEL_C_LIFEMODEL_H

/* The life estimator of one tendon, for firmware written in C. See estimator.hpp for what each call
 * does and may interrupt; the same code runs behind both. */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LM_PARAMETER_BLOCK_BYTES 128u /* of the longest block */
#define LM_STORAGE_BYTES 960u
#define LM_SNAPSHOT_BYTES 808u

/* Memory of one estimator, owned by the caller. */
typedef struct lm_estimator {
  uint64_t storage[LM_STORAGE_BYTES / 8u];
} lm_estimator;

/* Damage in steps of 2^-104, least significant word first. 1 is one life. */
typedef struct lm_damage {
  uint32_t words[4];
} lm_damage;

/* Bits of lm_reading.flags; sticky. */
enum {
  LM_SATURATED = 1,
  LM_OVERLOAD = 2,
  LM_NEGATIVE_TENSION = 4,
  LM_GAP = 8,
  LM_RESIDUE_OVERFLOW = 16,
  LM_OVERRUN = 32
};

typedef struct lm_reading {
  lm_damage closed;          /* full cycles */
  lm_damage open;            /* half cycles of the residue */
  lm_damage total;           /* closed + open */
  uint64_t closed_cycles;    /* full cycles counted */
  uint64_t open_half_cycles; /* half cycles counted or open */
  uint32_t flags;            /* LM_... */
  uint32_t survival_q30;     /* probability that the wire is whole, 0 .. 2^30 */
  uint32_t damage_ppb;       /* total damage in 1e-9, rounded down; 2^32 - 1 at most */
} lm_reading;

/* Takes a parameter block into use. NULL, or the reason for which the block is refused: one with an
 * extension is. Give all bytes that there are, also those beyond LM_PARAMETER_BLOCK_BYTES. */
const char* lm_init(lm_estimator* estimator, const void* block, size_t block_bytes);

/* One sample of input tension in steps of 2^-29 of the ultimate tension. True where enough waits by
 * now for lm_settle to be worth its call. May interrupt lm_settle and lm_read, as the other ways to
 * push may. */
bool lm_push_tension(lm_estimator* estimator, int32_t tension_q29);
/* One sample of input tension in mN. */
bool lm_push_tension_mN(lm_estimator* estimator, int32_t tension_mN);
/* One sample of motor current in mA. Counts as missing where the block has no drive. */
bool lm_push_current_mA(lm_estimator* estimator, int32_t current_mA);
/* One sample that is missing. */
void lm_push_missing(lm_estimator* estimator);

/* Counts what was pushed, in bounded time: once for each push that gave true is enough. True while
 * there is more. */
bool lm_settle(lm_estimator* estimator);

/* Life used at this instant. */
void lm_read(lm_estimator* estimator, lm_reading* reading);

/* Repeats of a stretch that did `each` damage until 10 % of wires have broken, rounded down: the
 * B10 of the whole life, which a wire may outlive. */
uint32_t lm_repeats_to_b10(const lm_estimator* estimator, const lm_damage* used,
                           const lm_damage* each);

/* Given that the wire is whole at `used` damage, see life/conditional.hpp; risks are 0 .. 2^30.
 *
 * The damage that it takes from there until it has broken with this risk. */
void lm_further_damage(const lm_estimator* estimator, const lm_damage* used, uint32_t risk_q30,
                       lm_damage* further);
/* The risk that it has broken after a further damage. */
uint32_t lm_break_risk_q30(const lm_estimator* estimator, const lm_damage* used,
                           const lm_damage* further);
/* Repeats of a stretch that did `each` damage until it has broken with this risk, rounded down. */
uint32_t lm_repeats_to_risk(const lm_estimator* estimator, const lm_damage* used,
                            const lm_damage* each, uint32_t risk_q30);

/* Writes the state to `out` of LM_SNAPSHOT_BYTES; gives the bytes used. */
size_t lm_snapshot(const lm_estimator* estimator, void* out);
/* Takes up a state. NULL, or the reason for which it is refused; the old state then stays. */
const char* lm_restore(lm_estimator* estimator, const void* snapshot, size_t snapshot_bytes);

#ifdef __cplusplus
}
#endif

#endif
