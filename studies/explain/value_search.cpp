// SPDX-License-Identifier: MIT
#include "studies/explain/value_search.hpp"

#include "solvers/structured/structured_solver.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/search/free_knots.hpp"
#include "studies/search/planned_solve.hpp"
#include "studies/search/presolve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// A value is found to this part of itself; a solve with that much to spare is feasible.
constexpr double value_accuracy = 1e-8;
constexpr int most_doublings = 24;
constexpr int most_root_steps = 60;
// Digits of a value that is told, and how far from the edge it lies at least, both of its size: a solve that
// ends within its tolerance of the edge would prove nothing.
constexpr int told_digits = 5;
constexpr double least_margin = 1e-6;
// Where the search's word was too good: how much further off a solve is tried, of the size.
constexpr double further_off[] = {0.0, 1e-4, 1e-3, 1e-2, 5e-2};
// Of a value that is determined: what is left of it after rounding errors are dropped.
constexpr int exact_digits = 9;

class ValueSearch {
 public:
    using Violation = double(const Scene& scene, const Budget& budget);

    ValueSearch(const Scene& scene, const Adjustment& adjustment, double given, const Budget& budget,
                Violation* violation = least_violation)
        : scene_(scene), adjustment_(adjustment), given_(given), budget_(budget), violation_(violation) {}

    /// The nearest feasible value in one direction, ±1.
    [[nodiscard]] std::optional<double> nearest(int direction) const {
        double outside = adjustment_.given;  // still infeasible
        double violation = given_;
        double step = adjustment_.step;
        for (int k = 0; k < most_doublings && !budget_.spent(); ++k, step *= 2.0) {
            const double end = direction > 0 ? adjustment_.most : adjustment_.least;
            double next = adjustment_.given + direction * step;
            const bool last = direction > 0 ? next >= end : next <= end;
            if (last) next = end;
            const double there = violation_at(next);
            if (there <= 0.0) return between(outside, violation, next, there);
            if (last) return {};
            outside = next;
            violation = there;
        }
        return {};
    }

    [[nodiscard]] FeasibleEdge edge(double feasible, int direction, double end) const {
        double inside = feasible, slack = violation_at(feasible);
        double step = adjustment_.step;
        for (int k = 0; k < most_doublings && !budget_.spent(); ++k, step *= 2.0) {
            const double next = feasible + direction * step;
            const bool last = direction * (next - end) >= 0.0;
            const double value = last ? end : next;
            const double there = violation_at(value);
            if (there > 0.0) return {between(value, there, inside, std::min(slack, 0.0)), value};
            inside = value;
            slack = there;
            if (last) return {inside, std::nullopt, true};
        }
        return {inside, std::nullopt};
    }

    [[nodiscard]] double towards(double feasible) const {
        return between(adjustment_.given, given_, feasible, 0.0);
    }

 private:
    const Scene& scene_;
    const Adjustment& adjustment_;
    double given_;
    const Budget& budget_;
    Violation* violation_;

    [[nodiscard]] double violation_at(double value) const {
        return violation_(adjustment_.with(scene_, value), budget_);
    }

    /// The boundary between an infeasible and a feasible value, from the feasible side.
    [[nodiscard]] double between(double outside, double violation, double inside, double slack) const {
        const double accuracy = value_accuracy * std::max(std::abs(inside), adjustment_.step);
        for (int k = 0; k < most_root_steps && std::abs(inside - outside) > accuracy; ++k) {
            if (budget_.spent()) break;
            double value = 0.5 * (inside + outside);
            // A slack of zero stands for all slack (a start that already keeps everything has its own).
            const bool usable = std::isfinite(violation) && slack < 0.0 && k % 3 != 2;
            if (usable) value = inside + (outside - inside) * slack / (slack - violation);
            value = std::clamp(value, std::min(inside, outside) + 0.1 * accuracy,
                               std::max(inside, outside) - 0.1 * accuracy);
            const double there = violation_at(value);
            if (there <= 0.0) {
                inside = value;
                slack = there;
            } else {
                outside = value;
                violation = there;
            }
        }
        return inside;
    }
};

constexpr double first_part = 0.02;
constexpr int most_joint_doublings = 16;
// The common part is found to this part of itself: finer than the digits it is told with.
constexpr double part_accuracy = 1e-7;
constexpr int most_joint_bisections = 40;
// A limit that could give way by less than this part less stays: bisection is not exact.
constexpr double noticeably_less = 1e-2;
// How much more than the least part a solve is tried with.
constexpr double larger_factors[] = {0.0, 1e-3, 1e-2, 1e-1};

class JointSearch {
 public:
    JointSearch(const Scene& scene, std::vector<Adjustment> members, const Budget& budget)
        : scene_(scene), members_(std::move(members)), budget_(budget) {
        std::erase_if(members_, [](const Adjustment& one) {
            return (one.may_grow ? one.most : one.least) == one.given;
        });
    }

