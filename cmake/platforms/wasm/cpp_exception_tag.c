/* SPDX-License-Identifier: MIT
   The tag that `throw` and `catch` of C++ go by in WebAssembly. clang up to 20 put it into every object;
   since then the unwinder has to bring it, and the one of emscripten 3.1.6 is older. */
__asm__(
    ".globl __cpp_exception\n"
    "\t.tagtype __cpp_exception i32\n"
    "__cpp_exception:\n");
