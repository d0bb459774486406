# SPDX-License-Identifier: MIT
# cmake -D program=... -D folder=... -D version=... -P write_shell_files.cmake
# Writes into the folder what `regista completion` prints for bash, zsh and fish, and in its folder man1, if help2man is
# there, a manual page of each command from its --help.
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder}/man1)

function(write_completion shell file)
  execute_process(COMMAND ${program} completion ${shell} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE why)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "`regista completion ${shell}` ended with ${status}: ${why}")
  endif()
  file(WRITE ${folder}/${file} "${text}")
endfunction()
write_completion(bash regista)
write_completion(zsh _regista)
write_completion(fish regista.fish)

find_program(help2man help2man)
if(NOT help2man)
  message(STATUS "No manual pages: help2man is not installed")
  return()
endif()
# The completion names every command in single quotes.
file(READ ${folder}/regista.fish text)
string(REGEX MATCHALL "'regista[a-z -]*'" commands "${text}")
list(REMOVE_DUPLICATES commands)
list(FILTER commands EXCLUDE REGEX " help")
foreach(command ${commands})
  string(REPLACE "'" "" command ${command})
  string(REPLACE " " "-" page ${command})
  string(REGEX REPLACE "^regista ?" "" words ${command})
  # The first line of help is "NAME: what it does", which is the NAME section of a page, too.
  separate_arguments(list_of_words UNIX_COMMAND "${words}")
  execute_process(COMMAND ${program} help ${list_of_words} OUTPUT_VARIABLE help)
  string(REGEX REPLACE "^[^:]*: ([^\n]*).*" "\\1" about "${help}")
  string(STRIP "${program} ${words}" run)
  set(file ${folder}/man1/${page}.1)
  execute_process(
    COMMAND ${help2man} --no-info --version-string=${version} --name=${about} --output=${file} "${run}"
    RESULT_VARIABLE status ERROR_VARIABLE why)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "help2man for `${command}` ended with ${status}: ${why}")
  endif()
  file(READ ${file} text)
  # help2man writes the path of the program that it ran, and the day on which it ran.
  string(REPLACE "${program}" "regista" text "${text}")
  string(REGEX REPLACE "\\.TH [^\n]*" ".TH \"${page}\" 1 \"\" \"regista ${version}\" \"User Commands\"" text "${text}")
  file(WRITE ${file} "${text}")
  execute_process(COMMAND gzip -9nf ${file})
endforeach()
