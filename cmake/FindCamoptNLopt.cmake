# SPDX-License-Identifier: MIT
# NLopt's C interface; Debian's C and C++ builds both carry it.
find_package(NLopt CONFIG QUIET)
if(TARGET NLopt::nlopt AND NOT TARGET camopt_nlopt_package)
  add_library(camopt_nlopt_package INTERFACE IMPORTED)
  target_link_libraries(camopt_nlopt_package INTERFACE NLopt::nlopt)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CamoptNLopt REQUIRED_VARS NLopt_DIR VERSION_VAR NLopt_VERSION)
