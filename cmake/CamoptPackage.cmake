# SPDX-License-Identifier: MIT
# camopt::camopt: everything, for those who do not want to choose. Without BUILD_SHARED_LIBS it is the static libraries of
# the folders; with it one shared library, libcamopt.so, made of the same objects. One, not one a folder: an embedder
# has one file to ship and one version to look at, and the folders may change among themselves.
get_property(modules GLOBAL PROPERTY CAMOPT_MODULES)
list(TRANSFORM modules PREPEND camopt:: OUTPUT_VARIABLE camopt_module_targets)

# Before 1.0 a minor version may change interfaces, so that the soname has both numbers.
file(CONFIGURE OUTPUT camopt_library.cpp CONTENT "// Nothing: the library is made of those of the folders.\n")
add_library(camopt_shared SHARED ${CMAKE_CURRENT_BINARY_DIR}/camopt_library.cpp)
set_target_properties(camopt_shared PROPERTIES OUTPUT_NAME camopt EXPORT_NAME camopt VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
# Every object of every folder, whoever calls it; then the folders once more for the packages they need.
set(camopt_archives "")
foreach(module IN LISTS camopt_module_targets)
  list(APPEND camopt_archives $<TARGET_FILE:${module}>)
  target_link_libraries(camopt_shared PRIVATE $<BUILD_INTERFACE:${module}>)
endforeach()
target_link_options(camopt_shared PRIVATE LINKER:--whole-archive ${camopt_archives} LINKER:--no-whole-archive)
set_property(TARGET camopt_shared APPEND PROPERTY LINK_DEPENDS ${camopt_archives})
target_link_libraries(camopt_shared PRIVATE $<BUILD_INTERFACE:camopt_instrumentation> PUBLIC Eigen3::Eigen)
target_compile_features(camopt_shared PUBLIC cxx_std_20)
target_include_directories(camopt_shared
  INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${camopt_promised_dir}>
            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

if(BUILD_SHARED_LIBS)
  add_library(camopt::camopt ALIAS camopt_shared)
else()
  # Only the test of the package builds it then.
  set_target_properties(camopt_shared PROPERTIES EXCLUDE_FROM_ALL ON)
  add_library(camopt_all INTERFACE)
  add_library(camopt::camopt ALIAS camopt_all)
  target_link_libraries(camopt_all INTERFACE ${camopt_module_targets})
  target_include_directories(camopt_all INTERFACE ${camopt_promised_dir})
endif()
