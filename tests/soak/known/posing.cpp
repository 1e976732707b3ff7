// SPDX-License-Identifier: MIT
#include "tests/soak/known/posing.hpp"

#include "tests/soak/figures/law.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace camopt::soak {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd drawn_direction(Draw& draw, Index size) {
    VectorXd direction(size);
    for (double& entry : direction) entry = draw.between(-1.0, 1.0) + draw.between(-1.0, 1.0);
    return direction.normalized();
}

/// A vertex of |y''|, |y'''| <= caps of a cubic: from inside along random lines, each to the next cap.
VectorXd at_many_caps(Draw& draw, const Draft& draft, const VectorXd& start) {
    const PiecewiseSpace& space = draft.space;
    std::vector<VectorXd> rows;
    for (const Run& run : draft.runs)
        for (int piece = run.first; piece < run.first + run.pieces; ++piece) {
            const double angle = run.angle;
            rows.push_back(space.row(derivative_alone(2), piece, space.begin(piece)) *
                           (angle * angle / run.height));
            rows.push_back(space.row(derivative_alone(2), piece, space.end(piece)) *
                           (angle * angle / run.height));
            rows.push_back(space.row(derivative_alone(3), piece, space.begin(piece)) *
                           (angle * angle * angle / run.height));
        }
    const auto count = static_cast<Index>(rows.size());
    MatrixXd all(count, space.size());
    for (Index k = 0; k < count; ++k) all.row(k) = rows[static_cast<std::size_t>(k)].transpose();
    const MatrixXd on = all * space.directions();
    VectorXd motion = start, caps(count);
    const VectorXd values = all * start;
    const double bend = draw.between(1.01, 1.5), jerk = draw.between(1.01, 2.0);
    double most_bend = 0.0, most_jerk = 0.0;
    for (Index k = 0; k < count; ++k) {
        double& most = k % 3 == 2 ? most_jerk : most_bend;
        most = std::max(most, std::abs(values[k]));
    }
    for (Index k = 0; k < count; ++k) caps[k] = k % 3 == 2 ? jerk * most_jerk : bend * most_bend;
    MatrixXd free = MatrixXd::Identity(space.freedom(), space.freedom());
    const int steps = draw.whole(1, static_cast<int>(space.freedom()));
    for (int step = 0; step < steps && free.cols() > 0; ++step) {
        const VectorXd line = free * drawn_direction(draw, free.cols());
        const VectorXd slope = on * line, now = all * motion;
        double length = 1e300;
        Index hit = -1;
        for (Index k = 0; k < count; ++k) {
            if (std::abs(slope[k]) < 1e-9 * caps[k]) continue;
            const double to = ((slope[k] > 0.0 ? caps[k] : -caps[k]) - now[k]) / slope[k];
            if (to < length) {
                length = to;
                hit = k;
            }
        }
        if (hit < 0) break;
        motion += space.directions() * (std::max(0.0, length) * line);
        // What is left of the freedom keeps the row where it is.
        const MatrixXd held = free.transpose() * on.row(hit).transpose();
        MatrixXd basis = MatrixXd::Identity(free.cols(), free.cols());
        basis.applyOnTheLeft(Eigen::ColPivHouseholderQR<MatrixXd>(held).householderQ());
        free = (free * basis.rightCols(free.cols() - 1)).eval();
    }
    return motion;
}

VectorXd drawn_motion(Draw& draw, const Draft& draft) {
    const PiecewiseSpace& space = draft.space;
    VectorXd motion = space.smoothest();
    if (space.degree() == 3 && draw.chance(0.75)) return at_many_caps(draw, draft, motion);
    const VectorXd change = space.directions() * drawn_direction(draw, space.freedom());
    const double size = draw.sized(1e-3, 0.1);
    return motion + change * (size / change.lpNorm<Eigen::Infinity>());
}

}  // namespace

