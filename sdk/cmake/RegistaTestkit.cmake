# SPDX-License-Identifier: MIT
# The static library regista::testkit out of its sources, in this build as in an author's: so it always has the same
# compiler, flags and GoogleTest as the tests that link it. It is built when a test needs it.
#
#   REGISTA_TESTKIT_SOURCE    where its .cpp files stand
#   REGISTA_TESTKIT_INCLUDE   where its headers stand, if not beside those of regista::sdk

if(NOT TARGET regista_testkit)
  file(GLOB regista_testkit_files CONFIGURE_DEPENDS ${REGISTA_TESTKIT_SOURCE}/*.cpp)
  # GoogleTest may be found after this: only the generator knows. Without it there is everything but
  # <regista/testkit/contract.hpp>.
  list(FILTER regista_testkit_files EXCLUDE REGEX "/contract\\.cpp$")
  list(APPEND regista_testkit_files $<$<TARGET_EXISTS:GTest::gtest>:${REGISTA_TESTKIT_SOURCE}/contract.cpp>)
  add_library(regista_testkit STATIC EXCLUDE_FROM_ALL ${regista_testkit_files})
  add_library(regista::testkit ALIAS regista_testkit)
  unset(regista_testkit_files)
  # Most of the time goes into standard headers: read them three times and not for each file.
  set_target_properties(regista_testkit PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  target_compile_features(regista_testkit PUBLIC cxx_std_20)
  # The same scenes on every processor. It runs for seconds, so no time is spent on making it faster than -O1 does.
  target_compile_options(regista_testkit PRIVATE -ffp-contract=off $<$<NOT:$<CONFIG:Debug>>:$<IF:$<BOOL:${REGISTA_SANITIZE}>,-O2,-O1>>)
  if(REGISTA_TESTKIT_INCLUDE)
    target_include_directories(regista_testkit PUBLIC ${REGISTA_TESTKIT_INCLUDE})
  endif()
  target_link_libraries(regista_testkit PUBLIC regista::sdk ${CMAKE_DL_LIBS} PRIVATE $<TARGET_NAME_IF_EXISTS:GTest::gtest>)
endif()
