# SPDX-License-Identifier: MIT
# find_package(regista 0.2): what a plugin needs that is built outside of Regista's own tree. The version is that of the
# plugin interface, <regista/abi.h>; another one than the program's is not found.
#
#   regista::sdk            the headers <regista/...>
#   regista::algorithms     what shipped assigners and utilities compute: <plugins/assigners/scram/algorithm.hpp>
#   regista::testkit        the contract suites for tests, compiled in the author's build (needs GoogleTest and C++).
#                           It takes the flags that are set before find_package(regista)
#   regista_add_plugin()    builds a shared object that the host accepts; see RegistaAddPlugin.cmake
#   regista_PLUGIN_DIRECTORY  where the plugins of this installation stand
get_filename_component(_regista_prefix ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
set(regista_PLUGIN_DIRECTORY ${_regista_prefix}/lib/regista/plugins)
set(REGISTA_TESTKIT_SOURCE ${_regista_prefix}/share/regista/testkit)
unset(_regista_prefix)

# For regista_add_plugin(... TEST ...); a plugin without tests does not need GoogleTest.
find_package(GTest QUIET)
include(GoogleTest)

include(${CMAKE_CURRENT_LIST_DIR}/regista-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RegistaAddPlugin.cmake)

# A project in plain C has no compiler for it.
get_property(_regista_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if("CXX" IN_LIST _regista_languages)
  include(${CMAKE_CURRENT_LIST_DIR}/RegistaTestkit.cmake)
  # What an author's warnings say about code that is not the author's, nobody can act on.
  target_compile_options(regista_testkit PRIVATE -w)
endif()
unset(_regista_languages)
