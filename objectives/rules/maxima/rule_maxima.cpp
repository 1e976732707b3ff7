// SPDX-License-Identifier: MIT
#include "objectives/rules/maxima/rule_maxima.hpp"

#include <iterator>

namespace camopt {

namespace {

// Samples of the slope on one piece without an enclosure of the rule: a spline's is short and smooth, a law's
// may be the whole segment.
constexpr int samples_on_spline = 8;
constexpr int samples_on_shape = 32;
// Candidates closer than this in value at one location coincide: the rule does not jump there.
constexpr double same_value = 1e-12;
// Relative to a rule's scale: maxima this far below the largest, and below 0, are irrelevant.
constexpr double far_below = 0.1;
// Relative to a rule's scale: accuracy of an enclosed maximum. A tenth of the tightest usual tolerance.
constexpr double enclosed_accuracy = 1e-10;

using piece_maxima::Effort;
using piece_maxima::SmoothPiece;
using piece_maxima::Stretch;
using piece_maxima::Subject;

/// A rule along pieces on which y is a polynomial of x − begin.
class RuleOnPolynomial {
 public:
    /// datum: the origin of y.
    RuleOnPolynomial(const PointRule& rule, const Eigen::VectorXd& q, double datum) : rule_(rule), q_(q) {
        if (!rule.linear()) return;
        affine_ = rule.evaluate({0.0, {-datum, 0.0, 0.0, 0.0}}, q);
        while (lowest_ < 3 && affine_->gradient[lowest_] == 0.0) ++lowest_;
    }

    /// Empty if it is not a polynomial. Valid until the next call.
    [[nodiscard]] const Eigen::VectorXd& along(const Eigen::Ref<const Eigen::VectorXd>& y) {
        if (!affine_) {
            std::array<Eigen::VectorXd, 4> derivatives;
            for (int order = 0; order < 4; ++order) derivatives[order] = differentiated(y, order);
            return polynomial_ = rule_.along(derivatives, q_);
        }
        polynomial_.setZero(terms(y, lowest_));
        polynomial_[0] = affine_->value;
        for (int order = lowest_; order < 4; ++order) {
            if (affine_->gradient[order] == 0.0) continue;
            derivative_.resize(terms(y, order));
            differentiate(y, order, derivative_);
            polynomial_.head(derivative_.size()) += affine_->gradient[order] * derivative_;
        }
        return polynomial_;
    }

 private:
    const PointRule& rule_;
    const Eigen::VectorXd& q_;
    std::optional<RuleValue> affine_;  ///< of a linear rule
    int lowest_ = 0;                   ///< the lowest derivative in it
    Eigen::VectorXd polynomial_, derivative_;

