# GCC writes the call graph of each object of a target, with stack frames, beside the object as .ci.
# A compiler cache would bring back the object alone.
function(write_call_graph target)
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fcallgraph-info=su>)
  set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "")
endfunction()
