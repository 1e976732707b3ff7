// SPDX-License-Identifier: MIT
// One combination measured: what it reached, whether that is proved, and how long the backend took.
//
// Timed is the exchange with the backend in it (minimize_by_exchange on a fresh problem); scene, matrices,
// proof and output are not. Counts, iterations and rounds are of one run, never summed over repeats.
#pragma once

#include "benchmarks/parts/combination.hpp"
#include "core/nlp.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt::benchmarks {

struct TimingPlan {
    double most_seconds = 2.0;     ///< of one solve; then its status is time_limit
    double series_seconds = 0.25;  ///< repeats of one combination together, after the least number
    int least_repeats = 5;         ///< of a solve quicker than `slow`
    int most_repeats = 15;
    double slow = 0.25;  ///< s; a slower solve is timed once
};

struct Measurement {
    Combination combination;
    std::string status;   ///< the backend's termination, "not in this build" or "skipped: …"
    std::string verdict;  ///< empty where nothing ran
    std::string reason;
    std::optional<double> proved_gap, objective;
    std::optional<double> reference, relative_error;
    std::string reference_source;  ///< "fraction" or "structured, states, proved"
    std::optional<double> seconds_median, seconds_min;
    int repeats = 0, iterations = 0, rounds = 0;
    EvaluationCounts counts;

    [[nodiscard]] bool timed_out() const { return status == "time_limit"; }
};

[[nodiscard]] Measurement measure(const Combination& combination, const TimingPlan& plan);

/// A row that says why nothing was run.
[[nodiscard]] Measurement not_measured(const Combination& combination, const std::string& status);

[[nodiscard]] double median(std::vector<double> values);

}  // namespace camopt::benchmarks