    static Eigen::Index terms(const Eigen::Ref<const Eigen::VectorXd>& y, int order) {
        return std::max<Eigen::Index>(1, y.size() - order);
    }
};

void add_candidates_on_spline(const SplineCurve& curve, const Eigen::VectorXd& polynomial,
                              const MotionFamily::Piece& piece, double shift, std::vector<Extremum>& all) {
    const std::size_t first = all.size();
    const std::vector<double>& breakpoints = curve.space().breakpoints();
    add_candidates(breakpoints[piece.segment], breakpoints[piece.segment + 1], polynomial, all);
    // Clamped to the piece against round-off.
    for (std::size_t k = first; k < all.size(); ++k)
        all[k].at = std::clamp(all[k].at - shift, piece.begin, piece.end);
}

/// Keeps the local maxima of ascending candidates; where two pieces join without a jump they count once.
std::vector<Extremum> maxima_among(const std::vector<Extremum>& candidates) {
    std::vector<Extremum> single;
    single.reserve(candidates.size());
    for (const Extremum& candidate : candidates) {
        if (!single.empty() && std::abs(single.back().at - candidate.at) <= same_value) {
            const double jump = std::abs(single.back().value - candidate.value);
            if (jump <= same_value * std::max(1.0, std::abs(candidate.value))) continue;
        }
        single.push_back(candidate);
    }
    std::vector<Extremum> maxima;
    for (std::size_t k = 0; k < single.size(); ++k) {
        // Undefined values are kept: they count as infinite violations, and so do their neighbours.
        const bool above_left = k == 0 || !(single[k].value < single[k - 1].value);
        const bool above_right = k + 1 == single.size() || !(single[k].value < single[k + 1].value);
        if (above_left && above_right) maxima.push_back(single[k]);
    }
    return maxima;
}

void append(std::vector<Extremum>& all, std::vector<Extremum> more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// Of a rule that holds at a few angles only.
std::vector<Extremum> at_places(const Subject& subject) {
    std::vector<Extremum> all;
    for (const double x : subject.rule.places()) {
        const Side side = x < subject.motion.end() ? Side::right : Side::left;
        all.push_back({subject.value(x, side), x, side});
    }
    return all;
}

/// Maxima on pieces where y is a polynomial but the rule is not: enclosed if possible, else sampled. Pieces
/// are collected first, so that the largest of their ends is known and excludes most of the motion.
class CurvedPieces {
 public:
    explicit CurvedPieces(const Subject& subject) : subject_(subject) {}

    /// The candidates of the piece become `all`'s next entries.
    void add(SmoothPiece piece, std::vector<Extremum>& all) {
        const Stretch& ends = piece.piece;
        all.push_back({subject_.value(ends.begin, Side::right), ends.begin, Side::right});
        all.push_back({subject_.value(ends.end, Side::left), ends.end, Side::left});
        pieces_.push_back(std::move(piece));
    }
    /// False: some piece could not be enclosed, and was sampled.
    bool finish(std::vector<Extremum>& all) const {
        if (pieces_.empty()) return true;
        bool complete = true;
        const double scale = subject_.rule.scale();
        double largest = -infinity;
        for (const Extremum& end : all) largest = std::max(largest, end.value);
        const double floor = std::min(0.0, largest) - far_below * scale;
        Effort effort = Effort::of(pieces_.size());
        for (const SmoothPiece& piece : pieces_) {
            if (auto inside =
                    piece_maxima::enclosed(subject_, piece, floor, enclosed_accuracy * scale, effort)) {
                append(all, std::move(*inside));
            } else {
                const int samples = piece.part ? samples_on_shape : samples_on_spline;
                append(all, piece_maxima::sampled(subject_, piece.piece, samples, effort));
                complete = false;
            }
        }
        // Where two pieces join, the left one's end comes first.
        std::ranges::stable_sort(all, [](const Extremum& one, const Extremum& other) {
            return one.at != other.at ? one.at < other.at
                                      : one.side == Side::left && other.side == Side::right;
        });
        return complete;
    }

 private:
    const Subject& subject_;
    std::vector<SmoothPiece> pieces_;
};

/// The displacement that is the origin of y for a placed rule.
double datum_of(const PlacedRule& rule, const MotionFamily& family, const MotionChain& motion) {
    if (rule.datum == PlacedRule::Datum::zero) return 0.0;
    const MotionFamily::Stretch& stretch = family.stretches()[rule.stretch];
    return rule.datum == PlacedRule::Datum::begin ? motion.at(stretch.begin, Side::right).derivative[0]
                                                  : motion.at(stretch.end, Side::left).derivative[0];
}

/// Of a rule that holds on a part of the motion: its ends replace what lies outside.
std::vector<Extremum> inside(const std::array<double, 2>& range, const Subject& subject,
                             std::vector<Extremum> all) {
    const double from = range[0], until = range[1];
    if (from == -infinity && until == infinity) return all;
    std::erase_if(all, [&](const Extremum& one) {
        return one.at < from || one.at > until || (one.at == from && one.side == Side::left) ||
               (one.at == until && one.side == Side::right);
    });
    const auto add = [&](auto where, double x, Side side) {
        if (x >= subject.motion.begin() && x <= subject.motion.end())
            all.insert(where, {subject.value(x, side), x, side});
    };
    add(all.begin(), from, Side::right);
    add(all.end(), until, Side::left);
    return all;
}

}  // namespace

// A spline as polynomials of x − begin.
std::vector<SmoothPiece> piece_maxima::pieces_of(const ChainPart& part) {
    if (!part.shape) return {{{part.begin, part.end}, Eigen::VectorXd::Constant(1, part.y0)}};
    std::vector<SmoothPiece> pieces;
    const auto* curve = dynamic_cast<const SplineCurve*>(part.shape.get());
    if (!curve || part.x_scale < 0.0) {
        std::vector<double> points = {part.begin, part.end};
        for (const double own : part.shape->breakpoints())
            points.push_back(std::clamp(part.x0 + part.x_scale * own, part.begin, part.end));
        std::ranges::sort(points);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            if (points[i + 1] - points[i] > same_value)
                pieces.push_back({{points[i], points[i + 1]}, {}, &part});
        return pieces;
    }
    const std::vector<double>& breakpoints = curve->space().breakpoints();
    for (int segment = 0; segment + 1 < static_cast<int>(breakpoints.size()); ++segment) {
        const auto at = static_cast<std::size_t>(segment);
        const double begin = part.x0 + part.x_scale * breakpoints[at];
        const double end = part.x0 + part.x_scale * breakpoints[at + 1];
        if (end <= part.begin + same_value || begin >= part.end - same_value)
            continue;  // of the adjacent part
        Eigen::VectorXd y = part.y_scale * curve->derivative_polynomial(segment, 0);
        for (int k = 0; k < static_cast<int>(y.size()); ++k) y[k] /= std::pow(part.x_scale, k);
        y[0] += part.y0;
        pieces.push_back({{begin, end}, std::move(y)});
    }
    return pieces;
}

std::vector<Extremum> rule_maxima(const PlacedRule& rule, const MotionFamily& family,
                                  const MotionChain& motion, const Eigen::VectorXd& q) {
    std::vector<Extremum> candidates;
    const Subject subject{*rule, motion, q};
    if (!rule->places().empty()) return at_places(subject);
    RuleOnPolynomial on_spline(*rule, q, datum_of(rule, family, motion));
    candidates.reserve(3 * family.pieces().size());
    CurvedPieces curved(subject);
    for (const MotionFamily::Piece& piece : family.pieces()) {
        if (!rule.holds_on(piece)) continue;
        const MotionFamily::Stretch& stretch = family.stretches()[piece.stretch];
        if (stretch.kind == StretchRequest::Kind::dwell) {
            const MotionPoint resting = motion.at(piece.begin);
            const RuleValue value = rule->evaluate(resting, q);
            if (value.by_place != 0.0)  // the follower rests, the cam's other parts do not
                curved.add({{piece.begin, piece.end}, Eigen::VectorXd::Constant(1, resting.derivative[0])},
                           candidates);
            else
                candidates.push_back({value.value, piece.begin, Side::right});
        } else if (stretch.kind == StretchRequest::Kind::spline) {
            const auto& curve = dynamic_cast<const SplineCurve&>(*motion.parts()[piece.stretch].shape);
            const Eigen::VectorXd& polynomial = on_spline.along(curve.pieces().col(piece.segment));
            if (polynomial.size() > 0) {
                add_candidates_on_spline(curve, polynomial, piece, stretch.shift, candidates);
            } else {
                curved.add({{piece.begin, piece.end}, curve.derivative_polynomial(piece.segment, 0)},
                           candidates);
            }
        } else {
            const ChainPart& part = motion.parts()[piece.stretch];
            curved.add({{piece.begin, piece.end}, {}, &part}, candidates);
        }
    }
    curved.finish(candidates);
    return maxima_among(inside({rule.from, rule.until}, subject, std::move(candidates)));
}

std::vector<Extremum> rule_maxima(const PointRule& rule, const Motion& motion, const Eigen::VectorXd& q) {
    return maxima_along(rule, motion, q).maxima;
}

MaximaAlong maxima_along(const PointRule& rule, const Motion& motion, const Eigen::VectorXd& q) {
    std::vector<Extremum> candidates;
    const Subject subject{rule, motion, q};
    if (!rule.places().empty()) return {at_places(subject)};
    CurvedPieces curved(subject);
    const auto* chain = dynamic_cast<const MotionChain*>(&motion);
    if (!chain) {
        const std::vector<double> points = motion.breakpoints();
        Effort effort = Effort::of(points.size());
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            append(candidates,
                   piece_maxima::sampled(subject, {points[i], points[i + 1]}, samples_on_shape, effort));
        return {maxima_among(inside(rule.holds_between(), subject, std::move(candidates))), false};
    }
    RuleOnPolynomial on_polynomial(rule, q, 0.0);
    const auto add = [&](SmoothPiece& piece) {
        const bool empty = piece.y.size() == 0;
        const Eigen::VectorXd& polynomial = empty ? piece.y : on_polynomial.along(piece.y);
        if (polynomial.size() > 0)
            add_candidates(piece.piece.begin, piece.piece.end, polynomial, candidates);
        else
            curved.add(std::move(piece), candidates);
    };
    for (const ChainPart& part : chain->parts())
        for (SmoothPiece& piece : piece_maxima::pieces_of(part)) add(piece);
    const bool complete = curved.finish(candidates);
    return {maxima_among(inside(rule.holds_between(), subject, std::move(candidates))), complete};
}

Extremum largest_of(const std::vector<Extremum>& maxima) {
    Extremum largest{-infinity, 0.0, Side::right};
    for (const Extremum& maximum : maxima) {
        // Undefined counts as an infinite violation.
        if (std::isnan(maximum.value)) return {infinity, maximum.at, maximum.side};
        if (maximum.value > largest.value) largest = maximum;
    }
    return largest;
}

Extremum extreme_of(const LinearBound& bound, const Motion& motion) {
    LinearBound plain = bound;
    plain.bound = 0.0;
    plain.scale = 1.0;
    return largest_of(rule_maxima(LinearRule(plain), motion, {}));
}

}  // namespace camopt
