// SPDX-License-Identifier: MIT
#include "tests/soak/figures/cam_extremes.hpp"

#include "tests/soak/figures/golden_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camopt::soak {

namespace {

constexpr int places = 48;  // a piece
// Samples this part of the figure's whole range below the largest one may stand beside a larger maximum. Of
// the range and not of the largest itself: a figure that a limit holds at 0 would leave its narrow dips out.
constexpr double beside = 0.05;
constexpr double none = -std::numeric_limits<double>::infinity();

}  // namespace

CamSurvey::CamSurvey(const Motion& motion, const Cam& cam) : motion_(motion), cam_(cam) {
    for (std::size_t k = 0; k < motion.pieces.size(); ++k) {
        const Piece& piece = motion.pieces[k];
        for (int j = 0; j <= places; ++j) {
            const long double x =
                j == places ? piece.end : piece.begin + (piece.end - piece.begin) * j / places;
            samples_.push_back({static_cast<int>(k), x, point(piece, x)});
            fastest_ = std::max(fastest_, std::abs(samples_.back().point.velocity));
        }
    }
}

CamPoint CamSurvey::point(const Piece& piece, long double x) const {
    const std::array<long double, 4> y = piece.at(x);
    const long double angle = motion_.unit_angle;
    return cam_point(
        cam_, {static_cast<double>(motion_.lift * y[0]), static_cast<double>(motion_.lift * y[1] / angle),
               static_cast<double>(motion_.lift * y[2] / (angle * angle))});
}

double CamSurvey::largest(const Amount& amount) const {
    std::vector<double> values;
    values.reserve(samples_.size());
    double found = none, lowest = -none;
    for (const Sample& sample : samples_) {
        values.push_back(amount(sample.point));
        if (std::isnan(values.back())) return std::numeric_limits<double>::quiet_NaN();
        found = std::max(found, values.back());
        if (values.back() != none) lowest = std::min(lowest, values.back());
    }
    // Every sample that no neighbour tops may stand beside a maximum.
    const double near = found - beside * std::max(std::abs(found), found - lowest);
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (values[k] < near || std::isinf(values[k])) continue;
        if (k > 0 && samples_[k - 1].piece == samples_[k].piece && values[k - 1] > values[k]) continue;
        if (k + 1 < values.size() && samples_[k + 1].piece == samples_[k].piece && values[k + 1] > values[k])
            continue;
        found = std::max(found, refined(amount, k));
    }
    return found;
}

double CamSurvey::least(const Amount& amount) const {
    return -largest([&](const CamPoint& point) {
        const double value = amount(point);
        return value == std::numeric_limits<double>::infinity() ? none : -value;
    });
}

double CamSurvey::refined(const Amount& amount, std::size_t about) const {
    const Piece& piece = motion_.pieces[static_cast<std::size_t>(samples_[about].piece)];
    const long double step = (piece.end - piece.begin) / places;
    return highest_between(std::max(piece.begin, samples_[about].x - step),
                           std::min(piece.end, samples_[about].x + step),
                           [&](long double x) { return amount(point(piece, x)); });
}

}  // namespace camopt::soak
