# SPDX-License-Identifier: MIT
# cmake -D program=... -D folder=... -P write_completion.cmake
# Writes <folder>/regista for bash and <folder>/_regista for zsh as `regista completion` prints them.
file(MAKE_DIRECTORY ${folder})
foreach(shell bash zsh)
  set(file ${folder}/regista)
  if(shell STREQUAL "zsh")
    set(file ${folder}/_regista)
  endif()
  execute_process(COMMAND ${program} completion ${shell} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE why)
  if(status EQUAL 0)
    file(WRITE ${file} "${text}")
  else()
    # Until the program has the command. When it has: FATAL_ERROR here, and no OPTIONAL where the two are installed.
    message(STATUS "no completion for ${shell}: `regista completion ${shell}` ended with ${status}")
    file(REMOVE ${file})
  endif()
endforeach()
file(TOUCH ${folder}/written)
