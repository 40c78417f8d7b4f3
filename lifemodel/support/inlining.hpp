#pragma once

/// On the target one copy of the arithmetic of a cycle is kept, because code is scarce; on a host
/// it is inlined, because calls cost more than memory.
#if defined(__arm__)
#define LIFEMODEL_ONE_COPY __attribute__((noinline))
#else
#define LIFEMODEL_ONE_COPY __attribute__((always_inline)) inline
#endif
