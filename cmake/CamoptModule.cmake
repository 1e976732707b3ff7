# SPDX-License-Identifier: MIT
# camopt_add_module(<folder> [COLD] SOURCES … HEADERS … [PUBLIC …] [PRIVATE …])
# One library a folder, camopt::<folder>, with its headers beside its sources. PUBLIC are the folders
# and packages its headers include, PRIVATE those only its sources need. COLD: read and write, words and pictures, where no
# time goes: compiled with -O1 in Release, in four fifths of the time; for pages as small as can be.

# Where <camopt/….hpp> are written, what is promised to embedders (include/promised_headers.cmake).
set(camopt_promised_dir ${PROJECT_BINARY_DIR}/include)

include(CheckCXXCompilerFlag)

add_library(camopt_warnings INTERFACE)
# A switch that lacks a kind or a follower is an error of every build.
target_compile_options(camopt_warnings INTERFACE -Werror=switch -Wall -Wextra -Wpedantic -Wconversion
  -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
if(NOT CAMOPT_UNITY_BUILD)  # the names of one file are no shadows of those of the next
  target_compile_options(camopt_warnings INTERFACE -Wshadow)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 sees overlapping copies in "text" + std::string where there are none (GCC bug 105651).
  target_compile_options(camopt_warnings INTERFACE -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ looks for memory to free whenever its heap has grown by so much: more seldom saves a twentieth of the time, and a
  # unit still stays below 1.5 GB (scripts/build).
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=524288>")
endif()
if(CAMOPT_WARNINGS_AS_ERRORS)
  target_compile_options(camopt_warnings INTERFACE -Werror)
endif()

add_library(camopt_instrumentation INTERFACE)
if(CAMOPT_SANITIZE)
  target_compile_options(camopt_instrumentation INTERFACE -fsanitize=${CAMOPT_SANITIZE}
    -fno-sanitize-recover=all -fno-omit-frame-pointer
    -Wno-maybe-uninitialized) # GCC loses track of members in instrumented code
  target_link_options(camopt_instrumentation INTERFACE -fsanitize=${CAMOPT_SANITIZE})
endif()
if(CAMOPT_COVERAGE)
  target_compile_options(camopt_instrumentation INTERFACE --coverage)
  target_link_options(camopt_instrumentation INTERFACE --coverage)
endif()

# camopt_header_only(<target> <result>): true for an imported package without a library. An installed camopt does
# not ask its consumers for those.
function(camopt_header_only target result)
  set(${result} FALSE PARENT_SCOPE)
  if(TARGET ${target})
    get_target_property(type ${target} TYPE)
    get_target_property(imported ${target} IMPORTED)
    get_target_property(libraries ${target} INTERFACE_LINK_LIBRARIES)
    if(imported AND type STREQUAL "INTERFACE_LIBRARY" AND NOT libraries)
      set(${result} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()

if(NOT DEFINED camopt_cold_level)  # a toolchain may
  set(camopt_cold_level -O1)
endif()
# g++ 12 sees numbers without a value where -O1 has not followed them.
set(camopt_cold_options $<$<CONFIG:Release>:${camopt_cold_level};-Wno-maybe-uninitialized>)
function(camopt_cold target)
  target_compile_options(${target} PRIVATE ${camopt_cold_options})
endfunction()

# camopt_compile_alone(<target> <sources …>): not together with others, whatever CAMOPT_UNITY_BUILD is.
function(camopt_compile_alone target)
  set_source_files_properties(${ARGN} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# camopt_embed_text(<function> <header> <folder> <files …>): <function>_text.cpp in the binary folder defines <function>(name), declared
# in <header>, which returns the text of one of the files, named from <folder>.
function(camopt_embed_text function header folder)
  list(JOIN ARGN "," names)
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE files)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}_text.cpp)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DROOT=${folder} -DNAMES=${names} -DFUNCTION=${function} -DHEADER=${header} -P ${script}
    DEPENDS ${files} ${script} COMMENT "Embedding the texts of ${function}" VERBATIM)
endfunction()

