// SPDX-License-Identifier: MIT
#include "dynamics/train_formulas.hpp"

#include "dynamics/linear_train.hpp"
#include "dynamics/small_matrices.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int most_masses = 4;

/// Relative displacements of the masses, row by row times √weight / √mass.
Eigen::MatrixXd weighted_elongations(const LinearTrain& train, double TrainStage::*weight) {
    const int n = train.masses();
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
        const TrainStage& stage = train.stages[i];
        rows(i, i) = std::sqrt(stage.*weight / stage.mass);
        if (i > 0)
            rows(i, i - 1) = -std::sqrt(stage.*weight / train.stages[static_cast<std::size_t>(i) - 1].mass);
    }
    return rows;
}

/// Springs in series: compliances are added, without cancellation.
void set_static_shapes(LinearTrain& train) {
    const int n = train.masses();
    train.share.setOnes(n);
    train.compliance.setZero(n);
    double series = 0.0;  // m/N from the cam to mass i
    for (int i = 0; i < n; ++i) {
        series += 1.0 / train.stages[i].stiffness;
        train.compliance[i] = series;
    }
    // The return spring pulls the output by k_r x_n: x = y − c_i k_r x_n with x_n = y / (1 + c_n k_r).
    const double loaded = 1.0 + series * train.return_stiffness;
    for (int i = 0; i < n; ++i) {
        train.share[i] -= train.compliance[i] * train.return_stiffness / loaded;
        train.compliance[i] /= loaded;
    }
}

// Any motion as pieces on which y' is a polynomial.
//
// Between two breakpoints a quintic through y', y'', y''' of both ends is tried first: it is exact for any
// spline up to degree 6. Otherwise (harmonic laws, polynomials of higher degree) Chebyshev interpolants on
// successively halved intervals approximate y' to round-off.

using Eigen::VectorXd;

constexpr int chebyshev_terms = 15;
// Relative to the largest slope of the piece: accepted residual of a fit, the round-off of the motion's
// formulas.
constexpr double rounding_of_slope = 4e-15;
// Of the largest |x|: round-off of the argument. A spline that crosses the end of a closed program is
// evaluated at x plus the length of the program.
constexpr double rounding_of_argument = 4.0 * std::numeric_limits<double>::epsilon();
// The last terms of a converged Chebyshev series, relative to the largest slope of the motion: round-off of
// its formulas.
constexpr double converged_terms = 2e-15;
constexpr int size_samples = 16;
constexpr int deepest_halving = 40;

struct Span {
    double begin = 0.0, end = 0.0;
    [[nodiscard]] double width() const { return end - begin; }
    [[nodiscard]] double at(double t) const { return begin + t * (end - begin); }
};

/// Σ_k c_k t^k through value, slope and second derivative by t at both ends.
VectorXd quintic(const std::array<double, 3>& left, const std::array<double, 3>& right) {
    VectorXd c(6);
    c.head(3) << left[0], left[1], 0.5 * left[2];
    const double rest = right[0] - c[0] - c[1] - c[2];
    const double slope = right[1] - c[1] - 2.0 * c[2];
    const double bend = right[2] - 2.0 * c[2];
    c[3] = 10.0 * rest - 4.0 * slope + 0.5 * bend;
    c[4] = -15.0 * rest + 7.0 * slope - bend;
    c[5] = 6.0 * rest - 3.0 * slope + 0.5 * bend;
    return c;
}

double value_at(const VectorXd& polynomial, double t) {
    double value = 0.0;
    for (Eigen::Index k = polynomial.size(); k-- > 0;) value = value * t + polynomial[k];
    return value;
}

class SlopeFit {
 public:
    SlopeFit(const Motion& motion, std::vector<SlopePiece>& pieces) : motion_(motion), pieces_(pieces) {
        const Span whole{motion.begin(), motion.end()};
        argument_ = rounding_of_argument * std::max(std::abs(whole.begin), std::abs(whole.end));
        for (int k = 0; k <= size_samples; ++k) {
            const double slope =
                std::abs(motion.at(whole.at(static_cast<double>(k) / size_samples)).derivative[1]);
            if (std::isfinite(slope)) largest_ = std::max(largest_, slope);
        }
    }

