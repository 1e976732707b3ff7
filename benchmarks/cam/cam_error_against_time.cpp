// SPDX-License-Identifier: MIT
// cam_error_against_time FOLDER [SECONDS]: solves every scene with a cam (cam_case.hpp) with every backend,
// writes cam_error_against_time.csv, its picture and cam_machine.txt into the folder.
//
// Standard output: a line for every run that ended above the best optimum by more than 1e-6, or found no
// motion. Progress goes to stderr. Takes some minutes: after SECONDS (600) no solve begins, and what is left
// is "skipped: out of time".
#include "benchmarks/cam/cam_error_against_time_csv.hpp"
#include "benchmarks/cam/cam_error_against_time_svg.hpp"
#include "benchmarks/parts/child_process.hpp"
#include "benchmarks/parts/machine.hpp"
#include "benchmarks/parts/solver_variants.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "core/text/parsing.hpp"
#include "core/text/text_file.hpp"
#include "report/folders/result_folder.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

namespace camopt::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* infeasible = "proved infeasible";
constexpr double agreement = 1e-6;      // relative, of objectives
constexpr double reference_gap = 1e-8;  // a reference proved less sharply is only the best known
constexpr double reference_tolerance = 1e-10, reference_seconds = 15.0;
constexpr TimingPlan plan{.most_seconds = 8.0, .series_seconds = 0.25, .least_repeats = 5, .slow = 0.3};

CamMeasurement row_of(const CamCase& one, const CamBackend& backend) {
    if (!is_available(backend.solver)) return not_measured(one, backend, "not in this build");
    if (is_too_large(backend, one)) return not_measured(one, backend, "skipped: too many segments");
    try {
        // COBYLA may run for ever between two evaluations: a child tries first.
        const auto attempt = [&] { return measure(one, backend, plan).verdict; };
        if (backend.solver == "nlopt.cobyla" && !text_of_child(attempt, 3.0 * plan.most_seconds))
            return not_measured(one, backend, "killed: it does not stop at its time limit");
        return measure(one, backend, plan);
    } catch (const std::exception& error) {
        return not_measured(one, backend, std::string("error: ") + error.what());
    }
}

/// What all rows of one scene are compared with: the proved optimum, else the best that anything found.
struct Reference {
    double objective = infinity;
    const char* source = "best known";
};

Certificate reference_certificate(const CamCase& one, const char* backend) {
    Scene scene = one.scene;
    scene.solver.name = backend;
    scene.solver.tolerance = reference_tolerance;
    scene.solver.max_seconds = reference_seconds;
    return solve_without_explaining(scene, {}).certificate;
}

Reference reference_of(const CamCase& one, std::span<const CamMeasurement> rows) {
    Reference best;
    for (const char* backend : {"structured", "ipopt"}) {
        if (!is_available(backend)) continue;
        const Certificate certificate = reference_certificate(one, backend);
        if (certificate.verdict == Verdict::infeasible) return {infinity, infeasible};
        if (certificate.verdict == Verdict::optimal && *certificate.gap <= reference_gap)
            return {certificate.objective, "proved"};
        best.objective = std::min(best.objective, certificate.objective);
    }
    for (const CamMeasurement& row : rows)
        best.objective = std::min(best.objective, row.objective.value_or(infinity));
    return best;
}

void compare(std::span<CamMeasurement> rows, const Reference& reference) {
    for (CamMeasurement& row : rows) {
        row.reference_source = reference.source;
        if (!std::isfinite(reference.objective)) continue;
        row.reference = reference.objective;
        if (row.objective) row.relative_error = (*row.objective - reference.objective) / reference.objective;
    }
}

void report_progress(const CamMeasurement& row) {
    std::fprintf(stderr, "%s n = %d, %s: %s %s\n", row.scene.c_str(), row.segments,
                 row.backend.name().c_str(), row.termination.c_str(), row.verdict.c_str());
}

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::vector<CamMeasurement> measured_rows(double most_seconds) {
    const Clock::time_point begin = Clock::now();
    std::vector<CamMeasurement> rows;
    for (const CamCase& one : cam_cases()) {
        const std::size_t first = rows.size();
        for (const CamBackend& backend : cam_backends()) {
            const bool late = seconds_since(begin) > most_seconds;
            rows.push_back(late ? not_measured(one, backend, "skipped: out of time") : row_of(one, backend));
            report_progress(rows.back());
        }
        if (seconds_since(begin) > most_seconds) continue;
        const std::span<CamMeasurement> own = std::span(rows).subspan(first);
        compare(own, reference_of(one, own));
    }
    return rows;
}

/// Agrees with the reference, or did not run at all.
bool is_as_it_should(const CamMeasurement& row) {
    if (row.verdict.empty()) return !row.termination.starts_with("error");
    if (row.reference_source == infeasible) return row.verdict == name_of(Verdict::infeasible);
    return row.relative_error && *row.relative_error <= agreement;
}

std::string distance(const CamMeasurement& row) {
    if (!row.reference) return "the scene is " + row.reference_source;
    if (!row.relative_error) return "no motion";
    return fmt::format("{:.2g} above the optimum {:.9g} ({})", *row.relative_error, *row.reference,
                       row.reference_source);
}

void print_disagreements(std::span<const CamMeasurement> rows) {
    int count = 0;
    for (const CamMeasurement& row : rows) {
        if (is_as_it_should(row)) continue;
        ++count;
        fmt::print("{} n = {}, {}: {}, {} ({}); {}, {} s\n", row.scene, row.segments, row.backend.name(),
                   row.termination, row.verdict, row.reason, distance(row),
                   row.seconds_median ? fmt::format("{:.3g}", *row.seconds_median) : "-");
    }
    fmt::print("{} of {} rows miss the optimum by more than {:g}\n", count, rows.size(), agreement);
}

void run(const std::filesystem::path& folder, double most_seconds) {
    prepare_folder(folder);
    const std::vector<CamMeasurement> rows = measured_rows(most_seconds);
    write_text_file(folder / "cam_error_against_time.csv", cam_measurements_csv(rows));
    write_text_file(folder / "cam_error_against_time.svg", cam_error_against_time_svg(rows, machine_line()));
    write_text_file(folder / "cam_machine.txt", machine_text());
    print_disagreements(rows);
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    const camopt::benchmarks::WholeOutput output;
    if (count != 2 && count != 3) {
        std::fputs("usage: cam_error_against_time FOLDER [SECONDS]\n", stderr);
        return 2;
    }
    try {
        camopt::benchmarks::run(words[1], count == 3 ? camopt::required_number(words[2]) : 600.0);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cam_error_against_time: %s\n", error.what());
        return 1;
    }
}
