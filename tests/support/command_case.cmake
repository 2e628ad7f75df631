# SPDX-License-Identifier: Apache-2.0
# The table of command tests. One row is
#
#   command_case(svg2curves/rect            the test's name: what is claimed
#     RUN    "svg2curves drawings/rect.svg" a line for bash, run in fixtures/ with the programs in PATH
#     STDOUT expected/rect.curves           a file beside the table that stdout must equal, byte for byte
#     STDERR "svg2curves: ..."              what stderr must be; nothing if left out
#     EXIT   1                              the exit code; 0 if left out
#     SAME   "other line")                  a line whose stdout must be the same bytes
#
# In STDERR, a line that begins with ~ is an extended regular expression for that line.
# Every case gets an empty folder in $OUT, which is the place for outputs with a name.
function(command_case name)
  cmake_parse_arguments(PARSE_ARGV 1 CASE "" "RUN;STDOUT;STDERR;EXIT;SAME" "")
  if(CASE_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${name}: not understood: ${CASE_UNPARSED_ARGUMENTS}")
  endif()
  if(CASE_STDOUT)
    set(CASE_STDOUT ${CMAKE_CURRENT_SOURCE_DIR}/${CASE_STDOUT})
  endif()
  if(NOT DEFINED CASE_EXIT)
    set(CASE_EXIT 0)
  endif()
  add_test(NAME ${name}
    COMMAND ${PROJECT_SOURCE_DIR}/tests/support/run_case
      ${name} "${CASE_RUN}" ${CASE_EXIT} "${CASE_STDERR}" "${CASE_STDOUT}" "${CASE_SAME}"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/fixtures)
  set_tests_properties(${name} PROPERTIES
    TIMEOUT 300
    ENVIRONMENT
      "PATH=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}:$ENV{PATH};OUT=${PROJECT_BINARY_DIR}/cases/${name};CASES=${CMAKE_CURRENT_SOURCE_DIR}")
endfunction()

# What holds for every program: --help, --version, an unknown option, a man page that agrees.
function(program_cases program)
  command_case(${program}/help-names-the-program RUN "${program} --help | grep -q '^${program} - '")
  command_case(${program}/version RUN "${program} --version | grep -qx '${program} (libstyle) ${PROJECT_VERSION}'")
  command_case(${program}/unknown-option
    RUN "${program} --no-such-option" EXIT 2
    STDERR "~${program}: .*--no-such-option.*; see ${program} --help")
  command_case(${program}/man-page-agrees-with-help
    RUN "$SUPPORT/compare_help_with_man ${program} ${PROJECT_SOURCE_DIR}/man/${program}.1.scd")
endfunction()
