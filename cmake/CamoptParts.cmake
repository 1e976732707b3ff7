# SPDX-License-Identifier: MIT
# Parts that stand on a large library (core/platform/parts.hpp): with CAMOPT_OPEN_PARTS a module each in lib/camopt, opened when
# it is first used, so that a program does not begin with the libraries of all of them; otherwise linked in.
set(CAMOPT_OPENED_PARTS "")
if(CAMOPT_OPEN_PARTS)
  set(libraries_and_parts IPOPT:ipopt HTTPLIB:http)
  if(CAMOPT_SHOP)
    list(APPEND libraries_and_parts CAIRO:pdf OPENCASCADE:step)
  endif()
  foreach(library_and_part IN LISTS libraries_and_parts)
    string(REGEX MATCH "^(.+):(.+)$" ignored ${library_and_part})
    if(CAMOPT_HAVE_${CMAKE_MATCH_1})
      list(APPEND CAMOPT_OPENED_PARTS ${CMAKE_MATCH_2})
    endif()
  endforeach()
endif()
# What a camopt and its parts have in common: classes pass between both.
set(camopt_part_build "${PROJECT_VERSION} by ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} with Eigen ${Eigen3_VERSION}")
if(CAMOPT_OPENED_PARTS)
  # Of every program of the build tree; what is installed says where it looks (CamoptInstall.cmake).
  list(APPEND CMAKE_BUILD_RPATH ${PROJECT_BINARY_DIR}/lib)
endif()

# camopt_part(<name> <library> <module> [COLD] DOOR <source> SOURCES … LIBRARIES …)
# The part <name> of the folder <module>, there where CAMOPT_HAVE_<library> is. DOOR is the source of the folder through which
# all of camopt reaches it; SOURCES see the LIBRARIES and, of camopt, what stands in headers alone.
function(camopt_part name library module)
  cmake_parse_arguments(PARSE_ARGV 3 arg "COLD" "DOOR" "SOURCES;LIBRARIES")
  set(target camopt_${module})
  set(build absent)
  if(CAMOPT_HAVE_${library})
    set(build linked)
  endif()
  if(${name} IN_LIST CAMOPT_OPENED_PARTS)
    set(build opened)
    set(part camopt_part_${name})
    add_library(${part} MODULE ${arg_SOURCES})
    set_target_properties(${part} PROPERTIES PREFIX "" SUFFIX .so CXX_EXTENSIONS OFF BUILD_RPATH "" INSTALL_RPATH ""
      LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/camopt
      LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/camopt_part.map)
    target_compile_features(${part} PRIVATE cxx_std_20)
    if(arg_COLD)
      camopt_cold(${part})
    endif()
    target_compile_definitions(${part} PRIVATE CAMOPT_PART_BUILD="${camopt_part_build}")
    target_include_directories(${part} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${part} PRIVATE Eigen3::Eigen fmt::fmt ${arg_LIBRARIES} camopt_warnings camopt_instrumentation)
    # None of camopt's libraries: what a part would need of them does not link.
    target_link_options(${part} PRIVATE LINKER:--version-script=${PROJECT_SOURCE_DIR}/cmake/camopt_part.map
      $<$<NOT:$<BOOL:${CAMOPT_SANITIZE}>>:LINKER:-z,defs>)
    add_dependencies(${target} ${part})
  elseif(build STREQUAL "linked")
    target_sources(${target} PRIVATE ${arg_SOURCES})
    target_link_libraries(${target} PRIVATE ${arg_LIBRARIES})
    set_property(SOURCE ${arg_SOURCES} TARGET_DIRECTORY ${target} APPEND PROPERTY COMPILE_DEFINITIONS
      CAMOPT_PART_BUILD="${camopt_part_build}")
  endif()
  string(TOUPPER ${name} upper)
  set_property(SOURCE ${arg_DOOR} TARGET_DIRECTORY ${target} APPEND PROPERTY COMPILE_DEFINITIONS CAMOPT_PART_${upper}=${build})
endfunction()
