# How every target of the project is compiled, whoever includes it. No instruction set is named here: a program that
# links hatbox, and hatbox's own code outside the kernels, runs on any CPU of the platform.
function(hatbox_compile_options target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wconversion -Wshadow $<$<BOOL:${HATBOX_WARNINGS_AS_ERRORS}>:-Werror>
    -ffp-contract=off)  # what is fused is what the code says, so that compilers agree on every bit
endfunction()

# For code whose speed matters less than the time it takes to compile.
set(hatbox_quick_to_compile $<$<CONFIG:Release>:-O1>)
