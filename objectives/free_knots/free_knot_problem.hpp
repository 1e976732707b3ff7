// SPDX-License-Identifier: MIT
// A DRD or RR scene with free interior breakpoints, as a ContinuousProblem.
//
// x as in free_knot_nlp.hpp. Completion, peaks and maxima of violation are computed by the CamProblem with
// the breakpoints of x fixed. A violation's `where.at` counts segments: i + fraction for the point at that
// part of segment i of the whole motion, so that it stays with the segment. Not convex; box() has no bounds.
#pragma once

#include "core/continuous_problem.hpp"
#include "core/peaks.hpp"
#include "objectives/free_knots/free_knot_nlp.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "scene/scene.hpp"
#include "splines/free_knot_form.hpp"

#include <memory>
#include <set>
#include <tuple>

namespace camopt {

/// The scene with these breakpoints, stored.
[[nodiscard]] Scene with_breakpoints(Scene scene, std::vector<double> breakpoints);

/// The scene's own breakpoints: the start of the search for free ones.
[[nodiscard]] std::vector<double> start_breakpoints(const Scene& scene);

class FreeKnotProblem final : public ContinuousProblem {
 public:
    /// `scene`: DRD or RR; its breakpoints are the start of the search, and assign exact points to segments.
    FreeKnotProblem(Scene scene, const Peaks& reference);

    [[nodiscard]] const Nlp& grid() const override { return *grid_; }
    [[nodiscard]] Eigen::VectorXd start() const override;
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override;
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override;
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override;
    int refine(std::span<const Violation> worst) override;
    [[nodiscard]] Box box(double incumbent, double relaxation) const override;

    [[nodiscard]] const FreeKnotForm& form() const { return *form_; }
    [[nodiscard]] std::vector<double> breakpoints(const Eigen::VectorXd& x) const;
    /// The problem with the breakpoints of x fixed, and x converted for it.
    [[nodiscard]] CamProblem fixed_problem(const Eigen::VectorXd& x) const;
    [[nodiscard]] Eigen::VectorXd fixed_point(const CamProblem& fixed, const Eigen::VectorXd& x) const;
    /// A point of a problem with fixed breakpoints, converted for this one.
    [[nodiscard]] Eigen::VectorXd free_point(const CamProblem& fixed, const Eigen::VectorXd& x) const;

 private:
    void start_grid();
    bool add_sample(int rule, int segment, double fraction, bool mirrored);
    void rebuild();
    [[nodiscard]] Eigen::VectorXd physical_form(const Eigen::VectorXd& x) const;

    Scene scene_;
    Peaks reference_;
    std::shared_ptr<const CamModel> model_;  ///< of the start: rules and parameters
    std::shared_ptr<const FreeKnotForm> form_;
    std::vector<FreeSample> samples_;
    std::set<std::tuple<int, int, bool, double>> places_;  ///< rule, segment, mirrored, fraction
    std::unique_ptr<FreeKnotNlp> grid_;
};

}  // namespace camopt
