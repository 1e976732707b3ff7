# SPDX-License-Identifier: MIT
# Run by `cmake --install`: headers name one another from the root of the source tree ("core/motion.hpp"); installed, from
# the one folder a consumer's compiler is given (include/), so that no name of a folder here can meet one of the consumer's.
set(camopt_root "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${camopt_include_dir}")
file(GLOB camopt_rooms RELATIVE "${camopt_root}/detail" "${camopt_root}/detail/*")
list(JOIN camopt_rooms "|" camopt_rooms)
file(GLOB_RECURSE camopt_headers "${camopt_root}/*.hpp")
foreach(header IN LISTS camopt_headers)
  file(READ "${header}" text)
  string(REGEX REPLACE "#include \"(${camopt_rooms})/" "#include \"camopt/detail/\\1/" changed "${text}")
  if(NOT changed STREQUAL text)
    file(WRITE "${header}" "${changed}")
  endif()
endforeach()
