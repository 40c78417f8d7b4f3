# Linux on 64-bit Arm.
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(TENDONLIFE_TRIPLE aarch64-linux-gnu)
set(TENDONLIFE_DEBIAN_ARCHITECTURE arm64)
set(TENDONLIFE_QEMU qemu-aarch64-static)
include("${CMAKE_CURRENT_LIST_DIR}/linux-gnu.cmake")
