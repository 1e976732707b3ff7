// SPDX-License-Identifier: MIT
#include "motions/laws/law_catalogue.hpp"
#include "objectives/scene_model.hpp"
#include "studies/measured/measured_fit.hpp"

#include <Eigen/Cholesky>

namespace camopt {

namespace {

// Gauss–Newton: a law is smooth enough that a dozen steps settle its two ends.
constexpr int most_steps = 25;
constexpr double settled = 1e-12, least_width = 0.2, most_width = 2.0;
constexpr std::size_t least_rows = 8;

/// Rows of one stroke: x from its begin by its angle, displacement as a share of that stroke.
struct StrokeRows {
    std::vector<MeasuredRow> rows;
    bool falls = false;
};

/// Share of the displacement and its slope; a fall runs through the law from its end.
std::array<double, 2> share_at(const Law& law, double t, bool falls) {
    if (t <= 0.0 || t >= 1.0) return {t <= 0.0 ? 0.0 : 1.0, 0.0};
    const auto at = law.at(falls ? 1.0 - t : t).derivative;
    return {falls ? 1.0 - at[0] : at[0], at[1]};
}

/// The law with its own begin and end (x of the stroke), by least squares from those of the stroke.
LawMatch fitted(const Law& law, const StrokeRows& stroke) {
    LawMatch match{law.info().title, 0.0, 1.0, 0.0, 0.0};
    const auto squares = [&](double begin, double end) {
        double sum = 0.0;
        match.largest = 0.0;
        for (const MeasuredRow& row : stroke.rows) {
            const double off =
                std::abs(share_at(law, (row.x - begin) / (end - begin), stroke.falls)[0] - row.y);
            match.largest = std::max(match.largest, off);
            sum += off * off;
        }
        return sum;
    };
    double best = squares(match.begin, match.end);
    for (int step = 0; step < most_steps; ++step) {
        const double width = match.end - match.begin;
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        for (const MeasuredRow& row : stroke.rows) {
            const double t = (row.x - match.begin) / width;
            const std::array<double, 2> at = share_at(law, t, stroke.falls);
            const Eigen::Vector2d slope(-at[1] * (1.0 - t) / width, -at[1] * t / width);
            normal += slope * slope.transpose();
            right -= (at[0] - row.y) * slope;
        }
        Eigen::Vector2d change = normal.ldlt().solve(right);
        if (!change.allFinite()) break;
        double now = best;
        for (int halving = 0; halving < 8; ++halving, change *= 0.5) {
            const double begin = match.begin + change[0], end = match.end + change[1];
            if (!(end - begin > least_width && end - begin < most_width)) continue;
            now = squares(begin, end);
            if (now > best) continue;
            match.begin = begin;
            match.end = end;
            break;
        }
        if (!(now < best) || change.norm() < settled) break;
        best = now;
    }
    best = squares(match.begin, match.end);
    match.rms = std::sqrt(best / static_cast<double>(stroke.rows.size()));
    return match;
}

}  // namespace

std::vector<LawMatch> nearest_laws(const MotionFamily& family, bool turns_back,
                                   const std::vector<MeasuredRow>& rows) {
    std::vector<LawMatch> matches;
    for (const MotionFamily::Stretch& stretch : family.stretches()) {
        const std::optional<double> from = known_displacement(stretch.from),
                                    to = known_displacement(stretch.to);
        if (stretch.kind != StretchRequest::Kind::spline || stretch.copy || !from || !to || *from == *to)
            continue;
        StrokeRows stroke{{}, *to < *from};
        const double width = stretch.end - stretch.begin;
        for (const MeasuredRow& row : rows)
            if (row.x >= stretch.begin && row.x <= stretch.end)
                stroke.rows.push_back({(row.x - stretch.begin) / width, (row.y - *from) / (*to - *from)});
        if (stroke.rows.size() < least_rows) continue;
        LawMatch best;
        for (const LawInfo& info : law_catalogue()) {
            const std::unique_ptr<Law> law = make_law(info.key);
            if (!info.rests || (info.top == TopEnd::turning_point && !turns_back)) continue;
            const LawMatch match = fitted(*law, stroke);
            if (best.law.empty() || match.rms < best.rms) best = match;
        }
        if (best.law.empty()) continue;
        best.begin = stretch.begin + best.begin * width;
        best.end = stretch.begin + best.end * width;
        best.largest *= std::abs(*to - *from);
        best.rms *= std::abs(*to - *from);
        matches.push_back(std::move(best));
    }
    return matches;
}

}  // namespace camopt
