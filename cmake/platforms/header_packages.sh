#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# header_packages.sh OUT: the header-only libraries for a cross compiler. OUT/include has links to nothing but them (with
# -isystem /usr/include a cross compiler would read this machine's libc), OUT/<package>Config.cmake what find_package wants:
#   cmake … -DCMAKE_PREFIX_PATH=OUT -DCAMOPT_TOMLPLUSPLUS_INCLUDE_DIR=OUT/include
set -euo pipefail

out="$(mkdir -p "$1/include" && cd "$1" && pwd)"
for name in fmt toml++ nlohmann CLI; do ln -sfn "/usr/include/$name" "$out/include/$name"; done

# package <name> <target> <version> <definitions>; unchanged files keep their time, so that nothing is configured again
package() {
    cat > "$out/new" <<CMAKE
if(NOT TARGET $2)
  add_library($2 INTERFACE IMPORTED)
  target_include_directories($2 SYSTEM INTERFACE $out/include)
  target_compile_definitions($2 INTERFACE $4)
endif()
CMAKE
    cmp -s "$out/new" "$out/$1Config.cmake" || cp "$out/new" "$out/$1Config.cmake"
    cat > "$out/new" <<CMAKE
set(PACKAGE_VERSION $3)
set(PACKAGE_VERSION_COMPATIBLE TRUE)
CMAKE
    cmp -s "$out/new" "$out/$1ConfigVersion.cmake" || cp "$out/new" "$out/$1ConfigVersion.cmake"
    rm "$out/new"
}
package fmt fmt::fmt 9.1.0 FMT_HEADER_ONLY
package nlohmann_json nlohmann_json::nlohmann_json 3.11.2 ""
package CLI11 CLI11::CLI11 2.1.2 ""