    void add(const Span& span, int halvings) {
        if (add_quintic(span) || add_chebyshev(span)) return;
        if (halvings == deepest_halving)
            throw InputError(fmt::format(
                "dynamics: found a motion whose velocity no polynomial approximates near x = {:.9g}; "
                "allowed: finite velocities and accelerations",
                span.begin));
        const double middle = span.at(0.5);
        add({span.begin, middle}, halvings + 1);
        add({middle, span.end}, halvings + 1);
    }

 private:
    /// What the round-off of the argument makes of y'; 0 where y'' is infinite.
    [[nodiscard]] double slope_rounding(const MotionPoint& left, const MotionPoint& right) const {
        const double bend = std::max(std::abs(left.derivative[2]), std::abs(right.derivative[2]));
        return std::isfinite(bend) ? argument_ * bend : 0.0;
    }

    void keep(const Span& span, VectorXd slope) {
        const double displacement = motion_.at(span.begin, Side::right).derivative[0];
        pieces_.push_back({span.begin, span.width(), displacement, std::move(slope)});
    }

    bool add_quintic(const Span& span) {
        const MotionPoint left = motion_.at(span.begin, Side::right);
        const MotionPoint right = motion_.at(span.end, Side::left);
        const double h = span.width();
        const auto scaled = [h](const MotionPoint& point) {
            return std::array{point.derivative[1], h * point.derivative[2], h * h * point.derivative[3]};
        };
        VectorXd slope = quintic(scaled(left), scaled(right));
        if (!slope.allFinite()) return false;
        const double size = slope.cwiseAbs().maxCoeff();
        const double moved =
            argument_ * h * std::max(std::abs(left.derivative[3]), std::abs(right.derivative[3]));
        const double rounding = rounding_of_slope * size + slope_rounding(left, right);
        // A spline's slope has one degree fewer: the leading coefficient of the quintic is round-off.
        for (const double t : {0.2, 0.5, 0.85}) {
            const MotionPoint point = motion_.at(span.at(t));
            const double off = std::abs(value_at(slope, t) - point.derivative[1]);
            double bend = 0.0;
            for (Eigen::Index k = 5; k >= 1; --k) bend = bend * t + static_cast<double>(k) * slope[k];
            const double off_bend = std::abs(bend - h * point.derivative[2]);
            if (!(off <= rounding && off_bend <= rounding_of_slope * size + moved)) return false;
        }
        Eigen::Index terms = slope.size();
        while (terms > 1 && std::abs(slope[terms - 1]) <= rounding_of_slope * size) --terms;
        keep(span, slope.head(terms));
        return true;
    }

    bool add_chebyshev(const Span& span) {
        constexpr int n = chebyshev_terms;
        VectorXd values(n);
        for (int i = 0; i < n; ++i) {
            const double node = std::cos(std::numbers::pi * (i + 0.5) / n);
            values[i] = motion_.at(span.at(0.5 * (node + 1.0))).derivative[1];
        }
        if (!values.allFinite()) return false;
        VectorXd terms(n);
        for (int k = 0; k < n; ++k) {
            double sum = 0.0;
            for (int i = 0; i < n; ++i) sum += values[i] * std::cos(std::numbers::pi * k * (i + 0.5) / n);
            terms[k] = sum * (k == 0 ? 1.0 : 2.0) / n;
        }
        const double converged =
            converged_terms * std::max(largest_, terms.cwiseAbs().maxCoeff()) +
            slope_rounding(motion_.at(span.begin, Side::right), motion_.at(span.end, Side::left));
        if (terms.tail(3).cwiseAbs().maxCoeff() > converged) return false;
        int kept = n;
        while (kept > 1 && std::abs(terms[kept - 1]) <= converged) --kept;
        keep(span, by_powers(terms.head(kept)));
        return true;
    }

