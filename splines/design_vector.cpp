// SPDX-License-Identifier: MIT
#include "splines/design_vector.hpp"

#include "core/errors.hpp"
#include "splines/design_forms.hpp"

namespace camopt {

namespace {
// A weight smaller than this relative to the row's largest is round-off.
constexpr double negligible = 1e-15;
}  // namespace

DesignVector DesignVector::make(const DesignRequest& request) {
    if (request.symmetry != Symmetry::none && !request.space.is_symmetric())
        throw InputError("symmetry: the breakpoints are not symmetric about the middle");
    DesignForm form = raw_form(request);
    DesignVector design(request.space);
    design.kind_ = request.kind;
    design.symmetry_ = request.symmetry;
    design.begin_state_ = request.begin_state;
    design.end_state_ = request.end_state;

    // Entries of known value leave the vector; the others are renumbered.
    std::vector<int> new_index(form.entries.size(), -1);
    for (std::size_t j = 0; j < form.entries.size(); ++j) {
        if (form.entries[j].fixed) continue;
        new_index[j] = static_cast<int>(design.names_.size());
        design.names_.push_back(form.entries[j].name);
        design.orders_.push_back(form.entries[j].order);
        design.places_.push_back(form.entries[j].place);
    }

    ConditionSelection selection;
    // Nothing to select if the ends are free and no points are requested: the usual case, at any size.
    if (!request.conditions.empty() || request.space.dimension() < 6) selection = select_conditions(request);
    design.redundant_ = std::move(selection.redundant);
    design.contradictions_ = std::move(selection.contradictions);
    std::vector<AffineRow> known;
    for (const Equality& equality : form.rows) {
        known.push_back(without_fixed(equality.row, form, new_index));
        design.add_equality({known.back(), equality.name});
    }
    for (const auto* conditions : {&form.leftover, &selection.kept}) {
        for (const PointCondition& condition : *conditions) {
            Equality row{condition_row(form, request.space, condition, new_index), condition.name};
            row = unlike(std::move(row), known);
            known.push_back(row.row);
            design.add_equality(std::move(row));
        }
    }
    for (LocalMap& map : form.maps) design.maps_.push_back(without_fixed(std::move(map), form, new_index));
    return design;
}

void DesignVector::add_equality(Equality equality) {
    const AffineRow& row = equality.row;
    double largest = 0.0;
    for (const double weight : row.weights) largest = std::max(largest, std::abs(weight));
    if (largest == 0.0) return;  // all its entries are fixed: no condition remains
    const double rounding = kind_ == DesignKind::ordinates ? 0.0 : negligible * largest;
    AffineRow kept{row.offset, {}, {}};
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        if (std::abs(row.weights[k]) <= rounding) continue;
        kept.columns.push_back(row.columns[k]);
        kept.weights.push_back(row.weights[k]);
    }
    if (kept.columns.size() == 1) fixed_entries_.push_back(kept.columns[0]);
    equality.row = std::move(kept);
    equalities_.push_back(std::move(equality));
}

AffineRow DesignVector::functional(double x, int order, Side side) const {
    const int segment = space_.segment_of(x, side);
    return functional_of(maps_[segment], x - space_.breakpoints()[segment], order);
}

SplineCurve DesignVector::curve(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd pieces(space_.degree() + 1, space_.segments());
    for (int i = 0; i < space_.segments(); ++i) pieces.col(i) = maps_[i].polynomial(x);
    return {space_, std::move(pieces)};
}

std::vector<int> DesignVector::reported_entries() const {
    std::vector<int> entries;
    for (int j = 0; j < size(); ++j) {
        if (kind_ == DesignKind::ordinates) {
            const bool mirrored = symmetry_ != Symmetry::none && 2 * places_[j] > space_.segments();
            const bool fixed = std::ranges::find(fixed_entries_, j) != fixed_entries_.end();
            if (mirrored || fixed || static_cast<int>(entries.size()) >= freedom()) continue;
        }
        entries.push_back(j);
    }
    return entries;
}

Eigen::VectorXd DesignVector::values_of(const SplineCurve& curve) const {
    Eigen::VectorXd values(size());
    const Eigen::VectorXd coefficients =
        kind_ == DesignKind::coefficients ? curve.coefficients() : Eigen::VectorXd();
    for (int j = 0; j < size(); ++j)
        values[j] = kind_ == DesignKind::coefficients
                        ? coefficients[places_[j]]
                        : curve.derivative(space_.breakpoints()[places_[j]], orders_[j]);
    return values;
}

Eigen::VectorXd DesignVector::entry_bounds(const Eigen::MatrixXd& derivative_bounds) const {
    const int last_segment = space_.segments() - 1;
    const int p = space_.degree();
    Eigen::VectorXd bounds(size());
    for (int j = 0; j < size(); ++j) {
        if (kind_ != DesignKind::coefficients) {
            const int right = std::min(places_[j], last_segment);
            const int left = std::max(places_[j] - 1, 0);
            bounds[j] = std::min(derivative_bounds(orders_[j], left), derivative_bounds(orders_[j], right));
            continue;
        }
        const int step = p - space_.continuity();
        bounds[j] = std::numeric_limits<double>::infinity();
        const int first = places_[j] <= p ? 0 : (places_[j] - p + step - 1) / step;
        for (int i = first; i <= std::min(places_[j] / step, last_segment); ++i) {
            const Eigen::RowVectorXd weights = blossom_weights(space_, places_[j], i);
            double bound = 0.0;
            double factorial = 1.0;
            for (int m = 0; m <= p; ++m) {
                if (m > 0) factorial *= m;
                // 0 · ∞ is not a bound: a weight of zero does not constrain an unbounded derivative.
                if (weights[m] != 0.0) bound += std::abs(weights[m]) * derivative_bounds(m, i) / factorial;
            }
            bounds[j] = std::min(bounds[j], bound);
        }
    }
    return bounds;
}

}  // namespace camopt
