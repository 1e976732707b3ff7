# SPDX-License-Identifier: MIT
# CHOLMOD's simplicial factorizations and KLU (LGPL-2.1+): only linear/ links them, and only where they are found.
find_path(CAMOPT_KLU_INCLUDE klu.h PATH_SUFFIXES suitesparse)
find_library(CAMOPT_KLU_LIBRARY klu)
find_library(CAMOPT_CHOLMOD_LIBRARY cholmod)
find_library(CAMOPT_SUITESPARSE_CONFIG_LIBRARY suitesparseconfig)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CamoptSuiteSparse REQUIRED_VARS CAMOPT_KLU_INCLUDE CAMOPT_KLU_LIBRARY
  CAMOPT_CHOLMOD_LIBRARY CAMOPT_SUITESPARSE_CONFIG_LIBRARY)
if(CamoptSuiteSparse_FOUND AND NOT TARGET camopt_suitesparse_package)
  add_library(camopt_suitesparse_package INTERFACE IMPORTED)
  target_include_directories(camopt_suitesparse_package INTERFACE ${CAMOPT_KLU_INCLUDE})
  target_link_libraries(camopt_suitesparse_package INTERFACE ${CAMOPT_KLU_LIBRARY} ${CAMOPT_CHOLMOD_LIBRARY}
    ${CAMOPT_SUITESPARSE_CONFIG_LIBRARY})
endif()
mark_as_advanced(CAMOPT_KLU_INCLUDE CAMOPT_KLU_LIBRARY CAMOPT_CHOLMOD_LIBRARY CAMOPT_SUITESPARSE_CONFIG_LIBRARY)
