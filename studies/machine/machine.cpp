// SPDX-License-Identifier: MIT
#include "studies/machine/machine.hpp"

#include "scene/part_names.hpp"
#include "scene/written_limits.hpp"
#include "solvers/registry.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/least/feasible_edge.hpp"
#include "studies/least/monotone.hpp"
#include "studies/machine/machine_build.hpp"
#include "studies/search/convex_solve.hpp"
#include "studies/search/presolve.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Of trials: the sign of the least common violation is proved, its value only steers the search.
constexpr double trial_tolerance = 1e-6;
constexpr int few_trials = 4;
constexpr double other_part = 0.02;  // of the whole time: another backend, for a speed that is not decided
constexpr double usual_slope = 2.0;  // of the steepness by log ω: of a limit on acceleration

/// The outcome at one speed.
struct Trial {
    double speed = 0.0;
    double violation = infinity;  ///< least common one
    std::optional<DualityProof> proof;
    Eigen::VectorXd x;
    bool exists = false;  ///< motions do, to the tolerance
    [[nodiscard]] bool feasible() const { return exists; }
    [[nodiscard]] bool settled() const { return exists || proof; }
    /// Nearly linear in log ω.
    [[nodiscard]] double steepness() const { return std::log1p(violation); }
};

class MachineSearch {
 public:
    MachineSearch(const MachineSpec& machine, const MachineOptions& options, const SolveControl& control)
        : options_(options), control_(control.sooner(options.max_seconds)) {
        result_.spec = machine;
        memory_.held.assign(machine.axes.size(), false);
        memory_.clearances.resize(machine.clearances.size());
    }

    MachineSolution run() {
        const Stopwatch watch;
        // Timing is not searched yet: that would move these angles around the convex program below.
        if (std::ranges::any_of(machine().axes,
                                [](const AxisSpec& axis) { return searches_angles(axis.scene); }))
            result_.notes.emplace_back(
                "segments whose angle is a range are solved with the angles given: timing is not searched");
        if (!contradicts_itself()) {
            if (machine().searches_speed())
                search_speed();
            else
                deliver_at(machine().least_speed);
        }
        result_.seconds_total = watch.seconds();
        return std::move(result_);
    }

    /// FixedMachine::passing: from the least speed upwards, by steps that double.
    std::optional<double> passing() {
        std::optional<double> passed;
        if (contradicts_itself()) return passed;
        decides_only_ = true;
        double step = options_.speed_gap;
        for (double speed = machine().least_speed; trial(speed).feasible() && !control_.ending();
             speed *= 1.0 + step, step *= 2.0) {
            passed = speed;
            if (speed >= machine().most_speed / (1.0 + step)) break;
        }
        return passed;
    }

 private:
    [[nodiscard]] const MachineSpec& machine() const { return result_.spec; }
    [[nodiscard]] static double rpm(double speed) { return speed / units::revolution_per_minute; }

    /// Conditions of one axis that no curve of its spline meets: nothing is searched.
    bool contradicts_itself() {
        const PosedMachine posed =
            posed_machine(machine(), scenes_at(machine(), machine().least_speed), memory_);
        for (int b = 0; b < posed.problem->axes(); ++b) {
            const MotionFamily& design = posed.problem->axis(b).model().design;
            if (design.contradictions().empty()) continue;
            Solution axis;
            axis.scene = machine().axes[static_cast<std::size_t>(b)].scene;
            report_contradictions(axis, design);
            result_.certificate = std::move(axis.certificate);
            result_.speed = machine().least_speed;
            result_.at_standstill = !has_points_in_time(axis.scene.motion);
            for (const std::string& note : axis.notes)
                result_.notes.push_back(machine().axes[static_cast<std::size_t>(b)].name + ": " + note);
            return true;
        }
        return false;
    }

    Trial trial(double speed) { return trial_of(speed, scenes_at(machine(), speed)); }

