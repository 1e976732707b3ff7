# SPDX-License-Identifier: MIT
# What `cmake --install` puts down: the promised headers in include/camopt, what they are made of in
# include/camopt/detail, a CMake package, a pkg-config file, and the camopt program where it is built. The libraries
# are the folders, with one component each, or the one shared library (BUILD_SHARED_LIBS). Either package can be installed
# by itself, as the tests do: cmake --install … --component camopt_static, camopt_shared.
include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY CAMOPT_MODULES)
set(camopt_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/camopt)
set(camopt_detail_dir ${CMAKE_INSTALL_INCLUDEDIR}/camopt/detail)
if(BUILD_SHARED_LIBS)
  set(camopt_only_static EXCLUDE_FROM_ALL)
  set(camopt_only_shared "")
else()
  set(camopt_only_static "")
  set(camopt_only_shared EXCLUDE_FROM_ALL)
endif()

# What a consumer of the static libraries has to find, by the target that a link line names.
set(camopt_package_of_Eigen3::Eigen Eigen3)
set(camopt_package_of_fmt::fmt fmt)
set(camopt_package_of_camopt_nlopt_package CamoptNLopt)
set(camopt_package_of_camopt_ipopt_package CamoptIpopt)
set(camopt_package_of_camopt_spqr_package CamoptSPQR)
set(camopt_package_of_camopt_suitesparse_package CamoptSuiteSparse)
set(camopt_package_of_camopt_opencascade_package CamoptOpenCascade)
set(camopt_package_of_camopt_cairo_package CamoptCairo)

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
set(camopt_pc_static "")
set(camopt_packages "")
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
  list(PREPEND camopt_pc_static -lcamopt_${module})

  install(TARGETS camopt_${module} EXPORT camopt-${module}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT camopt_static ${camopt_only_static}
    FILE_SET HEADERS DESTINATION ${camopt_detail_dir} COMPONENT camopt_static ${camopt_only_static})
  install(EXPORT camopt-${module} FILE camopt-${module}-targets.cmake NAMESPACE camopt::
    DESTINATION ${camopt_package_dir} COMPONENT camopt_static ${camopt_only_static})
  # The shared library's headers are the same files, of targets that are not exported with it.
  get_target_property(headers camopt_${module} HEADER_SET)
  foreach(header IN LISTS headers)
    cmake_path(ABSOLUTE_PATH header BASE_DIRECTORY ${PROJECT_SOURCE_DIR} NORMALIZE)
    cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE place)
    cmake_path(GET place PARENT_PATH place)
    install(FILES ${header} DESTINATION ${camopt_detail_dir}/${place} COMPONENT camopt_shared ${camopt_only_shared})
  endforeach()
endforeach()
install(TARGETS camopt_shared EXPORT camopt-shared
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT camopt_shared NAMELINK_COMPONENT camopt_shared
  ${camopt_only_shared})
install(EXPORT camopt-shared FILE camopt-shared-targets.cmake NAMESPACE camopt:: DESTINATION ${camopt_package_dir}
  COMPONENT camopt_shared ${camopt_only_shared})

# A package of each kind under the same names: who looks for camopt does not see which he got.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/camoptConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
# Programs of others that link the static libraries are told where the parts are that they open, unless Debian's linker looks there.
set(camopt_parts_elsewhere FALSE)
if(CAMOPT_OPENED_PARTS AND NOT CAMOPT_DEBIAN)
  set(camopt_parts_elsewhere TRUE)
endif()
include(CamoptPkgConfig)
get_target_property(promised camopt_face HEADER_SET)
foreach(kind static shared)
  set(kind_dir ${PROJECT_BINARY_DIR}/package/${kind})
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/camopt${kind}Config.cmake.in
    ${kind_dir}/camoptConfig.cmake INSTALL_DESTINATION ${camopt_package_dir}
    PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR)
  camopt_pkg_config(${kind} ${kind_dir}/camopt.pc)
  set(here COMPONENT camopt_${kind} ${camopt_only_${kind}})
  install(FILES ${kind_dir}/camoptConfig.cmake ${PROJECT_BINARY_DIR}/camoptConfigVersion.cmake
    ${PROJECT_BINARY_DIR}/package/camoptCComponent.cmake
    DESTINATION ${camopt_package_dir} ${here})
  install(FILES ${kind_dir}/camopt.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${here})
  install(FILES ${promised} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/camopt ${here})
  # In the tree a header is named from the root of the tree; installed, from include/.
  install(CODE "set(camopt_include_dir \"${CMAKE_INSTALL_INCLUDEDIR}/camopt\")" ${here})
  install(SCRIPT cmake/CamoptInstalledIncludes.cmake ${here})
  if(NOT CAMOPT_DEBIAN)  # whose packages have a copyright file
    install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} ${here})
  endif()
