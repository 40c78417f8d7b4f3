# Linux on another processor, with Debian's cross compiler. The thin file sets TENDONLIFE_TRIPLE,
# TENDONLIFE_DEBIAN_ARCHITECTURE and TENDONLIFE_QEMU. Programs that are built run under QEMU's user
# mode.
set(CMAKE_SYSTEM_NAME Linux)
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")

execute_process(
  COMMAND "${CMAKE_CURRENT_LIST_DIR}/sysroot.sh" --folder "${TENDONLIFE_DEBIAN_ARCHITECTURE}"
  OUTPUT_VARIABLE _sysroot OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
if(NOT EXISTS "${_sysroot}/packages.sha256")
  message(FATAL_ERROR "The libraries for ${TENDONLIFE_DEBIAN_ARCHITECTURE} are not in ${_sysroot}: "
    "run toolchains/sysroot.sh ${TENDONLIFE_DEBIAN_ARCHITECTURE}")
endif()
set(CMAKE_FIND_ROOT_PATH "${_sysroot}" "/usr/${TENDONLIFE_TRIPLE}")
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_LIBRARY_ARCHITECTURE "${TENDONLIFE_TRIPLE}")
set(_libraries "${_sysroot}/usr/lib/${TENDONLIFE_TRIPLE}")
set(ENV{PKG_CONFIG_LIBDIR} "${_libraries}/pkgconfig")
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${_sysroot}")

foreach(_language C CXX)
  set(CMAKE_${_language}_STANDARD_INCLUDE_DIRECTORIES "${_sysroot}/usr/include")
endforeach()
set(CMAKE_EXE_LINKER_FLAGS_INIT "-L${_libraries} -Wl,-rpath-link,${_libraries}")

find_program(TENDONLIFE_EMULATOR "${TENDONLIFE_QEMU}")
if(TENDONLIFE_EMULATOR)
  set(CMAKE_CROSSCOMPILING_EMULATOR "${TENDONLIFE_EMULATOR};-L;/usr/${TENDONLIFE_TRIPLE};-E;LD_LIBRARY_PATH=${_libraries}:${_sysroot}/lib/${TENDONLIFE_TRIPLE}")
endif()
