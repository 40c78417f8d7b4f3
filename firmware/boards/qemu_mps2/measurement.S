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

// uint32_t paint_gone_after(uint32_t a, uint32_t b, uint32_t c, void (*function)(void))
// In assembly, because it paints right up to its own stack pointer.

  .section .text.paint_gone_after, "ax"
  .global paint_gone_after
  .type paint_gone_after, %function
paint_gone_after:
  push {r4, r5, r6, lr}
  ldr r4, =stack_limit
  ldr r5, =0xC5A35CE9
  mov r6, r4
  mov r12, sp
1:
  str r5, [r6], #4
  cmp r6, r12
  blo 1b
  blx r3
2:
  ldr r0, [r4], #4
  cmp r0, r5
  bne 3f
  cmp r4, r6
  blo 2b
  add r4, #4
3:
  sub r0, r6, r4
  add r0, #4
  pop {r4, r5, r6, pc}
  .size paint_gone_after, . - paint_gone_after
