# cmake -DPROGRAM=… -DOUT=… -P check_baselines.cmake: hatbox_bench --check passes, fails and complains as it should, on
# baselines whose outcome no machine's speed can change.
set(case [["light": "disk", "map": "area", "isa": "scalar", "points": 16]])

# Runs the check of a list of checks; its exit code must be `code`, and what it prints match all of the patterns.
function(expect name code checks)
  set(file ${OUT}/${name}.json)
  file(WRITE ${file} "{\"note\": \"a test\", \"checks\": [${checks}]}")
  expect_file(${file} ${code} ${ARGN})
endfunction()

function(expect_file file code)
  execute_process(COMMAND ${PROGRAM} --check ${file} --repetitions 2 --min-time 0.001
    RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT result EQUAL code)
    message(SEND_ERROR "${file}: exit code ${result}, not ${code}\n${out}")
  endif()
  foreach(pattern ${ARGN})
    if(NOT out MATCHES "${pattern}")
      message(SEND_ERROR "${file}: \"${pattern}\" is not in\n${out}")
    endif()
  endforeach()
endfunction()

expect(generous 0 "{${case}, \"ratio\": \"vs_copy\", \"need\": 1e6, \"bound\": 1e6}"
  "vs_copy +[0-9.]+ +[0-9.]+ <= 1e.06 <= 1e.06  ok" "1 checks: 0 worse than their bounds, 0 more .*, 0 skipped")
expect(impossible 1 "{${case}, \"ratio\": \"vs_copy\", \"need\": 1e-6, \"bound\": 1e-6}"
  "vs_copy .* FAIL" "1 checks: 1 worse")
expect(impossible_larger 1 "{${case}, \"ratio\": \"vs_copy\", \"need\": 1e6, \"bound\": 1e6},
  {\"light\": \"carlson\", \"map\": \"rf\", \"isa\": \"scalar\", \"ratio\": \"vs_reference\", \"need\": 1e6, \"bound\": 1e6}"
  "vs_copy .* ok" "vs_reference .* FAIL" "2 checks: 1 worse")
expect(not_yet 0 "{${case}, \"ratio\": \"vs_copy\", \"need\": 1e-6, \"bound\": 1e6}"
  "above need" "0 worse than their bounds, 1 more")

# No machine has both of these.
set(two_isas)
foreach(isa avx2 neon)
  list(APPEND two_isas "{\"light\": \"disk\", \"map\": \"area\", \"isa\": \"${isa}\", \"points\": 16,
    \"ratio\": \"vs_copy\", \"need\": 1e6, \"bound\": 1e6}")
endforeach()
list(JOIN two_isas ", " two_isas)
expect(lacking 0 "${two_isas}" "no (avx2|neon) here" "[12] skipped")

set(limits "\"need\": 2, \"bound\": 2")
expect(unknown_ratio 1 "{${case}, \"ratio\": \"vs_luck\", ${limits}}"
  "unknown_ratio.json: checks.0.: unknown ratio \"vs_luck\", known are vs_area, ")
expect(unknown_member 1 "{${case}, \"ratio\": \"vs_area\", ${limits}, \"bond\": 1}" "unknown member \"bond\"")
expect(missing 1 "{${case}, \"ratio\": \"vs_area\", \"need\": 2}" "\"bound\" is missing")
expect(type 1 "{${case}, \"ratio\": \"vs_area\", \"need\": \"2\", \"bound\": 2}" "\"need\" has the wrong type")
expect(strict 1 "{${case}, \"ratio\": \"vs_area\", \"need\": 2, \"bound\": 1}" "stricter than the need")
expect(no_case 1 "{\"light\": \"moon\", \"map\": \"area\", \"isa\": \"scalar\", \"ratio\": \"vs_area\", ${limits}}"
  "no such case: moon/area/scalar")
expect(nothing_to_compare 1 "{${case}, \"ratio\": \"vs_single\", ${limits}}" "has no vs_single")
expect(empty 1 "" "list of \"checks\"")
file(WRITE ${OUT}/not_json.json "checks: []")
expect_file(${OUT}/not_json.json 1 "not_json.json: .*parse error")
expect_file(${OUT}/not_there.json 1 "not_there.json: cannot read it")
