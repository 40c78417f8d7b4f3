# Linux on 32-bit Arm with hardware floating point (ARMv7).
set(CMAKE_SYSTEM_PROCESSOR arm)
set(TENDONLIFE_TRIPLE arm-linux-gnueabihf)
set(TENDONLIFE_DEBIAN_ARCHITECTURE armhf)
set(TENDONLIFE_QEMU qemu-arm-static)
include("${CMAKE_CURRENT_LIST_DIR}/linux-gnu.cmake")
