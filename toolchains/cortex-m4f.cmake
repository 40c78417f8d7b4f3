# Cortex-M4 with its floating-point unit, which our code never uses: with -mgeneral-regs-only no
# instruction can name one of its registers. (The hard-float ABI would refuse the standard headers.)
set(TENDONLIFE_CPU_FLAGS
  "-mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=softfp -mgeneral-regs-only")
include("${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake")
