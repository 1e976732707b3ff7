// SPDX-License-Identifier: MIT
// The search space of motions: y(x) = y_0(x) + Σ_j x_j φ_j(x), over dwells, fixed shapes and splines.
//
// Adjacent spline intervals form one run: one spline with full continuity at their joints, represented by one
// DesignVector. A run ends at rest next to a dwell (y' = y'' = 0) and with the state of a fixed shape next to
// one. A free displacement at a joint is a separate entry. A closed family ends where it began; a run may
// extend across that point. DRD and RR are families of one spline run.
#pragma once

#include "splines/derivative_combination.hpp"
#include "splines/gram.hpp"
#include "splines/motion_chain.hpp"

namespace camopt {

struct StretchRequest {
    enum class Kind { dwell, shape, spline };
    Kind kind = Kind::dwell;
    double begin = 0.0, end = 0.0;           ///< x
    std::shared_ptr<const Motion> shape;     ///< kind shape: on [0, 1], from 0 to 1
    std::vector<double> breakpoints;         ///< kind spline: from begin to end
    std::optional<double> to;                ///< displacement at the end; none: free (dwell: as at its begin)
    std::vector<PointCondition> conditions;  ///< kind spline: further exact points inside, in x
};

struct FamilyRequest {
    int degree = 3, continuity = 2;
    DesignKind kind = DesignKind::states;
    std::vector<StretchRequest> stretches;  ///< from displacement 0
    bool closed = true;                     ///< ends at displacement 0, and as smooth as its runs
    /// Not closed, but goes on from the displacement it has reached: as smooth at that point.
    bool relative = false;
    std::array<double, 2> start{}, end{};  ///< y', y'' of a spline at an open end
    int repeat = 1;                        ///< closed: so many copies of all stretches, with the same entries
    /// Highest derivative that is 0 where a run meets a dwell or an open end; from 2 on (rest_conditions()).
    int rest = 2;
};

/// The displacement at a joint that no entry moves: given, or propagated by dwells and closure.
[[nodiscard]] std::optional<double> known_displacement(const AffineRow& row);

class MotionFamily {
 public:
    /// One interval of x. `from`, `to`: the displacement at its ends, as rows of the entries.
    struct Stretch {
        StretchRequest::Kind kind = StretchRequest::Kind::spline;
        double begin = 0.0, end = 0.0;
        int run = -1;        ///< spline: which run
        double shift = 0.0;  ///< spline: the run's own x is x + shift
        std::shared_ptr<const Motion> shape;
        AffineRow from, to;
        bool copy = false;  ///< of an earlier one: another interval with the same motion
    };
    /// A part of an interval with one formula.
    struct Piece {
        double begin = 0.0, end = 0.0;
        int stretch = 0;
        int segment = -1;  ///< of the run; -1: no spline
        bool copy = false;
    };

    MotionFamily(DesignVector single);  // NOLINT(google-explicit-constructor)
    /// Throws InputError if the intervals do not join, or displacements contradict each other.
    [[nodiscard]] static MotionFamily make(const FamilyRequest& request);
    /// The motions s = of(y) of this family's y, by the same entries and equalities: dwells and splines.
    /// Throws InputError for a family with a fixed shape, or whose splines are not smooth enough.
    [[nodiscard]] MotionFamily cam_motions(const DerivativeCombination& of) const;

    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] std::string name(int index) const;
    /// Order of the derivative that entry `index` stands for.
    [[nodiscard]] int order(int index) const;
    /// x of the breakpoint that entry `index`, a state of a run, belongs to; none of other entries.
    [[nodiscard]] std::optional<double> place(int index) const;

    [[nodiscard]] double begin() const { return stretches_.front().begin; }
    [[nodiscard]] double end() const { return stretches_.back().end; }
    [[nodiscard]] const std::vector<Stretch>& stretches() const { return stretches_; }
    /// Those that are no copies: the first ones.
    [[nodiscard]] std::span<const Stretch> own_stretches() const {
        return {stretches_.data(), stretches_.size() / static_cast<std::size_t>(repeat_)};
    }
    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
    [[nodiscard]] int piece_of(double x, Side side) const { return interval_of(piece_begins_, x, side); }

    [[nodiscard]] int runs() const { return static_cast<int>(runs_.size()); }
    [[nodiscard]] const DesignVector& run(int index) const { return runs_[index].design; }
    [[nodiscard]] const SplineSpace& run_space(int index) const {
        const Run& run = runs_[index];
        return run.combined_space ? *run.combined_space : run.design.space();
    }
    /// The first entry of a run's design vector.
    [[nodiscard]] int first_entry(int run) const { return runs_[run].first; }
    /// Entries after those of all runs: free displacements (and states) at joints.
    [[nodiscard]] int first_joint_entry() const { return first_joint_; }

    [[nodiscard]] AffineRow functional(double x, int order, Side side = Side::right) const;
    [[nodiscard]] const std::vector<Equality>& equalities() const { return equalities_; }
    [[nodiscard]] std::vector<ConditionConflict> redundant() const;
    [[nodiscard]] std::vector<ConditionConflict> contradictions() const;
    [[nodiscard]] int freedom() const { return size() - static_cast<int>(equalities_.size()); }
    [[nodiscard]] std::vector<int> reported_entries() const;

    [[nodiscard]] SplineCurve run_curve(int run, const Eigen::VectorXd& x) const;
    [[nodiscard]] MotionChain motion(const Eigen::VectorXd& x) const;

    /// Σ_i weight_i ∫ over spline piece i of (y^{(order)})² dx / Σ_i width_i. weights: one a stretch;
    /// none: 1.
    [[nodiscard]] QuadraticForm mean_square(int order, const std::vector<double>& weights = {}) const;

 private:
    struct Run {
        DesignVector design;
        int first = 0;
        std::vector<LocalMap> maps;  ///< over the entries of the family, joint entries included
        std::optional<SplineSpace> combined_space = {};  ///< of a combined family: that of the maps
    };
    struct Builder;
    MotionFamily() = default;
    void add_pieces();

    std::vector<Run> runs_;
    std::vector<Stretch> stretches_;
    std::vector<Piece> pieces_;
    std::vector<double> piece_begins_;
    std::vector<Equality> equalities_;
    std::vector<std::pair<std::string, int>> joints_;  ///< name and order of the joint entries
    int first_joint_ = 0, size_ = 0, repeat_ = 1;
};

}  // namespace camopt
