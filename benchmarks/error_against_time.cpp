// SPDX-License-Identifier: MIT
// error_against_time FOLDER: measures every combination (combination.hpp) and writes error_against_time.csv,
// its picture and machine.txt into the folder. Takes some minutes; progress goes to stderr.
#include "benchmarks/error_against_time_csv.hpp"
#include "benchmarks/error_against_time_svg.hpp"
#include "benchmarks/machine.hpp"
#include "benchmarks/measurement.hpp"
#include "output/result_folder.hpp"
#include "output/text_file.hpp"
#include "solvers/registry.hpp"
#include "studies/solve.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <set>

namespace camopt::benchmarks {

namespace {

constexpr double reference_gap = 1e-9;  // a reference proved less sharply is none

struct Reference {
    double objective;
    std::string source;
};

bool is_available(const std::string& backend) {
    return std::ranges::any_of(solver_entries(),
                               [&](const auto& entry) { return entry.name == backend && entry.available; });
}

/// The proved optimum of each spline space and motion, independent of the row that is measured.
class References {
 public:
    const std::optional<Reference>& of(const Combination& combination) {
        const auto [place, fresh] = known_.try_emplace(combination.optimum());
        if (fresh) place->second = find(combination);
        return place->second;
    }

 private:
    static std::optional<Reference> find(Combination combination) {
        if (const auto exact = exact_optimum(combination)) return Reference{*exact, "fraction"};
        combination.backend = "structured";
        for (const DesignKind design :
             {DesignKind::states, DesignKind::coefficients, DesignKind::ordinates}) {
            combination.design = design;
            Scene scene = scene_of(combination, 60.0);
            scene.solver.tolerance = 1e-10;
            const Certificate certificate = solve(scene).certificate;
            if (certificate.verdict == Verdict::optimal && *certificate.gap <= reference_gap)
                return Reference{certificate.objective,
                                 std::string("structured ") + name_of(design) + " proved"};
        }
        return {};
    }

    std::map<std::string, std::optional<Reference>> known_;
};

void compare(Measurement& row, const std::optional<Reference>& reference) {
    if (!reference) return;
    row.reference = reference->objective;
    row.reference_source = reference->source;
    if (row.objective) row.relative_error = (*row.objective - reference->objective) / reference->objective;
}

Measurement row_of(const Combination& combination, std::set<std::string>& timed_out) {
    if (!is_available(combination.backend)) return not_measured(combination, "not in this build");
    if (timed_out.contains(combination.series()))
        return not_measured(combination, "skipped: fewer segments reached the time limit");
    try {
        Measurement row = measure(combination, {});
        if (row.timed_out()) timed_out.insert(combination.series());
        return row;
    } catch (const std::exception& error) {
        return not_measured(combination, std::string("error: ") + error.what());
    }
}

std::vector<Measurement> measured_rows() {
    References references;
    std::set<std::string> timed_out;
    std::vector<Measurement> rows;
    for (const Combination& combination : combinations()) {
        rows.push_back(row_of(combination, timed_out));
        compare(rows.back(), references.of(combination));
        std::fprintf(stderr, "%s n = %d: %s %s\n", combination.series().c_str(), combination.segments,
                     rows.back().status.c_str(), rows.back().verdict.c_str());
    }
    return rows;
}

void run(const std::filesystem::path& folder) {
    prepare_folder(folder);
    const std::vector<Measurement> rows = measured_rows();
    write_text_file(folder / "error_against_time.csv", measurements_csv(rows));
    write_text_file(folder / "error_against_time.svg", error_against_time_svg(rows, machine_line()));
    write_text_file(folder / "machine.txt", machine_text());
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    if (count != 2) {
        std::fputs("usage: error_against_time FOLDER\n", stderr);
        return 2;
    }
    try {
        camopt::benchmarks::run(words[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error_against_time: %s\n", error.what());
        return 1;
    }
}
