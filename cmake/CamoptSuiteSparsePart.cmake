# SPDX-License-Identifier: MIT
include(FindPackageHandleStandardArgs)

# camopt_find_suitesparse_part(<package> <target> <header> <library>): one library of SuiteSparse over CHOLMOD, as the
# imported <target>. For the Find modules.
macro(camopt_find_suitesparse_part package target header library)
  string(TOUPPER ${library} camopt_part)
  find_path(CAMOPT_${camopt_part}_INCLUDE ${header} PATH_SUFFIXES suitesparse)
  find_library(CAMOPT_${camopt_part}_LIBRARY ${library})
  find_library(CAMOPT_CHOLMOD_LIBRARY cholmod)
  find_library(CAMOPT_SUITESPARSE_CONFIG_LIBRARY suitesparseconfig)
  find_package_handle_standard_args(${package} REQUIRED_VARS CAMOPT_${camopt_part}_INCLUDE
    CAMOPT_${camopt_part}_LIBRARY CAMOPT_CHOLMOD_LIBRARY CAMOPT_SUITESPARSE_CONFIG_LIBRARY)
  if(${package}_FOUND AND NOT TARGET ${target})
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} INTERFACE ${CAMOPT_${camopt_part}_INCLUDE})
    target_link_libraries(${target} INTERFACE ${CAMOPT_${camopt_part}_LIBRARY} ${CAMOPT_CHOLMOD_LIBRARY}
      ${CAMOPT_SUITESPARSE_CONFIG_LIBRARY})
  endif()
  mark_as_advanced(CAMOPT_${camopt_part}_INCLUDE CAMOPT_${camopt_part}_LIBRARY CAMOPT_CHOLMOD_LIBRARY
    CAMOPT_SUITESPARSE_CONFIG_LIBRARY)
endmacro()
