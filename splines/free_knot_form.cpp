// SPDX-License-Identifier: MIT
#include "splines/free_knot_form.hpp"

#include "core/errors.hpp"
#include "core/nlp.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr std::array<const char*, 6> derivative_name = {"y", "y'", "y''", "y'''", "y''''", "y'''''"};
// Locations closer than this part of the motion coincide.
constexpr double same_place = 1e-12;

}  // namespace

FreeKnotForm::FreeKnotForm(const DesignRequest& request, double least_part)
    : space_(request.space),
      symmetry_(request.symmetry),
      sum_(request.begin_state[0] + request.end_state[0]) {
    const int all = space_.segments();
    const bool half = symmetry_ != Symmetry::none;
    if (half && !space_.is_symmetric())
        throw InputError("breakpoints: found ones that are not symmetric; allowed: symmetric ones");
    segments_ = half ? (all + 1) / 2 : all;
    end_ = half ? 0.5 * (space_.begin() + space_.end()) : space_.end();
    least_ = least_part * mean_length();
    for (int i = 0; i < all; ++i) least_ = std::min(least_, space_.width(i));
    lower_ = Eigen::VectorXd::Constant(size(), -infinity);
    upper_ = Eigen::VectorXd::Constant(size(), infinity);
    double before = begin();
    for (int k = 1; k < segments_; ++k) {
        before += least_length(k - 1);
        lower_[breakpoint(k)] = before;
    }
    double after = end_;
    for (int k = segments_ - 1; k >= 1; --k) {
        after -= least_length(k);
        upper_[breakpoint(k)] = after;
    }
    add_ends(request);
    for (const PointCondition& condition : request.conditions) add_condition(condition);
    add_joints();
}

double FreeKnotForm::least_length(int segment) const {
    const bool cut = symmetry_ != Symmetry::none && space_.segments() % 2 == 1 && segment == segments_ - 1;
    return cut ? 0.5 * least_ : least_;
}

void FreeKnotForm::add_ends(const DesignRequest& request) {
    for (int order = 0; order < 3; ++order) fix(coefficient(0, order), request.begin_state[order]);
    const FreePlace last{segments_ - 1, true, 1.0};
    if (symmetry_ == Symmetry::none) {
        for (int order = 0; order < 3; ++order)
            add_equality(
                last, order, request.end_state[order],
                fmt::format("{}({:.6g}) = {:.6g}", derivative_name[order], end_, request.end_state[order]));
        return;
    }
    // Where mirroring changes the sign, the value in the middle is half the offset; if the middle is not a
    // breakpoint, this holds for all derivatives.
    const int highest = space_.segments() % 2 == 0 ? continuity() : degree();
    for (int order = 0; order <= highest; ++order) {
        if (mirror_sign(order) > 0.0) continue;
        add_equality(last, order, 0.5 * mirror_offset(order),
                     fmt::format("symmetry of {} in the middle", derivative_name[order]));
    }
}

void FreeKnotForm::add_joints() {
    for (int i = 0; i + 1 < segments_; ++i) {
        for (int order = 0; order <= continuity(); ++order)
            equalities_.push_back(
                {{i, true, 1.0},
                 order,
                 coefficient(i + 1, order),
                 0.0,
                 fmt::format("continuity of derivative {} at breakpoint {}", order, i + 1)});
    }
}

void FreeKnotForm::add_condition(const PointCondition& condition) {
    double at = condition.at;
    double value = condition.value;
    Side side = condition.side;
    const double same = same_place * (whole_end() - begin());
    if (symmetry_ != Symmetry::none && at > end_ + same) {
        at = begin() + whole_end() - at;
        value = mirror_sign(condition.order) * (value - mirror_offset(condition.order));
        side = side == Side::left ? Side::right : Side::left;
    }
    if (at <= begin() + same) {
        if (condition.order >= 3) add_equality({0, true, 0.0}, condition.order, value, condition.name);
        return;  // the rest is the state at the start
    }
    if (at >= end_ - same) {
        add_equality({segments_ - 1, true, 1.0}, condition.order, value, condition.name);
        return;
    }
    const int segment = std::min(space_.segment_of(at, side), segments_ - 1);
    add_equality({segment, false, at}, condition.order, value, condition.name);
    if (const int left = breakpoint(segment); left >= 0) upper_[left] = std::min(upper_[left], at);
    if (const int right = breakpoint(segment + 1); right >= 0) lower_[right] = std::max(lower_[right], at);
}

/// Omits duplicates: a symmetric motion states many conditions twice.
void FreeKnotForm::add_equality(const FreePlace& place, int order, double value, const std::string& name) {
    const bool known = std::ranges::any_of(equalities_, [&](const FreeEquality& other) {
        return other.order == order && other.place.segment == place.segment &&
               other.place.moves == place.moves && std::abs(other.place.at - place.at) <= same_place;
    });
    if (!known) equalities_.push_back({place, order, -1, value, name});
}

std::string FreeKnotForm::name(int entry) const {
    const int first = (degree() + 1) * segments_;
    if (entry >= first) return fmt::format("x[{}]", entry - first + 1);
    return fmt::format("{}[{}]", derivative_name[order(entry)], entry / (degree() + 1));
}

double FreeKnotForm::breakpoint_at(const Eigen::VectorXd& x, int k) const {
    const int entry = breakpoint(k);
    if (entry >= 0) return x[entry];
    return k <= 0 ? begin() : end_;
}

double FreeKnotForm::power(double tau, int order, int m) {
    if (m < order) return 0.0;
    double value = 1.0;
    for (int k = 1; k <= m - order; ++k) value *= tau / k;
    return value;
}