    [[nodiscard]] std::vector<Relaxation> run() {
        if (members_.empty()) return {};
        const double part = least_part();
        if (!(part > 0.0)) return {};
        std::vector<double> parts(members_.size(), part);
        give_back(parts);
        for (const double more : larger_factors) {
            Scene changed = scene_;
            std::vector<Relaxation> rows = rounded(parts, 1.0 + more, changed);
            if (is_solved(changed, budget_)) return rows;
            if (budget_.spent()) break;
        }
        return {};
    }

 private:
    const Scene& scene_;
    std::vector<Adjustment> members_;
    const Budget& budget_;

    [[nodiscard]] static double size_of(const Adjustment& one) {
        return std::max(std::abs(one.given), one.step);
    }
    /// An upper limit times 1 + part, a lower one divided by it: both give way by the same factor, and a
    /// least radius never comes to nothing.
    [[nodiscard]] static double value_of(const Adjustment& one, double part) {
        if (one.may_grow) return std::min(one.given + part * size_of(one), one.most);
        if (one.given > 0.0) return std::max(one.given / (1.0 + part), one.least);
        return std::max(one.given - part * size_of(one), one.least);
    }
    /// Of each member its own part; 0: it keeps its value.
    [[nodiscard]] bool does(const std::vector<double>& parts) const {
        Scene changed = scene_;
        for (std::size_t i = 0; i < members_.size(); ++i)
            if (parts[i] > 0.0) changed = members_[i].with(changed, value_of(members_[i], parts[i]));
        return least_violation(changed, budget_) <= 0.0;
    }
    /// Between a part that does and one that does not.
    template <class Does>
    [[nodiscard]] double least_between(double high, double low, const Does& does_with) const {
        return bisected(does_with, {high, low}, most_joint_bisections,
                        [&](const Border& now) {
                            return now.with - now.without <= part_accuracy * now.with || budget_.spent();
                        })
            .with;
    }
    /// 0: none found.
    [[nodiscard]] double least_part() const {
        const auto all = [&](double part) { return does(std::vector<double>(members_.size(), part)); };
        double low = 0.0, high = first_part;
        for (int k = 0; !all(high); ++k, high *= 2.0) {
            if (k == most_joint_doublings || budget_.spent()) return 0.0;
            low = high;
        }
        return least_between(high, low, all);
    }
    /// One that has to give way far would take the others along further than they need.
    void give_back(std::vector<double>& parts) const {
        const auto does_with = [&](std::size_t i) {
            return [this, &parts, i](double part) {
                std::vector<double> tried = parts;
                tried[i] = part;
                return does(tried);
            };
        };
        for (std::size_t i = parts.size(); i-- > 0;)
            if (!budget_.spent() && does_with(i)(0.0)) parts[i] = 0.0;
        for (std::size_t i = parts.size(); i-- > 0;) {
            const double less = (1.0 - noticeably_less) * parts[i];
            if (less > 0.0 && !budget_.spent() && does_with(i)(less))
                parts[i] = least_between(less, 0.0, does_with(i));
        }
    }
    /// `factor`: of every part. `changed`: gets the rows' values.
    [[nodiscard]] std::vector<Relaxation> rounded(const std::vector<double>& parts, double factor,
                                                  Scene& changed) const {
        std::vector<Relaxation> rows;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (parts[i] == 0.0) continue;
            const Adjustment& one = members_[i];
            const double needed = value_of(one, factor * parts[i]),
                         size = std::max(std::abs(needed), one.step);
            const double reported = std::clamp(safe_value(needed, one.may_grow, size),
                                               std::min(one.least, one.given), std::max(one.most, one.given));
            rows.push_back({one.key, one.given, needed, reported});
            changed = one.with(changed, reported);
        }
        return rows;
    }
};

constexpr int least_factor = 8;      // three doublings are always tried, but for
constexpr int most_segments = 512;   // splines that take longer than the explanation may
constexpr int enough_segments = 64;  // few segments are doubled on up to here

bool is_feasible(const Scene& scene, int segments, const Budget& budget) {
    return least_violation(with_segments(scene, segments), budget) <= 0.0;
}

/// The fewest segments above `fails` that a search finds feasible, at most `works`.
int fewest(const Scene& scene, int fails, int works, const Budget& budget) {
    while (works - fails > 1 && !budget.spent()) {
        const int middle = (fails + works) / 2;
        (is_feasible(scene, middle, budget) ? works : fails) = middle;
    }
    return works;
}

bool is_told(const Scene& scene, int segments, const Budget& budget) {
    const bool uniform = scene.spline.breakpoints.empty();
    return is_solved(with_segments(scene, segments), budget) &&
           (!uniform || is_solved(with_segments(scene, segments + 1), budget));
}