# camopt_compile_with(<target> <source> <options …>): alone, without precompiled headers, with further options.
function(camopt_compile_with target source)
  set_property(SOURCE ${source} TARGET_DIRECTORY ${target} APPEND PROPERTY COMPILE_OPTIONS ${ARGN})
  set_property(SOURCE ${source} TARGET_DIRECTORY ${target} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
  camopt_compile_alone(${target} ${source})
endfunction()

# camopt_wide_kernels(<target> <source>): the loops once more for machines with AVX2 and FMA (linear/kernels.hpp), where
# the compiler knows them: these two alone, which the program looks for before it runs such code. Compiled alone, and without
# precompiled headers: their inline functions must not be compiled so.
check_cxx_compiler_flag(-march=x86-64-v3 CAMOPT_COMPILES_X86_64_V3)
function(camopt_wide_kernels target source)
  if(NOT CAMOPT_COMPILES_X86_64_V3)
    return()
  endif()
  target_sources(${target} PRIVATE ${source})
  target_compile_definitions(${target} PRIVATE CAMOPT_WIDE_KERNELS)
  camopt_compile_with(${target} ${source} -mavx2 -mfma)
endfunction()

# camopt_compile_together(<target> [<most>]): its sources in equal units of at most CAMOPT_UNITY_BATCH (<most>), where
# CAMOPT_UNITY_BUILD is on: unequal ones are waited for at the end of a build.
function(camopt_compile_together target)
  set(most ${CAMOPT_UNITY_BATCH})
  if(ARGC GREATER 1)
    set(most ${ARGV1})
  endif()
  if(NOT CAMOPT_UNITY_BUILD)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(LENGTH sources count)
  set(size 0)
  if(count GREATER 0 AND most GREATER 0)
    math(EXPR units "(${count} + ${most} - 1) / ${most}")
    math(EXPR size "(${count} + ${units} - 1) / ${units}")
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
endfunction()

function(camopt_add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COLD" "" "SOURCES;HEADERS;PUBLIC;PRIVATE")
  set(target camopt_${name})
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(camopt::${name} ALIAS ${target})
  target_sources(${target} PUBLIC FILE_SET HEADERS
    BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
  if(CAMOPT_LONE_HEADERS)
    set(sources ${arg_SOURCES})
    list(TRANSFORM sources REPLACE "\\.cpp$" ".hpp")
    set(lone ${arg_HEADERS})
    list(REMOVE_ITEM lone ${sources})
    target_sources(${target} PUBLIC FILE_SET lone TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${lone})
    set_property(TARGET ${target} PROPERTY INTERFACE_HEADER_SETS_TO_VERIFY lone)
  endif()
  # <camopt/….hpp>, what is promised to embedders: for a project with camopt in it. Nothing of camopt includes them.
  if(NOT PROJECT_IS_TOP_LEVEL)
    target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${camopt_promised_dir}>)
  endif()
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON)
  set(private "")
  foreach(library IN LISTS arg_PRIVATE)
    camopt_header_only(${library} header_only)
    if(header_only)
      list(APPEND private $<BUILD_INTERFACE:${library}>)
    else()
      list(APPEND private ${library})
    endif()
  endforeach()
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${private}
    $<BUILD_INTERFACE:camopt_warnings> $<BUILD_INTERFACE:camopt_instrumentation>)
  set(precompiled camopt_precompiled)
  if(arg_COLD)
    camopt_cold(${target})
    set(precompiled camopt_precompiled_cold)
  endif()
  if("fmt::fmt" IN_LIST arg_PRIVATE)
    camopt_use_precompiled(${target} ${precompiled})
  endif()
  # A picture's layout goes by the same short names in every file: page_width, margin, top.
  set(pictures ${arg_SOURCES})
  list(FILTER pictures INCLUDE REGEX "_svg\\.cpp$")
  camopt_compile_alone(${target} ${pictures})
  camopt_compile_together(${target})
  set_property(GLOBAL APPEND PROPERTY CAMOPT_MODULES ${name})
endfunction()