    Trial trial_of(double speed, const std::vector<Scene>& scenes) {
        PosedMachine posed = posed_machine(machine(), scenes, memory_);
        Trial trial;
        trial.speed = speed;
        ExchangeOptions exchange = machine_exchange(machine(), options_.max_seconds);
        const double tight = exchange.tolerance;
        exchange.tolerance = exchange.backend.tolerance = std::max(tight, trial_tolerance);
        exchange.decides_only = decides_only_;
        constexpr int attempts = 3;  // the second to a tighter tolerance, the third by another backend
        for (int attempt = 0; attempt < attempts; ++attempt) {
            const std::string name = attempt == attempts - 1 ? solver_after_structured() : "structured";
            if (name.empty()) break;
            const std::unique_ptr<Solver> other = name == "structured" ? nullptr : make_solver(name);
            if (other) exchange.backend.max_seconds = other_part * options_.max_seconds;
            Feasibility found = find_feasible(*posed.problem, exchange, control_, other.get());
            if (found.point.x.size() > 0 && found.point.violation < trial.violation) {
                trial.violation = found.point.violation;
                trial.exists = trial.violation <= tight;
                trial.x = std::move(found.point.x);
            }
            if (!trial.exists) trial.proof = std::move(found.proof);
            if (trial.settled() || control_.ending()) break;
            exchange.tolerance = exchange.backend.tolerance = tight;
        }
        ++result_.trials;
        memory_.keep(*posed.problem);
        if (trial.x.size() > 0) memory_.x = trial.x;
        if (control_.progress)
            control_.progress(fmt::format("{:.6g} rpm: violation {:.3g}, {}", rpm(speed), trial.violation,
                                          trial.feasible() ? "motions exist"
                                          : trial.proof    ? "proved impossible"
                                                           : "not decided"));
        return trial;
    }

    /// Rounded to digits that the gap does not need: a speed that people can read.
    [[nodiscard]] double rounded(double speed) const {
        const double digits = std::ceil(-std::log10(options_.speed_gap)) + 2.0;
        const double whole = std::pow(10.0, digits - std::ceil(std::log10(rpm(speed))));
        return std::round(rpm(speed) * whole) / whole * units::revolution_per_minute;
    }

    void take_proof(const Trial& impossible) {
        result_.impossible_above = impossible.speed;
        result_.impossible = impossible.proof;
        const PosedMachine posed = posed_machine(machine(), scenes_at(machine(), impossible.speed), memory_);
        result_.limited_by = limits_of_proof(machine(), *posed.problem, *impossible.proof);
    }

    /// No motions at the least speed: a contradiction of limits, or, at any speed, of the clearances.
    void report_infeasible(const Trial& least) {
        result_.speed = least.speed;
        const MachineMemory known = memory_;
        memory_.axes.clear();
        memory_.x = {};
        Trial slow = trial_of(0.0, scenes_at_standstill(machine()));
        // Motions that leave their strokes do not count: these are held, and tried again.
        if (slow.feasible() &&
            hold_strokes(posed_machine(machine(), scenes_at_standstill(machine()), memory_), slow.x, memory_))
            slow = trial_of(0.0, scenes_at_standstill(machine()));
        result_.at_standstill =
            !slow.feasible() && slow.proof && std::ranges::all_of(machine().axes, [](const AxisSpec& axis) {
                return standstill_is_any_speed(axis.scene);
            });
        const Trial& told = result_.at_standstill ? slow : least;
        Certificate& certificate = result_.certificate;
        certificate.verdict = Verdict::infeasible;
        certificate.reason = Reason::limits_contradict;
        certificate.worst_violation = told.violation;
        certificate.proof = told.proof;
        certificate.proof_kind = ProofKind::duality;
        PosedMachine posed = posed_machine(
            machine(),
            result_.at_standstill ? scenes_at_standstill(machine()) : scenes_at(machine(), least.speed),
            result_.at_standstill ? memory_ : known);
        result_.limited_by = limits_of_proof(machine(), *posed.problem, *told.proof);
    }

