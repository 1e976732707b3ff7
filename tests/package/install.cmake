# SPDX-License-Identifier: MIT
# Installs BUILD into PREFIX, which is emptied first: a file left by an earlier build must not help.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} COMMAND_ERROR_IS_FATAL ANY)