endforeach()
# The C library is the component c of either package: one target by hand, for it brings nothing but itself.
get_property(camopt_c_soversion GLOBAL PROPERTY CAMOPT_C_SOVERSION)
configure_file(cmake/camoptCComponent.cmake.in package/camoptCComponent.cmake @ONLY)
if(CAMOPT_C)
  foreach(kind static shared)
    set(here COMPONENT camopt_${kind} ${camopt_only_${kind}})
    install(TARGETS camopt_c_${kind}
      LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT camopt_${kind} NAMELINK_COMPONENT camopt_${kind}
      ${camopt_only_${kind}})
    install(FILES bindings/c/camopt.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${here})
    install(FILES ${PROJECT_BINARY_DIR}/package/camopt_c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${here})
  endforeach()
  configure_file(cmake/camopt_c.pc.in package/camopt_c.pc @ONLY)
endif()
install(FILES cmake/FindCamoptIpopt.cmake cmake/CamoptPkgConfigPart.cmake cmake/FindCamoptNLopt.cmake cmake/FindCamoptSPQR.cmake
  cmake/FindCamoptSuiteSparse.cmake cmake/CamoptSuiteSparsePart.cmake cmake/FindCamoptOpenCascade.cmake
  cmake/FindCamoptCairo.cmake
  DESTINATION ${camopt_package_dir}/modules COMPONENT camopt_static ${camopt_only_static})

# The parts, for program, libraries and Python package alike, and so with each of these that is installed alone. Each looks below
# the folders of its run path; a system's own folders (Debian) the linker knows.
foreach(part IN LISTS CAMOPT_OPENED_PARTS)
  set(part_component camopt_parts)
  if(part STREQUAL "step")  # a separate Debian package
    set(part_component camopt_step)
  endif()
  install(TARGETS camopt_part_${part} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/camopt COMPONENT ${part_component})
  if(NOT CAMOPT_DEBIAN)
    foreach(user program static shared python)
      install(TARGETS camopt_part_${part} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/camopt COMPONENT camopt_${user} EXCLUDE_FROM_ALL)
    endforeach()
  endif()
endforeach()
# camopt_look_for_parts(<target> <folder below the prefix that it is installed in>)
function(camopt_look_for_parts target folder)
  if(CAMOPT_OPENED_PARTS)
    file(RELATIVE_PATH way ${CMAKE_INSTALL_PREFIX}/${folder} ${CMAKE_INSTALL_FULL_LIBDIR})
    string(REGEX REPLACE "/$" "" run_path "$ORIGIN/${way}")
    set_property(TARGET ${target} APPEND PROPERTY INSTALL_RPATH ${run_path})
  endif()
endfunction()
camopt_look_for_parts(camopt_shared ${CMAKE_INSTALL_LIBDIR})
if(CAMOPT_HAVE_PYTHON)
  camopt_look_for_parts(camopt_python ${CAMOPT_PYTHON_DIR}/camopt)
endif()

if(TARGET camopt)
  camopt_look_for_parts(camopt ${CMAKE_INSTALL_BINDIR})
  set(here COMPONENT camopt_program)
  install(TARGETS camopt RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} ${here})
  set(camopt_manual_file ${PROJECT_BINARY_DIR}/apps/camopt.1)
  set(camopt_zsh_dir zsh/site-functions)
  if(CAMOPT_DEBIAN)  # where its policy puts them
    string(APPEND camopt_manual_file .gz)
    set(camopt_zsh_dir zsh/vendor-completions)
  endif()
  if(TARGET camopt_manual)
    install(FILES ${camopt_manual_file} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 ${here})
  endif()
  # Where each shell looks by itself.
  install(FILES apps/completion/camopt.bash RENAME camopt DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions ${here})
  install(FILES apps/completion/_camopt DESTINATION ${CMAKE_INSTALL_DATADIR}/${camopt_zsh_dir} ${here})
  install(FILES apps/completion/camopt.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d ${here})
endif()
