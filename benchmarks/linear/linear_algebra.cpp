// SPDX-License-Identifier: MIT
// linear_algebra: the structured solver with every factorization it can use, in turns.
//
// The call on the final grid of DRD scenes over states, tolerance 1e-9; the ways are what the backend's
// option `factorization` allows. CSV on the standard output; the error is against the exchange at 1e-10.
// Ways slower than some seconds are timed once. Progress goes to stderr.
#include "benchmarks/parts/backend_runs.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "report/csv/csv_line.hpp"
#include "solvers/registry.hpp"

#include <cstdio>
#include <exception>
#include <set>

namespace camopt::benchmarks {

namespace {

constexpr int repeats = 5;
// With more the exchange of a quintic spline does not settle (docs/stability.md).
constexpr int most_quintic_segments = 64;
constexpr double slow_seconds = 1.5, most_seconds = 10.0;
constexpr const char* option_name = "factorization";

struct Size {
    int degree, segments;
};

/// One variant a factorization; only the default where the backend offers no choice.
std::vector<SolverVariant> factorizations() {
    std::vector<SolverVariant> variants;
    for (const SolverEntry& entry : solver_entries()) {
        if (entry.name != "structured") continue;
        for (const NativeOption& option : entry.options) {
            if (option.name != option_name) continue;
            for (const std::string& choice : option.choices)
                variants.push_back({"structured", choice, {{option_name, choice}}});
        }
    }
    if (variants.empty()) variants.push_back({"structured", "default", {}});
    return variants;
}

void print_line(const Size& size, const FinalGrid& grid, const SolverVariant& variant,
                const WayFigures& figures) {
    CsvLine line;
    line.words(variant.words).count(size.degree).count(size.segments).words(figures.last.status);
    line.number(figures.last.objective).number((figures.last.objective - grid.objective) / grid.objective);
    line.number(figures.median_seconds).number(figures.least_seconds).count(figures.repeats);
    line.count(figures.last.iterations);
    std::fputs(line.finish().c_str(), stdout);
    std::fflush(stdout);
}

void print_failure(const Size& size, const SolverVariant& variant, const std::string& message) {
    CsvLine line;
    line.words(variant.words).count(size.degree).count(size.segments).words(message).blank(6);
    std::fputs(line.finish().c_str(), stdout);
}

/// `slow`: ways that larger sizes of the same degree are to leave out; filled here.
void measure_size(const Size& size, const std::vector<SolverVariant>& variants, std::set<std::string>& slow) {
    const Scene scene = drd_scene(size.degree, size.segments);
    const FinalGrid grid = final_grid(scene, 1e-10);
    std::vector<TimedWay> ways;
    std::vector<SolverVariant> quick;
    for (const SolverVariant& variant : variants) {
        if (slow.contains(variant.words)) {
            print_failure(size, variant, "skipped: slow with fewer segments");
            continue;
        }
        const auto once = [&grid, variant] {
            return steadied([&] { return run_call(grid.problem, {variant, 1e-9, most_seconds}); });
        };
        try {
            const RunOutcome first = once();
            if (first.seconds > slow_seconds) {
                slow.insert(variant.words);
                print_line(size, grid, variant, {first, first.seconds, first.seconds, 1});
                continue;
            }
        } catch (const std::exception& error) {
            print_failure(size, variant, error.what());
            continue;
        }
        ways.push_back({variant.words, once});
        quick.push_back(variant);
    }
    const std::vector<WayFigures> figures = run_in_turns(ways, repeats);
    for (std::size_t k = 0; k < quick.size(); ++k) print_line(size, grid, quick[k], figures[k]);
    std::fprintf(stderr, "linear_algebra: degree %d, n = %d\n", size.degree, size.segments);
}

void print_table() {
    std::puts(
        "factorization,degree,n,status,objective,relative_error,seconds_median,seconds_min,repeats,"
        "iterations");
    const std::vector<SolverVariant> variants = factorizations();
    for (const int degree : {3, 5}) {
        std::set<std::string> slow;
        for (const int segments : {12, 24, 64, 256, 1024, 4096}) {
            if (degree == 5 && segments > most_quintic_segments) break;
            measure_size({degree, segments}, variants, slow);
        }
    }
}

}  // namespace

}  // namespace camopt::benchmarks

int main() {
    const camopt::benchmarks::WholeOutput output;
    try {
        camopt::benchmarks::print_table();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "linear_algebra: %s\n", error.what());
        return 1;
    }
}