    /// Σ c_k T_k(2t − 1) by powers of t.
    static VectorXd by_powers(const VectorXd& terms) {
        VectorXd before = VectorXd::Zero(terms.size()), current = before, sum = before;
        before[0] = 1.0;
        sum[0] = terms[0];
        if (terms.size() == 1) return sum;
        current[0] = -1.0;
        current[1] = 2.0;
        sum += terms[1] * current;
        for (Eigen::Index k = 2; k < terms.size(); ++k) {
            VectorXd next = -before - 2.0 * current;
            next.tail(next.size() - 1) += 4.0 * current.head(current.size() - 1);
            sum += terms[k] * next;
            before = current;
            current = next;
        }
        return sum;
    }

    const Motion& motion_;
    std::vector<SlopePiece>& pieces_;
    double largest_ = 0.0;   ///< slope of the motion, by samples
    double argument_ = 0.0;  ///< round-off of x
};

/// Throws InputError where y' is not finite, or no polynomial approximates it (an infinite y'' at an end).
std::vector<SlopePiece> slope_pieces(const Motion& motion) {
    std::vector<SlopePiece> pieces;
    SlopeFit fit(motion, pieces);
    const std::vector<double> points = motion.breakpoints();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        if (points[i + 1] > points[i]) fit.add({points[i], points[i + 1]}, 0);
    return pieces;
}

class LinearTrainFormulas final : public TrainFormulas {
 public:
    explicit LinearTrainFormulas(LinearTrain train) : train_(std::move(train)) {
        const Eigen::VectorXd values = singular_values(train_.elongations());
        frequencies_.assign(values.begin(), values.end());
        vibrates_ = at(1.0, 1.0, 1.0)->modes().rows() > 0;
    }

    [[nodiscard]] std::unique_ptr<const TrainAtSpeed> at(double speed, double unit_angle,
                                                         double lift) const override {
        return std::make_unique<LinearTrainAtSpeed>(train_, speed, unit_angle, lift);
    }
    [[nodiscard]] std::vector<SlopePiece> pieces(const Motion& motion) const override {
        return slope_pieces(motion);
    }
    [[nodiscard]] const std::vector<double>& natural_frequencies() const override { return frequencies_; }
    [[nodiscard]] bool vibrates() const override { return vibrates_; }

 private:
    LinearTrain train_;
    std::vector<double> frequencies_;
    bool vibrates_ = false;
};

}  // namespace

Eigen::MatrixXd LinearTrain::elongations() const {
    return with_ground(weighted_elongations(*this, &TrainStage::stiffness), return_stiffness);
}

Eigen::MatrixXd LinearTrain::damped_elongations() const {
    return with_ground(weighted_elongations(*this, &TrainStage::damping), ground_damping);
}

Eigen::MatrixXd LinearTrain::with_ground(Eigen::MatrixXd rows, double weight) const {
    if (weight == 0.0) return rows;
    const int n = masses();
    rows.conservativeResize(n + 1, n);
    rows.row(n).setZero();
    rows(n, n - 1) = std::sqrt(weight / stages.back().mass);
    return rows;
}

LinearTrain linear_train(const DynamicsSpec& spec) {
    LinearTrain train;
    train.stages = spec.stages;
    train.stages.push_back(spec.output());
    train.return_stiffness = spec.return_stiffness;
    train.preload = spec.preload;
    train.ground_damping = spec.ground_damping;
    if (train.masses() > most_masses)
        throw SceneError({"dynamics.stage", fmt::format("{} stages before the output", spec.stages.size()),
                          fmt::format("at most {}", most_masses - 1)});
    for (const TrainStage& stage : train.stages)
        if (!(stage.mass > 0.0) || !(stage.stiffness > 0.0) || !(stage.damping >= 0.0))
            throw InputError(
                fmt::format("dynamics: found mass {}, stiffness {}, damping {}; allowed: masses and "
                            "stiffnesses > 0, damping >= 0",
                            stage.mass, stage.stiffness, stage.damping));
    set_static_shapes(train);
    return train;
}

std::shared_ptr<const TrainFormulas> train_formulas(const DynamicsSpec& spec) {
    return std::make_shared<LinearTrainFormulas>(linear_train(spec));
}

void complete_dynamics(Scene& scene) {
    if (scene.dynamics && !scene.dynamics->formulas)
        scene.dynamics->formulas = train_formulas(*scene.dynamics);
}

}  // namespace camopt
