# SPDX-License-Identifier: MIT
# Configures SOURCE in BINARY with OPTIONS; passes where that fails with a message that matches WORDS.
execute_process(COMMAND ${CMAKE_COMMAND} --fresh -S ${SOURCE} -B ${BINARY} ${OPTIONS}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "${SOURCE} was configured; it had to be refused:\n${output}")
endif()
string(REGEX REPLACE "[ \n]+" " " one_line "${output}")
if(NOT one_line MATCHES "${WORDS}")
  message(FATAL_ERROR "Refused, but without '${WORDS}':\n${output}")
endif()
