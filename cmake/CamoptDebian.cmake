# SPDX-License-Identifier: MIT
# CAMOPT_DEBIAN: five Debian packages by cpack, each a component of cmake --install: camopt, libcamopt-dev (static), python3-camopt,
# and the parts that each of these opens when it uses them: camopt-parts, and camopt-step for itself, which needs 370 MB.
# The preset `debian` has the options that belong to it; scripts/release debian builds, checks and names the result.
if(CAMOPT_GPL)
  message(FATAL_ERROR "camopt: Debian packages are distributed: CAMOPT_DEBIAN=ON needs CAMOPT_GPL=OFF (preset debian)")
endif()
if(BUILD_SHARED_LIBS OR NOT CAMOPT_C OR NOT CAMOPT_HAVE_PYTHON OR NOT TARGET camopt
   OR NOT CAMOPT_OPENED_PARTS STREQUAL "ipopt;http;pdf;step")
  message(FATAL_ERROR "camopt: CAMOPT_DEBIAN=ON needs the program, the C library, the Python package, static libraries and every part (preset debian)")
endif()
# Debian demands "Name <address>" with a host that has a dot. camopt has no address: its maintainers are reached as SECURITY.md and
# CONTRIBUTING.md say. `.invalid` is reserved (RFC 2606), so it receives no mail. Distributors set their own contact here.
set(CAMOPT_DEBIAN_MAINTAINER "The camopt maintainers <noreply@camopt.invalid>" CACHE STRING "Maintainer of the Debian packages")
set(CAMOPT_OFFLINE_PAGE "" CACHE FILEPATH "Page of scripts/offline_page, camopt.html; the package camopt installs it in share/camopt")

if(NOT EXISTS "${CAMOPT_OFFLINE_PAGE}")
  message(FATAL_ERROR "camopt: CAMOPT_DEBIAN=ON needs CAMOPT_OFFLINE_PAGE (scripts/offline_page): the package camopt contains the page")
endif()
install(FILES ${CAMOPT_OFFLINE_PAGE} DESTINATION ${CMAKE_INSTALL_DATADIR}/camopt COMPONENT camopt_program)

