/* What stm32g431xx.h needs of CMSIS-Core. */
#pragma once

#include <stdint.h>

#define __I volatile const
#define __O volatile
#define __IO volatile
