# How every target of the project is compiled, whoever includes it. No instruction set is named here: a program that
# links hatbox, and hatbox's own code outside the kernels, runs on any CPU of the platform.
function(hatbox_compile_options target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wconversion -Wshadow $<$<BOOL:${HATBOX_WARNINGS_AS_ERRORS}>:-Werror>
    # Numbers that are none are looked for, also where the including project has them declared away; and what is fused is
    # what the code says, so that compilers agree on every bit.
    -fno-fast-math -ffp-contract=off)
endfunction()

set(HATBOX_SANITIZERS "" CACHE STRING "Sanitizers, such as address;undefined, that watch the library and the renderer")

# What a target does is watched, in all programs that link it. The tests are not: they would take twice as long to
# compile, and the arrays they give to the library are seen by it.
function(hatbox_sanitize target)
  if(HATBOX_SANITIZERS)
    list(JOIN HATBOX_SANITIZERS "," sanitizers)
    target_compile_options(${target} PRIVATE
      -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${sanitizers})
  endif()
endfunction()

# For code whose speed matters less than the time it takes to compile.
set(hatbox_quick_to_compile $<$<CONFIG:Release>:-O1>)
