#include "c_interface_in_c.h"

const char* count_in_c(const void* block, size_t block_bytes, const int32_t* tensions_q29,
                       size_t count, lm_reading* reading) {
  lm_estimator first;
  lm_estimator second;
  unsigned char snapshot[LM_SNAPSHOT_BYTES];
  lm_estimator* active = &first;
  const char* refused = lm_init(&first, block, block_bytes);
  if (refused == NULL) {
    refused = lm_init(&second, block, block_bytes);
  }
  for (size_t i = 0; i < count && refused == NULL; ++i) {
    if (i == count / 2) {
      refused = lm_restore(&second, snapshot, lm_snapshot(&first, snapshot));
      active = &second;
    }
    if (lm_push_tension(active, tensions_q29[i])) {
      lm_settle(active);
    }
  }
  if (refused == NULL) {
    lm_read(active, reading);
  }
  return refused;
}
