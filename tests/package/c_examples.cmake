# SPDX-License-Identifier: MIT
# The C examples of bindings/c/examples against the installed package: static and shared core, every C compiler there is, by
# find_package and by pkg-config; what they print is looked at.
set(c_examples ${PROJECT_SOURCE_DIR}/bindings/c/examples)
set(first_solve_prints "spline.degree: found 4; allowed: 3, 5 or 7.*optimal: objective 0\\.93951366.*120\\.0 deg +10\\.00000 mm")
set(weight_sweep_prints "row 1 of 21.*optimal.*row 21 of 21.*ok after 21 rows, progress was told")
set(cam_profile_prints "optimal: objective 0\\.8617.*pressure_angle_deg = 30 deg: reached 30\\.0000 \\(active\\).*drawing: complete")

# camopt_add_c_runs(<prefix of the names> <folder of the programs> <fixture>): each program runs and prints what it should.
function(camopt_add_c_runs prefix folder fixture)
  foreach(example first_solve weight_sweep cam_profile)
    add_test(NAME ${prefix}_${example}_runs COMMAND ${folder}/${example})
    set_tests_properties(${prefix}_${example}_runs PROPERTIES FIXTURES_REQUIRED ${fixture}
      PASS_REGULAR_EXPRESSION "${${example}_prints}")
  endforeach()
  add_test(NAME ${prefix}_cancelled_sweep_runs COMMAND ${folder}/weight_sweep 4)
  set_tests_properties(${prefix}_cancelled_sweep_runs PROPERTIES FIXTURES_REQUIRED ${fixture}
    PASS_REGULAR_EXPRESSION "cancelled after 4 rows")
endfunction()

# camopt_add_c_tests(<static|shared> <name of the compiler> <compiler>)
function(camopt_add_c_tests kind name compiler)
  set(prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix_${kind})
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/c_examples_${kind}_${name})
  set(tests package.c_${kind}_${name})
  set(flags "-Wall -Wextra -pedantic -Werror ${consumer_flags}")
  add_test(NAME ${tests}_builds COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${c_examples} ${folder}
    --build-generator ${CMAKE_GENERATOR}
    --build-makeprogram ${CMAKE_MAKE_PROGRAM} --build-options -DCMAKE_C_COMPILER=${compiler} "-DCMAKE_C_FLAGS=${flags}"
    -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE})
  set_tests_properties(${tests}_builds PROPERTIES FIXTURES_REQUIRED camopt_${kind}_installed
    FIXTURES_SETUP c_${kind}_${name}_built)
  camopt_add_c_runs(${tests} ${folder} c_${kind}_${name}_built)
  if(NOT PKG_CONFIG_EXECUTABLE)
    return()
  endif()
  set(tests package.c_${kind}_${name}_pkg_config)
  set(folder ${folder}_pkg_config)
  add_test(NAME ${tests}_builds COMMAND ${CMAKE_COMMAND} -DPREFIX=${prefix} -DLIBDIR=${CMAKE_INSTALL_LIBDIR}
    -DPKG_CONFIG=${PKG_CONFIG_EXECUTABLE} -DCOMPILER=${compiler} "-DFLAGS=-std=c99 ${flags}" -DVERSION=${PROJECT_VERSION}
    -DFOLDER=${folder} -DEXAMPLES=${c_examples} -P ${CMAKE_CURRENT_LIST_DIR}/c_pkg_config.cmake)
  set_tests_properties(${tests}_builds PROPERTIES FIXTURES_REQUIRED camopt_${kind}_installed
    FIXTURES_SETUP c_${kind}_${name}_pkg_config_built)
  camopt_add_c_runs(${tests} ${folder} c_${kind}_${name}_pkg_config_built)
endfunction()

# The sanitizers' run-time libraries of two compilers do not go together.
set(c_compilers gcc clang)
if(CAMOPT_SANITIZE OR CAMOPT_COVERAGE)
  set(c_compilers gcc)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    set(c_compilers clang)
  endif()
endif()
foreach(name IN LISTS c_compilers)
  find_program(CAMOPT_${name} ${name})
  if(NOT CAMOPT_${name})
    message(STATUS "camopt: no ${name}: the C examples are not tested with it")
    continue()
  endif()
  foreach(kind static shared)
    camopt_add_c_tests(${kind} ${name} ${CAMOPT_${name}})
  endforeach()
endforeach()

