// SPDX-License-Identifier: MIT
#include "studies/search/moving_breakpoints.hpp"

namespace camopt {

namespace {

// Least distance of breakpoints, as a part of the mean. Cubic: two that coincide would make the acceleration
// jump, an infinite jerk, so a weight on the jerk separates them anyway. Quintic and septic: three would tend
// to coincide, where the jerk may jump; but a smooth jerk is the reason for that degree, and divisions by
// powers of the distance would lose digits.
constexpr double least_part_cubic = 0.01, least_part_higher = 0.1;
// A step shifts the maxima of rules that are curved between breakpoints: it sees them at Chebyshev points of
// every piece.
constexpr int points_a_degree = 2;
constexpr double pi = 3.14159265358979323846;

}  // namespace

std::vector<RuleSample> samples_between(const CamModel& model) {
    const MotionFamily& family = model.design;
    std::vector<RuleSample> samples;
    for (int r = 0; r < static_cast<int>(model.rules.size()); ++r) {
        const PlacedRule& rule = model.rules[static_cast<std::size_t>(r)];
        if (rule->whole() || !rule->places().empty() || rule->starts_without_rows()) continue;
        for (const MotionFamily::Piece& piece : family.pieces()) {
            if (piece.segment < 0 || !rule.holds_on(piece)) continue;
            const MotionFamily::Stretch& stretch =
                family.stretches()[static_cast<std::size_t>(piece.stretch)];
            const int degree =
                family.run_space(stretch.run).degree() - (rule->linear() ? rule->highest_order() : 0);
            const int points = degree <= 1 ? 0 : points_a_degree * degree;
            for (int k = 1; k < points; ++k) {
                const double part = 0.5 * (1.0 - std::cos(pi * k / points));
                samples.push_back({r, piece.begin + part * (piece.end - piece.begin), Side::right});
            }
        }
    }
    return samples;
}

std::vector<RuleSample> moved_samples(const CamModel& from, const CamModel& to,
                                      std::vector<RuleSample> samples) {
    const std::vector<MotionFamily::Piece>&before = from.design.pieces(), &after = to.design.pieces();
    if (before.size() != after.size()) return {};
    for (RuleSample& sample : samples) {
        const PlacedRule& rule = from.rules[static_cast<std::size_t>(sample.rule)];
        if (rule->whole() || !rule->places().empty()) continue;  // at places of their own
        const auto i = static_cast<std::size_t>(from.design.piece_of(sample.at, sample.side));
        const MotionFamily::Piece &own = before[i], &other = after[i];
        if (own.begin == other.begin && own.end == other.end) continue;
        const double part = (sample.at - own.begin) / (own.end - own.begin);
        const double at = sample.at == own.end ? other.end : other.begin + part * (other.end - other.begin);
        const double held = std::clamp(at, rule.from, rule.until);
        if (rule->scale_at(held) > 0.0) sample.at = held;
    }
    return samples;
}

Eigen::VectorXd carried(const CamProblem& from, const Eigen::VectorXd& x, const CamModel& to) {
    const MotionChain motion = from.motion(x);
    const MotionFamily &before = from.model().design, &after = to.design;
    Eigen::VectorXd entries = from.design_values(x);
    for (int j = 0; j < before.size(); ++j) {
        const std::optional<double> own = before.place(j), other = after.place(j);
        if (!own || !other || *own == *other) continue;
        // Between the polynomials of both sides: smooth also where the jerk jumps.
        const MotionPoint left = motion.at(*own, Side::left), right = motion.at(*own, Side::right);
        const auto order = static_cast<std::size_t>(before.order(j));
        const double moved = *other - *own;
        double power = moved;  // moved^i / i!
        for (std::size_t i = 1; order + i < left.derivative.size(); ++i) {
            entries[j] += 0.5 * (left.derivative[order + i] + right.derivative[order + i]) * power;
            power *= moved / static_cast<double>(i + 1);
        }
    }
    Eigen::VectorXd same = x;
    same.head(entries.size()) = entries.cwiseQuotient(design_scales(to));
    return same;
}

MovingBreakpoints::MovingBreakpoints(const Scene& scene, const Peaks& reference, HeldStrokes strokes,
                                     std::vector<double> points, CostUnits units)
    : scene_(scene),
      reference_(reference),
      strokes_(std::move(strokes)),
      units_(std::move(units)),
      start_(std::move(points)) {
    const std::size_t segments = start_.size() - 1;
    const bool symmetric = scene.motion.symmetric;
    const auto count = static_cast<Eigen::Index>(segments);
    mean_ = (start_.back() - start_.front()) / static_cast<double>(segments);
    least_ = (scene.spline.degree == 3 ? least_part_cubic : least_part_higher) * mean_;
    for (std::size_t i = 0; i < segments; ++i) least_ = std::min(least_, start_[i + 1] - start_[i]);
    const std::vector<double> held = held_breakpoints(scene);
    for (std::size_t k = 1; k <= (symmetric ? (segments - 1) / 2 : segments - 1); ++k)
        if (std::ranges::find(held, start_[k]) == held.end()) moving_.push_back(k);
    room_slope_ = Eigen::MatrixXd::Zero(count, size());
    for (Eigen::Index j = 0; j < size(); ++j) {
        const auto k = static_cast<Eigen::Index>(moving_[static_cast<std::size_t>(j)]);
        room_slope_(k - 1, j) += 1.0;
        room_slope_(k, j) -= 1.0;
        if (!symmetric) continue;
        room_slope_(count - k - 1, j) -= 1.0;
        room_slope_(count - k, j) += 1.0;
    }
}

std::vector<double> MovingBreakpoints::points(const Eigen::VectorXd& moves) const {
    std::vector<double> moved = start_;
    for (std::size_t j = 0; j < moving_.size(); ++j) {
        const std::size_t k = moving_[j];
        moved[k] += moves[static_cast<Eigen::Index>(j)] * mean_;
        if (scene_.motion.symmetric) moved[moved.size() - 1 - k] = moved.back() - moved[k];
    }
    return moved;
}

Eigen::VectorXd MovingBreakpoints::room(const Eigen::VectorXd& moves) const {
    const std::vector<double> all = points(moves);
    Eigen::VectorXd room(static_cast<Eigen::Index>(all.size()) - 1);
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
        room[static_cast<Eigen::Index>(i)] = (all[i + 1] - all[i] - least_) / mean_;
    return room;
}

CamModel MovingBreakpoints::model(const Eigen::VectorXd& moves) const {
    return scene_model(with_breakpoints(scene_, points(moves)), DesignKind::states, reference_, strokes_,
                       units_);
}

}  // namespace camopt
