// SPDX-License-Identifier: MIT
#include "studies/search/free_transmission.hpp"

#include "studies/delivered/solution_report.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Of the range, and of the interval between the neighbours of the best of them: to 1e-6 of it.
constexpr int first_values = 9, golden_sections = 29;
// Of two objectives that differ by less, the first stays: the limits of the motor are inactive there.
constexpr double same_objective = 1e-9;
// Values without a motion count as worse than any objective, by their violation up to this.
constexpr double without_motion = 1e30, worst_violation = 1e6;

class TransmissionSearch {
 public:
    TransmissionSearch(const Scene& scene, const SolveControl& control, const SolveScene& solve)
        : scene_(scene), control_(control), solve_(solve) {}

    void run() {
        const std::array<double, 2>& range = *scene_.drive->transmission_range;
        const double low = std::log(range[0]), step = (std::log(range[1]) - low) / (first_values - 1);
        int nearest = first_values / 2;
        // From the middle outwards.
        for (int k = 0; k < first_values && !control_.ending(); ++k) {
            const int index = first_values / 2 + (k % 2 == 0 ? -k / 2 : (k + 1) / 2);
            if (cost_at(low + index * step)) nearest = index;
        }
        const auto at = [&](int index) { return low + std::clamp(index, 0, first_values - 1) * step; };
        (void)golden_maximum(
            [&](double log_value) {
                cost_at(log_value);
                return -latest_;
            },
            at(nearest - 1), at(nearest + 1), golden_sections,
            [&](const GoldenSection&) { return control_.ending().has_value(); });
    }

    [[nodiscard]] Solution deliver() {
        Solution solution = std::move(best_);
        Scene scene = scene_;
        scene.drive->transmission = value_;
        set_scene(solution, std::move(scene));
        solution.seconds_solve = solution.seconds_total = watch_.seconds();
        solution.solver.convex = false;
        for (std::string& note : solution.notes) note.insert(0, "for this transmission: ");
        judge(solution.certificate);
        solution.notes.push_back(fmt::format(
            "searched transmission: {} values tried; nothing is proved of values in between", tried_));
        if (solution.motion) add_to_design(solution, {"drive.transmission"}, std::span(&value_, 1));
        return solution;
    }

 private:
    const Scene& scene_;
    const SolveControl& control_;
    const SolveScene& solve_;
    Stopwatch watch_;
    Solution best_;
    double value_ = 0.0, least_ = infinity, latest_ = infinity;
    int tried_ = 0;

    /// Solves with a transmission; whether it is the best so far.
    bool cost_at(double log_value) {
        Scene one = scene_;
        one.drive->transmission = std::exp(log_value);
        one.drive->transmission_range.reset();
        Solution solution = solve_(one, control_);
        const Certificate& certificate = solution.certificate;
        latest_ = solution.motion
                      ? certificate.objective
                      : without_motion * (1.0 + std::min(certificate.worst_violation, worst_violation));
        const bool better =
            tried_++ == 0 || latest_ < least_ - same_objective * std::max(1.0, std::abs(least_));
        if (!better) return false;
        least_ = latest_;
        value_ = one.drive->transmission;
        best_ = std::move(solution);
        return true;
    }

    /// What holds for one value is no proof for others.
    void judge(Certificate& certificate) const {
        forget_proof(certificate);
        certificate.cases.clear();
        const std::optional<Termination> ended = control_.ending();
        if (certificate.verdict == Verdict::infeasible) {
            certificate.verdict = Verdict::failed;
            certificate.reason = ended ? reason_of(*ended) : Reason::no_feasible_point;
        } else if (certificate.verdict == Verdict::optimal) {
            certificate.verdict = ended ? Verdict::feasible : Verdict::local;
            certificate.reason = ended ? reason_of(*ended) : Reason::stationary;
        }
    }
};

}  // namespace

Solution solve_free_transmission(const Scene& scene, const SolveControl& control, const SolveScene& solve) {
    TransmissionSearch search(scene, control, solve);
    search.run();
    return search.deliver();
}

}  // namespace camopt
