# SPDX-License-Identifier: MIT
# CAMOPT_GPL=OFF: SOURCE configured so into BINARY links none of SuiteSparse's libraries, asks for none that is insisted on, and
# says under what terms its binaries may be passed on. HAS_GPL: the build that runs this test has them, and must be seen to.
cmake_minimum_required(VERSION 3.25)
set(gpl_libraries "lib(spqr|cholmod|klu)\\.(so|a)")
function(configure result_and_output)
  file(REMOVE_RECURSE ${BINARY})
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BINARY} -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER} -DCAMOPT_GPL=OFF
    -DCAMOPT_BUILD_TESTS=OFF -DCAMOPT_BUILD_BENCHMARKS=OFF -DCAMOPT_PYTHON=OFF ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(${result_and_output} "${result}: ${output}" PARENT_SCOPE)
endfunction()

configure(said)
if(NOT said MATCHES "^0: .*a binary may be distributed under the MIT license")
  message(FATAL_ERROR "CAMOPT_GPL=OFF: ${said}")
endif()
file(STRINGS ${BINARY}/build.ninja links REGEX ${gpl_libraries})
if(links)
  message(FATAL_ERROR "CAMOPT_GPL=OFF still links ${links}")
endif()
file(STRINGS ${WITH_GPL}/build.ninja links REGEX ${gpl_libraries})
if(HAS_GPL AND NOT links)
  message(FATAL_ERROR "the build with SuiteSparse links none of it by the names looked for here")
endif()
configure(said -DCAMOPT_WITH_SPQR=ON)
if(NOT said MATCHES "^1: .*CAMOPT_WITH_SPQR=ON asks for a library under the GPL")
  message(FATAL_ERROR "CAMOPT_GPL=OFF with SPQR insisted on: ${said}")
endif()
