# What every GNU cross compiler has in common. A thin file sets TENDONLIFE_TRIPLE, and what is its
# own, and includes this one.
foreach(_language C CXX ASM)
  set(_driver gcc)
  if(_language STREQUAL "CXX")
    set(_driver g++)
  endif()
  set(CMAKE_${_language}_COMPILER "${TENDONLIFE_TRIPLE}-${_driver}")
endforeach()

# Programs are those of this machine, all else is the target's.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)

foreach(_language C CXX)
  set(CMAKE_${_language}_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of release builds")
endforeach()
