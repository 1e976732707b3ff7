#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# benchmarks/against_commit.sh COMMIT BUILD [PAIRS [FOLDER]]: did solving scenes without a cam become slower since
# COMMIT?
#
# Checks COMMIT out beside the repository (in FOLDER, which is kept; else in a folder of its own), builds solve_seconds
# there as BUILD, a built folder of this tree, was built, and runs both programs alternately, the first of a pair in
# turns. CSV on the standard output: scene, median processor seconds of solve() before and after, median and quartiles
# of the ratio after / before, the ratio of the least wall seconds, pairs, whether both found the same optimum.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
commit="$1" build="$2" pairs="${3:-40}" old="${4:-}" repeats=5
if [[ -z $old ]]; then
    old="$(mktemp -d)"
    trap 'git -C "$root" worktree remove --force "$old/tree" >/dev/null 2>&1 || true; rm -rf "$old"' EXIT
fi

prepare() {
    local tree="$old/tree"
    git -C "$root" worktree prune # of a folder that was deleted
    [[ -d $tree ]] || git -C "$root" worktree add --detach "$tree" "$commit"
    mkdir -p "$tree/benchmarks/parts"
    cp "$root/benchmarks/solve_seconds.cpp" "$tree/benchmarks/"
    cp "$root/benchmarks/parts/whole_output.hpp" "$tree/benchmarks/parts/"
    grep -q solve_seconds "$tree/benchmarks/CMakeLists.txt" || cat >> "$tree/benchmarks/CMakeLists.txt" <<'END'
add_executable(solve_seconds solve_seconds.cpp)
target_include_directories(solve_seconds PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(solve_seconds PRIVATE camopt::studies camopt::input camopt_warnings)
END
    cmake -S "$tree" -B "$old/build" -G Ninja -DCAMOPT_BUILD_BENCHMARKS=ON \
        -DCMAKE_BUILD_TYPE="$(setting CMAKE_BUILD_TYPE)" -DCMAKE_CXX_COMPILER="$(setting CMAKE_CXX_COMPILER)" \
        -DCMAKE_CXX_FLAGS="$(setting CMAKE_CXX_FLAGS)" \
        -DCMAKE_CXX_COMPILER_LAUNCHER="$(setting CMAKE_CXX_COMPILER_LAUNCHER)"
    nice cmake --build "$old/build" -j "${CAMOPT_JOBS:-1}" --target solve_seconds
}

setting() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

prepare >&2

run_old() { "$old/build/benchmarks/solve_seconds" "$1" "$repeats"; }
run_new() { "$build/benchmarks/solve_seconds" "$1" "$repeats"; }

# One line a pair: what the old program prints, then what the new one prints.
pair() {
    local before after
    if (($2 % 2)); then
        before="$(run_old "$1")"
        after="$(run_new "$1")"
    else
        after="$(run_new "$1")"
        before="$(run_old "$1")"
    fi
    echo "$before $after"
}

# The value at a fraction of the sorted numbers of a column.
at_fraction() { awk -v c="$1" '{print $c}' "$3" | sort -g | awk -v f="$2" '{v[NR] = $1}
    END {p = 1 + f * (NR - 1); i = int(p); print v[i] + (p - i) * ((i < NR ? v[i + 1] : v[i]) - v[i])}'; }

echo "scene,seconds_before,seconds_after,ratio_median,ratio_lower_quartile,ratio_upper_quartile,ratio_of_least,pairs,same_optimum"
for scene in drd_cubic_12 drd_cubic_64 rr_cubic_24 drd_quintic_12; do
    file="$old/$scene.txt"
    # processor, wall, objective before; the same after; the ratio; 1 where the optimum is the same
    for ((i = 0; i < pairs; ++i)); do pair "$old/tree/scenes/$scene.toml" "$i"; done |
        awk '{d = $3 - $6; print $0, $4 / $1, ((d < 0 ? -d : d) <= 1e-7 * $3)}' > "$file"
    least="$(awk 'NR == 1 || $2 < a {a = $2} NR == 1 || $5 < b {b = $5} END {print b / a}' "$file")"
    same="$(awk '{s += $8} END {print (s == NR ? "yes" : "no")}' "$file")"
    quartiles="$(at_fraction 7 0.25 "$file"),$(at_fraction 7 0.75 "$file")"
    echo "$scene,$(at_fraction 1 0.5 "$file"),$(at_fraction 4 0.5 "$file"),$(at_fraction 7 0.5 "$file"),$quartiles,$least,$pairs,$same"
done
