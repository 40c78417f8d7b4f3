set(embed_assets_script "${CMAKE_CURRENT_LIST_DIR}/embed_assets.cmake")

# embed_assets(FOLDER NAMESPACE NAME=FILE NAME=FILE+FILE...)
# Writes a C++ file that defines the texts, which FOLDER declares in assets.hpp or where it uses them, when a file
# changes, and sets `embedded` to its name.
function(embed_assets folder namespace)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${folder}/assets.cpp")
  set(assets "")
  set(files "")
  foreach(asset IN LISTS ARGN)
    string(REGEX MATCH "^([a-z_]+)=(.+)$" _ "${asset}")
    set(name "${CMAKE_MATCH_1}")
    string(REPLACE "+" ";" own "${CMAKE_MATCH_2}")
    list(TRANSFORM own PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" REGEX "^[^/]")
    list(APPEND files ${own})
    list(JOIN own "+" own)
    list(APPEND assets "${name}=${own}")
  endforeach()
  list(JOIN assets "," assets)
  add_custom_command(OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}"
      "-DNAMESPACE=${namespace}" "-DASSETS=${assets}" -P "${embed_assets_script}"
    DEPENDS "${embed_assets_script}" ${files}
    COMMENT "Embedding ${namespace}"
    VERBATIM)
  set(embedded "${output}" PARENT_SCOPE)
endfunction()
