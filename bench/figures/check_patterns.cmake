# cmake -DPROGRAM=… -DOUT=… -P check_patterns.cmake: what figure_patterns tells of continuity is what is known of the maps.
execute_process(COMMAND ${PROGRAM} ${OUT} COMMAND_ERROR_IS_FATAL ANY)

# The largest distance of neighbours over the median, in a lattice of 512².
function(expect_fine_lattice map low high)
  file(STRINGS ${OUT}/continuity.csv row REGEX "^${map},512,")
  string(REPLACE "," ";" row "${row}")
  list(GET row 3 ratio)
  if(ratio LESS low OR ratio GREATER high)
    message(SEND_ERROR "${map}: ${ratio} is not between ${low} and ${high}")
  endif()
endfunction()

foreach(smooth disk,area disk,ld_radial disk,table_ld_radial ellipse,ld_radial rectangle,spherical triangle,area)
  expect_fine_lattice(${smooth} 1 8)
endforeach()
expect_fine_lattice(disk,radial 5 10)  # like a square root at the centre
expect_fine_lattice(disk,parallel 20 40)  # like a cube root at the ends of the slices
expect_fine_lattice(rectangle,two_triangles 400 1000)  # torn: as wide as the light
expect_fine_lattice(disk,rejection 400 1000)
