// SPDX-License-Identifier: MIT
// The points of a cam along a motion, each evaluated once.
#pragma once

#include "profiles/sampling.hpp"
#include "splines/motion_chain.hpp"

#include <tuple>
#include <unordered_map>

namespace camopt {

/// The points of a cam along its motion. A point is evaluated where it is asked for first and remembered, so
/// that tables, drawings and programs made from one cam share them. One thread at a time.
class CamPoints {
 public:
    CamPoints(DrivenMechanism cam, MotionChain motion, const MotionScale& scale)
        : cam_(std::move(cam)), motion_(std::move(motion)), scale_(scale) {}

    [[nodiscard]] const DrivenMechanism& cam() const { return cam_; }
    [[nodiscard]] const MotionChain& motion() const { return motion_; }
    [[nodiscard]] const MotionScale& scale() const { return scale_; }

    /// x beyond the motion: its end. The side after a breakpoint, at the end that before.
    [[nodiscard]] MotionPoint motion_at(double x) const {
        return camopt::motion_at(motion_, std::clamp(x, motion_.begin(), motion_.end()));
    }
    [[nodiscard]] const MechanismPoint& at(double x, int station = 0) const {
        return at(motion_at(x), station);
    }
    /// `motion`: of this motion, from either side.
    [[nodiscard]] const MechanismPoint& at(const MotionPoint& motion, int station) const;

 private:
    /// θ, s', s'', station: along one motion a point does not depend on more.
    using Place = std::tuple<double, double, double, int>;
    struct PlaceHash {
        std::size_t operator()(const Place& place) const;
    };
    DrivenMechanism cam_;
    MotionChain motion_;
    MotionScale scale_;
    mutable std::unordered_map<Place, MechanismPoint, PlaceHash> points_;
};

}  // namespace camopt