std::size_t Posing::run_of(int piece) const {
    const auto holds = [piece](const Run& run) { return piece < run.first + run.pieces; };
    const auto found = std::ranges::find_if(draft_.runs, holds);
    return std::min(static_cast<std::size_t>(found - draft_.runs.begin()), draft_.runs.size() - 1);
}

std::vector<Extreme> Posing::extremes_of(const Quantity& quantity) const {
    std::vector<Extreme> all;
    for (std::size_t k = 0; k < draft_.runs.size(); ++k) {
        const Run& run = draft_.runs[k];
        for (int piece = run.first; piece < run.first + run.pieces; ++piece) {
            for (Extreme one : draft_.space.extremes(motion_, quantity.of_run[k], piece)) {
                one.value += quantity.constant_in(k);
                all.push_back(one);
            }
        }
    }
    return all;
}

double Posing::size_of(const Combination& weights, const Extreme& at, double constant) const {
    double sum = std::abs(constant);
    for (std::size_t order = 0; order < weights.size(); ++order) {
        if (weights[order] == 0.0) continue;
        const auto derivative = [&](std::size_t r) {
            return draft_.space.row(derivative_alone(static_cast<int>(r)), at.piece, at.x).dot(motion_);
        };
        sum += std::abs(weights[order]) * (1.0 + static_cast<double>(order)) * std::abs(derivative(order));
        if (order + 1 < weights.size()) sum += std::abs(weights[order] * at.x * derivative(order + 1));
    }
    // Beside an end at rest the powers that a double adds up nearly cancel.
    long double terms = 0.0L, power = 1.0L;
    const long double t = (at.x - draft_.space.begin(at.piece)) / draft_.space.width(at.piece);
    for (const long double coefficient : draft_.space.polynomial(motion_, weights, at.piece)) {
        terms += std::abs(coefficient) * power;
        power *= t;
    }
    return std::max(sum, static_cast<double>(terms));
}

void Posing::add_terms() {
    for (std::size_t t = 0; t < draft_.terms.size(); ++t) {
        const CostTerm& term = draft_.terms[t];
        const std::vector<Extreme> found = extremes_of(term);
        double peak = std::abs(term.constant);
        for (const Extreme& one : found) peak = std::max(peak, std::abs(one.value));
        peaks_.push_back(peak);
        for (const Extreme& one : found) {
            const double value = one.value;
            if (std::abs(value) < peak * (1.0 - same_peak)) continue;
            const auto run = run_of(one.piece);
            ActiveRow row;
            row.of = ActiveRow::Of::term;
            row.owner = t;
            row.gradient = draft_.space.row(term.of_run[run], one.piece, one.x);
            row.sign = value > 0.0 ? 1.0 : -1.0;
            row.size = size_of(term.of_run[run], one, term.constant_in(run));
            row.gap = peak - std::abs(value);
            row.preference = 3.0 * draw_.between(0.5, 1.0);
            add(std::move(row));
        }
    }
}

void Posing::add_area() {
    const VectorXd integral = draft_.space.integral();
    lost_area_ = 1.0 - (integral.dot(motion_) + draft_.resting_area) / draft_.length;
    // A law's own lost area is 1/2 on strokes alone.
    const bool known_area =
        draft_.reference_law.empty() || (draft_.runs.size() == 1 && draft_.runs.front().table < 0);
    if (known_area && !draft_.advances && lost_area_ > 0.05 && draw_.chance(0.3)) {
        ActiveRow row;
        row.of = ActiveRow::Of::area;
        row.gradient = -integral / draft_.length;
        row.size = 1.0 + std::abs(lost_area_);
        row.preference = 2.0;
        add(std::move(row));
    }
}