    void report_undecided(const Trial& trial) {
        result_.speed = trial.speed;
        result_.certificate.verdict = Verdict::failed;
        const std::optional<Termination> ending = control_.ending();
        result_.certificate.reason = ending ? reason_of(*ending) : Reason::no_feasible_point;
        result_.notes.push_back(fmt::format(
            "at {:.6g} rpm neither motions nor a proof of impossibility were found", rpm(trial.speed)));
    }

    /// A feasible and an infeasible speed to begin with; the latter is missing where the end of the range is
    /// reached. Nullopt: the machine is settled.
    struct Bracket {
        Trial low;
        std::optional<Trial> high;
    };

    std::optional<Bracket> first_bracket() {
        Trial most = trial(machine().most_speed);
        if (most.feasible() && !result_.scanned) return Bracket{std::move(most), {}};
        if (result_.scanned) return scanned_bracket(std::move(most));
        std::optional<Trial> least = slowest();
        if (!least) return {};
        return Bracket{std::move(*least), std::move(most)};
    }

    /// Motions at the least speed or, where that is not decided, at one a little above it: then they exist at
    /// every lower one. Nullopt: there are none, which is reported.
    std::optional<Trial> slowest() {
        Trial least = trial(machine().least_speed);
        double speed = machine().least_speed;
        for (int k = 0; k < few_trials && !least.settled() && !control_.ending(); ++k) {
            speed = std::pow(speed, 0.75) * std::pow(machine().most_speed, 0.25);
            if (Trial next = trial(speed); next.feasible()) least = std::move(next);
        }
        if (least.feasible()) return least;
        least.proof ? report_infeasible(least) : report_undecided(least);
        return {};
    }

    /// The largest feasible one of speeds over the whole range, and the next above it.
    std::optional<Bracket> scanned_bracket(Trial above) {
        if (above.feasible()) return Bracket{std::move(above), {}};
        const double ratio = machine().most_speed / machine().least_speed;
        for (int k = options_.scanned_speeds - 2; k >= 0 && !control_.ending(); --k) {
            Trial next = trial(machine().least_speed *
                               std::pow(ratio, static_cast<double>(k) / (options_.scanned_speeds - 1)));
            if (next.feasible()) return Bracket{std::move(next), std::move(above)};
            above = std::move(next);
        }
        report_undecided(above);
        result_.notes.push_back(
            fmt::format("{} speeds over the range were tried: at none of them motions exist, but limits of "
                        "this machine may hold at speeds between",
                        options_.scanned_speeds));
        return {};
    }

    /// Narrows the bracket to half the gap by the steepness over log ω. A speed that is not decided counts as
    /// impossible; where the bracket ends at one, speeds above it are tried until one is proved impossible.
    void narrow(Bracket& bracket) {
        const double gap = std::log1p(options_.speed_gap);
        const auto steepness_at = [&](double log_speed) {
            Trial next = trial(std::exp(log_speed));
            const double found = next.feasible() ? 0.0 : next.steepness();
            if (next.feasible())
                bracket.low = std::move(next);
            else if (next.proof || (!bracket.high->proof && next.speed < bracket.high->speed))
                bracket.high = std::move(next);
            return found;
        };
        const ValueSearch search{steepness_at, [&] { return control_.ending().has_value(); },
                                 [&](double log_speed) { return std::log(rounded(std::exp(log_speed))); },
                                 usual_slope};
        const double most = std::log(bracket.high->speed);
        const ValueBracket found = closed_in(
            search, {{std::log(bracket.low.speed), 0.0}, {most, bracket.high->steepness()}}, 0.5 * gap);
        double above = found.outside.value;
        const auto known = [&] { return bracket.high->proof ? std::log(bracket.high->speed) : most; };
        for (double step = gap; above + step < known() && !control_.ending(); step *= 2.0)
            (void)steepness_at(above += step);
    }

