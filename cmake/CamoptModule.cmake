# SPDX-License-Identifier: MIT
# camopt_add_module(<folder> SOURCES … HEADERS … [PUBLIC …] [PRIVATE …])
# One library a folder, camopt::<folder>, with its headers beside its sources. PUBLIC are the folders
# and packages its headers include, PRIVATE those only its sources need.

add_library(camopt_warnings INTERFACE)
target_compile_options(camopt_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 sees overlapping copies in "text" + std::string where there are none (GCC bug 105651).
  target_compile_options(camopt_warnings INTERFACE -Wno-restrict)
endif()
if(CAMOPT_WARNINGS_AS_ERRORS)
  target_compile_options(camopt_warnings INTERFACE -Werror)
endif()

add_library(camopt_instrumentation INTERFACE)
if(CAMOPT_SANITIZE)
  target_compile_options(camopt_instrumentation INTERFACE -fsanitize=${CAMOPT_SANITIZE}
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(camopt_instrumentation INTERFACE -fsanitize=${CAMOPT_SANITIZE})
endif()
if(CAMOPT_COVERAGE)
  target_compile_options(camopt_instrumentation INTERFACE --coverage)
  target_link_options(camopt_instrumentation INTERFACE --coverage)
endif()

# camopt_header_only(<target> <result>): true for an imported package without a library. An installed camopt does
# not ask its consumers for those.
function(camopt_header_only target result)
  set(${result} FALSE PARENT_SCOPE)
  if(TARGET ${target})
    get_target_property(type ${target} TYPE)
    get_target_property(imported ${target} IMPORTED)
    get_target_property(libraries ${target} INTERFACE_LINK_LIBRARIES)
    if(imported AND type STREQUAL "INTERFACE_LIBRARY" AND NOT libraries)
      set(${result} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()

function(camopt_add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE")
  set(target camopt_${name})
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(camopt::${name} ALIAS ${target})
  target_sources(${target} PUBLIC FILE_SET HEADERS
    BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON)
  set(private "")
  foreach(library IN LISTS arg_PRIVATE)
    camopt_header_only(${library} header_only)
    if(header_only)
      list(APPEND private $<BUILD_INTERFACE:${library}>)
    else()
      list(APPEND private ${library})
    endif()
  endforeach()
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${private}
    $<BUILD_INTERFACE:camopt_warnings> $<BUILD_INTERFACE:camopt_instrumentation>)
  if("fmt::fmt" IN_LIST arg_PRIVATE)
    camopt_use_precompiled(${target} camopt_precompiled)
  endif()
  set_property(GLOBAL APPEND PROPERTY CAMOPT_MODULES ${name})
endfunction()

# camopt_add_test(<name> SOURCES … [LIBRARIES …] [LABELS …]): one GoogleTest program, its cases known to ctest.
function(camopt_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT" "SOURCES;LIBRARIES;LABELS")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest_main camopt_warnings
    camopt_instrumentation)
  target_compile_definitions(${name} PRIVATE CAMOPT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  # What is tested is optimised; the tests themselves are compiled more often than they run.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1;-Wno-maybe-uninitialized>)
  camopt_use_precompiled(${name} camopt_precompiled_tests)
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 600)
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}")
endfunction()
