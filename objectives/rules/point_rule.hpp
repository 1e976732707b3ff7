// SPDX-License-Identifier: MIT
// A rule at one cam angle: g(y, y', y'', y'''; q) <= 0 for every x.
//
// A rule depends on one point of the motion and a few parameters q (the peak variables, the cam's
// dimensions), in their normalised units, and gives its value with first and second partials. It is
// independent of the design vector: constant sparse maps apply the chain rule (cam_problem.hpp).
#pragma once

#include "core/errors.hpp"
#include "core/nlp.hpp"
#include "core/numbers/enclosures.hpp"
#include "splines/motion_family.hpp"

namespace camopt {

/// Partials by (y, y', y'', y''', q_1 … q_m): gradient 4 + m, hessian (4 + m) x (4 + m), symmetric.
struct RuleValue {
    double value = 0.0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
    double by_place = 0.0;  ///< partial by x alone, for rules that depend on it explicitly
};

/// The admissible values of y'.
struct SlopeRange {
    double least = -infinity, most = infinity;
};

class WholeMotionRule;

/// What a rule says of itself, besides its formula.
struct RuleData {
    std::string name;                  ///< of a limit of the scene: its key as written by the user
    int highest_order = 3;             ///< derivative of y in the formula: where it jumps, the rule may jump
    bool limit = true;                 ///< of the user's scene, as opposed to a peak variable's definition
    bool linear = false;               ///< affine in the point and in q: its continuous maxima are then exact
    std::vector<int> parameters = {};  ///< of the problem: which of them are q_1 … q_m
    int sign = 0;                      ///< of its rows, as remark and fields (RowOrigin)
    std::string remark = {};
    RowFields fields = {};            ///< without a key: the name is the key
    double scale = 1.0;               ///< a value of this is a violation of 100 %; > 0
    std::vector<double> places = {};  ///< x where alone it holds, ascending; empty: at every cam angle
    std::array<double, 2> between = {-infinity, infinity};  ///< x between which it holds, both included
    /// The first grid has no rows of it: most motions satisfy it anyway, and the exchange adds violated rows.
    bool starts_without_rows = false;
};

class PointRule {
 public:
    virtual ~PointRule() = default;
    /// This rule, if it depends on more than one point.
    [[nodiscard]] virtual const WholeMotionRule* whole() const { return nullptr; }
    [[nodiscard]] const std::string& name() const { return data_.name; }
    /// Of the rows that enforce it, without a location.
    [[nodiscard]] RowOrigin origin() const {
        RowOrigin origin{data_.name,  data_.remark,        {},         Side::right,
                         data_.limit, data_.highest_order, data_.sign, data_.fields};
        if (origin.fields.key.empty()) origin.fields.key = data_.name;
        return origin;
    }
    [[nodiscard]] const std::vector<int>& parameters() const { return data_.parameters; }
    [[nodiscard]] bool linear() const { return data_.linear; }
    [[nodiscard]] int highest_order() const { return data_.highest_order; }
    [[nodiscard]] bool limit() const { return data_.limit; }
    [[nodiscard]] const std::vector<double>& places() const { return data_.places; }
    [[nodiscard]] const std::array<double, 2>& holds_between() const { return data_.between; }
    [[nodiscard]] bool starts_without_rows() const { return data_.starts_without_rows; }
    [[nodiscard]] double scale() const { return data_.scale; }
    /// `least`, `most`: extremes of y over the motions in question; ±infinity: unknown.
    [[nodiscard]] virtual Curvature curvature(double /*least*/, double /*most*/) const {
        return linear() ? Curvature::linear : Curvature::general;
    }
    /// For any y, with the parameters at their values; everything if the rule has parameters.
    [[nodiscard]] virtual SlopeRange slope_range() const { return {}; }
    /// Its scale at one location; 0 where conditions of the motion make the rule active.
    [[nodiscard]] virtual double scale_at(double /*x*/) const { return scale(); }
    /// Round-off of its value, of a rule whose scale at some locations is far below scale().
    [[nodiscard]] virtual double rounding() const { return 0.0; }
    /// Along a piece on which y to its third derivative are the polynomials `derivatives` of one variable:
    /// the rule as a polynomial of it, whose maxima are then exact. Nullopt if it is not one; optional for
    /// linear rules.
    [[nodiscard]] virtual Eigen::VectorXd along(const std::array<Eigen::VectorXd, 4>& /*derivatives*/,
                                                const Eigen::VectorXd& /*q*/) const {
        return {};
    }
    /// Along a stretch `x` on which y to its fourth derivative lie in `derivatives`: enclosures of the rule,
    /// its slope and its second derivative by x. Returns nullopt if no enclosure is implemented: the maxima
    /// are then sampled.
    [[nodiscard]] virtual std::optional<RangeAlong> range_along(
        const Interval& /*x*/, const std::array<Interval, 5>& /*derivatives*/,
        const Eigen::VectorXd& /*q*/) const {
        return {};
    }
    /// Over a box of (y, y', y'', y''', q_1 … q_m), for every x in `at`: enclosures of the rule times a
    /// positive factor, with its partials. The rule chooses a factor that reduces curvature. Returns nullopt
    /// if no enclosure is implemented; bounds then omit the rule.
    [[nodiscard]] virtual std::optional<RangeOver> range_over(std::span<const Interval> /*box*/,
                                                              const Interval& /*at*/) const {
        return {};
    }
    [[nodiscard]] virtual RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const = 0;

