# Compiles src/kernels.cpp once per instruction set. Leaves hatbox_kernel_objects (object files, each exporting one
# KernelTable named hatbox_kernels_<isa>) and writes generated/isa_list.h, from which dispatch.cpp picks.
set(hatbox_kernel_objects)
set(hatbox_isa_names)
set(hatbox_isa_rows)

# Every kernel object brings its own copy of the same inline functions, compiled with its own flags. A linker that kept
# one copy for all could keep one an old CPU cannot run. So all symbols but the table become local, and the section
# groups, by whose names linkers (bfd, gold and lld alike) drop such duplicates even when they are local, are dissolved.
function(hatbox_localize isa object)
  add_custom_command(OUTPUT ${object}
    COMMAND ${CMAKE_OBJCOPY} --remove-section=.group --keep-global-symbol=hatbox_kernels_${isa}
            $<TARGET_OBJECTS:hatbox_kernels_${isa}> ${object}
    DEPENDS $<TARGET_OBJECTS:hatbox_kernels_${isa}>
    COMMENT "Localizing the symbols of hatbox_kernels_${isa}"
    VERBATIM)
  set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
endfunction()

set(HATBOX_ISAS "" CACHE STRING "The instruction sets to build, of those the platform has; scalar always (empty: all)")
foreach(isa IN LISTS HATBOX_ISAS)
  if(NOT isa MATCHES "^(scalar|sse4_2|avx2|avx512|neon)$")
    message(FATAL_ERROR "HATBOX_ISAS: no instruction set ${isa}, but scalar, sse4_2, avx2, avx512 and neon")
  endif()
endforeach()

function(hatbox_add_isa isa)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "ARCH" "FLAGS;CPU")
  if(HATBOX_ISAS AND NOT isa STREQUAL scalar AND NOT isa IN_LIST HATBOX_ISAS)
    return()
  endif()
  set(target hatbox_kernels_${isa})
  add_library(${target} OBJECT ${PROJECT_SOURCE_DIR}/src/kernels.cpp)
  hatbox_compile_options(${target})
  hatbox_sanitize(${target})
  if(HATBOX_SANITIZERS MATCHES undefined)
    # What they look at is every reference to a vector there is: three quarters of the code, for no array of a caller.
    target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,object-size,vptr)
  endif()
  target_compile_definitions(${target} PRIVATE HATBOX_ISA=${isa})
  # To find out which pointers never meet takes a third of the time, and makes nothing faster.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-pta>)
  # Instructions in an order in which chains overlap: only to be had, on x86, by asking; from statements as they stand.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fschedule-insns;-fsched-pressure;-fno-tree-ter>)
  # FLAGS add to the platform's least CPU, and a user's -march adds nothing.
  target_compile_options(${target} PRIVATE $<$<BOOL:${hatbox_is_x86}>:-march=x86-64>)
  # A unique symbol would stay global whatever objcopy is told, and what a linker optimizes it does not look at.
  target_compile_options(${target} PRIVATE ${arg_FLAGS} -fno-lto $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  set_target_properties(${target} PROPERTIES
    CXX_VISIBILITY_PRESET hidden
    INTERPROCEDURAL_OPTIMIZATION OFF)
  if(arg_ARCH)
    target_compile_definitions(${target} PRIVATE HATBOX_ISA_ARCH=${arg_ARCH})
    target_link_libraries(${target} PRIVATE xsimd)
  endif()

  set(object ${PROJECT_BINARY_DIR}/kernels/${target}.o)
  hatbox_localize(${isa} ${object})

  list(TRANSFORM arg_CPU REPLACE "(.+)" "__builtin_cpu_supports(\"\\1\")")
  list(JOIN arg_CPU " && " supported)
  if(NOT supported)
    set(supported true)
  endif()

  set(hatbox_kernel_objects ${hatbox_kernel_objects} ${object} PARENT_SCOPE)
  set(hatbox_isa_names ${hatbox_isa_names} ${isa} PARENT_SCOPE)
  set(hatbox_isa_rows "${hatbox_isa_rows} \\\n  ROW(${isa}, (${supported}))" PARENT_SCOPE)
endfunction()

file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/kernels)

set(hatbox_is_x86 FALSE)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(hatbox_is_x86 TRUE)
endif()

# g++ 12 warns of its own AVX-512 header, whose undefined vectors are undefined on purpose (GCC bug 105593).
set(avx512_header_warnings $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized>)

# g++ moves structs of vectors in pieces of 16 bytes otherwise, and reading such a vector back whole waits for the pieces.
set(hatbox_move_256)
set(hatbox_move_512)
if(hatbox_is_x86)
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-mmove-max=256 hatbox_has_move_max)
endif()
if(hatbox_has_move_max)
  set(hatbox_move_256 -mmove-max=256 -mstore-max=256)
  set(hatbox_move_512 -mmove-max=512 -mstore-max=512)
endif()

# THE list, slowest first: what the kernels are compiled with (FLAGS), which xsimd arch they use (ARCH; none: plain
# float), and all that a CPU and its operating system must offer to run them (CPU, as __builtin_cpu_supports names it).
# -msse4.2 and everything above it lets the compiler use popcnt too.
hatbox_add_isa(scalar)
if(hatbox_is_x86)
  hatbox_add_isa(sse4_2
    FLAGS -msse4.2
    ARCH xsimd::sse4_2
    CPU sse4.2 popcnt)
  hatbox_add_isa(avx2
    FLAGS -mavx2 -mfma ${hatbox_move_256}
    ARCH xsimd::fma3<xsimd::avx2>
    CPU avx2 fma popcnt)
  hatbox_add_isa(avx512
    FLAGS -mavx512f -mavx512cd -mavx512dq -mavx512bw -mavx512vl -mavx2 -mfma ${hatbox_move_512}
          ${avx512_header_warnings}
    ARCH xsimd::avx512bw
    CPU avx512f avx512cd avx512dq avx512bw avx512vl avx2 fma popcnt)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  hatbox_add_isa(neon
    ARCH xsimd::neon64)
endif()

configure_file(${PROJECT_SOURCE_DIR}/cmake/isa_list.h.in ${PROJECT_BINARY_DIR}/generated/isa_list.h @ONLY)
list(JOIN hatbox_isa_names ", " names)
message(STATUS "hatbox instruction sets: ${names}")
