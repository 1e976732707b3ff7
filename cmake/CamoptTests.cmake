# SPDX-License-Identifier: MIT
# Tests by tier. A tier is a ctest label and a budget for each case (CONTRIBUTING.md, "Tests"):
#   unit     below 0.5 s    scripts/test, and the sanitizers in CI
#   solve    0.5 to 3 s     scripts/test
#   product  what a user receives: the program, its files, the package, the documents    scripts/test
#   python   the Python package    .ci/run, and scripts/test --python
#   nightly  everything longer    scripts/nightly
# The cases of a GoogleTest program belong to `unit` unless tests/tiers.txt names them.

# camopt_label(<tier> TESTS … TARGETS …): the tier of tests, and what has to be built before `ctest -L <tier>` runs them
# (target <tier>_tests).
function(camopt_label tier)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "TESTS;TARGETS")
  if(NOT tier MATCHES "^(unit|solve|product|python|nightly)$")
    message(FATAL_ERROR "camopt_label: found the tier '${tier}'; allowed: unit, solve, product, python, nightly")
  endif()
  if(NOT TARGET ${tier}_tests)
    add_custom_target(${tier}_tests)
  endif()
  if(arg_TARGETS)
    add_dependencies(${tier}_tests ${arg_TARGETS})
  endif()
  if(arg_TESTS)
    set_tests_properties(${arg_TESTS} PROPERTIES LABELS ${tier})
  endif()
endfunction()

# tests/tiers.txt as two filters of GoogleTest, camopt_cases_of_solve and camopt_cases_of_nightly.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/tiers.txt)
file(STRINGS ${PROJECT_SOURCE_DIR}/tests/tiers.txt camopt_tier_lines REGEX "^[^#]")
foreach(line IN LISTS camopt_tier_lines)
  if(NOT line MATCHES "^(solve|nightly) +([^ :-]+)$")
    message(FATAL_ERROR "tests/tiers.txt: found '${line}'; allowed: solve or nightly, then one pattern of GoogleTest")
  endif()
  list(APPEND camopt_cases_of_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
endforeach()
list(JOIN camopt_cases_of_solve ":" camopt_cases_of_solve)
list(JOIN camopt_cases_of_nightly ":" camopt_cases_of_nightly)

# camopt_add_test(<name> SOURCES … [LIBRARIES …] [TIMEOUT …] [ENVIRONMENT NAME=VALUE]): one GoogleTest program; ctest knows its
# cases by their tiers and starts the longer ones first. A case that makes no assertion fails
# (tests/support/counted_assertions.hpp).
function(camopt_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT;ENVIRONMENT" "SOURCES;LIBRARIES")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} camopt_test_sources GTest::gtest_main camopt_warnings camopt_instrumentation)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests)
  # What is tested is optimised; the tests themselves are compiled more often than they run.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1;-Wno-maybe-uninitialized>)
  camopt_use_precompiled(${name} camopt_precompiled_tests)
  if(NOT TARGET camopt_precompiled_tests)  # which contain it
    target_compile_options(${name} PRIVATE "SHELL:-include tests/support/counted_assertions.hpp")
  endif()
  camopt_compile_together(${name} ${CAMOPT_TEST_UNITY_BATCH})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 600)
  endif()
  set(filter_unit "*-${camopt_cases_of_solve}:${camopt_cases_of_nightly}")
  set(filter_solve "${camopt_cases_of_solve}-${camopt_cases_of_nightly}")
  set(filter_nightly "${camopt_cases_of_nightly}")
  set(cost_unit 0.1)
  set(cost_solve 2)
  set(cost_nightly 10)
  foreach(tier unit solve nightly)
    camopt_label(${tier} TARGETS ${name})
    if(filter_${tier} MATCHES "^(-|$)")
      continue()  # no pattern of this tier
    endif()
    gtest_discover_tests(${name} TEST_FILTER "${filter_${tier}}" TEST_LIST ${name}_${tier} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
      PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS ${tier} COST ${cost_${tier}} ENVIRONMENT "${arg_ENVIRONMENT}")
  endforeach()
endfunction()