/// A cost, or a limit: the mean square over the runs and the rests.
void Posing::add_root_mean_squares() {
    for (std::size_t k = 0; k < draft_.root_mean_squares.size(); ++k) {
        const RmsDraft& rms = draft_.root_mean_squares[k];
        PiecewiseSpace::Square sum{rms.rests * rms.constant * rms.constant,
                                   VectorXd::Zero(draft_.space.size())};
        double length = rms.rests;
        for (std::size_t r = 0; r < draft_.runs.size(); ++r) {
            const Run& run = draft_.runs[r];
            length += run.end - run.begin;
            draft_.space.add_square(motion_, rms.of_run[r], rms.constant_in(r), run.first, run.pieces, sum);
        }
        rms_.push_back(std::sqrt(sum.value / length));
        rms_bounds_.push_back(rms_.back());
        const bool limits = !rms.limit_key.empty() && draw_.chance(0.5);
        if (!draw_.chance(rms.chance) || (!feasible_ && !limits)) continue;
        ActiveRow row;
        row.of = limits ? ActiveRow::Of::rms_limit : ActiveRow::Of::rms;
        row.owner = k;
        row.gradient = sum.slope / (length * rms_.back());
        row.size = 4.0 * rms_.back();
        row.scale = rms_.back();
        row.preference = 2.0;
        add(std::move(row));
    }
}

void Posing::add_limits() {
    using Side = LimitDraft::Side;
    for (std::size_t l = 0; l < draft_.limits.size(); ++l) {
        const LimitDraft& limit = draft_.limits[l];
        const std::vector<Extreme> found = extremes_of(limit);
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const Extreme& one : found) {
            least = std::min(least, one.value);
            most = std::max(most, one.value);
        }
        const double edge = limit.side == Side::above   ? most
                            : limit.side == Side::below ? least
                                                        : std::max(most, -least);
        const double bound = limit.side == Side::below ? edge - limit.widening : edge + limit.widening;
        const bool rests = limit.side == Side::above ? limit.at_rest_most + limit.widening <= bound
                           : limit.side == Side::below
                               ? limit.at_rest_least - limit.widening >= bound
                               : std::max(limit.at_rest_most, -limit.at_rest_least) <= bound;
        const bool allowed = rests && bound > limit.must_exceed && (limit.side != Side::both || bound > 0.0);
        bounds_.push_back(allowed ? std::optional(bound) : std::nullopt);
        loosened_.push_back(0.0);
        if (!allowed) continue;
        const double slack = same_peak * std::max(std::abs(edge), 1e-300);
        for (const Extreme& one : found) {
            const double value = one.value;
            const bool high = limit.side != Side::below && value >= edge - slack;
            const bool low = (limit.side == Side::below && value <= edge + slack) ||
                             (limit.side == Side::both && -value >= edge - slack);
            if (!high && !low) continue;
            const auto run = run_of(one.piece);
            ActiveRow row;
            row.of = ActiveRow::Of::limit;
            row.owner = l;
            row.gradient = draft_.space.row(limit.of_run[run], one.piece, one.x);
            if (row.gradient.isZero(0.0)) continue;
            row.sign = high ? 1.0 : -1.0;
            row.size = size_of(limit.of_run[run], one, limit.constant_in(run));
            row.scale = std::max(most, -least);
            row.gap = std::abs(edge - (limit.side == Side::both ? std::abs(value) : value));
            row.preference = 2.0 * draw_.between(0.5, 1.0);
            add(std::move(row));
        }
    }
}

