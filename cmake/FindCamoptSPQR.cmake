# SPDX-License-Identifier: MIT
# SuiteSparseQR (GPL-2+): only linear/ links it, and only where it is found.
find_path(CAMOPT_SPQR_INCLUDE SuiteSparseQR.hpp PATH_SUFFIXES suitesparse)
find_library(CAMOPT_SPQR_LIBRARY spqr)
find_library(CAMOPT_CHOLMOD_LIBRARY cholmod)
find_library(CAMOPT_SUITESPARSE_CONFIG_LIBRARY suitesparseconfig)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CamoptSPQR REQUIRED_VARS CAMOPT_SPQR_INCLUDE CAMOPT_SPQR_LIBRARY
  CAMOPT_CHOLMOD_LIBRARY CAMOPT_SUITESPARSE_CONFIG_LIBRARY)
if(CamoptSPQR_FOUND AND NOT TARGET camopt_spqr_package)
  add_library(camopt_spqr_package INTERFACE IMPORTED)
  target_include_directories(camopt_spqr_package INTERFACE ${CAMOPT_SPQR_INCLUDE})
  target_link_libraries(camopt_spqr_package INTERFACE ${CAMOPT_SPQR_LIBRARY} ${CAMOPT_CHOLMOD_LIBRARY}
    ${CAMOPT_SUITESPARSE_CONFIG_LIBRARY})
endif()
mark_as_advanced(CAMOPT_SPQR_INCLUDE CAMOPT_SPQR_LIBRARY CAMOPT_CHOLMOD_LIBRARY
  CAMOPT_SUITESPARSE_CONFIG_LIBRARY)
