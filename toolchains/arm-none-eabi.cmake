# GNU Arm Embedded: what every bare-metal Arm target has in common. The file of a CPU sets
# TENDONLIFE_CPU_FLAGS and then includes this one.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(TENDONLIFE_TRIPLE arm-none-eabi)
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")

# There is no start-up code to link a trial program with.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(_common "${TENDONLIFE_CPU_FLAGS} -ffunction-sections -fdata-sections -fno-common")
set(CMAKE_ASM_FLAGS_INIT "${TENDONLIFE_CPU_FLAGS}")
set(CMAKE_C_FLAGS_INIT "${_common}")
set(CMAKE_CXX_FLAGS_INIT
  "${_common} -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections -Wl,--fatal-warnings")
