# SPDX-License-Identifier: MIT
# Installs the components COMPONENTS (separated by commas) of BUILD into PREFIX, or as `cmake --install` does without a
# component. PREFIX is emptied first: a file left by an earlier build must not help. TARGET is built before.
file(REMOVE_RECURSE ${PREFIX})
if(TARGET)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target ${TARGET} COMMAND_ERROR_IS_FATAL ANY)
endif()
if(NOT COMPONENTS)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} COMMAND_ERROR_IS_FATAL ANY)
endif()
string(REPLACE "," ";" COMPONENTS "${COMPONENTS}")
foreach(component IN LISTS COMPONENTS)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} --component ${component}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