 protected:
    explicit PointRule(RuleData data) : data_(std::move(data)) {}
    PointRule(const PointRule&) = default;
    PointRule& operator=(const PointRule&) = default;

 private:
    RuleData data_;
};

// A rule over the whole motion, linear in it (or quadratic and convex): g(motion; q; setting) <= 0 for every
// setting.
//
// A setting identifies a row besides its location: a speed of the cam, a direction. Rows are added where the
// rule is largest over locations and settings together.

class WholeMotionRule final : public PointRule {
 public:
    struct Place {
        Extremum where;
        std::vector<double> setting;
    };
    using Setting = std::span<const double>;

    struct Parts {
        /// The local maxima along the motion over all settings, the largest among them, at q = 0; those below
        /// q may be left out.
        std::function<std::vector<Place>(const Motion&, double q)> maxima;
        /// The rule at q = 0 by the entries of the family; none: it is quadratic.
        std::function<AffineRow(const MotionFamily&, double at, Side, Setting)> row = {};
        /// The rows of the first grid: so many that a motion that satisfies them is nearly feasible between
        /// them. Values do not count.
        std::vector<Place> first = {{{0.0, 0.0}, {0.0}}};
        bool is_one_row = false;  ///< that of `first`: no motion needs another
        /// Further settings whose rows are added together with those of this one.
        std::function<std::vector<std::vector<double>>(Setting)> beside = {};
        std::function<std::string(Setting)> remark = {};  ///< identifies the row: "310 rpm"
        /// The same as numbers, as RowFields::which.
        std::function<std::map<std::string, double>(Setting)> which = {};
        /// Of a rule that is quadratic: (form − 1) / 2, a convex form of the entries of the family, one row.
        std::function<QuadraticForm(const MotionFamily&)> form = {};
    };

    WholeMotionRule(RuleData data, Parts parts) : PointRule(std::move(data)), parts_(std::move(parts)) {}

    /// q as in evaluate(), or none: 0.
    [[nodiscard]] std::vector<Place> maxima(const Motion& motion, const Eigen::VectorXd& q) const {
        const double own = q.size() > 0 ? q[0] : 0.0;
        std::vector<Place> places = parts_.maxima(motion, own);
        for (Place& place : places) place.where.value -= own;
        return places;
    }
    [[nodiscard]] AffineRow row(const MotionFamily& family, double at, Side side, Setting setting) const {
        if (!parts_.row) throw ModelError(name() + ": a quadratic rule has no linear row");
        return parts_.row(family, at, side, setting);
    }
    [[nodiscard]] const std::vector<Place>& first() const { return parts_.first; }
    [[nodiscard]] bool is_one_row() const { return parts_.is_one_row; }
    [[nodiscard]] std::vector<std::vector<double>> beside(Setting setting) const {
        return parts_.beside ? parts_.beside(setting) : std::vector<std::vector<double>>{};
    }
    [[nodiscard]] std::string remark(Setting setting) const {
        return parts_.remark ? parts_.remark(setting) : std::string();
    }
    [[nodiscard]] std::map<std::string, double> which(Setting setting) const {
        return parts_.which ? parts_.which(setting) : std::map<std::string, double>();
    }
    [[nodiscard]] std::optional<QuadraticForm> form(const MotionFamily& family) const {
        return parts_.form ? std::optional(parts_.form(family)) : std::nullopt;
    }

    [[nodiscard]] const WholeMotionRule* whole() const override { return this; }
    [[nodiscard]] Curvature curvature(double, double) const override {
        return linear() ? Curvature::linear : Curvature::convex;
    }
    /// It does not depend on a single point; throws ModelError.
    [[nodiscard]] RuleValue evaluate(const MotionPoint&, const Eigen::VectorXd&) const override {
        throw ModelError(name() + ": a rule of the whole motion was evaluated at a single point");
    }

 private:
    Parts parts_;
};

}  // namespace camopt
