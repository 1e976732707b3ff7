// SPDX-License-Identifier: MIT
// A CamModel as a ContinuousProblem: the motion's design vector and the cam's rules on a grid of angles.
//
// x = design entries and parameters in optimizer units (grid_nlp.hpp). Rules hold at every cam angle: their
// continuous maxima come from rule_maxima.hpp.
#pragma once

#include "core/continuous_problem.hpp"
#include "objectives/grid/equality_projection.hpp"
#include "objectives/grid/grid_nlp.hpp"
#include "objectives/rules/model.hpp"

#include <map>
#include <memory>
#include <optional>

namespace camopt {

class CamProblem final : public ContinuousProblem {
 public:
    /// The first grid: every rule at the breakpoints (both sides where its derivative jumps) and, where it is
    /// curved between them, at the middles.
    explicit CamProblem(CamModel model);
    /// The same with a grid already refined for another cost over the same rules (the tie-break).
    CamProblem(CamModel model, const std::vector<RuleSample>& samples);

    [[nodiscard]] const Nlp& grid() const override { return *grid_; }
    [[nodiscard]] Eigen::VectorXd start() const override;
    [[nodiscard]] Eigen::VectorXd completed(const Eigen::VectorXd& x) const override;
    [[nodiscard]] double objective(const Eigen::VectorXd& x) const override;
    [[nodiscard]] std::vector<Violation> violations(const Eigen::VectorXd& x, double slack) const override;
    [[nodiscard]] double worst_of_limits(const Eigen::VectorXd& x) const override;
    int refine(std::span<const Violation> worst) override;
    int refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) override;
    [[nodiscard]] Box box(double incumbent, double relaxation) const override;
    [[nodiscard]] bool convex(double incumbent) const override;
    /// A smooth random motion (a beam under random loads) and random dimensions, from a seed.
    [[nodiscard]] Eigen::VectorXd random_start(unsigned seed) const;

    [[nodiscard]] const CamModel& model() const { return *model_; }
    [[nodiscard]] const std::vector<RuleSample>& samples() const { return samples_; }
    [[nodiscard]] MotionChain motion(const Eigen::VectorXd& x) const;
    /// The spline of the first run: all of it for DRD and RR.
    [[nodiscard]] SplineCurve curve(const Eigen::VectorXd& x) const;
    /// Design entries of x in their own units.
    [[nodiscard]] Eigen::VectorXd design_values(const Eigen::VectorXd& x) const;

 private:
    void start_grid();
    void start_rule(int index);
    bool add_sample(int rule, double at, Side side);
    bool add_whole_sample(const RuleSample& sample);
    void refine_whole(const Violation& violation);
    void complete_responses(const MotionChain& chain, Eigen::VectorXd& x) const;
    void add_samples(std::span<const Violation> worst);
    void add_around(const Violation& violation);
    int append_rows();
    struct Pressed;
    [[nodiscard]] std::optional<Pressed> pressed_around(const Violation& violation,
                                                        const Eigen::VectorXd& row_multipliers) const;
    void add_pressed(const Violation& violation, const Pressed& pressed);
    [[nodiscard]] std::vector<Violation> violations_of(bool limits_only, const Eigen::VectorXd& x,
                                                       double slack) const;
    [[nodiscard]] Eigen::VectorXd own_parameters(int rule, const Eigen::VectorXd& x) const;
    void complete_parameters(Eigen::VectorXd& x) const;
    void complete_peaks(const SplineCurve& curve, Eigen::VectorXd& x) const;
    void complete_own_peaks(const MotionChain& chain, Eigen::VectorXd& x) const;
    void complete_program_peaks(const MotionChain& chain, Eigen::VectorXd& x) const;
    [[nodiscard]] Eigen::VectorXd smoothest(const Eigen::VectorXd& load) const;
    [[nodiscard]] std::array<double, 2> displacement_range(double incumbent) const;
    struct SupportedBounds;
    [[nodiscard]] SupportedBounds supported_bounds(double incumbent, double relaxation) const;

    std::shared_ptr<const CamModel> model_;
    std::vector<RuleSample> samples_;
    /// Samples of each rule by (piece, x), to find neighbours and duplicates.
    std::vector<std::map<std::pair<int, double>, int>> places_;
    std::unique_ptr<GridNlp> grid_;
    std::unique_ptr<EqualityProjection> projection_;
    Eigen::VectorXd scales_;   ///< of the design entries
    std::size_t on_grid_ = 0;  ///< samples that already have rows
};

}  // namespace camopt
