# The package as strangers use it: installed below the build directory and found by CMake and pkg-config, or built as part
# of another project, static and shared. Programs outside link it and run.
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix)
set(consumer_dir ${CMAKE_CURRENT_BINARY_DIR}/consumer)
set(scripts_dir ${CMAKE_CURRENT_SOURCE_DIR}/package)

add_test(NAME package_version
  COMMAND ${CMAKE_COMMAND} -DVERSION=${PROJECT_VERSION} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
          -P ${scripts_dir}/check_version.cmake)

# What the README shows is that very program.
add_test(NAME readme_example
  COMMAND ${CMAKE_COMMAND} -DREADME=${PROJECT_SOURCE_DIR}/README.md
          -DEXAMPLE=${CMAKE_CURRENT_SOURCE_DIR}/consumer/example.cpp
          -P ${CMAKE_CURRENT_SOURCE_DIR}/check_readme.cmake)

add_test(NAME package_install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
set_tests_properties(package_install PROPERTIES FIXTURES_SETUP package)

if(BUILD_SHARED_LIBS)
  set(kind shared)
else()
  set(kind static)
endif()
set(how_to_build -DTBB_DIR=${TBB_DIR} -DCMAKE_TOOLCHAIN_FILE=${CMAKE_TOOLCHAIN_FILE}
  -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER})

# Compiled for the oldest CPU there is, as whoever links the library may be.
set(flags ${CMAKE_CXX_FLAGS})
if(hatbox_is_x86)
  string(APPEND flags " -march=x86-64")
endif()
add_test(NAME package_consumer
  COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${consumer_dir}
    --build-generator ${CMAKE_GENERATOR}
    --build-options -Dhatbox_ROOT=${prefix} ${how_to_build} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
      -DCMAKE_CXX_FLAGS=${flags} -DCONSUMER_KIND=${kind}
    --test-command ${CMAKE_CROSSCOMPILING_EMULATOR} ${consumer_dir}/example)
set_tests_properties(package_consumer PROPERTIES FIXTURES_REQUIRED package FIXTURES_SETUP consumer)
foreach(program direct every_isa mis)
  add_test(NAME consumer_${program} COMMAND ${CMAKE_CROSSCOMPILING_EMULATOR} ${consumer_dir}/${program})
  set_tests_properties(consumer_${program} PROPERTIES FIXTURES_REQUIRED consumer)
endforeach()

function(hatbox_add_refusal name expected)  # find_package with ARGN must fail so
  add_test(NAME package_refuses_${name}
    COMMAND ${CMAKE_COMMAND} -S ${scripts_dir}/refusal -B ${CMAKE_CURRENT_BINARY_DIR}/refusal/${name}
            -Dhatbox_ROOT=${prefix} -DTBB_DIR=${TBB_DIR} "-DWANTED=${ARGN}")
  set_tests_properties(package_refuses_${name} PROPERTIES
    FIXTURES_REQUIRED package PASS_REGULAR_EXPRESSION "${expected}")
endfunction()
hatbox_add_refusal(component "no component \"gpu\", only[ \n]+\"${kind}\"" COMPONENTS gpu)
hatbox_add_refusal(version "requested version \"0.2\"" 0.2)

