# SPDX-License-Identifier: MIT
# Text files as strings of a C++ program, at build time:
#   cmake -DOUTPUT=file.cpp -DROOT=folder -DNAMES=a.js,b.css -P EmbedText.cmake
# defines camopt::page_asset(name), which returns the text of one of them; with -DFUNCTION=other -DHEADER=other.hpp
# another function, declared in another header.
string(REPLACE "," ";" names "${NAMES}")
if(NOT FUNCTION)
  set(FUNCTION page_asset)
  set(HEADER report/page/page_parts.hpp)
endif()
set(code "// Made by cmake/EmbedText.cmake.\n#include \"${HEADER}\"\n\n#include \"core/errors.hpp\"\n\nnamespace camopt {\n\n")
string(APPEND code "std::string_view ${FUNCTION}(std::string_view name) {\n")
foreach(name IN LISTS names)
  file(READ "${ROOT}/${name}" text)
  string(FIND "${text}" ")camopt\"" inside)
  if(NOT inside EQUAL -1)
    message(FATAL_ERROR "${name} holds the mark that ends a text")
  endif()
  string(APPEND code "    if (name == \"${name}\")\n        return R\"camopt(${text})camopt\";\n")
endforeach()
string(APPEND code "    throw ModelError(\"${FUNCTION}: no such file\");\n}\n\n}  // namespace camopt\n")
file(WRITE "${OUTPUT}" "${code}")
