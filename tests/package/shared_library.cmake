# SPDX-License-Identifier: MIT
# The shared library in FOLDER carries the soname SONAME, and PROGRAM needs it by that name and no other camopt.
execute_process(COMMAND ${READELF} -d ${FOLDER}/libcamopt.so OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
if(NOT text MATCHES "SONAME[^\n]*\\[${SONAME}\\]")
  message(FATAL_ERROR "libcamopt.so has not the soname ${SONAME}:\n${text}")
endif()
execute_process(COMMAND ${READELF} -d ${PROGRAM} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "NEEDED[^\n]*\\[libcamopt[^]]*\\]" needed "${text}")
list(LENGTH needed count)
if(NOT count EQUAL 1 OR NOT needed MATCHES "${SONAME}")
  message(FATAL_ERROR "${PROGRAM} needs ${needed}, not ${SONAME} alone")
endif()
