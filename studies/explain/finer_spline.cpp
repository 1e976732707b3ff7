// SPDX-License-Identifier: MIT
#include "studies/explain/finer_spline.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

constexpr int least_factor = 8;      // three doublings are always tried, but for
constexpr int most_segments = 512;   // splines that take longer than the explanation may
constexpr int enough_segments = 64;  // few segments are doubled on up to here

bool is_feasible(const Scene& scene, int segments, const Budget& budget) {
    return least_violation(with_segments(scene, segments), budget) <= 0.0;
}

/// The fewest segments above `fails` that a search finds feasible, at most `works`.
int fewest(const Scene& scene, int fails, int works, const Budget& budget) {
    while (works - fails > 1 && !budget.spent()) {
        const int middle = (fails + works) / 2;
        (is_feasible(scene, middle, budget) ? works : fails) = middle;
    }
    return works;
}

bool is_told(const Scene& scene, int segments, const Budget& budget) {
    const bool uniform = scene.spline.breakpoints.empty();
    return is_solved(with_segments(scene, segments), budget) &&
           (!uniform || is_solved(with_segments(scene, segments + 1), budget));
}

}  // namespace

FinerSpline finer_spline(const Scene& scene, const Budget& budget) {
    FinerSpline result;
    const int given = segments_of(scene.spline);
    const bool uniform = scene.spline.breakpoints.empty();
    const int most = std::min(most_segments, std::max(least_factor * given, enough_segments));
    int fails = given;
    for (int n = 2 * given; n <= most && !budget.spent(); n *= 2) {
        budget.say(fmt::format("suggested changes: {} segments", n));
        const bool feasible = is_feasible(scene, n, budget);
        if (budget.spent()) break;
        if (feasible) {
            const int found = uniform ? fewest(scene, fails, n, budget) : n;
            for (const int told : {found, found + 1, found + 2, n}) {
                if (budget.spent()) return result;
                if (told > n || (!uniform && told != n) || !is_told(scene, told, budget)) continue;
                result.row =
                    Relaxation{uniform ? "spline.segments" : "spline.breakpoints", static_cast<double>(given),
                               static_cast<double>(told), static_cast<double>(told)};
                result.finest = 0;
                return result;
            }
            if (budget.spent()) break;  // what the clock ended was not tried in vain
        }
        fails = n;
        result.finest = n;
    }
    return result;
}

}  // namespace camopt