# The page on the C library says nothing that does not compile.
if(CAMOPT_gcc AND NOT CAMOPT_SANITIZE AND NOT CAMOPT_COVERAGE)
  find_package(Python3 COMPONENTS Interpreter REQUIRED)
  set(installed ${CMAKE_CURRENT_BINARY_DIR}/prefix_static)
  add_test(NAME package.c_page COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/c_docs.py
    ${PROJECT_SOURCE_DIR}/docs/embedding_c.md ${CMAKE_CURRENT_BINARY_DIR}/c_page ${CAMOPT_gcc} -std=c99 -Wall -Wextra
    -pedantic -Werror -I${installed}/${CMAKE_INSTALL_INCLUDEDIR} -L${installed}/${CMAKE_INSTALL_LIBDIR} -lcamopt_c
    -Wl,-rpath,${installed}/${CMAKE_INSTALL_LIBDIR})
  set_tests_properties(package.c_page PROPERTIES FIXTURES_REQUIRED camopt_static_installed
    PASS_REGULAR_EXPRESSION "optimal: objective 0\\.926.*4 blocks compiled, 1 run")
endif()

# A program that has both faces in it, and what the libraries show.
find_package(Python3 COMPONENTS Interpreter REQUIRED)
foreach(kind static shared)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/c_and_cpp_${kind})
  add_test(NAME package.c_${kind}_beside_cpp_builds COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test
    ${CMAKE_CURRENT_LIST_DIR}/c_and_cpp ${folder} --build-generator ${CMAKE_GENERATOR}
    --build-makeprogram ${CMAKE_MAKE_PROGRAM} --build-options
    -DCMAKE_PREFIX_PATH=${CMAKE_CURRENT_BINARY_DIR}/prefix_${kind} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
    -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} "-DCMAKE_CXX_FLAGS=${consumer_flags}" -DCAMOPT_VERSION=${PROJECT_VERSION})
  set_tests_properties(package.c_${kind}_beside_cpp_builds PROPERTIES FIXTURES_REQUIRED camopt_${kind}_installed
    FIXTURES_SETUP c_${kind}_beside_cpp_built)
  add_test(NAME package.c_${kind}_beside_cpp_runs COMMAND ${folder}/c_and_cpp)
  set_tests_properties(package.c_${kind}_beside_cpp_runs PROPERTIES FIXTURES_REQUIRED c_${kind}_beside_cpp_built
    PASS_REGULAR_EXPRESSION "the same to the last bit")
  add_test(NAME package.c_${kind}_symbols COMMAND ${Python3_EXECUTABLE} -B
    ${PROJECT_SOURCE_DIR}/tests/bindings/c/exported_symbols.py ${CMAKE_NM}
    ${CMAKE_CURRENT_BINARY_DIR}/prefix_${kind}/${CMAKE_INSTALL_LIBDIR}/libcamopt_c.so.0
    ${CMAKE_CURRENT_BINARY_DIR}/prefix_${kind}/${CMAKE_INSTALL_INCLUDEDIR}/camopt.h)
  set_tests_properties(package.c_${kind}_symbols PROPERTIES FIXTURES_REQUIRED camopt_${kind}_installed)
endforeach()
add_test(NAME package.c_shared_needs_the_core COMMAND ${CMAKE_COMMAND} -DREADELF=${CMAKE_READELF}
  -DLIBRARY=${CMAKE_CURRENT_BINARY_DIR}/prefix_shared/${CMAKE_INSTALL_LIBDIR}/libcamopt_c.so -DSONAME=libcamopt_c.so.0
  -DNEEDS=libcamopt.so.${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} -P ${CMAKE_CURRENT_LIST_DIR}/c_library.cmake)
set_tests_properties(package.c_shared_needs_the_core PROPERTIES FIXTURES_REQUIRED camopt_shared_installed)
add_test(NAME package.c_static_needs_no_core COMMAND ${CMAKE_COMMAND} -DREADELF=${CMAKE_READELF}
  -DLIBRARY=${CMAKE_CURRENT_BINARY_DIR}/prefix_static/${CMAKE_INSTALL_LIBDIR}/libcamopt_c.so -DSONAME=libcamopt_c.so.0
  -DNEEDS= -P ${CMAKE_CURRENT_LIST_DIR}/c_library.cmake)
set_tests_properties(package.c_static_needs_no_core PROPERTIES FIXTURES_REQUIRED camopt_static_installed)
