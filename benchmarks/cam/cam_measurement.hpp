// SPDX-License-Identifier: MIT
// One scene with a cam, solved by one backend: what it reached, whether that is proved, and how long it took.
//
// Timed is the solve as a user gets it: exchange, starts where the scene is not convex, and the proof; not
// input and output. Counts are of one run, over all its rounds and starts.
#pragma once

#include "benchmarks/cam/cam_case.hpp"
#include "benchmarks/parts/measurement.hpp"
#include "core/nlp.hpp"

#include <optional>
#include <string>

namespace camopt::benchmarks {

struct CamMeasurement {
    std::string scene;
    int segments = 0;
    CamBackend backend;
    std::string termination;  ///< the backend's, "not in this build" or "skipped: …"
    std::string verdict;      ///< empty where nothing ran
    std::string reason;
    bool convex = true;
    std::optional<double> proved_gap, objective, worst_violation;
    std::optional<double> reference, relative_error;
    std::string reference_source;  ///< "proved", "best known" or "proved infeasible"
    std::optional<double> seconds_median, seconds_min;
    int repeats = 0, iterations = 0, rounds = 0, starts = 0;
    EvaluationCounts counts;
};

[[nodiscard]] CamMeasurement measure(const CamCase& one, const CamBackend& backend, const TimingPlan& plan);

/// A row that says why nothing was run.
[[nodiscard]] CamMeasurement not_measured(const CamCase& one, const CamBackend& backend,
                                          const std::string& termination);

}  // namespace camopt::benchmarks
