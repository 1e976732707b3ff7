# SPDX-License-Identifier: MIT
# SOURCE compiled by COMPILER as C++17: it must fail with one error, which says what to do.
execute_process(COMMAND ${COMPILER} -std=c++17 -fsyntax-only -I${INCLUDE} -isystem ${EIGEN} ${SOURCE}
  RESULT_VARIABLE status ERROR_VARIABLE words)
string(REGEX MATCHALL "error:" errors "${words}")
list(LENGTH errors count)
if(status EQUAL 0 OR NOT count EQUAL 1 OR NOT words MATCHES "camopt needs C\\+\\+20: compile with -std=c\\+\\+20")
  message(FATAL_ERROR "${count} errors instead of one that says what to do:\n${words}")
endif()
