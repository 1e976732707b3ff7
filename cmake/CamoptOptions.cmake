# SPDX-License-Identifier: MIT
# Every choice the person who builds camopt can make.
include(CMakeDependentOption)

option(CAMOPT_BUILD_APPS "Build the camopt command line" ${PROJECT_IS_TOP_LEVEL})
option(CAMOPT_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(CAMOPT_BUILD_BENCHMARKS "Build the benchmarks" ${PROJECT_IS_TOP_LEVEL})
option(CAMOPT_BUILD_NOTEBOOKS "Build what the notebooks' kernel needs; it loads the shared library" OFF)
option(CAMOPT_BUILD_FUZZERS "Build the libFuzzer targets (clang only)" OFF)
option(CAMOPT_SHOP "Build what a workshop or a controller takes: drawings, solids, NC programs, electronic cams" ON)
option(CAMOPT_C "Build the C library (bindings/c)" ${PROJECT_IS_TOP_LEVEL})
option(CAMOPT_INSTALL "Rules for cmake --install" ${PROJECT_IS_TOP_LEVEL})
if(PROJECT_IS_TOP_LEVEL)
  option(BUILD_SHARED_LIBS "camopt::camopt, and what is installed, is one shared library" OFF)
endif()
option(CAMOPT_UNITY_BUILD "Compile sources of a folder together: half the time of a clean build" OFF)
set(CAMOPT_UNITY_BATCH 24 CACHE STRING "How many at most; 0: all, where two that do not go together are seen whatever their order")
set(CAMOPT_TEST_UNITY_BATCH 8 CACHE STRING "The same of the tests of a folder")
# A source includes its own header first, which the test lint.include_rules demands: compiled by itself it has shown that the
# header needs nothing before it.
option(CAMOPT_LONE_HEADERS "CMAKE_VERIFY_INTERFACE_HEADER_SETS for headers without a source only; with CAMOPT_INSTALL=OFF" OFF)
option(CAMOPT_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)

# Parts under the GPL are SuiteSparse's; whoever passes a binary on may not want them.
option(CAMOPT_GPL "Use libraries under the GPL (SuiteSparseQR, CHOLMOD) where they are found" ON)

# AUTO takes a library where it is found, ON insists, OFF leaves it out.
foreach(backend IPOPT NLOPT SPQR SUITESPARSE OPENCASCADE CAIRO HTTPLIB)
  set(CAMOPT_WITH_${backend} AUTO CACHE STRING "Use ${backend}: AUTO, ON or OFF")
  set_property(CACHE CAMOPT_WITH_${backend} PROPERTY STRINGS AUTO ON OFF)
endforeach()

# Whoever builds camopt into a project of his own ships one program. Only where there are modules: not on Windows, not in a browser.
cmake_dependent_option(CAMOPT_OPEN_PARTS "Ipopt, cairo, cpp-httplib and Open CASCADE behind modules that are opened when used"
  ${PROJECT_IS_TOP_LEVEL} UNIX OFF)

set(CAMOPT_PYTHON AUTO CACHE STRING "Build the Python package: AUTO (where camopt is the project and it can be), ON or OFF")
set_property(CACHE CAMOPT_PYTHON PROPERTY STRINGS AUTO ON OFF)

option(CAMOPT_DEBIAN "Debian packages by cpack (preset debian)" OFF)

set(CAMOPT_SANITIZE "" CACHE STRING "Sanitizers for every target, for example address,undefined")
option(CAMOPT_COVERAGE "Instrument every target for coverage" OFF)

# A parent project's build type is its own.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