FreePoint FreeKnotForm::point(const Eigen::VectorXd& x, const FreePlace& place) const {
    const double left = breakpoint_at(x, place.segment);
    FreePoint point;
    if (place.moves) {
        point.tau = place.at * (breakpoint_at(x, place.segment + 1) - left);
        point.by_left = -place.at;
        point.by_right = place.at;
    } else {
        point.tau = place.at - left;
        point.by_left = -1.0;
    }
    point.x = left + point.tau;
    const int p = degree();
    for (int r = 0; r <= p; ++r) {
        double& value = point.derivative[static_cast<std::size_t>(r)];
        for (int m = p; m >= r; --m) {  // Horner: a_m + τ/(m − r + 1) (a_{m+1} + …)
            value = x[coefficient(place.segment, m)] + point.tau / (m - r + 1) * value;
        }
    }
    return point;
}

double FreeKnotForm::mirror_sign(int order) const {
    const double parity = order % 2 == 0 ? 1.0 : -1.0;
    return symmetry_ == Symmetry::odd ? -parity : parity;
}

std::vector<double> FreeKnotForm::breakpoints(const Eigen::VectorXd& x) const {
    std::vector<double> modelled{begin()};
    for (int k = 1; k < segments_; ++k) {
        const int entry = breakpoint(k);
        const double wanted = std::clamp(x[entry], lower_[entry], upper_[entry]);
        modelled.push_back(std::max(wanted, modelled.back() + least_length(k - 1)));
    }
    modelled.push_back(end_);
    for (int k = segments_ - 1; k >= 1; --k) {
        double& own = modelled[static_cast<std::size_t>(k)];
        own = std::min(own, modelled[static_cast<std::size_t>(k) + 1] - least_length(k));
    }
    if (symmetry_ == Symmetry::none) return modelled;
    const int all = space_.segments();
    if (all % 2 == 1) modelled.pop_back();
    for (int k = static_cast<int>(modelled.size()); k <= all; ++k)
        modelled.push_back(begin() + whole_end() - modelled[static_cast<std::size_t>(all - k)]);
    return modelled;
}

SplineCurve FreeKnotForm::curve(const Eigen::VectorXd& x) const {
    const int all = space_.segments();
    Eigen::VectorXd kept = x.head(size());
    const std::vector<double> points = breakpoints(x);
    for (int k = 1; k < segments_; ++k) kept[breakpoint(k)] = points[static_cast<std::size_t>(k)];
    Eigen::MatrixXd pieces(degree() + 1, all);
    for (int i = 0; i < all; ++i) {
        const bool mirrored = i >= segments_;
        const int source = mirrored ? all - 1 - i : i;
        const FreePoint left = point(kept, {source, true, mirrored ? 1.0 : 0.0});
        for (int m = 0; m <= degree(); ++m) {
            double derivative = left.derivative[static_cast<std::size_t>(m)];
            if (mirrored) derivative = mirror_sign(m) * derivative + mirror_offset(m);
            pieces(m, i) = power(1.0, 0, m) * derivative;
        }
    }
    return {SplineSpace(degree(), continuity(), points), std::move(pieces)};
}

Eigen::VectorXd FreeKnotForm::values_of(const SplineCurve& curve) const {
    Eigen::VectorXd x(size());
    for (int i = 0; i < segments_; ++i) {
        for (int m = 0; m <= degree(); ++m) x[coefficient(i, m)] = curve.pieces()(m, i) / power(1.0, 0, m);
        if (breakpoint(i) >= 0) x[breakpoint(i)] = curve.breakpoints()[static_cast<std::size_t>(i)];
    }
    return x;
}

SegmentEnergy segment_energy(const FreeKnotForm& form, const Eigen::VectorXd& x, int segment, int order) {
    const FreePoint end = form.point(x, {segment, true, 1.0});
    const double h = end.tau;
    const int terms = form.degree() - order + 1;
    const int left = terms, right = terms + 1;
    Eigen::VectorXd a(terms);
    for (int k = 0; k < terms; ++k) a[k] = x[form.coefficient(segment, order + k)];
    Eigen::MatrixXd gram(terms, terms);
    for (int k = 0; k < terms; ++k) {
        for (int l = 0; l < terms; ++l)
            gram(k, l) = h * FreeKnotForm::power(h, 0, k) * FreeKnotForm::power(h, 0, l) / (k + l + 1);
    }
    SegmentEnergy energy{a.dot(gram * a), Eigen::VectorXd::Zero(terms + 2),
                         Eigen::MatrixXd::Zero(terms + 2, terms + 2)};
    const double at_end = end.derivative[static_cast<std::size_t>(order)];
    const double next = end.derivative[static_cast<std::size_t>(order) + 1];
    energy.slope.head(terms) = 2.0 * gram * a;
    energy.slope[right] = at_end * at_end;
    energy.slope[left] = -energy.slope[right];
    energy.curvature.topLeftCorner(terms, terms) = 2.0 * gram;
    for (int k = 0; k < terms; ++k) {
        const double mixed = 2.0 * at_end * FreeKnotForm::power(h, 0, k);
        energy.curvature(k, right) = energy.curvature(right, k) = mixed;
        energy.curvature(k, left) = energy.curvature(left, k) = -mixed;
    }
    const double by_length = 2.0 * at_end * next;
    energy.curvature(left, left) = energy.curvature(right, right) = by_length;
    energy.curvature(left, right) = energy.curvature(right, left) = -by_length;
    return energy;
}

}  // namespace camopt
