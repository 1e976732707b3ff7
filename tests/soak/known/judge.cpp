// SPDX-License-Identifier: MIT
#include "tests/soak/known/judge.hpp"

#include "core/errors.hpp"
#include "input/loading/load_scene.hpp"
#include "input/machine/machine_reader.hpp"
#include "studies/machine/machine.hpp"
#include "studies/search/planned_solve.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/soak/known/scene_files.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <exception>

namespace camopt::soak {

namespace {

/// Relative: what a verdict optimal promises beyond the gap that it states.
constexpr double accuracy = 1e-8;
/// The scales of camopt's rows are not exactly those of known_scene.cpp.
constexpr double other_scales = 100.0;
/// Parts of a row's scale: motions that violate all rows by less may be taken for feasible (solver.tolerance
/// 1e-9).
constexpr double within_tolerance = other_scales * 1e-9;

Judged of_optimum(const KnownAnswer& answer, const Certificate& found) {
    Judged judged;
    if (found.verdict == Verdict::infeasible) {
        judged.judgement = std::isinf(answer.above) ? Judgement::right : Judgement::wrong;
        judged.why = fmt::format("infeasible; known optimum {:.17g}", answer.objective);
        return judged;
    }
    const double stated = found.gap.value_or(0.0) * std::max(1.0, std::abs(found.objective));
    const double near = std::max(accuracy * std::abs(answer.objective), stated) + answer.error;
    const double off = found.objective - answer.objective;
    // Where limits leave no room the result says by how much it passes them, and what it is compared with.
    const double passes = found.proof ? found.proof->limits_relaxed_by : 0.0;
    const double below = answer.below + passes * other_scales * answer.condition * std::abs(answer.objective);
    if (found.lower_bound && *found.lower_bound > answer.objective + answer.above + answer.error +
                                                      1e-12 * std::abs(answer.objective))
        judged.why = fmt::format("bound {:.17g} above the known optimum {:.17g}", *found.lower_bound,
                                 answer.objective);
    else if (has_feasible_motion(found.verdict) && off < -near - below)
        judged.why = fmt::format("objective {:.17g} below the known optimum {:.17g} by {:.2e}",
                                 found.objective, answer.objective, -off);
    else if (found.verdict == Verdict::optimal && off > near + answer.above)
        judged.why = fmt::format("objective {:.17g} above the known optimum {:.17g} by {:.2e}",
                                 found.objective, answer.objective, off);
    else
        judged.judgement = found.verdict == Verdict::optimal ? Judgement::right : Judgement::open;
    return judged;
}

Judged of_contradiction(const KnownAnswer& answer, const Certificate& found) {
    Judged judged;
    const bool moves = has_feasible_motion(found.verdict);
    if (answer.feasible)
        judged.judgement = moves                                  ? Judgement::right
                           : found.verdict == Verdict::infeasible ? Judgement::wrong
                                                                  : Judgement::open;
    else
        judged.judgement = found.verdict == Verdict::infeasible ? Judgement::right
                           : moves                              ? Judgement::wrong
                                                                : Judgement::open;
    if (!answer.feasible && moves && answer.margin < within_tolerance) judged.judgement = Judgement::right;
    if (judged.judgement != Judgement::right)
        judged.why = fmt::format("{}; known: {} by {:.2e} of the rows' sizes", name_of(found.verdict),
                                 answer.feasible ? "feasible" : "infeasible", answer.margin);
    return judged;
}

Certificate certificate_of(const KnownScene& scene) {
    if (scene.axes.empty())
        return solve_without_explaining(scene_of_toml(scene.text, {}, "known"), {}).certificate;
    const test::TemporaryFolder folder;  // machines are read from files
    const std::filesystem::path file = write_scene(scene, folder.path(), "machine", "");
    MachineOptions options;
    options.max_seconds = 20.0;  // as in the scenes of one motion
    options.explain = false;
    return solve_machine(input::read_machine(file, load_scene), options).certificate;
}

}  // namespace

const char* name_of(Judgement judgement) {
    static constexpr const char* names[] = {"right", "open", "wrong", "refused"};
    return names[static_cast<int>(judgement)];
}

Judged judged(const KnownScene& scene) {
    const auto begin = std::chrono::steady_clock::now();
    Judged found;
    try {
        const Certificate certificate = certificate_of(scene);
        const bool optimum = scene.answer.feasible && scene.answer.margin == 0.0;
        found = optimum ? of_optimum(scene.answer, certificate) : of_contradiction(scene.answer, certificate);
        found.verdict = name_of(certificate.verdict);
        if (found.judgement == Judgement::open)
            found.why += fmt::format(" ({}: {}, violation {:.2e})", found.verdict,
                                     name_of(certificate.reason), certificate.worst_violation);
    } catch (const InputError& error) {
        found.judgement = Judgement::refused;
        found.verdict = "refused";
        found.why = error.what();
    } catch (const std::exception& error) {
        found.judgement = Judgement::wrong;
        found.verdict = "exception";
        found.why = error.what();
    }
    found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return found;
}

}  // namespace camopt::soak
