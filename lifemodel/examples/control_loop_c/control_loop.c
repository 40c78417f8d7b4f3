/* The estimator in a control loop written in C. The parameter block comes from `host_sim pack`. */
#include <lifemodel/c/lifemodel.h>
#include <stdio.h>

static lm_estimator estimator;

int main(int argc, char** argv) {
  unsigned char block[LM_PARAMETER_BLOCK_BYTES + 4]; /* lm_init refuses what is longer */
  FILE* file = argc > 1 ? fopen(argv[1], "rb") : NULL;
  if (file == NULL) {
    fprintf(stderr, "usage: control_loop_c PARAMETER_BLOCK\n");
    return 2;
  }
  size_t bytes = fread(block, 1, sizeof block, file);
  fclose(file);
  const char* refused = lm_init(&estimator, block, bytes);
  if (refused != NULL) {
    fprintf(stderr, "parameter block refused: %s\n", refused);
    return 1;
  }
  for (int tick = 0; tick < 60000; ++tick) {
    int32_t tension_mN = 14000 + 68 * (tick % 1000 < 500 ? tick % 500 : 500 - tick % 500);
    if (lm_push_tension_mN(&estimator, tension_mN)) {
      lm_settle(&estimator);
    }
  }
  lm_reading reading;
  lm_read(&estimator, &reading);
  printf("life used: %u ppb\n", (unsigned)reading.damage_ppb);
  return 0;
}
