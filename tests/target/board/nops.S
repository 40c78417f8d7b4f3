  .syntax unified
  .thumb
  .text

// void run_nops(uint32_t count): `count` nops, 0 .. 1000, between four instructions and a return.
  .global run_nops
  .type run_nops, %function
run_nops:
  ldr r1, =nops_end
  sub r1, r1, r0, lsl #1
  orr r1, r1, #1
  bx r1
  .rept 1000
  nop
  .endr
nops_end:
  bx lr
  .size run_nops, . - run_nops

// void run_loop(uint32_t rounds): two instructions a round, and a return.
  .global run_loop
  .type run_loop, %function
run_loop:
  subs r0, #1
  bne run_loop
  bx lr
  .size run_loop, . - run_loop