# camopt_debian_documents(<component> <package>): the licence of camopt and of what is compiled in, and the changelog.
string(TIMESTAMP camopt_debian_date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH, if set
function(camopt_debian_documents component package)
  set(folder ${PROJECT_BINARY_DIR}/debian/${package})
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${Python_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/scripts/license_texts ${package}
    OUTPUT_FILE ${folder}/copyright COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${folder}/changelog "${package} (${PROJECT_VERSION}) bookworm; urgency=medium\n\n"
    "  * Release ${PROJECT_VERSION}. CHANGELOG.md of the source lists the changes.\n\n"
    " -- ${CAMOPT_DEBIAN_MAINTAINER}  ${camopt_debian_date}\n")
  execute_process(COMMAND gzip -9nf ${folder}/changelog COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${folder}/copyright ${folder}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endfunction()
camopt_debian_documents(camopt_program camopt)
camopt_debian_documents(camopt_static libcamopt-dev)
camopt_debian_documents(camopt_python python3-camopt)
camopt_debian_documents(camopt_parts camopt-parts)
camopt_debian_documents(camopt_step camopt-step)

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL camopt_program camopt_static camopt_python camopt_parts camopt_step)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "${CAMOPT_DEBIAN_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_CAMOPT_PROGRAM_PACKAGE_NAME camopt)
set(CPACK_DEBIAN_CAMOPT_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CAMOPT_PROGRAM_DESCRIPTION "optimal motion curves for cams and servo axes, with proof
Finds the spline with the least weighted peaks of velocity, acceleration and
jerk under limits of motion, cam and forces, and proves a lower bound that
holds for every spline of that space. Writes report, drawing, NC program and
controller table. camopt-parts has Ipopt, PDF drawings and the studio's
server, camopt-step STEP files.")

# What the CMake package and camopt.pc name. libcamopt_c.so, the C library, is made of
# the static libraries; it is here with its header, so that a program in C needs this package where it runs, too.
# A part is of the same build as what opens it.
foreach(component PROGRAM STATIC PYTHON)
  set(CPACK_DEBIAN_CAMOPT_${component}_PACKAGE_RECOMMENDS "camopt-parts (= ${PROJECT_VERSION})")
endforeach()
set(CPACK_DEBIAN_CAMOPT_PROGRAM_PACKAGE_SUGGESTS "camopt-step (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_CAMOPT_STATIC_PACKAGE_SUGGESTS "camopt-step (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_CAMOPT_PARTS_PACKAGE_NAME camopt-parts)
set(CPACK_DEBIAN_CAMOPT_PARTS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CAMOPT_PARTS_DESCRIPTION "optimal motion curves for cams - Ipopt, PDF and studio
What camopt, its C and C++ libraries and its Python package open when they
use it: the solver Ipopt, PDF drawings by cairo, and the HTTP server of
camopt studio.")

set(CPACK_DEBIAN_CAMOPT_STEP_PACKAGE_NAME camopt-step)
set(CPACK_DEBIAN_CAMOPT_STEP_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CAMOPT_STEP_DESCRIPTION "optimal motion curves for cams - STEP files
What camopt, its C and C++ libraries and its Python package open when they
write a cam as a STEP file: Open CASCADE.")

set(CPACK_DEBIAN_CAMOPT_STATIC_PACKAGE_NAME libcamopt-dev)
set(CPACK_DEBIAN_CAMOPT_STATIC_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_CAMOPT_STATIC_PACKAGE_DEPENDS
  "libeigen3-dev, libfmt-dev, libnlopt-dev")
set(CPACK_DEBIAN_CAMOPT_STATIC_DESCRIPTION "optimal motion curves for cams - libraries for C++ and C
Static C++ libraries, headers, CMake package and pkg-config file of camopt,
which optimizes motion curves of cams and servo axes, and its C library.")

set(CPACK_DEBIAN_CAMOPT_PYTHON_PACKAGE_NAME python3-camopt)
set(CPACK_DEBIAN_CAMOPT_PYTHON_PACKAGE_SECTION python)
math(EXPR camopt_next_python "${Python_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_CAMOPT_PYTHON_PACKAGE_DEPENDS
  "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${camopt_next_python}), python3-numpy")
set(CPACK_DEBIAN_CAMOPT_PYTHON_PACKAGE_SUGGESTS "python3-scipy, camopt-step (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_CAMOPT_PYTHON_DESCRIPTION "optimal motion curves for cams - Python package
Solves scenes of camopt from Python: NumPy arrays in and out, user-defined
terms and limits, sweeps, machines, and all files that the program writes.")
# camopt_debian_control(<component in upper case> <name> <text>): one more file of a package's control archive.
function(camopt_debian_control component name text)
  set(path ${PROJECT_BINARY_DIR}/debian/${component}/${name})
  file(WRITE ${path} "${text}")
  set(variable CPACK_DEBIAN_${component}_PACKAGE_CONTROL_EXTRA)
  set(${variable} ${${variable}} ${path} PARENT_SCOPE)
endfunction()
# Byte code is written at installation and removed with the package.
set(camopt_script "#!/bin/sh\nset -e\nif command -v %1 >/dev/null; then\n    %1 -p python3-camopt\nfi\n")
string(REPLACE "%1" py3compile camopt_postinst "${camopt_script}")
string(REPLACE "%1" py3clean camopt_prerm "${camopt_script}")
camopt_debian_control(CAMOPT_PYTHON postinst "${camopt_postinst}")
camopt_debian_control(CAMOPT_PYTHON prerm "${camopt_prerm}")
# The dynamic linker finds libcamopt_c.so; what links it depends on this package.
camopt_debian_control(CAMOPT_STATIC triggers "activate-noawait ldconfig\n")
camopt_debian_control(CAMOPT_STATIC shlibs
  "libcamopt_c ${camopt_c_soversion} libcamopt-dev (>= ${PROJECT_VERSION})\n")
include(CPack)