    /// The speeds of which neither motions nor their impossibility are known.
    void note_undecided(const Bracket& bracket) {
        const double known = bracket.high->proof ? bracket.high->speed : machine().most_speed;
        if (bracket.high->proof && known <= bracket.low.speed * (1.0 + options_.speed_gap) * (1.0 + 1e-9))
            return;
        result_.notes.push_back(fmt::format(
            "between {:.6g} and {:.6g} rpm neither motions nor a proof of impossibility were found{}",
            rpm(bracket.low.speed), rpm(known),
            control_.ending() ? fmt::format(": {}", name_of(reason_of(*control_.ending()))) : ""));
    }

    void search_speed() {
        result_.scanned = std::ranges::any_of(
            machine().axes, [](const AxisSpec& axis) { return !only_tightens_with_speed(axis.scene); });
        std::optional<Bracket> bracket = first_bracket();
        while (bracket) {
            if (bracket->high) narrow(*bracket);
            memory_.x = bracket->low.x;
            const bool complete = deliver_at(bracket->low.speed);
            if (complete) break;
            // Axes are held within their strokes from now on: motions may need a lower speed.
            Trial again = trial(bracket->low.speed);
            if (again.feasible()) {
                bracket->low = std::move(again);
                continue;
            }
            bracket->high = std::move(again);
            std::optional<Trial> least = slowest();
            if (!least) return;
            bracket->low = std::move(*least);
        }
        if (!bracket) return;
        result_.reached_most = !bracket->high;
        if (bracket->high) {
            if (bracket->high->proof) take_proof(*bracket->high);
            if (!result_.scanned) note_undecided(*bracket);
            if (options_.explain && !control_.ending())
                ask_what_is_needed(machine(),
                                   scenes_at(machine(), result_.speed * (1.0 + options_.more_speed)), memory_,
                                   result_.limited_by, asking(), control_);
        }
        judge_speed();
    }

    [[nodiscard]] ExchangeOptions asking() const {
        ExchangeOptions exchange = machine_exchange(machine(), options_.max_seconds);
        exchange.tolerance = exchange.backend.tolerance = std::max(exchange.tolerance, trial_tolerance);
        return exchange;
    }

    /// The verdict speaks of the speed: optimal where it is proved to within the gap.
    void judge_speed() {
        Certificate& certificate = result_.certificate;
        if (result_.axes.empty()) return;
        const bool proved =
            result_.reached_most ||
            (result_.impossible && !result_.scanned &&
             *result_.impossible_above <= result_.speed * (1.0 + options_.speed_gap) * (1.0 + 1e-12));
        if (certificate.verdict == Verdict::failed) return;
        if (proved && certificate.verdict != Verdict::optimal)
            result_.notes.push_back(fmt::format(
                "the speed is proved; the total objective at it is {}{}", name_of(certificate.verdict),
                certificate.gap ? fmt::format(", proved to within {:.1e}", *certificate.gap) : ""));
        certificate.verdict = proved ? Verdict::optimal : Verdict::feasible;
        if (proved) certificate.reason = Reason::none;
        if (result_.scanned)
            result_.notes.push_back(fmt::format(
                "limits of this machine do not only tighten with speed: {} speeds over the range were tried; "
                "between these, and above the speed reached, nothing is claimed",
                options_.scanned_speeds));
    }

    /// The least total objective at a speed, from memory_.x. False: axes left their strokes, and are held
    /// from now on. What is left without a proof at a given speed is tried again as a single motion would be,
    /// with its design vector: more variables, but numbers of one size.
    bool deliver_at(double speed) {
        const MachineSolution before = result_;
        if (!deliver(speed, false)) return false;
        if (machine().searches_speed() || is_proved(result_.certificate) || control_.ending()) return true;
        MachineSolution first = std::exchange(result_, before);
        MachineMemory memory = memory_;
        memory_.design = DesignKind::states;
        memory_.x = {};
        memory_.axes.clear();
        deliver(speed, true);
        // Motions that keep every limit but fail their audit are no impossibility.
        const double tolerance = machine_exchange(machine(), options_.max_seconds).tolerance;
        const bool contradicts = result_.certificate.verdict == Verdict::infeasible &&
                                 first.certificate.worst_violation <= tolerance;
        if (!contradicts && is_better(result_.certificate, first.certificate, wanted_gap())) return true;
        result_ = std::move(first);
        memory_ = std::move(memory);
        return true;
    }

