// SPDX-License-Identifier: MIT
// error_against_time FOLDER [SECONDS]: measures every combination (combination.hpp) and writes
// error_against_time.csv and machine.txt into the folder. Progress goes to stderr.
//
// A series ends where a solve reaches the time limit (2 s, NLopt 0.6 s) or the next one would be likely to.
// Each backend has its share of SECONDS (600); what is left then is "skipped: out of time".
#include "benchmarks/error_against_time_csv.hpp"
#include "benchmarks/machine.hpp"
#include "benchmarks/measurement.hpp"
#include "benchmarks/solver_variants.hpp"
#include "output/result_folder.hpp"
#include "output/text_file.hpp"
#include "studies/solve.hpp"

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

    std::vector<Measurement> rows() {
        std::vector<Measurement> rows;
        for (const Combination& combination : combinations()) {
            rows.push_back(row_of(combination));
            if (rows.back().objective) compare(rows.back(), references_.of(combination));
            std::fprintf(stderr, "%s n = %d: %s %s\n", combination.series().c_str(), combination.segments,
                         rows.back().status.c_str(), rows.back().verdict.c_str());
        }
        return rows;
    }

 private:
    Measurement row_of(const Combination& combination) {
        if (!is_available(combination.backend)) return not_measured(combination, "not in this build");
        if (timed_out_.contains(combination.series()))
            return not_measured(combination, "skipped: fewer segments reached the time limit");
        if (is_out_of_time(combination.backend)) return not_measured(combination, "skipped: out of time");
        try {
            Measurement row = measure(combination, plan_of(combination));
            if (row.timed_out()) timed_out_.insert(combination.series());
            return row;
        } catch (const std::exception& error) {
            return not_measured(combination, std::string("error: ") + error.what());
        }
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
    const std::vector<Measurement> rows = Study(seconds).rows();
    write_text_file(folder / "error_against_time.csv", measurements_csv(rows));
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
        camopt::benchmarks::run(words[1], count == 3 ? std::atof(words[2]) : 600.0);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error_against_time: %s\n", error.what());
        return 1;
    }
}