std::optional<Posing::Corridor> Posing::corridor_at(const Extreme& at, int order, bool above) {
    const PiecewiseSpace& space = draft_.space;
    const Run& run = draft_.runs[run_of(at.piece)];
    const double sign = above ? 1.0 : -1.0;
    Corridor corridor;
    corridor.order = order;
    corridor.above = above;
    if (order == space.degree()) {  // constant along the piece
        corridor.from = space.begin(at.piece) + 0.2 * space.width(at.piece);
        corridor.to = space.end(at.piece) - 0.3 * space.width(at.piece);
    }
    const double slope =
        order == space.degree() ? 0.0 : space.row(derivative_alone(order + 1), at.piece, at.x).dot(motion_);
    // Where the spline joins a law or another one, the far side counts too.
    const double inset = draft_.runs.size() > 1 || run.table >= 0 ? 1e-3 * (run.end - run.begin) : 0.0;
    double reach = space.width(at.piece) * draw_.sized(0.05, 1.5);
    const bool narrow = narrow_ && draw_.chance(0.3);
    if (narrow) reach = draw_.sized(1e-11, 1e-6);
    for (int tries = 0; tries < 8; ++tries, reach *= 0.4) {
        if (order < space.degree()) {
            const bool onward = sign * slope < 0.0;
            corridor.from = onward ? at.x : std::max(run.begin + inset, at.x - reach);
            corridor.to = onward ? std::min(run.end - inset, at.x + reach) : at.x;
        }
        if (corridor.to - corridor.from < (narrow ? 1e-12 : 1e-6)) return std::nullopt;
        double edge = -std::numeric_limits<double>::infinity();
        for (int piece = run.first; piece < run.first + run.pieces; ++piece) {
            const double low = std::max(corridor.from, space.begin(piece)),
                         high = std::min(corridor.to, space.end(piece));
            if (low > high) continue;
            for (const Extreme& one : space.extremes(motion_, derivative_alone(order), piece, low, high))
                edge = std::max(edge, sign * one.value);
        }
        if (edge > sign * at.value + 1e-13 * std::abs(at.value)) continue;
        corridor.bound = at.value + sign * draft_.made_error[static_cast<std::size_t>(order)];
        return corridor;
    }
    return std::nullopt;
}

void Posing::add_corridors() {
    const PiecewiseSpace& space = draft_.space;
    const int wanted = 3 * static_cast<int>(space.freedom()) + 4;
    std::array<double, 4> scales{};
    for (int order = 0; order <= 3; ++order)
        for (const Extreme& one :
             extremes_of({std::vector<Combination>(draft_.runs.size(), derivative_alone(order))}))
            scales[static_cast<std::size_t>(order)] =
                std::max(scales[static_cast<std::size_t>(order)], std::abs(one.value));
    for (int tries = 0; tries < wanted; ++tries) {
        const int piece = draw_.whole(0, space.pieces() - 1);
        const int order = draw_.chance(0.4) ? 0 : draw_.whole(1, std::min(3, draft_.continuity + 1));
        if (draft_.made_error[2] > 0.0 && order == 3) continue;  // tolerances of the jerk are not bounded
        Extreme at{space.begin(piece) + space.width(piece) * draw_.between(0.05, 0.95), piece, 0.0};
        at.value = space.row(derivative_alone(order), piece, at.x).dot(motion_);
        const bool above = draw_.chance(0.5);
        const std::optional<Corridor> corridor = corridor_at(at, order, above);
        if (!corridor) continue;
        ActiveRow row;
        row.of = ActiveRow::Of::corridor;
        row.owner = corridors_.size();
        row.gradient = space.row(derivative_alone(order), piece, at.x);
        row.sign = above ? 1.0 : -1.0;
        row.size = size_of(derivative_alone(order), at, 0.0);
        row.scale = scales[static_cast<std::size_t>(order)];
        row.preference = draw_.between(0.3, 1.0);
        corridors_.push_back(*corridor);
        corridor_loosened_.push_back(0.0);
        add(std::move(row));
    }
}

void Posing::add_value(Point& point, int piece, int order, double preference) {
    ActiveRow row;
    row.of = ActiveRow::Of::point;
    row.owner = points_.size();
    row.gradient = draft_.space.row(derivative_alone(order), piece, point.x);
    row.part = point.values.size();
    point.values.push_back({order, row.gradient.dot(motion_), false});
    row.size = size_of(derivative_alone(order), {point.x, piece, 0.0}, 0.0);
    row.preference = preference;
    row.free = true;
    add(std::move(row));
}

