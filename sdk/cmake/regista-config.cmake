# SPDX-License-Identifier: MIT
# find_package(regista): what a plugin needs that is built outside of Regista's own tree.
#
#   regista::sdk            the headers <regista/...>
#   regista::testkit        the contract suites for tests (needs GoogleTest)
#   regista_add_plugin()    builds a shared object that the host accepts; see RegistaAddPlugin.cmake
#   regista_PLUGIN_DIRECTORY  where the plugins of this installation stand
get_filename_component(_regista_prefix ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
set(regista_PLUGIN_DIRECTORY ${_regista_prefix}/lib/regista/plugins)
unset(_regista_prefix)

# For regista_add_plugin(... TEST ...); a plugin without tests does not need GoogleTest.
find_package(GTest QUIET)
include(GoogleTest)

include(${CMAKE_CURRENT_LIST_DIR}/regista-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RegistaAddPlugin.cmake)
