# SPDX-License-Identifier: MIT
# cairo with its PDF surface: drawings as PDF.
find_path(CamoptCairo_INCLUDE_DIR cairo-pdf.h PATH_SUFFIXES cairo)
find_library(CamoptCairo_LIBRARY cairo)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CamoptCairo REQUIRED_VARS CamoptCairo_INCLUDE_DIR CamoptCairo_LIBRARY)
mark_as_advanced(CamoptCairo_INCLUDE_DIR CamoptCairo_LIBRARY)
if(CamoptCairo_FOUND AND NOT TARGET camopt_cairo_package)
  add_library(camopt_cairo_package INTERFACE IMPORTED)
  target_include_directories(camopt_cairo_package SYSTEM INTERFACE ${CamoptCairo_INCLUDE_DIR})
  target_link_libraries(camopt_cairo_package INTERFACE ${CamoptCairo_LIBRARY})
endif()
