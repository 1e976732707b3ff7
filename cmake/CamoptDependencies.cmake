# SPDX-License-Identifier: MIT
# Required: Eigen for everything, fmt for messages, toml++ for input/, nlohmann-json for output/, CLI11 for apps/.
# Optional ones become the variables CAMOPT_HAVE_IPOPT, CAMOPT_HAVE_NLOPT, CAMOPT_HAVE_SPQR,
# CAMOPT_HAVE_SUITESPARSE, CAMOPT_HAVE_OPENCASCADE and imported targets.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json 3.10 REQUIRED)
if(CAMOPT_BUILD_APPS)
  find_package(CLI11 REQUIRED)
endif()
if(CAMOPT_BUILD_TESTS)
  find_package(GTest REQUIRED)
  include(GoogleTest)
endif()

# camopt_optional(<NAME> <target>): reads CAMOPT_WITH_<NAME>, tries Find<package>, sets CAMOPT_HAVE_<NAME>.
macro(camopt_optional name package target)
  set(CAMOPT_HAVE_${name} OFF)
  if(NOT CAMOPT_WITH_${name} STREQUAL "OFF")
    if(CAMOPT_WITH_${name} STREQUAL "ON")
      find_package(${package} REQUIRED)
    else()
      find_package(${package} QUIET)
    endif()
    if(TARGET ${target})
      set(CAMOPT_HAVE_${name} ON)
    endif()
  endif()
  message(STATUS "camopt: ${name} ${CAMOPT_HAVE_${name}}")
endmacro()

camopt_optional(IPOPT CamoptIpopt camopt_ipopt_package)
camopt_optional(NLOPT CamoptNLopt camopt_nlopt_package)
camopt_optional(SPQR CamoptSPQR camopt_spqr_package)
camopt_optional(SUITESPARSE CamoptSuiteSparse camopt_suitesparse_package)
camopt_optional(OPENCASCADE CamoptOpenCascade camopt_opencascade_package)