void Posing::add_points() {
    const PiecewiseSpace& space = draft_.space;
    if (!draft_.may_pass_points || draw_.chance(0.4)) return;
    const int count = draw_.whole(1, std::max(1, static_cast<int>(space.freedom()) / 2));
    for (int k = 0; k < count; ++k) {
        const int piece = draw_.whole(0, space.pieces() - 1);
        Point point;
        point.run = run_of(piece);
        point.x = space.begin(piece) + space.width(piece) * draw_.between(0.05, 0.95);
        const bool straight = std::ranges::any_of(draft_.regions, [&](const Region& region) {
            return point.x > region.from && point.x < region.to;
        });
        if (straight) continue;
        for (int order = 0; order <= 2; ++order)
            if (draw_.chance(order == 0 ? 0.8 : 0.25))
                add_value(point, piece, order, draw_.between(0.3, 1.5));
        if (point.values.empty()) continue;
        points_.push_back(point);
        if (edges_ && draw_.chance(0.2)) add_twin(point, piece);
    }
}

/// Their velocity is always written, and where they begin if it has a multiplier. False: the pieces around
/// one leave it no other velocity.
bool Posing::add_regions() {
    for (const Region& region : draft_.regions) {
        Point point;
        point.run = region.run;
        point.x = region.from;
        point.until = region.to;
        const int piece = draft_.space.piece_of(0.5 * (region.from + region.to));
        const VectorXd slope = draft_.space.row(derivative_alone(1), piece, region.from);
        if ((draft_.space.directions().transpose() * slope).norm() < 1e-7 * slope.norm()) return false;
        add_value(point, piece, 1, draw_.between(0.3, 1.5));
        if (draw_.chance(0.5)) add_value(point, piece, 0, draw_.between(0.3, 1.5));
        points_.push_back(point);
    }
    return true;
}

/// A second point so close to the first that both say a slope.
void Posing::add_twin(Point point, int piece) {
    const double distance = draw_.sized(1e-12, 1e-5);
    point.x += distance;
    if (point.x >= draft_.space.end(piece)) return;
    ActiveRow row;
    row.of = ActiveRow::Of::point;
    row.owner = points_.size();
    row.gradient = draft_.space.row(derivative_alone(0), piece, point.x);
    point.values = {{0, row.gradient.dot(motion_), false}};
    point.twin_distance = distance;
    row.size = size_of(derivative_alone(0), {point.x, piece, 0.0}, 0.0);
    row.preference = 0.1;
    row.free = true;
    points_.push_back(point);
    add(std::move(row));
}

double Posing::multiplier_sum(ActiveRow::Of of, std::size_t owner) const {
    double sum = 0.0;
    for (const ActiveRow& row : rows_)
        if (row.of == of && row.owner == owner) sum += row.multiplier;
    return sum;
}

bool Posing::stays_within_strokes() const {
    for (const Run& run : draft_.runs)
        for (int piece = run.first; piece < run.first + run.pieces; ++piece)
            for (const Extreme& one : draft_.space.extremes(motion_, derivative_alone(0), piece))
                if (one.value < run.least - 1e-14 || one.value > run.most + 1e-14) return false;
    return true;
}

bool Posing::can_be_built() const {
    for (int piece = 0; piece < draft_.space.pieces(); ++piece)
        for (const Extreme& one : draft_.space.extremes(motion_, derivative_alone(0), piece))
            if (one.value < draft_.lowest) return false;
    return true;
}

bool Posing::is_monotone() const {
    for (const Run& run : draft_.runs)
        for (int piece = run.first; piece < run.first + run.pieces; ++piece)
            for (const Extreme& one : draft_.space.extremes(motion_, derivative_alone(1), piece))
                if ((run.rises ? one.value : -one.value) < -1e-12) return false;
    return true;
}

bool Posing::draw_rows(bool feasible) {
    if (!draft_.space.close() || draft_.space.freedom() < 1) return false;
    spelling_draw_ = Draw(static_cast<std::uint64_t>(draw_.whole(0, 1 << 30)));
    feasible_ = feasible;
    narrow_ = edges_ && draw_.chance(0.1);
    if (narrow_) draft_.change = "narrow corridors";
    motion_ = drawn_motion(draw_, draft_);
    within_lift_ = stays_within_strokes();
    if (draft_.monotone && (!within_lift_ || !is_monotone())) return false;
    if (!can_be_built()) return false;
    add_terms();
    if (feasible) add_area();
    add_root_mean_squares();
    add_limits();
    add_corridors();
    add_points();
    return add_regions();
}

