// SPDX-License-Identifier: MIT
// One row of the stability table: what must come out and from where that is known, what came out, the verdict
// on the verdict.
#pragma once

#include "solvers/certificate/certificate.hpp"
#include "tests/soak/scenes/scene_text.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace camopt {
struct Solution;
}

namespace camopt::stability {

using soak::SceneText;

/// What a row promises. The objective lies in [least, most], each known to `digits`; the delivered one may
/// lie beyond by `accuracy` (both relative).
struct Expectation {
    std::vector<Verdict> verdicts = {Verdict::optimal};
    std::optional<double> least, most;
    double digits = 0.0;
    double accuracy = 1e-9;
    /// Beside `accuracy` the gap asked for counts (solver.gap): what `optimal` says, no more.
    bool honest_gap = false;
    bool may_give_up =
        false;  ///< beyond double precision, or beyond what the backend promises: `unsolved` is no news
    double violation = 1e-9;  ///< of the delivered motion, found independently
    double rounding =
        0.0;  ///< beside its own, what the recomputed objective may differ by from the reported one
    std::string source;
};

[[nodiscard]] Expectation exactly(double objective, std::string source, double accuracy = 1e-9);
[[nodiscard]] Expectation at_most(double value, std::string source);

/// unsolved: a weaker verdict than expected, with its reason; everything it claims is true. wrong: a claim
/// that is not.
enum class Judgement { ok, unsolved, wrong, absent };
[[nodiscard]] const char* name_of(Judgement value);

struct StabilityRow {
    std::string group, name;
    std::string quantity = "objective";
    std::string backend;  ///< empty: nothing was solved
    Expectation expected;
    std::string verdict, reason;  ///< empty: a figure, not a verdict
    std::optional<double> found;  ///< recomputed from the delivered motion alone
    std::optional<double> gap, violation, jerk_jump, relative_error;
    std::optional<double> condition_acceleration, condition_jerk;
    double seconds = 0.0;
    Judgement judgement = Judgement::ok;
    std::string why;  ///< where it is wrong or absent
    // Of the solve of a scene.
    std::string scene = {};
    std::shared_ptr<const Solution> solution = {};
};

struct StabilityCase {
    std::string group, name;
    bool quick = true;  ///< a second or so: run by the tests too
    std::function<StabilityRow()> run;
};

/// Solves the scene and judges what comes out, whatever happens, by the checks of the random trials
/// (tests/soak/relations) and by what is expected: an exception is a wrong row.
[[nodiscard]] StabilityRow solved_row(const SceneText& scene, const Expectation& expected);

/// A figure that is no verdict.
[[nodiscard]] StabilityRow figure_row(std::string quantity, double found, const Expectation& expected);

/// Something the library must refuse with InputError.
[[nodiscard]] StabilityRow refused_row(const std::function<void()>& attempt, std::string source);

/// Sets judgement and why from the figures of the row.
void judge_objective(StabilityRow& row, double gap_asked);

[[nodiscard]] bool is_available(const std::string& backend);

}  // namespace camopt::stability
