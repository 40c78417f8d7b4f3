/* stm32g431xx.h includes it, and needs nothing of it. */
#pragma once
