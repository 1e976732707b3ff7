// SPDX-License-Identifier: MIT
// A cam of any kind along a motion: its points, each evaluated once.
#pragma once

#include "core/motion.hpp"
#include "profiles/sampling.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/scene.hpp"
#include "splines/motion_chain.hpp"

#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace camopt {

[[nodiscard]] MechanismPoint mechanism_point(const DrivenMechanism& mechanism, const MotionPoint& motion,
                                             const MotionScale& scale, int station = 0);

/// About `count` points of one station, evenly by cam angle, the motion's breakpoints among them, and which
/// those are. Throws InputError for fewer than 2.
struct MechanismProfile {
    std::vector<MechanismPoint> points;
    std::vector<double> outputs;  ///< s of each, m or rad
    std::vector<int> breaks;
};
[[nodiscard]] MechanismProfile mechanism_profile(const DrivenMechanism& mechanism, const Motion& motion,
                                                 const MotionScale& scale, int count, int station = 0);

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
    [[nodiscard]] MotionPoint motion_at(double x) const;
    [[nodiscard]] const MechanismPoint& at(double x, int station = 0) const;
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

// A second look at every limit on the cam of a delivered motion: not at points, but along every stretch of
// it.

/// One rule that keeps a limit, along the whole motion.
struct EnclosedLimit {
    std::string key;     ///< "limits.pressure_angle_deg"
    double worst = 0.0;  ///< relative to the rule's scale; above 0 the limit is passed; infinite: no value
    double at = 0.0;     ///< x
    /// No larger one hides between points: enclosed by interval arithmetic, at every station there is.
    bool complete = false;
};

/// Of every rule of the scene's limits on its cam, whose formulas and numbers are `cam`.
[[nodiscard]] std::vector<EnclosedLimit> enclosed_limits(const Scene& scene, const DrivenMechanism& cam,
                                                         const Motion& motion);

/// All rules of a limit are complete, and there is one.
[[nodiscard]] bool is_verified(const std::vector<EnclosedLimit>& limits, const std::string& key);

}  // namespace camopt
