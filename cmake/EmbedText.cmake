# SPDX-License-Identifier: MIT
# Text files as strings of a C++ program, at build time (camopt_embed_text):
#   cmake -DOUTPUT=file.cpp -DROOT=folder -DNAMES=a.js,b.css -DFUNCTION=page_asset -DHEADER=page.hpp -P EmbedText.cmake
# defines camopt::page_asset(name), declared in page.hpp, which returns the text of one of them.
string(REPLACE "," ";" names "${NAMES}")
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
