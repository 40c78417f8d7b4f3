set(embed_assets_script "${CMAKE_CURRENT_LIST_DIR}/embed_assets.cmake")

# embed_assets(OUTPUT HEADER <include> NAMESPACE <namespace> ASSETS name=file name=file1+file2...)
# Writes OUTPUT, a C++ file that defines the texts that the header declares, when a file changes.
function(embed_assets output)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADER;NAMESPACE" "ASSETS")
  list(JOIN arg_ASSETS "," assets)
  set(files "${arg_ASSETS}")
  list(TRANSFORM files REPLACE "^[a-z_]+=" "")
  string(REPLACE "+" ";" files "${files}")
  add_custom_command(OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DHEADER=${arg_HEADER}"
      "-DNAMESPACE=${arg_NAMESPACE}" "-DASSETS=${assets}" -P "${embed_assets_script}"
    DEPENDS "${embed_assets_script}" ${files}
    COMMENT "Embedding ${arg_HEADER}"
    VERBATIM)
endfunction()
