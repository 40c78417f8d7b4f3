# Linux on 32-bit Arm with hardware floating point (ARMv7).
set(CMAKE_SYSTEM_PROCESSOR arm)
set(TENDONLIFE_TRIPLE arm-linux-gnueabihf)
set(TENDONLIFE_DEBIAN_ARCHITECTURE armhf)
set(TENDONLIFE_QEMU qemu-arm-static)
# All code is built by one compiler: that GCC 7.1 changed how some types are passed is of no interest.
set(CMAKE_CXX_FLAGS_INIT "-Wno-psabi")
include("${CMAKE_CURRENT_LIST_DIR}/linux-gnu.cmake")
