# SPDX-License-Identifier: MIT
# What `cmake --install` puts down: the libraries and headers of every folder that has a target, a CMake package
# with one component a folder, and the camopt program where it is built.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY CAMOPT_MODULES)
set(camopt_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/camopt)

# camopt::camopt: everything, for those who do not want to choose.
add_library(camopt_all INTERFACE)
add_library(camopt::camopt ALIAS camopt_all)

# What a consumer of the static libraries has to find, by the target that a link line names.
set(camopt_package_of_Eigen3::Eigen Eigen3)
set(camopt_package_of_fmt::fmt fmt)
set(camopt_package_of_tomlplusplus::tomlplusplus tomlplusplus)
set(camopt_package_of_camopt_nlopt_package CamoptNLopt)
set(camopt_package_of_camopt_ipopt_package CamoptIpopt)
set(camopt_package_of_camopt_spqr_package CamoptSPQR)
set(camopt_package_of_camopt_suitesparse_package CamoptSuiteSparse)
set(camopt_package_of_camopt_opencascade_package CamoptOpenCascade)

# camopt_link_line(<module> <components> <packages>): the folders and the packages that a module names itself.
function(camopt_link_line module components packages)
  get_target_property(line camopt_${module} INTERFACE_LINK_LIBRARIES)
  if(NOT line)
    set(line "")
  endif()
  set(found_components "")
  set(found_packages "")
  foreach(item IN LISTS line)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" item "${item}")
    if(item MATCHES "^camopt::(.+)$")
      list(APPEND found_components ${CMAKE_MATCH_1})
    elseif(item MATCHES "^(::@|\\$<BUILD_INTERFACE:)")
      # A directory marker, or something that only this build tree links.
    elseif(DEFINED camopt_package_of_${item})
      list(APPEND found_packages ${camopt_package_of_${item}})
    else()
      message(FATAL_ERROR "camopt_${module} links '${item}', and cmake/CamoptInstall.cmake does not know which "
                          "package brings it")
    endif()
  endforeach()
  set(${components} ${found_components} PARENT_SCOPE)
  set(${packages} ${found_packages} PARENT_SCOPE)
endfunction()

# Modules stand in the order of the data flow, so what a module needs has its own closure already.
set(component_table "")
foreach(module IN LISTS modules)
  camopt_link_line(${module} direct packages)
  set(needs_${module} ${direct})
  foreach(component IN LISTS direct)
    list(APPEND needs_${module} ${needs_${component}})
  endforeach()
  list(REMOVE_DUPLICATES needs_${module})
  list(REMOVE_DUPLICATES packages)
  string(APPEND component_table "set(_camopt_needs_${module} \"${needs_${module}}\")\n"
                                "set(_camopt_packages_${module} \"${packages}\")\n")

  target_link_libraries(camopt_all INTERFACE camopt::${module})
  install(TARGETS camopt_${module} EXPORT camopt-${module}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/camopt)
  install(EXPORT camopt-${module} FILE camopt-${module}-targets.cmake NAMESPACE camopt::
    DESTINATION ${camopt_package_dir})
endforeach()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/camoptConfig.cmake.in
  ${PROJECT_BINARY_DIR}/camoptConfig.cmake INSTALL_DESTINATION ${camopt_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/camoptConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/camoptConfig.cmake ${PROJECT_BINARY_DIR}/camoptConfigVersion.cmake
  DESTINATION ${camopt_package_dir})
install(FILES cmake/FindCamoptIpopt.cmake cmake/FindCamoptNLopt.cmake cmake/FindCamoptSPQR.cmake
  cmake/FindCamoptSuiteSparse.cmake cmake/FindCamoptOpenCascade.cmake
  DESTINATION ${camopt_package_dir}/modules)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(TARGET camopt)
  install(TARGETS camopt RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
