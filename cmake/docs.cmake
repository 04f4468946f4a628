# cmake -DOUT=<directory> -P cmake/docs.cmake: the HTML of the public headers, by doxygen. Fails on its warnings.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH source_dir)
cmake_path(ABSOLUTE_PATH OUT OUTPUT_VARIABLE output)

# The version stands in one place: there.
file(STRINGS ${source_dir}/CMakeLists.txt project REGEX "^project\\(")
string(REGEX MATCH "VERSION (([0-9]+)\\.([0-9]+)\\.([0-9]+))" found "${project}")
set(PROJECT_VERSION ${CMAKE_MATCH_1})
set(PROJECT_VERSION_MAJOR ${CMAKE_MATCH_2})
set(PROJECT_VERSION_MINOR ${CMAKE_MATCH_3})
set(PROJECT_VERSION_PATCH ${CMAKE_MATCH_4})

file(REMOVE_RECURSE ${output})
configure_file(${source_dir}/cmake/version.h.in ${output}/include/hatbox/version.h @ONLY)
configure_file(${source_dir}/cmake/Doxyfile.in ${output}/Doxyfile @ONLY)
execute_process(COMMAND doxygen ${output}/Doxyfile RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "doxygen has something to say")
endif()