constexpr int most_rounds = 40;

/// Whether t* of the model is above zero: at most so many exchange rounds as that needs, since a grid's t is
/// a bound from below and a judged motion's one from above. The value is whichever of the two decided.
double least_violation(const CamModel& model, double tolerance, const Budget& budget) {
    CamProblem problem(model);
    const Candidate start = judged(problem, problem.start());
    if (start.violation <= 0.0) return start.violation;
    ElasticProblem elastic(problem);
    const std::unique_ptr<Solver> solver = make_structured_solver();
    Eigen::VectorXd x = elastic.start();
    double violation = start.violation;
    for (int round = 0; round < most_rounds && !budget.spent(); ++round) {
        BackendOptions options;
        options.tolerance = tolerance;
        const BackendResult result = solver->minimize(elastic.grid(), x, options, budget.control());
        if (result.termination != Termination::converged || !result.x.allFinite()) {
            // The value of such a point is no bound: the whole search decides.
            const Feasibility whole = find_feasible(problem, {}, budget.control());
            return whole.point.violation <= tolerance ? std::min(0.0, whole.point.violation)
                                                      : whole.point.violation;
        }
        const double on_grid = result.x[result.x.size() - 1];
        if (on_grid > tolerance) return on_grid;
        const Candidate found = judged(problem, result.x.head(result.x.size() - 1));
        violation = std::min(violation, found.violation);
        if (violation <= 0.0) return violation;
        std::vector<Violation> worst = elastic.violations(result.x, 0.0);
        if (worst.empty() || elastic.refine(worst) == 0) break;
        x = elastic.completed(result.x);
    }
    return violation <= tolerance ? 0.0 : violation;
}

/// The scene as it is solved to answer: what decides which of its motions is best plays no part.
Solution answer(Scene scene, const Budget& budget, const PlanOptions& options = {}) {
    scene.solver.name = "auto";
    scene.solver.options.clear();
    scene.objective.tie_break = TieBreak::none;
    return solve_without_explaining(scene, budget.control(), nullptr, options);
}

/// The motion of a search that leaves its proof out, audited. The solve that the user would start begins with
/// the same search.
Solution search(const Scene& scene, const Budget& budget) {
    Solution solution = answer(scene, budget, {.look = true});
    audit_delivered(solution);
    const Verdict verdict = solution.certificate.verdict;
    if (verdict == Verdict::infeasible || verdict == Verdict::failed) withdraw_motion(solution);
    return solution;
}

}  // namespace

std::optional<double> nearest_value(const Scene& scene, const Adjustment& adjustment, double given,
                                    const Budget& budget) {
    const ValueSearch search(scene, adjustment, given, budget);
    std::optional<double> nearest;
    for (const int direction : {1, -1}) {
        if (!(direction > 0 ? adjustment.may_grow : adjustment.may_shrink)) continue;
        const std::optional<double> found = search.nearest(direction);
        const bool nearer = found && (!nearest || std::abs(*found - adjustment.given) <
                                                      std::abs(*nearest - adjustment.given));
        if (nearer) nearest = found;
    }
    return nearest;
}

FeasibleEdge feasible_edge(const Scene& scene, const Adjustment& adjustment, double feasible, int direction,
                           double end, const Budget& budget) {
    return ValueSearch(scene, adjustment, infinity, budget, violation_of_any).edge(feasible, direction, end);
}

double value_towards(const Scene& scene, const Adjustment& adjustment, double feasible,
                     const Budget& budget) {
    return ValueSearch(scene, adjustment, infinity, budget).towards(feasible);
}

double rounded_away(double value, int decimals, bool up) {
    // Dividing by a power of ten gives the double nearest to the decimal number.
    const double power = std::pow(10.0, std::abs(decimals));
    const double scaled = decimals >= 0 ? value * power : value / power;
    const double steps = up ? std::ceil(scaled) : std::floor(scaled);
    return decimals >= 0 ? steps / power : steps * power;
}

double safe_value(double needed, bool up, double size) {
    size = std::max(size, std::abs(needed));
    if (!(size > 0.0) || !std::isfinite(size)) return needed;
    const int decimals = told_digits - 1 - static_cast<int>(std::floor(std::log10(size)));
    return rounded_away(needed + (up ? least_margin : -least_margin) * size, decimals, up);
}

