#ifndef TESTS_LIFEMODEL_C_INTERFACE_IN_C_H
#define TESTS_LIFEMODEL_C_INTERFACE_IN_C_H

#include "lifemodel/c/lifemodel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Pushes `count` tensions through the C interface, in C, saving and restoring half-way. */
const char* count_in_c(const void* block, size_t block_bytes, const int32_t* tensions_q29,
                       size_t count, lm_reading* reading);

#ifdef __cplusplus
}
#endif

#endif
