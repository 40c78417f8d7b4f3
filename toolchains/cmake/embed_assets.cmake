# cmake -DOUTPUT=<cpp> -DNAMESPACE=<ns> "-DASSETS=name=file,name=file1+file2" -P embed_assets.cmake
# Writes a C++ file that defines one std::string_view for each name, holding its files in order.
set(code "#include <string_view>\n\nnamespace ${NAMESPACE} {\n")
string(REPLACE "," ";" assets "${ASSETS}")
foreach(asset IN LISTS assets)
  string(REGEX MATCH "^([a-z_]+)=(.+)$" matched "${asset}")
  if(NOT matched)
    message(FATAL_ERROR "embed_assets: '${asset}' is not name=file")
  endif()
  set(name "${CMAKE_MATCH_1}")
  string(REPLACE "+" ";" files "${CMAKE_MATCH_2}")
  set(bytes "")
  foreach(file IN LISTS files)
    file(READ "${file}" hex HEX)
    string(REGEX REPLACE "(..)" "'\\\\x\\1'," part "${hex}")
    string(APPEND bytes "${part}\n")
  endforeach()
  string(APPEND code
    "static constexpr char kBytes_${name}[] = {\n${bytes}};\n"
    "extern constinit const std::string_view ${name}(kBytes_${name}, sizeof kBytes_${name});\n")
endforeach()
string(APPEND code "}  // namespace ${NAMESPACE}\n")
file(WRITE "${OUTPUT}" "${code}")
