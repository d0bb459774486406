# SPDX-License-Identifier: MIT
# Programs of tests: compiled for the compiler's time and not for their own, each one entry of ctest.
add_library(regista_test_flags INTERFACE)
target_link_libraries(regista_test_flags INTERFACE regista_flags regista_batches)
# g++ collects garbage for an eighth of its time where nobody tells it that there is memory.
target_compile_options(regista_test_flags INTERFACE
  $<$<NOT:$<CONFIG:Debug>>:$<IF:$<BOOL:$<TARGET_PROPERTY:REGISTA_OPTIMISED>>,-O2,-O0>> $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)

regista_precompiled_headers(TEST <gmock/gmock.h> <gtest/gtest.h>)
target_link_libraries(regista_headers_TEST PRIVATE regista_test_flags GTest::gmock)

# What must pass before every commit: scripts/test builds this target and runs the tests with the label `commit`.
add_custom_target(regista_commit_tests)
file(REMOVE_RECURSE ${CMAKE_BINARY_DIR}/test_inputs)

# regista_commit_test(NAME [BUILDS TARGETS...] [READS FILES_AND_FOLDERS...]): makes a test one of these. It needs the targets.
# scripts/test runs it again where something that it reads has changed; one that says nothing is run each time.
function(regista_commit_test name)
  cmake_parse_arguments(TEST "" "" "BUILDS;READS" ${ARGN})
  set_property(TEST ${name} APPEND PROPERTY LABELS commit)
  if(TEST_BUILDS)
    add_dependencies(regista_commit_tests ${TEST_BUILDS})
  endif()
  if(TEST_READS)
    string(REPLACE ";" "\n" reads "${TEST_READS}")
    file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/test_inputs/${name} CONTENT "${reads}\n")
  endif()
endfunction()

# regista_test_program(PROGRAM NAME [LABEL label] [READS FILES...]): NAME is that of the entry; without a label it is run
# before every commit. Files are compiled in batches, for what they share are the templates of GoogleTest. What it reads
# stands in the definitions of its target, or is said. With sanitizers a test may take minutes.
function(regista_test_program program name)
  cmake_parse_arguments(TEST "" "LABEL" "READS" ${ARGN})
  target_link_libraries(${program} PRIVATE regista_test_flags)
  regista_precompile(${program} TEST)
  set_target_properties(${program} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  add_test(NAME ${name} COMMAND ${program})
  set_tests_properties(${name} PROPERTIES TIMEOUT 1200)
  if(TEST_LABEL)
    set_property(TEST ${name} PROPERTY LABELS ${TEST_LABEL})
  else()
    regista_commit_test(${name} BUILDS ${program}
      READS $<TARGET_FILE:${program}> ${TEST_READS} $<TARGET_PROPERTY:${program},COMPILE_DEFINITIONS>)
  endif()
endfunction()

# Of files of this folder whose names clash with those of another one.
function(regista_compile_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# Of a program that computes for longer than a compiler needs for making it faster.
function(regista_optimise_test program)
  set_target_properties(${program} PROPERTIES REGISTA_OPTIMISED ON DISABLE_PRECOMPILE_HEADERS ON)
endfunction()
