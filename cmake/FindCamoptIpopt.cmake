# SPDX-License-Identifier: MIT
# Ipopt by its pkg-config file: the packaged 3.11 (headers in coin/) and 3.14 (coin-or/) have no common CMake file.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(CAMOPT_IPOPT QUIET IMPORTED_TARGET ipopt)
  if(CAMOPT_IPOPT_FOUND AND NOT TARGET camopt_ipopt_package)
    add_library(camopt_ipopt_package INTERFACE IMPORTED)
    target_link_libraries(camopt_ipopt_package INTERFACE PkgConfig::CAMOPT_IPOPT)
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CamoptIpopt REQUIRED_VARS CAMOPT_IPOPT_FOUND
  VERSION_VAR CAMOPT_IPOPT_VERSION)
