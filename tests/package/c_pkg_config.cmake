# SPDX-License-Identifier: MIT
# The C examples in EXAMPLES compiled into FOLDER by COMPILER with FLAGS and with what pkg-config says of the camopt_c in PREFIX;
# LIBDIR is the folder of the libraries there.
set(ENV{PKG_CONFIG_PATH} "${PREFIX}/${LIBDIR}/pkgconfig:$ENV{PKG_CONFIG_PATH}")
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs camopt_c OUTPUT_VARIABLE words
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PKG_CONFIG} --modversion camopt_c OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT version STREQUAL VERSION)
  message(FATAL_ERROR "camopt_c.pc has version ${version}, not ${VERSION}")
endif()
separate_arguments(words UNIX_COMMAND "${words}")
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
file(MAKE_DIRECTORY ${FOLDER})
foreach(example first_solve weight_sweep cam_profile)
  execute_process(COMMAND ${COMPILER} ${flags} ${EXAMPLES}/${example}.c -o ${FOLDER}/${example} ${words}
    -Wl,-rpath,${PREFIX}/${LIBDIR} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
