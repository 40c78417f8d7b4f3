# Options, warnings and instrumentation shared by every target of the project.
include(CMakeDependentOption)

option(TENDONLIFE_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
cmake_dependent_option(TENDONLIFE_HOST "Build host_sim" ${PROJECT_IS_TOP_LEVEL}
  "NOT CMAKE_CROSSCOMPILING" OFF)
option(TENDONLIFE_INSTALL "Install lifemodel" ${PROJECT_IS_TOP_LEVEL})
option(TENDONLIFE_SANITIZE "Address and undefined-behaviour sanitizers" OFF)
option(TENDONLIFE_COVERAGE "Line and branch coverage" OFF)
option(TENDONLIFE_FUZZ "Build the libFuzzer targets (Clang)" OFF)
option(TENDONLIFE_BENCH "Build the host benchmarks" OFF)
option(TENDONLIFE_LONG_TESTS "Build what takes long to run, too: blind campaigns, proofs, a virtual board, a kernel, pages in a browser" ON)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# For who changes the project, and not for who has a newer compiler.
set(TENDONLIFE_WARNINGS_ARE_ERRORS "$ENV{TENDONLIFE_WARNINGS_ARE_ERRORS}" CACHE BOOL "Warnings are errors")
add_library(project_warnings INTERFACE)
target_compile_options(project_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow
  -Wswitch-enum $<$<BOOL:${TENDONLIFE_WARNINGS_ARE_ERRORS}>:-Werror>)
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC takes each source but the first of such a build for a header.
  target_compile_options(project_warnings INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage>)
endif()

if(TENDONLIFE_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
if(TENDONLIFE_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()
