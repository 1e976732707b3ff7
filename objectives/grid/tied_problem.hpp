// SPDX-License-Identifier: MIT
//
// Tie-break: a CamProblem with a small energy added to its cost,
//
//   f + weight · e,   e = mean square of y''' over its reference²,
//
// on the problem's own grid, which both refine. For a weight small enough the optimum is, among the optima of
// the problem, the one of least ∫ y'''².
#pragma once

#include "objectives/grid/cam_problem.hpp"

#include <memory>

namespace camopt {

class TiedProblem final : public ContinuousProblem {
 public:
    /// The problem must outlive this one. weight > 0.
    TiedProblem(CamProblem& problem, double weight);
    ~TiedProblem() override;

    /// Changes the weight of the energy; > 0.
    void set_weight(double weight);
    /// e of the motion of x.
    [[nodiscard]] double energy(const Eigen::VectorXd& x) const;

    [[nodiscard]] const Nlp& grid() const override;
    [[nodiscard]] Eigen::VectorXd start() const override { return problem_.start(); }
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override;
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override;
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override;
    [[nodiscard]] double worst_of_limits(const Eigen::VectorXd& x) const override;
    int refine(std::span<const Violation> worst) override;
    int refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) override;
    [[nodiscard]] Box box(double incumbent, double relaxation) const override;
    [[nodiscard]] bool convex(double incumbent) const override { return problem_.convex(incumbent); }

 private:
    class Grid;
    void follow(int added);

    CamProblem& problem_;
    QuadraticForm energy_;  ///< of design entries in the optimizer's units
    double weight_;
    std::unique_ptr<Grid> grid_;
};

}  // namespace camopt