std::optional<Relaxation> solved_relaxation(const Scene& scene, const Adjustment& adjustment, double needed,
                                            const Budget& budget) {
    const bool up = needed > adjustment.given;
    const double size = std::max(std::abs(needed), adjustment.step);
    const auto solved = [&](double told) {
        return !budget.spent() && is_solved(adjustment.with(scene, told), budget);
    };
    const auto row = [&](double edge, double told) {
        Relaxation found{adjustment.key, adjustment.given, edge, told};
        if (adjustment.also) found.also = adjustment.also(told);
        return found;
    };
    for (const double margin : further_off) {
        const double edge = needed + (up ? margin : -margin) * size;
        // The end of a range needs no margin: there is nothing beyond it.
        const double told =
            std::clamp(safe_value(edge, up, size), std::min(adjustment.least, adjustment.given),
                       std::max(adjustment.most, adjustment.given));
        if (solved(told)) return row(margin == 0.0 ? needed : told, told);
    }
    const double scale =
        needed == 0.0 ? 1.0 : std::pow(10.0, exact_digits - std::ceil(std::log10(std::abs(needed))));
    for (const double told : {std::round(needed * scale) / scale, as_written(needed)})
        if (solved(told)) return row(needed, told);
    return {};
}

std::vector<Relaxation> joint_relaxation(const Scene& scene, const std::vector<Adjustment>& members,
                                         const Budget& budget) {
    return JointSearch(scene, members, budget).run();
}

FinerSpline finer_spline(const Scene& scene, const Budget& budget) {
    FinerSpline result;
    const int given = segments_of(scene.spline);
    const bool uniform = scene.spline.breakpoints.empty();
    const int most = std::min(most_segments, std::max(least_factor * given, enough_segments));
    int fails = given;
    for (int n = 2 * given; n <= most && !budget.spent(); n *= 2) {
        budget.say(fmt::format("suggested changes: {} segments", n));
        const bool feasible = is_feasible(scene, n, budget);
        if (budget.spent()) break;
        if (feasible) {
            const int found = uniform ? fewest(scene, fails, n, budget) : n;
            for (const int told : {found, found + 1, found + 2, n}) {
                if (budget.spent()) return result;
                if (told > n || (!uniform && told != n) || !is_told(scene, told, budget)) continue;
                result.row =
                    Relaxation{uniform ? "spline.segments" : "spline.breakpoints", static_cast<double>(given),
                               static_cast<double>(told), static_cast<double>(told)};
                result.finest = 0;
                return result;
            }
            if (budget.spent()) break;  // what the clock ended does not count as tried
        }
        fails = n;
        result.finest = n;
    }
    return result;
}

double least_violation(const Scene& scene, const Budget& budget) {
    if (find_fault(scene)) return infinity;
    // The breakpoints that the search would start from do not decide for free ones.
    if (scene.spline.free_knots) {
        if (no_motion_keeps_all_caps(scene)) return infinity;
        if (!limit_breakpoints(scene, reference_peaks(scene)).empty()) return 0.0;
    }
    const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    if (!model.design.contradictions().empty()) return infinity;
    if (const auto rest = rest_conflict(model, scene.solver.tolerance)) return rest->violation;
    const CamModel convex = convex_part(model, ConvexOver::every_motion);
    const double tolerance = scene.solver.tolerance;
    const double necessary = least_violation(convex, tolerance, budget);
    if (necessary > 0.0) return necessary;
    if (convex.rules.size() < model.rules.size())
        if (const double all = least_violation(model, tolerance, budget); all > 0.0) return all;
    // The strokes last: with them the edge of what is feasible is near everywhere.
    const CamModel held =
        scene_model(scene, DesignKind::states, reference_peaks(scene), HeldStrokes{.held = true});
    return held.rules.size() == model.rules.size() ? necessary : least_violation(held, tolerance, budget);
}

double violation_of_any(const Scene& scene, const Budget& budget) {
    if (!searches_angles(scene)) return least_violation(scene, budget);
    return is_solved(scene, budget) ? 0.0 : infinity;
}

std::shared_ptr<const MotionChain> solved_motion(const Scene& scene, const Budget& budget) {
    if (budget.spent() || find_fault(scene)) return nullptr;
    // The first of several starts is one of those of the scene itself: what it finds is found with all.
    Scene first = scene;
    first.solver.starts = 1;
    const Solution one = search(first, budget);
    const bool settled = one.motion || one.certificate.verdict == Verdict::infeasible;
    if (settled || budget.spent() || scene.solver.starts == 1) return one.motion;
    return search(scene, budget).motion;
}

std::optional<std::vector<ConflictReport>> proved_conflict(const Scene& scene, const Budget& budget) {
    if (budget.spent() || find_fault(scene)) return {};
    if (scene.spline.free_knots)
        return no_motion_keeps_all_caps(scene) ? std::optional(std::vector<ConflictReport>{}) : std::nullopt;
    Scene first = scene;
    first.solver.starts = 1;
    Solution solution = answer(first, budget);
    if (solution.certificate.verdict != Verdict::infeasible) return {};
    return std::move(solution.conflict);
}

}  // namespace camopt
