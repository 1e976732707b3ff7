# SPDX-License-Identifier: MIT
# CMake toolchain: g++ for 64-bit Windows with POSIX threads, everything in the one .exe; no DLL but the system's.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
# An object of a unity build has more sections than the plain format counts. The linker writes the time of the build
# otherwise, which would change the file.
set(CMAKE_CXX_FLAGS_INIT "-Wa,-mbig-obj -D_WIN32_WINNT=0x0A00 -DNOMINMAX")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -Wl,--gc-sections -Wl,--no-insert-timestamp")
