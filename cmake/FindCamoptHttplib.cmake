# SPDX-License-Identifier: MIT
# cpp-httplib as a compiled library, by its pkg-config file: that also says which of the library's options it was
# compiled with, on which the layout of its classes depends. Older than 0.11 it is not known to do.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(CAMOPT_HTTPLIB QUIET IMPORTED_TARGET cpp-httplib>=0.11)
  if(CAMOPT_HTTPLIB_FOUND AND NOT TARGET camopt_httplib_package)
    add_library(camopt_httplib_package INTERFACE IMPORTED)
    target_link_libraries(camopt_httplib_package INTERFACE PkgConfig::CAMOPT_HTTPLIB)
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CamoptHttplib REQUIRED_VARS CAMOPT_HTTPLIB_FOUND
  VERSION_VAR CAMOPT_HTTPLIB_VERSION)
