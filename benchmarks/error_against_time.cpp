// SPDX-License-Identifier: MIT
// error_against_time FOLDER [SECONDS]: measures every combination (combination.hpp) and writes
// error_against_time.csv and machine.txt into the folder. Progress goes to stderr.
//
// A series ends where a solve reaches the time limit (2 s, NLopt 0.6 s) or the next one would be likely to.
// Each backend has its share of SECONDS (600); what is left then is "skipped: out of time".
#include "benchmarks/error_against_time_csv.hpp"
#include "benchmarks/parts/child_process.hpp"
#include "benchmarks/parts/machine.hpp"
#include "benchmarks/parts/measurement.hpp"
#include "benchmarks/parts/solver_variants.hpp"
#include "core/text/parsing.hpp"
#include "core/text/text_file.hpp"
#include "report/folders/result_folder.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <set>

namespace camopt::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double reference_gap = 1e-8;  // a reference proved less sharply is none
constexpr double reference_seconds = 30.0;
constexpr int most_dense_segments = 64;  // references of more come from `states` alone

/// How long one solve of a backend may take; then its series ends.
TimingPlan plan_of(const Combination& combination) {
    TimingPlan plan;
    plan.slow = 0.1;
    if (combination.backend == "structured") plan.most_seconds = 6.0;
    if (combination.backend.starts_with("nlopt.")) plan.most_seconds = 0.6;
    return plan;
}

struct Reference {
    double objective;
    std::string source;
};

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
            if (design != DesignKind::states && combination.segments > most_dense_segments) break;
            combination.design = design;
            Scene scene = scene_of(combination, reference_seconds);
            scene.solver.tolerance = 1e-10;
            const Certificate certificate = solve(scene).certificate;
            if (certificate.verdict == Verdict::optimal && *certificate.gap <= reference_gap)
                return Reference{certificate.objective,
                                 fmt::format("structured {}, proved to {:.1g}", name_of(design),
                                             std::max(*certificate.gap, 0.0))};
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

/// The structured solver's share pays for the references too.
double share_of(const std::string& backend) {
    if (backend == "structured") return 0.4;
    return backend == "ipopt" ? 0.2 : 0.1;
}

/// Runs combination after combination as long as its backend has time.
class Study {
 public:
    explicit Study(double seconds) : seconds_(seconds) {}

    /// The whole table as CSV.
    std::string table() {
        std::string text = measurements_csv({});
        for (const Combination& combination : combinations()) {
            const std::string line = line_of(combination);
            text += line;
            std::fprintf(stderr, "%s n = %d: %s", combination.series().c_str(), combination.segments,
                         line.c_str());
        }
        return text;
    }

 private:
    static std::string line_of(const Measurement& row) {
        return measurements_csv({&row, 1}).substr(measurements_csv({}).size());
    }

    std::string line_of(const Combination& combination) {
        const auto left_out = [&](const char* why) { return line_of(not_measured(combination, why)); };
        if (!is_available(combination.backend)) return left_out("not in this build");
        if (timed_out_.contains(combination.series()))
            return left_out("skipped: fewer segments reached the time limit");
        if (is_out_of_time(combination.backend)) return left_out("skipped: out of time");
        return measured_line(combination);
    }

    /// Measured in a child: it may never come back. A '*' before the line: it reached its time limit.
    std::string measured_line(const Combination& combination) {
        const std::optional<Reference>& reference = references_.of(combination);
        const TimingPlan plan = plan_of(combination);
        const auto work = [&] {
            try {
                Measurement row = measure(combination, plan);
                compare(row, reference);
                return (row.timed_out() ? "*" : "") + line_of(row);
            } catch (const std::exception& error) {
                return line_of(not_measured(combination, std::string("error: ") + error.what()));
            }
        };
        // The solve, its proof, and the timed runs.
        const std::optional<std::string> line = text_of_child(work, 4.0 * plan.most_seconds + 4.0);
        if (!line || line->starts_with('*')) timed_out_.insert(combination.series());
        if (!line) return line_of(not_measured(combination, "killed: it does not stop at its time limit"));
        return line->starts_with('*') ? line->substr(1) : *line;
    }

    bool is_out_of_time(const std::string& backend) {
        const Clock::time_point now = Clock::now();
        const Clock::time_point begin = begins_.try_emplace(backend, now).first->second;
        return std::chrono::duration<double>(now - begin).count() > share_of(backend) * seconds_;
    }

    double seconds_;
    std::map<std::string, Clock::time_point> begins_;  ///< of each backend's first row
    References references_;
    std::set<std::string> timed_out_;
};

void run(const std::filesystem::path& folder, double seconds) {
    prepare_folder(folder);
    write_text_file(folder / "error_against_time.csv", Study(seconds).table());
    write_text_file(folder / "machine.txt", machine_text());
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    if (count != 2 && count != 3) {
        std::fputs("usage: error_against_time FOLDER [SECONDS]\n", stderr);
        return 2;
    }
    try {
        camopt::benchmarks::run(words[1], count == 3 ? camopt::required_number(words[2]) : 600.0);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error_against_time: %s\n", error.what());
        return 1;
    }
}
