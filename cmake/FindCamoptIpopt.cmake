# SPDX-License-Identifier: MIT
# Ipopt by its pkg-config file: the packaged 3.11 (headers in coin/) and 3.14 (coin-or/) have no common CMake file.
include("${CMAKE_CURRENT_LIST_DIR}/CamoptPkgConfigPart.cmake")
camopt_find_by_pkg_config(CamoptIpopt camopt_ipopt_package ipopt)
