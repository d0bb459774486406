# SPDX-License-Identifier: MIT
# Programs of tests: compiled for the compiler's time and not for their own, each one entry of ctest.
add_library(regista_test_flags INTERFACE)
target_link_libraries(regista_test_flags INTERFACE regista_flags regista_batches)
# g++ collects garbage for an eighth of its time where nobody tells it that there is memory.
target_compile_options(regista_test_flags INTERFACE
  $<$<NOT:$<CONFIG:Debug>>:$<IF:$<BOOL:$<TARGET_PROPERTY:REGISTA_OPTIMISED>>,-O2,-O0>> $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)

regista_precompiled_headers(TEST <gmock/gmock.h> <gtest/gtest.h>)
target_link_libraries(regista_headers_TEST PRIVATE regista_test_flags GTest::gmock)

# regista_test_program(PROGRAM NAME): NAME is that of the entry. Files are compiled in batches, for what they share are the
# templates of GoogleTest. With sanitizers a test may take minutes.
function(regista_test_program program name)
  target_link_libraries(${program} PRIVATE regista_test_flags)
  regista_precompile(${program} TEST)
  set_target_properties(${program} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  add_test(NAME ${name} COMMAND ${program})
  set_tests_properties(${name} PROPERTIES TIMEOUT 1200)
endfunction()

# Of files of this folder whose names clash with those of another one.
function(regista_compile_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# Of a program that computes for longer than a compiler needs for making it faster.
function(regista_optimise_test program)
  set_target_properties(${program} PROPERTIES REGISTA_OPTIMISED ON DISABLE_PRECOMPILE_HEADERS ON)
endfunction()
