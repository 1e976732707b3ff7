# SPDX-License-Identifier: MIT
# Headers of others that most files here read, compiled once: one for the libraries, one for the test programs.
# What is precompiled is not included by name where it is used, or a build without it would not work: the preset
# `dev` builds without.
option(CAMOPT_PRECOMPILED_HEADERS "Compile the headers of Eigen, fmt and the standard library once"
  ${PROJECT_IS_TOP_LEVEL})

set(camopt_precompiled_list <algorithm> <array> <cmath> <functional> <limits> <map> <memory> <optional> <span> <string>
  <vector> <Eigen/Core> <Eigen/SparseCore>)

# camopt_precompile(<name> PIC <ON|OFF> EXTENSIONS <ON|OFF> LIBRARIES … HEADERS … OPTIONS …): what camopt_use_precompiled can
# name. Those who use it are compiled with the same choices, or the compiler does not take it.
function(camopt_precompile name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PIC;EXTENSIONS" "LIBRARIES;HEADERS;OPTIONS")
  if(NOT CAMOPT_PRECOMPILED_HEADERS)
    return()
  endif()
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "// Nothing: it brings the precompiled headers.\n")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS ${arg_EXTENSIONS}
    POSITION_INDEPENDENT_CODE ${arg_PIC})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} camopt_warnings camopt_instrumentation)
  target_compile_options(${name} PRIVATE ${arg_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${camopt_precompiled_list} ${arg_HEADERS})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${name} PRIVATE -fpch-preprocess)  # so that a compiler cache sees through it
  endif()
endfunction()

function(camopt_use_precompiled target name)
  if(NOT TARGET ${name})
    return()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${name})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ 12 sees overflows in "text" + std::string where there are none (GCC bug 105651), and no longer knows
    # that they are in a header of the system.
    target_compile_options(${target} PRIVATE -fpch-preprocess -Wno-array-bounds -Wno-stringop-overflow
      -Wno-stringop-overread)
  endif()
endfunction()
