#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# exception_runtime.sh OUT: the runtime of C++ exceptions for clang-22 --target=wasm32-wasi, which Debian's
# libc++abi-22-dev-wasm32 leaves out, as OUT/libcamopt_runtime.a, with what else the C++ library lacks. Its sources
# (LLVM 13's, Apache-2.0 WITH LLVM-exception) are in Debian's binary package emscripten: unpacked, not installed.
# Needs: clang-22 lld-22 wasi-libc libc++-22-dev-wasm32 libc++abi-22-dev-wasm32 libclang-rt-22-dev-wasm32 and llvm-ar.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
out="$(mkdir -p "$1/objects" && cd "$1" && pwd)"
if [[ ! -d "$out/emscripten" ]]; then
    mkdir -p "$out/package"
    (cd "$out/package" && apt-get download -qq emscripten)
    mkdir "$out/unpacking"
    dpkg-deb --fsys-tarfile "$out"/package/emscripten_*.deb | tar -x -C "$out/unpacking" --strip-components=6 \
        ./usr/share/emscripten/system/lib/libcxxabi ./usr/share/emscripten/system/lib/libunwind
    mv "$out/unpacking" "$out/emscripten"
fi
abi="$out/emscripten/libcxxabi" unwind="$out/emscripten/libunwind"
options=(--target=wasm32-wasi -Wno-deprecated -fwasm-exceptions -O2 -DNDEBUG "-ffile-prefix-map=$out=." "-I$unwind/include"
    -D__USING_WASM_EXCEPTIONS__)
# LLVM 13's sources with LLVM 22's headers: macros that were removed since are defined here.
for name in cxa_exception cxa_personality cxa_aux_runtime; do
    clang++-22 "${options[@]}" -std=c++20 "-I$abi/src" "-I$abi/include" -D_LIBCXXABI_BUILDING_LIBRARY \
        -D_LIBCPP_BUILDING_LIBRARY -D_LIBCXXABI_HAS_NO_THREADS -D_LIBCPP_HAS_NO_THREADS -D_LIBCPP_INLINE_VISIBILITY= -w \
        -c "$abi/src/$name.cpp" -o "$out/objects/$name.o"
done
clang-22 "${options[@]}" -include stdbool.h "-I$unwind/src" -D__EMSCRIPTEN__ -D_LIBUNWIND_HAS_NO_THREADS \
    -D_LIBUNWIND_DISABLE_VISIBILITY_ANNOTATIONS -c "$unwind/src/Unwind-wasm.c" -o "$out/objects/unwind.o"
for name in throwing_new wasi_files; do
    clang++-22 "${options[@]}" -std=c++20 -isystem "$here/include" -c "$here/$name.cpp" -o "$out/objects/$name.o"
done
clang-22 "${options[@]}" -c "$here/cpp_exception_tag.c" -o "$out/objects/tag.o"
rm -f "$out/libcamopt_runtime.a"
archive=llvm-ar-14
for name in llvm-ar-22 llvm-ar; do ! command -v "$name" >/dev/null || archive="$name"; done
"$archive" rcsD "$out/libcamopt_runtime.a" "$out"/objects/*.o
