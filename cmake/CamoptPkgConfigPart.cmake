# SPDX-License-Identifier: MIT
include(FindPackageHandleStandardArgs)

# camopt_find_by_pkg_config(<package> <target> <module>): what pkg-config knows as <module>, as the imported <target>.
# For the Find modules.
macro(camopt_find_by_pkg_config package target module)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(${package}_module QUIET IMPORTED_TARGET ${module})
    if(${package}_module_FOUND AND NOT TARGET ${target})
      add_library(${target} INTERFACE IMPORTED)
      target_link_libraries(${target} INTERFACE PkgConfig::${package}_module)
    endif()
  endif()
  find_package_handle_standard_args(${package} REQUIRED_VARS ${package}_module_FOUND
    VERSION_VAR ${package}_module_VERSION)
endmacro()
