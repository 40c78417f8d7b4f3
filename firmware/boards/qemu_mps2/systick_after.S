// uint32_t systick_after(uint32_t a, uint32_t b, uint32_t c, void (*function)(void))
// In assembly, so that nothing but the call lies between the write to SysTick and its reading.

  .syntax unified
  .thumb
  .section .text.systick_after, "ax"
  .global systick_after
  .type systick_after, %function
systick_after:
  push {r4, lr}
  ldr r4, =0xE000E018
  str r4, [r4]
  blx r3
  ldr r0, [r4]
  pop {r4, pc}
  .size systick_after, . - systick_after
