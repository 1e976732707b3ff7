# SPDX-License-Identifier: MIT
# The parts of Open CASCADE that write STEP files: its data exchange and what that stands on. Its own CMake package is
# not used: it asks for the development files of TBB and of everything else the whole of it was built with.
find_path(CamoptOpenCascade_INCLUDE_DIR STEPControl_Writer.hxx PATH_SUFFIXES opencascade)
set(camopt_opencascade_libraries "")
set(camopt_opencascade_variables CamoptOpenCascade_INCLUDE_DIR)
foreach(part TKSTEP TKSTEPBase TKXSBase TKBO TKPrim TKTopAlgo TKBRep TKGeomBase TKG3d TKMath TKernel)
  find_library(CamoptOpenCascade_${part} ${part})
  list(APPEND camopt_opencascade_libraries ${CamoptOpenCascade_${part}})
  list(APPEND camopt_opencascade_variables CamoptOpenCascade_${part})
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CamoptOpenCascade REQUIRED_VARS ${camopt_opencascade_variables})
mark_as_advanced(${camopt_opencascade_variables})
if(CamoptOpenCascade_FOUND AND NOT TARGET camopt_opencascade_package)
  add_library(camopt_opencascade_package INTERFACE IMPORTED)
  target_include_directories(camopt_opencascade_package SYSTEM INTERFACE ${CamoptOpenCascade_INCLUDE_DIR})
  target_link_libraries(camopt_opencascade_package INTERFACE ${camopt_opencascade_libraries})
endif()
