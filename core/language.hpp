// SPDX-License-Identifier: MIT
// First in every public header: a compiler without C++20 stops here with one line instead of hundreds of
// errors.
#pragma once

#if __cplusplus < 202002L
// A file that is missing ends the compilation at once; #error would not.
#include <camopt needs C++20: compile with -std=c++20 or later>
#endif
