# SPDX-License-Identifier: MIT
# MPI's C interface, of whatever implementation the compiler wrapper mpicxx or mpicc on the path belongs to.
set(MPI_CXX_SKIP_MPICXX ON)
find_package(MPI QUIET COMPONENTS CXX)
if(MPI_CXX_FOUND AND NOT TARGET camopt_mpi_package)
  add_library(camopt_mpi_package INTERFACE IMPORTED)
  target_link_libraries(camopt_mpi_package INTERFACE MPI::MPI_CXX)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CamoptMPI REQUIRED_VARS MPI_CXX_FOUND VERSION_VAR MPI_CXX_VERSION)
