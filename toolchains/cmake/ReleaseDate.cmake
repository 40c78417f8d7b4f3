# The newest entry of the changelog tells version and date of the release; both are those of every
# manual page and package.
set(TENDONLIFE_CHANGELOG "${PROJECT_SOURCE_DIR}/toolchains/debian/changelog")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${TENDONLIFE_CHANGELOG}")
file(STRINGS "${TENDONLIFE_CHANGELOG}" _first LIMIT_COUNT 1)
if(NOT _first MATCHES "^tendonlife \\(${PROJECT_VERSION}\\) ")
  message(FATAL_ERROR "${TENDONLIFE_CHANGELOG}:1: '${_first}' is no entry of version ${PROJECT_VERSION}")
endif()
file(STRINGS "${TENDONLIFE_CHANGELOG}" _signed REGEX "^ -- .*  " LIMIT_COUNT 1)
string(REGEX REPLACE "^ -- .*  " "" _date "${_signed}")
foreach(_format "DATE;+%Y-%m-%d" "EPOCH;+%s")
  list(GET _format 0 _name)
  list(GET _format 1 _how)
  execute_process(COMMAND date -u -d "${_date}" "${_how}"
    OUTPUT_VARIABLE TENDONLIFE_RELEASE_${_name} OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
