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
    message(FATAL_ERROR "`regista completion ${shell}` ended with ${status}: ${why}")
  endif()
endforeach()
file(TOUCH ${folder}/written)
