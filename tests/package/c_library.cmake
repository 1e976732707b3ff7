# SPDX-License-Identifier: MIT
# LIBRARY carries the soname SONAME, and needs of camopt's libraries NEEDS alone (none where that is empty).
execute_process(COMMAND ${READELF} -d ${LIBRARY} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
if(NOT text MATCHES "SONAME[^\n]*\\[${SONAME}\\]")
  message(FATAL_ERROR "${LIBRARY} has not the soname ${SONAME}:\n${text}")
endif()
string(REGEX MATCHALL "NEEDED[^\n]*\\[libcamopt[^]]*\\]" needed "${text}")
string(REGEX REPLACE "NEEDED[^[]*\\[([^]]*)\\]" "\\1" needed "${needed}")
if(NOT needed STREQUAL "${NEEDS}")
  message(FATAL_ERROR "${LIBRARY} needs '${needed}', not '${NEEDS}'")
endif()
