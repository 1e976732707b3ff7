// SPDX-License-Identifier: MIT
// Private to studies/delivered: figures of a cam of any kind, and their extremes over the motion and over all
// stations.
#pragma once

#include "core/numbers/sampled_maximum.hpp"
#include "studies/delivered/driven_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace camopt {

/// A point of the cam and the state of the output that made it.
struct CamPlace {
    MechanismPoint point;
    FollowerState state;
};
using CamPlaceFigure = std::function<double(const CamPlace&)>;

/// Keeps references to the cam and the motion. What its figures share, the points of the cam at the samples
/// that they all look at first, is made once.
class CamTurn {
 public:
    CamTurn(const DrivenMechanism& cam, const Motion& motion, const MotionScale& scale)
        : cam_(cam),
          motion_(motion),
          scale_(scale),
          points_(motion.breakpoints()),
          at_samples_(static_cast<std::size_t>(cam.formulas->stations())) {}

    [[nodiscard]] Extremum largest(const CamPlaceFigure& figure) const {
        std::optional<Extremum> best;
        for (int station = 0; station < cam_.formulas->stations(); ++station) {
            const Extremum one = largest(figure, station);
            if (!best || one.value > best->value) best = one;
        }
        return *best;
    }
    [[nodiscard]] Extremum largest(const CamPlaceFigure& figure, int station) const {
        const auto along = [&](double x, Side side) { return figure(place(motion_.at(x, side), station)); };
        const std::vector<CamPlace>& known = at_samples(station);
        if (known.empty()) return largest_along(points_, along);
        return largest_along(points_, along, [&](std::size_t k) { return figure(known[k]); });
    }
    [[nodiscard]] Extremum least(const CamPlaceFigure& figure, int station) const {
        Extremum found = largest([&](const CamPlace& place) { return -figure(place); }, station);
        found.value = -found.value;
        return found;
    }
    [[nodiscard]] Extremum least(const CamPlaceFigure& figure) const {
        Extremum found = largest([&](const CamPlace& place) { return -figure(place); });
        found.value = -found.value;
        return found;
    }
    /// |φ| with s' = 0 put in, whatever rounding made of it.
    [[nodiscard]] double pressure_angle_at_rest(double x) const {
        double largest = 0.0;
        for (int station = 0; station < cam_.formulas->stations(); ++station)
            largest = std::max(largest, pressure_angle_at_rest(x, station));
        return largest;
    }

 private:
    [[nodiscard]] double pressure_angle_at_rest(double x, int station) const {
        FollowerState state = state_of(motion_.at(x, x < motion_.end() ? Side::right : Side::left), scale_);
        state.velocity = 0.0;
        const double theta = scale_.unit_angle * x;
        return std::abs(cam_.formulas->point(theta, {cam_.dimensions, state}, station).pressure_angle);
    }
    [[nodiscard]] CamPlace place(const MotionPoint& motion, int station) const {
        return {mechanism_point(cam_, motion, scale_, station), state_of(motion, scale_)};
    }

    /// Empty where there are too many to keep.
    [[nodiscard]] const std::vector<CamPlace>& at_samples(int station) const {
        constexpr std::size_t most_kept = 50000;  // some 10 MB
        std::vector<CamPlace>& known = at_samples_[static_cast<std::size_t>(station)];
        if (!known.empty()) return known;
        const std::vector<SamplePlace> places = sample_places(points_);
        if (places.size() > most_kept) return known;
        known.reserve(places.size());
        for (const SamplePlace& at : places) known.push_back(place(motion_.at(at.at, at.side), station));
        return known;
    }

    const DrivenMechanism& cam_;
    const Motion& motion_;
    MotionScale scale_;
    std::vector<double> points_;
    mutable std::vector<std::vector<CamPlace>> at_samples_;  ///< of every station, once asked for
};

}  // namespace camopt