void Posing::add_to(Balance& balance) {
    balance.add(draft_.space, motion_);
    for (ActiveRow& row : rows_) balance.add(row);
}

void Posing::choose() {
    for (ActiveRow& row : rows_)
        if (row.of == ActiveRow::Of::point)
            points_[row.owner].values[row.part].used = row.written =
                row.multiplier > 0.0 || (points_[row.owner].until > 0.0 && row.part == 0) ||
                (feasible_ && draw_.chance(0.05));
    for (std::size_t k = 1; k < points_.size(); ++k) {
        Point::Value &first = points_[k - 1].values.front(), &twin = points_[k].values.front();
        if (points_[k].twin_distance == 0.0 || !first.used || first.order != 0 || !feasible_) continue;
        twin.used = true;
        for (ActiveRow& row : rows_)
            if (row.of == ActiveRow::Of::point && row.owner == k && row.part == 0) row.written = true;
        closest_ = std::min(closest_, points_[k].twin_distance);
    }
    if (closest_ < 1.0 && !narrow_) draft_.change = "set points close together";
    // Bounds without a multiplier: some stay, further off.
    for (std::size_t l = 0; l < draft_.limits.size(); ++l)
        if (multiplier_sum(ActiveRow::Of::limit, l) == 0.0 && draw_.chance(0.4))
            loosened_[l] = draw_.between(0.02, 0.5);
    for (std::size_t c = 0; c < corridors_.size(); ++c)
        if (multiplier_sum(ActiveRow::Of::corridor, c) == 0.0 && draw_.chance(0.06))
            corridor_loosened_[c] = draw_.between(0.02, 0.5);
    for (std::size_t k = 0; k < rms_.size(); ++k) {
        const double known = draft_.root_mean_squares[k].reference;
        rms_reference_.push_back(known > 0.0 ? known : rms_[k] * draw_.between(0.3, 3.0));
    }
    if (draft_.reference_law.empty()) area_reference_ = std::round(draw_.between(0.2, 0.8) * 100.0) / 100.0;
}

double Posing::total() const {
    double sum = multiplier_sum(ActiveRow::Of::area, 0) * lost_area_;
    for (std::size_t t = 0; t < draft_.terms.size(); ++t)
        sum += multiplier_sum(ActiveRow::Of::term, t) * peaks_[t];
    for (std::size_t k = 0; k < rms_.size(); ++k) sum += multiplier_sum(ActiveRow::Of::rms, k) * rms_[k];
    return sum;
}

bool Posing::tighten(const ActiveRow& row, double by) {
    if (row.of == ActiveRow::Of::rms_limit) return (rms_bounds_[row.owner] -= by) > 0.0;
    if (row.of != ActiveRow::Of::limit) {
        Corridor& corridor = corridors_[row.owner];
        corridor.bound -= corridor.above ? by : -by;
        return true;
    }
    // Every row of the limit moves with it.
    double& bound = bounds_[row.owner].value();
    const LimitDraft& limit = draft_.limits[row.owner];
    bound -= limit.side == LimitDraft::Side::below ? -by : by;
    if (!(bound > limit.must_exceed) || (limit.side == LimitDraft::Side::both && bound <= 0.0)) return false;
    for (std::size_t l = 0; l < draft_.limits.size(); ++l) {  // the other side of the same quantity
        const bool pair = l != row.owner && draft_.limits[l].key == limit.key && bounds_[l].has_value();
        if (pair && (limit.side == LimitDraft::Side::below ? bound >= *bounds_[l] : bound <= *bounds_[l]))
            return false;
    }
    return true;
}

