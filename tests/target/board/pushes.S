  .syntax unified
  .thumb
  .text

// void push_nothing(uint32_t): uses no stack.
  .global push_nothing
  .type push_nothing, %function
push_nothing:
  bx lr
  .size push_nothing, . - push_nothing

// void push_words(uint32_t count): writes `count` words below the stack pointer, then takes them back.
  .global push_words
  .type push_words, %function
push_words:
  mov r1, sp
1:
  push {r0}
  subs r0, #1
  bne 1b
  mov sp, r1
  bx lr
  .size push_words, . - push_words
