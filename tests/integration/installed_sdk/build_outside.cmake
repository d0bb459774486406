# SPDX-License-Identifier: MIT
# cmake -D build=... -D source=... -D work=... [...] -P build_outside.cmake
# An author's first hour: an installed SDK, a project of one's own, find_package, a shared object that a host accepts.
cmake_minimum_required(VERSION 3.25)
set(prefix ${work}/prefix)
set(project ${work}/project)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix} --component sdk)
# Copied, so that no relative path can lead back into the source tree.
file(COPY ${CMAKE_CURRENT_LIST_DIR}/project DESTINATION ${work})
run(${CMAKE_COMMAND} -S ${project} -B ${project}/build -G ${generator} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_C_COMPILER=${c_compiler} -D CMAKE_CXX_COMPILER=${cxx_compiler} -D CMAKE_PREFIX_PATH=${prefix}
    -D CMAKE_EXPORT_COMPILE_COMMANDS=ON)

file(READ ${project}/build/compile_commands.json commands)
foreach(folder sdk host plugins league)
  string(FIND "${commands}" "${source}/${folder}/" position)
  if(NOT position EQUAL -1)
    message(FATAL_ERROR "the outside project was compiled with files of ${source}/${folder}:\n${commands}")
  endif()
endforeach()

run(${CMAKE_COMMAND} --build ${project}/build)
file(GLOB plugins ${project}/build/plugins/*.so)
run(${python} ${source}/tests/architecture/exported_symbols.py ${plugins})
run(${CMAKE_CTEST_COMMAND} --test-dir ${project}/build --no-tests=error --output-on-failure)

# The league is such a project. All of it is compiled, one of its tests is run.
file(COPY ${source}/league DESTINATION ${work})
run(${CMAKE_COMMAND} -S ${work}/league -B ${work}/league/build -G ${generator} -D CMAKE_BUILD_TYPE=Debug
    -D CMAKE_CXX_COMPILER=${cxx_compiler} -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${work}/league/build --target regista_league test_static_partition)
run(${CMAKE_CTEST_COMMAND} --test-dir ${work}/league/build --no-tests=error --output-on-failure -R ^static_partition\\.)
run(${python} ${source}/tests/architecture/exported_symbols.py ${work}/league/build/lib/regista/plugins)

# Who asks for another version of the plugin interface than the installed one is told so, and by name.
file(WRITE ${work}/later/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.25)\nproject(later C)\nfind_package(regista 99.0 REQUIRED)\n")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${work}/later -B ${work}/later/build -G ${generator}
  -D CMAKE_C_COMPILER=${c_compiler} -D CMAKE_PREFIX_PATH=${prefix}
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE output)
if(status EQUAL 0 OR NOT output MATCHES "requested version \"99.0\"" OR NOT output MATCHES "regista-config.cmake, version: [0-9.]+")
  message(FATAL_ERROR "an interface of version 99.0 was asked for, and CMake ended with ${status}:\n${output}")
endif()
