# SPDX-License-Identifier: MIT
# CHOLMOD's simplicial factorizations and KLU (LGPL-2.1+): only linear/ links them, and only where they are found.
include("${CMAKE_CURRENT_LIST_DIR}/CamoptSuiteSparsePart.cmake")
camopt_find_suitesparse_part(CamoptSuiteSparse camopt_suitesparse_package klu.h klu)
