# SPDX-License-Identifier: MIT
# Half of a build from nothing was reading the same headers again. Files that are compiled with the same flags share one
# precompiled header: regista_precompile(TARGET ROOM|COLD_ROOM|PLUGIN|TEST). It holds headers of libraries alone; an edited
# header of ours then costs what it did. Headers that a macro of a command line changes must not be among them, as g++ and
# clang++ read a precompiled one only where that macro is the same: hence no fmt.
find_package(Eigen3 REQUIRED NO_MODULE)
set(regista_standard_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <set> <span>
  <sstream> <string> <string_view> <tuple> <unordered_map> <variant> <vector> <Eigen/Core>)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/no_code.cpp CONTENT "")

function(regista_precompiled_headers name)
  add_library(regista_headers_${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/no_code.cpp)
  target_link_libraries(regista_headers_${name} PRIVATE regista_flags Eigen3::Eigen)
  target_precompile_headers(regista_headers_${name} PRIVATE ${regista_standard_headers} ${ARGN})
endfunction()

function(regista_precompile target kind)
  target_precompile_headers(${target} REUSE_FROM regista_headers_${kind})
endfunction()

regista_precompiled_headers(ROOM)
regista_precompiled_headers(COLD_ROOM)
target_link_libraries(regista_headers_COLD_ROOM PRIVATE regista_cold)
regista_precompiled_headers(PLUGIN)
set_target_properties(regista_headers_PLUGIN PROPERTIES
  POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
target_compile_options(regista_headers_PLUGIN PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