# The rest is of the release and not of how it is compiled: not again under sanitizers nor under emulation.
if(CMAKE_CROSSCOMPILING OR HATBOX_SANITIZERS OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()

if(hatbox_is_x86 AND kind STREQUAL static)
  add_test(NAME consumer_instructions
    COMMAND sh -c "\"$1\" --disassemble --no-show-raw-insn \"$2\" | awk -f \"$3\"" -
            ${CMAKE_OBJDUMP} ${consumer_dir}/mis ${scripts_dir}/check_instructions.awk)
  set_tests_properties(consumer_instructions PROPERTIES FIXTURES_REQUIRED consumer)
endif()

find_program(HATBOX_PKG_CONFIG NAMES pkg-config pkgconf)
function(hatbox_add_pkg_config_test name prefix kind)
  add_test(NAME ${name}
    COMMAND ${CMAKE_COMMAND} -DPKG_CONFIG=${HATBOX_PKG_CONFIG} -DPREFIX=${prefix} -DKIND=${kind}
            -DLIBDIR=${CMAKE_INSTALL_LIBDIR} -DVERSION=${PROJECT_VERSION} -DCXX=${CMAKE_CXX_COMPILER}
            -DSOURCE=${CMAKE_CURRENT_SOURCE_DIR}/consumer/example.cpp
            -DWORK_DIR=${CMAKE_CURRENT_BINARY_DIR}/${name} -P ${scripts_dir}/pkg_config_consumer.cmake)
  set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
endfunction()
hatbox_add_pkg_config_test(package_pkg_config ${prefix} ${kind})
set_tests_properties(package_pkg_config PROPERTIES FIXTURES_REQUIRED package)

# As part of another project, which asks for a shared library of the slow kernels, not optimized, by flags that would undo
# what kernels count on. The second way finds compiled what the first one needed, and installs it.
set(parent_flags "-O0 -ffast-math")
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  string(APPEND parent_flags " -flto")  # clang's asks for a linker's plugin
endif()
if(hatbox_is_x86)
  file(STRINGS /proc/cpuinfo has_avx2 REGEX "^flags.* avx2 ")
  if(has_avx2)
    string(APPEND parent_flags " -march=haswell")
  endif()
endif()
set(parent_dir ${CMAKE_CURRENT_BINARY_DIR}/parent)
set(shared_prefix ${CMAKE_CURRENT_BINARY_DIR}/shared_prefix)
function(hatbox_add_parent name)
  add_test(NAME parent_${name}
    COMMAND ${CMAKE_CTEST_COMMAND}
      --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/parent ${parent_dir}
      --build-generator ${CMAKE_GENERATOR} --build-noclean
      --build-options -DHATBOX_SOURCE_DIR=${PROJECT_SOURCE_DIR} ${how_to_build} -Dxsimd_DIR=${xsimd_DIR}
        -DBUILD_SHARED_LIBS=ON -DHATBOX_ISAS=sse4_2 "-DCMAKE_CXX_FLAGS=${parent_flags}" ${ARGN}
      --test-command ${parent_dir}/parent)
endfunction()
hatbox_add_parent(fetch_content -DPARENT_FETCHES=ON -DHATBOX_INSTALL=OFF)
set_tests_properties(parent_fetch_content PROPERTIES FIXTURES_SETUP parent TIMEOUT 600)
set(parent_kernels ${parent_dir}/_deps/hatbox-build/kernels/hatbox_kernels_scalar.o)
add_test(NAME parent_kernel_symbols
  COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DREADELF=${CMAKE_READELF} -DOBJECTS=${parent_kernels}
          -P ${PROJECT_SOURCE_DIR}/cmake/check_kernel_symbols.cmake)
set_tests_properties(parent_kernel_symbols PROPERTIES FIXTURES_REQUIRED parent)
add_test(NAME parent_installs_its_own
  COMMAND ${CMAKE_COMMAND} -DBINARY_DIR=${parent_dir} -DPREFIX=${CMAKE_CURRENT_BINARY_DIR}/parent_prefix
          -P ${scripts_dir}/check_parent_install.cmake)
set_tests_properties(parent_installs_its_own PROPERTIES FIXTURES_REQUIRED parent FIXTURES_SETUP parent_installed)
hatbox_add_parent(add_subdirectory -DPARENT_FETCHES=OFF -DHATBOX_INSTALL=ON)
set_tests_properties(parent_add_subdirectory PROPERTIES
  FIXTURES_REQUIRED "parent;parent_installed" FIXTURES_SETUP shared TIMEOUT 600)

add_test(NAME shared_install COMMAND ${CMAKE_COMMAND} --install ${parent_dir} --prefix ${shared_prefix})
set_tests_properties(shared_install PROPERTIES FIXTURES_REQUIRED shared FIXTURES_SETUP shared_package)
add_test(NAME shared_symbols
  COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DINCLUDE_DIR=${PROJECT_SOURCE_DIR}/include
          -DLIBRARY=${shared_prefix}/${CMAKE_INSTALL_LIBDIR}/libhatbox.so.${PROJECT_VERSION}
          -P ${scripts_dir}/check_exports.cmake)
set_tests_properties(shared_symbols PROPERTIES FIXTURES_REQUIRED shared_package)
set(shared_consumer_dir ${CMAKE_CURRENT_BINARY_DIR}/shared_consumer)
add_test(NAME shared_consumer
  COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${shared_consumer_dir}
    --build-generator ${CMAKE_GENERATOR}
    --build-options -Dhatbox_ROOT=${shared_prefix} ${how_to_build} -DCONSUMER_KIND=shared -DCONSUMER_PROGRAMS=every_isa
      -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON
    --test-command ${shared_consumer_dir}/every_isa)
set_tests_properties(shared_consumer PROPERTIES FIXTURES_REQUIRED shared_package)
hatbox_add_pkg_config_test(shared_pkg_config ${shared_prefix} shared)
set_tests_properties(shared_pkg_config PROPERTIES FIXTURES_REQUIRED shared_package)