    bool deliver(double speed, bool persistent) {
        ExchangeOptions exchange = machine_exchange(machine(), options_.max_seconds);
        std::vector<Scene> scenes = scenes_at(machine(), speed);
        const std::vector<std::string> notes = result_.notes;
        std::optional<Certificate> any;  // of motions whose cams cannot be built too
        for (;;) {
            PosedMachine posed = posed_machine(machine(), scenes, memory_);
            JudgeOptions judge{exchange.tolerance, wanted_gap()};
            ContinuousResult found = least_total(*posed.problem, exchange, judge, control_, persistent);
            memory_.keep(*posed.problem);
            result_.speed = speed;
            result_.certificate = std::move(found.certificate);
            if (found.x.size() == 0) {
                if (any)
                    report_no_buildable_motions();
                else
                    report_no_motions(speed);
                return true;
            }
            if (hold_strokes(posed, found.x, memory_)) {
                memory_.x = {};
                if (machine().searches_speed()) return false;
                continue;
            }
            if (any) settle_by_relaxation(result_.certificate, *any, wanted_gap());
            Certificate unaudited = result_.certificate;
            take_motions(posed, found.x);
            const bool unbuilt = result_.certificate.reason == Reason::cam_cannot_be_built;
            const bool tried_again = unbuilt && !machine().searches_speed() && unaudited.lower_bound &&
                                     !control_.ending() && hold_reach(scenes);
            if (tried_again) {
                if (!any) any = std::move(unaudited);
                continue;
            }
            if (any && result_.certificate.verdict != Verdict::failed) {
                result_.notes = notes;  // the others are of the motions before
                result_.notes.emplace_back(
                    "the first optimum leaves the range of a cam; these are the best motions whose cams can "
                    "be built");
            }
            return true;
        }
    }

    /// Within the reach of the cams there are none, or none were found; of the scenes as given nothing is
    /// proved.
    void report_no_buildable_motions() {
        result_.certificate = {};
        result_.certificate.verdict = Verdict::failed;
        result_.certificate.reason = Reason::cam_cannot_be_built;
    }

    void report_no_motions(double speed) {
        const Certificate& certificate = result_.certificate;
        if (machine().searches_speed() || certificate.verdict != Verdict::infeasible) return;
        Trial least;
        least.speed = speed;
        least.violation = certificate.worst_violation;
        least.proof = certificate.proof;
        report_infeasible(least);
    }

    /// Axes whose cams cannot be built stay within their reach from now on. False: all do already.
    bool hold_reach(std::vector<Scene>& scenes) {
        bool fresh = false;
        for (std::size_t b = 0; b < scenes.size(); ++b) {
            if (!reach_[b] || scenes[b].motion.reach) continue;
            scenes[b].motion.reach = reach_[b];
            fresh = true;
            if (b < memory_.axes.size()) memory_.axes[b].clear();  // its rules are others now
        }
        if (fresh) memory_.x = {};
        return fresh;
    }

    [[nodiscard]] double wanted_gap() const {
        double gap = machine().axes.front().scene.solver.wanted_gap();
        for (const AxisSpec& axis : machine().axes) gap = std::min(gap, axis.scene.solver.wanted_gap());
        return gap;
    }

