# SPDX-License-Identifier: MIT
# camopt_python_with(<variable> <modules>): an interpreter that imports the modules ("ezdxf"; "ipykernel, jupyter_client"), or
# the first where none does: what it runs says what is missing. Debian's modules belong to Debian's interpreter, which
# need not be the first.
function(camopt_python_with variable modules)
  find_package(Python3 COMPONENTS Interpreter REQUIRED)
  foreach(candidate ${Python3_EXECUTABLE} /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import ${modules}" RESULT_VARIABLE missing OUTPUT_QUIET ERROR_QUIET)
    if(missing EQUAL 0)
      set(${variable} ${candidate} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(${variable} ${Python3_EXECUTABLE} PARENT_SCOPE)
endfunction()