void Posing::write_objective(SceneText& text) const {
    SceneTable& objective = text.at("objective");
    SceneTable references;
    const bool law = !draft_.reference_law.empty();
    const auto add = [&](const std::string& key, double weight, double reference) {
        if (weight <= 0.0) return;
        objective.set(key, weight * reference);
        if (!law) references.set(key, reference);
    };
    for (std::size_t t = 0; t < draft_.terms.size(); ++t) {
        const CostTerm& term = draft_.terms[t];
        add(term.key, feasible_ ? multiplier_sum(ActiveRow::Of::term, t) : drawn_weights_[t] / term.reference,
            term.reference);
    }
    add("area", multiplier_sum(ActiveRow::Of::area, 0), area_reference_);
    for (std::size_t k = 0; k < rms_.size(); ++k)
        add(draft_.root_mean_squares[k].key, multiplier_sum(ActiveRow::Of::rms, k), rms_reference_[k]);
    if (objective.members.empty()) {
        objective.set("jerk", 1.0);
        if (!law) references.set("jerk", 69.0);
    }
    objective.set("reference", law ? quoted(draft_.reference_law) : inline_text(references));
}

void Posing::write_limits(SceneText& text) const {
    std::vector<std::pair<std::string, SceneTable>> pairs;
    for (std::size_t l = 0; l < draft_.limits.size(); ++l) {
        const LimitDraft& limit = draft_.limits[l];
        const bool tight = multiplier_sum(ActiveRow::Of::limit, l) > 0.0;
        if (!bounds_[l] || (!tight && loosened_[l] == 0.0)) continue;
        double bound = *bounds_[l];
        const double away = loosened_[l] * (std::abs(bound) + 1e-3);
        if (!tight) bound += limit.side == LimitDraft::Side::below ? -away : away;
        if (!(bound > limit.must_exceed)) continue;
        const std::string number = number_text(bound * limit.factor);
        if (limit.member.empty()) {
            text.at("limits").set(limit.key, number);
            continue;
        }
        auto found = std::ranges::find(pairs, limit.key, &std::pair<std::string, SceneTable>::first);
        if (found == pairs.end()) found = pairs.emplace(found, limit.key, SceneTable{});
        found->second.set(limit.member, number);
    }
    for (const auto& [key, table] : pairs) text.at("limits").set(key, inline_text(table));
    for (std::size_t k = 0; k < rms_.size(); ++k)
        if (multiplier_sum(ActiveRow::Of::rms_limit, k) > 0.0)
            text.at("limits").set(draft_.root_mean_squares[k].limit_key, rms_bounds_[k]);
}

void Posing::write_corridors(SceneText& text) const {
    for (std::size_t c = 0; c < corridors_.size(); ++c) {
        const Corridor& corridor = corridors_[c];
        const bool tight = multiplier_sum(ActiveRow::Of::corridor, c) > 0.0;
        if (!tight && corridor_loosened_[c] == 0.0) continue;
        double bound = corridor.bound;
        if (!tight) bound += (corridor.above ? 1.0 : -1.0) * corridor_loosened_[c] * (std::abs(bound) + 0.1);
        SceneTable& table = text.append("motion.corridor");
        const bool degrees = spelling_draw_.chance(0.7);
        const double size = degrees ? degree_angle : 1.0;
        const auto place = [&](double x) { return x * (draft_.units.unit / size); };
        // The end of the motion need not be written, and is not met by rounding.
        table.set(degrees ? "from_deg" : "from_rad", place(corridor.from));
        if (corridor.to < draft_.length) table.set(degrees ? "to_deg" : "to_rad", place(corridor.to));
        const Spelling spelling = drawn_spelling(spelling_draw_, draft_.units, corridor.order, 1.0);
        SceneTable sides;
        sides.set(corridor.above ? "max" : "min", bound * spelling.factor);
        table.set(order_names[corridor.order] + spelling.ending, inline_text(sides));
    }
}

