# SPDX-License-Identifier: MIT
# SuiteSparseQR (GPL-2+): only linear/ links it, and only where it is found.
include("${CMAKE_CURRENT_LIST_DIR}/CamoptSuiteSparsePart.cmake")
camopt_find_suitesparse_part(CamoptSPQR camopt_spqr_package SuiteSparseQR.hpp spqr)
