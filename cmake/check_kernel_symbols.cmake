# Fails unless each of OBJECTS, .../hatbox_kernels_<isa>.o, exports its table alone, takes part in no merging by the
# linker nor in its optimization, and asks for no C++ function from outside: that one could be compiled for any
# instruction set.
function(run_tool variable)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()

if(NOT OBJECTS)
  message(FATAL_ERROR "no kernel objects to look at")
endif()
foreach(object IN LISTS OBJECTS)
  cmake_path(GET object STEM table)

  run_tool(symbols ${NM} --format=posix --defined-only --extern-only ${object})
  if(NOT symbols MATCHES "^${table} [A-Z] [^\n]*\n$")
    message(SEND_ERROR "${object} exports more, or other, than ${table}:\n${symbols}")
  endif()

  run_tool(groups ${READELF} --wide --section-groups ${object})
  if(groups MATCHES "group section")
    message(SEND_ERROR "${object} has section groups a linker may merge:\n${groups}")
  endif()

  run_tool(sections ${READELF} --wide --section-headers ${object})
  if(sections MATCHES "gnu\\.lto")
    message(SEND_ERROR "${object} has code for a linker to optimize:\n${sections}")
  endif()

  run_tool(wanted ${NM} --format=posix --undefined-only ${object})
  if(wanted MATCHES "(^|\n)_Z")
    message(SEND_ERROR "${object} needs C++ functions from outside:\n${wanted}")
  endif()
endforeach()
