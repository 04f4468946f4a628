# The installed package: install it below the build directory, then build and run programs outside that find it.
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix)
set(consumer_dir ${CMAKE_CURRENT_BINARY_DIR}/consumer)

add_test(NAME package_install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
set_tests_properties(package_install PROPERTIES FIXTURES_SETUP package)

add_test(NAME package_consumer
  COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${consumer_dir}
    --build-generator ${CMAKE_GENERATOR}
    --build-options -Dhatbox_ROOT=${prefix} -DTBB_DIR=${TBB_DIR} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
      -DCMAKE_TOOLCHAIN_FILE=${CMAKE_TOOLCHAIN_FILE} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}
    --test-command ${CMAKE_CROSSCOMPILING_EMULATOR} ${consumer_dir}/example)
set_tests_properties(package_consumer PROPERTIES FIXTURES_REQUIRED package FIXTURES_SETUP consumer)
foreach(program direct mis)
  add_test(NAME consumer_${program} COMMAND ${CMAKE_CROSSCOMPILING_EMULATOR} ${consumer_dir}/${program})
  set_tests_properties(consumer_${program} PROPERTIES FIXTURES_REQUIRED consumer)
endforeach()

# What the README shows is that very program.
add_test(NAME readme_example
  COMMAND ${CMAKE_COMMAND} -DREADME=${PROJECT_SOURCE_DIR}/README.md
          -DEXAMPLE=${CMAKE_CURRENT_SOURCE_DIR}/consumer/example.cpp
          -P ${CMAKE_CURRENT_SOURCE_DIR}/check_readme.cmake)