    void take_motions(PosedMachine& posed, const Eigen::VectorXd& x) {
        result_.axes.clear();
        result_.clearances.clear();
        reach_.assign(machine().axes.size(), std::nullopt);
        Reason failed = Reason::none;
        for (int b = 0; b < posed.problem->axes(); ++b) {
            const auto at = static_cast<std::size_t>(b);
            const Solution& axis = result_.axes.emplace_back(delivered_axis(posed, b, x));
            if (axis.certificate.verdict != Verdict::failed) continue;
            failed = axis.certificate.reason;
            if (failed == Reason::cam_cannot_be_built) reach_[at] = buildable_reach(axis);
            result_.notes.push_back(fmt::format("{}: {}", machine().axes[at].name, axis.notes.back()));
        }
        if (failed != Reason::none) {  // no motion of a machine without the others
            result_.certificate.verdict = Verdict::failed;
            result_.certificate.reason = failed;
            result_.axes.clear();
            return;
        }
        for (Solution& axis : result_.axes) axis.scene.motion.reach.reset();
        for (int k = 0; k < static_cast<int>(machine().clearances.size()); ++k) {
            Extremum worst = posed.problem->worst_of_clearance(k, x);
            worst.value *= -posed.problem->clearance_scale(k);
            result_.clearances.push_back(worst);
        }
        for (std::size_t b = 0; b < result_.axes.size(); ++b)
            result_.axes[b].machine = words_of_axis(static_cast<int>(b), *posed.problem);
    }

    /// Solution::machine.
    [[nodiscard]] std::string words_of_axis(int axis, const MachineProblem& problem) const {
        constexpr double active = 1e-6;  // of the clearance's scale
        std::string text = fmt::format("it begins at {:.6g} deg of the master",
                                       machine().axes[static_cast<std::size_t>(axis)].phase / units::degree);
        for (std::size_t k = 0; k < result_.clearances.size(); ++k) {
            const Clearance& given = machine().clearances[k];
            const auto own = std::ranges::find(given.axes, axis) - given.axes.begin();
            if (own == std::ssize(given.axes) || given.factors[static_cast<std::size_t>(own)] == 0.0)
                continue;
            if (result_.clearances[k].value > active * problem.clearance_scale(static_cast<int>(k))) continue;
            text += fmt::format("; {} shapes it, active at {:.6g} deg of the master",
                                given.key.empty() ? name_of_clearance(static_cast<int>(k)) : given.key,
                                result_.clearances[k].at / units::degree);
        }
        return text;
    }

    const MachineOptions& options_;
    SolveControl control_;
    MachineMemory memory_;
    MachineSolution result_;
    /// Of axes whose cam cannot be built: what it could (buildable_reach).
    std::vector<std::optional<std::array<double, 2>>> reach_;
    bool decides_only_ = false;  ///< least violations are not asked for
};

}  // namespace

SweepRow machine_row(int number, std::span<const double> settings, const MachineSolution& solution) {
    SweepRow row = certified_row(number, settings, solution.certificate);
    if (row.is_feasible()) {
        row.objective = solution.certificate.objective;
        row.machine.speed = solution.speed;
    }
    row.machine.impossible_above = solution.impossible_above;
    for (const MachineLimit& limit : solution.limited_by) {
        const bool own = limit.axis >= 0;
        row.active_limits.push_back(own ? solution.spec.axes[static_cast<std::size_t>(limit.axis)].name +
                                              "." + limit.key
                                        : limit.key);
    }
    row.seconds_solve = row.seconds_total = solution.seconds_total;
    return row;
}

MachineSolution solve_machine(const MachineSpec& machine, const MachineOptions& options,
                              const SolveControl& control) {
    options.validate();
    if (const std::optional<SceneFault> fault = find_fault(machine)) throw SceneError(*fault);
    for (std::size_t b = 0; b < machine.axes.size(); ++b) {
        try {
            (void)valid_scene(at_speed(machine.axes[b].scene, machine.least_speed));
        } catch (const SceneError& error) {
            throw SceneError({entry_key("axis", b, joined_key("scene", error.fault().member)),
                              error.fault().found, error.fault().allowed});
        }
    }
    if (!searches_timing(machine)) return MachineSearch(machine, options, control).run();
    const FixedMachine fixed{[](const auto&... asked) { return MachineSearch(asked...).run(); },
                             [](const auto&... asked) { return MachineSearch(asked...).passing(); }};
    return solve_with_timing(machine, options, control, fixed);
}

}  // namespace camopt
