# SPDX-License-Identifier: MIT
# The programs of examples/ against the installed static package, without optimization: they compile in seconds, and what they
# print is compared.
set(examples ${CMAKE_CURRENT_BINARY_DIR}/examples)
add_test(NAME package.examples_configure COMMAND ${CMAKE_COMMAND} --fresh -S ${PROJECT_SOURCE_DIR}/examples -B ${examples}
  -G ${CMAKE_GENERATOR} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_PREFIX_PATH=${prefix}
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}" "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror ${consumer_flags}")
set_tests_properties(package.examples_configure PROPERTIES
  FIXTURES_REQUIRED camopt_static_installed FIXTURES_SETUP examples_configured)
add_test(NAME package.examples_build COMMAND ${CMAKE_COMMAND} --build ${examples})
set_tests_properties(package.examples_build PROPERTIES
  FIXTURES_REQUIRED "camopt_static_installed;examples_configured" FIXTURES_SETUP examples_built COST 60)

# camopt_add_example(<name> <what it prints>)
function(camopt_add_example name prints)
  add_test(NAME package.example_${name}_runs COMMAND ${examples}/${name})
  set_tests_properties(package.example_${name}_runs PROPERTIES FIXTURES_REQUIRED examples_built PASS_REGULAR_EXPRESSION "${prints}")
endfunction()
camopt_add_example(first_solve
  "optimal: objective 0\\.939514, no .* below 0\\.93951.*V 1\\.7143  A 5\\.1429  J 61\\.714.* 30\\.0 deg   1\\.1309")
camopt_add_example(weight_sweep
  "0\\.1  2\\.0000   32\\.000    optimal.*0\\.5  1\\.7634   38\\.47.*0\\.9  1\\.3333   85\\.333    optimal")
camopt_add_example(cam_in_the_loop
  "optimal.*base radius 17\\.61.*pressure angle 30\\.000 deg.*above 13\\.544 mm.*least convex radius 9\\.41")
camopt_add_example(own_term "optimal: objective 0\\.78635.*squared_acceleration at most 23\\.0400")
camopt_add_example(limits_only
  "30 m/s2: optimal.*velocity: 550 of 550 mm/s.*15 m/s2: infeasible.*acceleration_m_s2 = 20 instead of 15")
camopt_add_example(machine "optimal at 182\\.[23][0-9] rpm, impossible at 182\\.[34].*limited by clearance\\[0\\]")
