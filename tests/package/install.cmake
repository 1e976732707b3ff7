# SPDX-License-Identifier: MIT
# Installs BUILD (only its COMPONENT where one is named; TARGET is built before) into PREFIX, which is emptied first: a file
# left by an earlier build must not help.
file(REMOVE_RECURSE ${PREFIX})
if(TARGET)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target ${TARGET} COMMAND_ERROR_IS_FATAL ANY)
endif()
set(component "")
if(COMPONENT)
  set(component --component ${COMPONENT})
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} ${component} COMMAND_ERROR_IS_FATAL ANY)
