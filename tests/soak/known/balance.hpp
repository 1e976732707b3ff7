// SPDX-License-Identifier: MIT
// Multipliers of rows that are active at a motion, or at several motions at once, and the answer that follows
// from them (known_scene.hpp says why).
#pragma once

#include "tests/soak/known/known_scene.hpp"
#include "tests/soak/known/piecewise_space.hpp"

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <vector>

namespace camopt::soak {

inline constexpr double rounding = std::numeric_limits<double>::epsilon();
inline constexpr double roundings = 32.0;   ///< of each number, on its way from the file to a row
inline constexpr double same_peak = 1e-11;  ///< relative: extremes that are one peak but for rounding

/// One row of the scene that is active at the motion: sign · (gradient · c) <= sign · value.
struct ActiveRow {
    enum class Of { term, area, rms, limit, rms_limit, corridor, point, clearance } of = Of::term;
    std::size_t owner = 0;
    Eigen::VectorXd gradient;
    double sign = 1.0;
    double size = 1.0;   ///< of its numbers: |value| + |x · slope|
    double scale = 1.0;  ///< of its quantity along the whole motion
    double gap = 0.0;    ///< to the bound, by rounding
    double preference = 1.0;
    bool free = false;     ///< an equation
    bool written = false;  ///< even without a multiplier
    double multiplier = 0.0;

    std::size_t part = 0;  ///< of a point: which of its values

    [[nodiscard]] bool is_cost() const { return of == Of::term || of == Of::area || of == Of::rms; }
};

/// Motions, one or several, whose coefficients follow each other.
class Balance {
 public:
    void add(const PiecewiseSpace& space, const Eigen::VectorXd& motion);
    /// A row of the motion added last, or, where `of_all`, one whose gradient has the coefficients of all of
    /// them.
    void add(ActiveRow& row, bool of_all = false);

    /// Finds multipliers, with costs of every motion or with none. False: there are none.
    [[nodiscard]] bool find(bool with_costs);
    /// Multiplies them so that what the costs come to, `total`, becomes `objective`.
    [[nodiscard]] KnownAnswer optimum(double total, double objective);
    /// Without costs: the inequality that says most, in sizes of the rows; null: there is none.
    [[nodiscard]] const ActiveRow* heaviest() const;
    /// The answer where its bound is moved by `shift` of its scale. Nullopt: rounding may hide whether there
    /// are motions.
    [[nodiscard]] std::optional<KnownAnswer> contradiction(double shift) const;

 private:
    struct Part {
        const PiecewiseSpace* space;
        const Eigen::VectorXd* motion;
        Eigen::Index first, first_direction;
    };
    struct Row {
        ActiveRow* row;
        Eigen::Index first;  ///< coefficient of its gradient
        std::size_t part;
    };
    /// How a row changes with the changes of all motions.
    [[nodiscard]] Eigen::VectorXd on_directions(const Eigen::VectorXd& gradient, Eigen::Index first) const;
    /// Of a vector of all coefficients.
    [[nodiscard]] Eigen::VectorXd weighted_sum() const;
    [[nodiscard]] double sensitivity(const Eigen::VectorXd& sum) const;
    [[nodiscard]] double drift() const;
    /// Of all motions, to the next ones of their spaces.
    [[nodiscard]] Eigen::VectorXd correction() const;
    [[nodiscard]] double reach() const;
    void judge_growth(double lipschitz, KnownAnswer& answer) const;

    std::vector<Part> parts_;
    std::vector<Row> rows_;
    Eigen::Index size_ = 0, freedom_ = 0;
};

}  // namespace camopt::soak
