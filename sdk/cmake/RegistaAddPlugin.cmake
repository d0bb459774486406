# SPDX-License-Identifier: MIT
# regista_add_plugin(<name> SOURCES <files>... [LINKS <targets>...] [TEST <file>])
#
# Builds <name>.so as a Regista plugin: everything hidden but the one entry point, no contraction of floating-point
# expressions, never unloaded. TEST names a GoogleTest source; it is compiled into test_<name>, which finds the shared
# object through the macro REGISTA_PLUGIN_FILE (regista/testkit/loaded.hpp).

function(regista_add_plugin name)
  cmake_parse_arguments(PLUGIN "" "TEST" "SOURCES;LINKS" ${ARGN})
  if(NOT PLUGIN_SOURCES)
    message(FATAL_ERROR "regista_add_plugin(${name}): SOURCES is missing")
  endif()
  add_library(${name} MODULE ${PLUGIN_SOURCES})
  set_target_properties(${name} PROPERTIES
    PREFIX "" CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(REGISTA_PLUGIN_OUTPUT_DIRECTORY)
    set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${REGISTA_PLUGIN_OUTPUT_DIRECTORY})
  endif()
  target_compile_options(${name} PRIVATE -ffp-contract=off -fno-math-errno -fno-trapping-math $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  set(language CXX)
  if(NOT CMAKE_CXX_COMPILER_ID)
    set(language C)  # a project in plain C
  endif()
  target_compile_definitions(${name} PRIVATE
    REGISTA_BUILD_TAG="${CMAKE_${language}_COMPILER_ID} ${CMAKE_${language}_COMPILER_VERSION} ${CMAKE_BUILD_TYPE}")
  # Hidden visibility alone leaks weak standard-library symbols into the process; the version script leaves one.
  target_link_options(${name} PRIVATE
    LINKER:--version-script=${CMAKE_CURRENT_FUNCTION_LIST_DIR}/plugin.map LINKER:-z,nodelete)
  set_property(TARGET ${name} APPEND PROPERTY LINK_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/plugin.map)
  target_link_libraries(${name} PRIVATE regista::sdk ${PLUGIN_LINKS})
  if(COMMAND regista_precompile)
    target_link_libraries(${name} PRIVATE regista_flags)
    if(PLUGIN_SOURCES MATCHES "\\.cpp")
      regista_precompile(${name} PLUGIN)
    endif()
  endif()

  if(PLUGIN_TEST AND (REGISTA_TESTS OR NOT DEFINED REGISTA_TESTS))
    add_executable(test_${name} ${PLUGIN_TEST})
    target_link_libraries(test_${name} PRIVATE regista::testkit GTest::gmock_main ${PLUGIN_LINKS})
    # The path has a file of its own, so that a compiler cache knows the test in every folder.
    set(path ${CMAKE_CURRENT_BINARY_DIR}/${name}_$<CONFIG>_file.cpp)
    file(GENERATE OUTPUT ${path} CONTENT
      "extern const char regista_plugin_file[];\nconst char regista_plugin_file[] = \"$<TARGET_FILE:${name}>\";\n")
    target_sources(test_${name} PRIVATE ${path})
    target_compile_definitions(test_${name} PRIVATE REGISTA_PLUGIN_FILE=regista_plugin_file)
    add_dependencies(test_${name} ${name})
    if(COMMAND regista_test_program)
      regista_test_program(test_${name} ${name} READS $<TARGET_FILE:${name}>)
    else()
      gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_MODE PRE_TEST)
    endif()
  endif()
endfunction()
