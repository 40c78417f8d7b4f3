# Cortex-M4 with its floating-point unit, which our code never uses: with -mgeneral-regs-only no
# instruction can name one of its registers. (The hard-float ABI would refuse the standard headers.)
set(TENDONLIFE_CPU_FLAGS
  "-mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=softfp -mgeneral-regs-only")
include("${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake")

# Tests run under QEMU. -icount shift=6 makes every instruction take 64 ns of virtual time, so that
# counts are the same in every run and on every machine.
set(CMAKE_CROSSCOMPILING_EMULATOR
  "qemu-system-arm;-M;mps2-an386;-cpu;cortex-m4;-nographic;-monitor;none;-serial;null;-icount;shift=6;-semihosting-config;enable=on,target=native;-kernel")