void Posing::write_points(SceneText& text) const {
    std::vector<std::vector<SceneTable>> of_run(draft_.runs.size());
    for (const Point& point : points_) {
        if (std::ranges::none_of(point.values, &Point::Value::used)) continue;
        const Run& run = draft_.runs[point.run];
        const bool own = run.table >= 0;  // counted from the start of its segment, and in its angle
        const double unit = own ? run.end - run.begin : 1.0, begin = own ? run.begin : 0.0;
        SceneTable table;
        const bool degrees = spelling_draw_.chance(0.5);
        const auto place = [&](const char* key, double x) {
            if (degrees)
                table.set(std::string(key) + "_deg", (x - begin) * (draft_.units.unit / degree_angle));
            else
                table.set(key, (x - begin) / unit);
        };
        place(point.until > 0.0 ? "from" : "at", point.x);
        if (point.until > 0.0) place("to", point.until);
        for (const auto& [order, value, used] : point.values) {
            if (!used) continue;
            const Spelling spelling =
                drawn_spelling(spelling_draw_, draft_.units, order, std::pow(unit, order));
            table.set(order_names[order] + spelling.ending, value * spelling.factor);
        }
        of_run[point.run].push_back(table);
    }
    std::vector<SceneTable*> segments;
    for (SceneTable& table : text.tables())
        if (table.name == "motion.segments") segments.push_back(&table);
    for (std::size_t k = 0; k < of_run.size(); ++k) {
        if (of_run[k].empty()) continue;
        const int own = draft_.runs[k].table;
        SceneTable& table = own < 0 ? text.at("motion") : *segments[static_cast<std::size_t>(own)];
        table.set("via", inline_text(of_run[k]));
    }
}

SceneText Posing::written() {
    if (!feasible_)
        for (std::size_t t = 0; t < draft_.terms.size(); ++t)
            drawn_weights_.push_back(draw_.between(0.1, 1.0));
    SceneText text = draft_.text;
    if (!within_lift_) text.at("motion").set("within_lift", "false");
    write_points(text);
    write_objective(text);
    write_limits(text);
    write_corridors(text);
    SceneTable& solver = text.at("solver");
    solver.set("max_seconds", "20");
    if (spelling_draw_.chance(0.5)) text.at("objective").set("tie_break", quoted("none"));
    return text;
}

namespace {

/// Whether rounding of the rows moves an optimum by next to nothing; to its error is added what it does.
bool is_sharp(KnownAnswer& answer) {
    const double moved = roundings * rounding * answer.room;
    answer.error += moved;
    return answer.growth >= 0.0 && moved < 1e-9 * answer.objective && answer.error < 1e-8 * answer.objective;
}

/// Both displacements are rounded: the slope between them is known to rounding / distance. There may be no
/// motion with that slope, and the optimum may be far above.
void widen(KnownAnswer& answer, double distance) {
    answer.growth = -1.0;
    answer.above = std::numeric_limits<double>::infinity();
    answer.below += 1e3 * rounding / distance * answer.objective * answer.condition;
}

}  // namespace

Question drawn_question(Draw& draw, bool feasible, bool edges) {
    Question question;
    question.feasible = feasible;
    // Near the impossible: a millionth of it and less to either side.
    question.shift = draw.sized(1e-6, 1.0);
    if (edges && !question.feasible)
        question.shift = (draw.chance(0.5) ? 1.0 : -1.0) * draw.sized(1e-13, 1e-6);
    return question;
}

std::optional<KnownAnswer> answer_of(Draw& draw, const Question& question, Balance& balance,
                                     std::span<const Posing* const> posings, const Tightening& tighten) {
    if (!question.feasible) {
        const ActiveRow* const heaviest = balance.heaviest();
        if (heaviest == nullptr || !tighten(*heaviest, question.shift * heaviest->scale)) return {};
        return balance.contradiction(question.shift);
    }
    double total = 0.0, closest = 1.0;
    for (const Posing* const posing : posings) {
        total += posing->total();
        closest = std::min(closest, posing->closest());
    }
    const double objective = draw.sized(0.2, 5.0);
    if (!std::isfinite(objective / total)) return {};
    KnownAnswer answer = balance.optimum(total, objective);
    if (closest < 1.0)
        widen(answer, closest);
    else if (!is_sharp(answer))
        return {};
    return answer;
}

}  // namespace camopt::soak
