# SPDX-License-Identifier: MIT
# cpp-httplib as a compiled library, by its pkg-config file: that also says which of the library's options it was
# compiled with, on which the layout of its classes depends. Older than 0.11 it is not known to do.
include("${CMAKE_CURRENT_LIST_DIR}/CamoptPkgConfigPart.cmake")
camopt_find_by_pkg_config(CamoptHttplib camopt_httplib_package cpp-httplib>=0.11)
