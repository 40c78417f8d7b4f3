# The chart library of the pages: uplot_js, uplot_css and uplot_licence are its files.
set(fetch_uplot "${PROJECT_SOURCE_DIR}/toolchains/fetch_uplot.sh")
if(NOT TENDONLIFE_UPLOT_DIR)
  execute_process(COMMAND "${fetch_uplot}" --folder
    OUTPUT_VARIABLE uplot_default OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
endif()
set(TENDONLIFE_UPLOT_DIR "${uplot_default}" CACHE PATH
  "Folder with uPlot.iife.min.js, uPlot.min.css and LICENSE of uPlot 1.6")
set(uplot_js "${TENDONLIFE_UPLOT_DIR}/uPlot.iife.min.js")
set(uplot_css "${TENDONLIFE_UPLOT_DIR}/uPlot.min.css")
set(uplot_licence "${TENDONLIFE_UPLOT_DIR}/LICENSE")
if(NOT EXISTS "${uplot_js}" OR NOT EXISTS "${uplot_css}" OR NOT EXISTS "${uplot_licence}")
  execute_process(COMMAND "${fetch_uplot}" "${TENDONLIFE_UPLOT_DIR}" RESULT_VARIABLE fetch_result)
  if(NOT fetch_result EQUAL 0)
    message(FATAL_ERROR "The chart library uPlot is missing from ${TENDONLIFE_UPLOT_DIR} and could "
      "not be fetched (see above). Run ${fetch_uplot} where there is a network, or set "
      "TENDONLIFE_UPLOT_DIR to a folder that holds its files.")
  endif()
endif()
