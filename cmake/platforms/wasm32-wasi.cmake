# SPDX-License-Identifier: MIT
# CMake toolchain: Debian's clang-22 for WebAssembly, with C++ exceptions. CAMOPT_WASM_RUNTIME is the folder that
# cmake/platforms/wasm/exception_runtime.sh filled.
#   cmake -S … -DCMAKE_TOOLCHAIN_FILE=cmake/platforms/wasm32-wasi.cmake -DCAMOPT_WASM_RUNTIME=/path …
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES CAMOPT_WASM_RUNTIME)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-22)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
find_program(CMAKE_AR NAMES llvm-ar-22 llvm-ar-14 llvm-ar REQUIRED)
find_program(CMAKE_RANLIB NAMES llvm-ranlib-22 llvm-ranlib-14 llvm-ranlib REQUIRED)
# The shims come before the C++ library's headers. Some names of warnings are g++'s.
set(CMAKE_CXX_FLAGS_INIT
  "-Wno-deprecated -Wno-unknown-warning-option -fwasm-exceptions -msimd128 -isystem ${CMAKE_CURRENT_LIST_DIR}/wasm/include")
# A page is downloaded: where no time goes, code is small (camopt_cold).
set(camopt_cold_level -Oz)
# The C++ library is compiled without exceptions: what it lacks comes before it.
set(CMAKE_CXX_STANDARD_LIBRARIES "-L${CAMOPT_WASM_RUNTIME} -lcamopt_runtime")
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY NEVER)
