// SPDX-License-Identifier: MIT
// The delivered motion and its cam, sampled once: what charts, pages and tables iterate over. A plain value.
#pragma once

#include "objectives/drive_rules.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// Lift and unit angle of the scene: what the points of a cam are made with.
[[nodiscard]] MotionScale motion_scale(const Scene& scene);

/// Solution::whole_turn.
[[nodiscard]] MotionChain whole_turn(const Solution& solution);

/// The motion of the whole cam: an RR motion that leaves a part of the revolution rests there, which closes
/// the cam. A DRD motion remains the open sector of its rise. Throws InputError without a motion.
[[nodiscard]] MotionChain cam_motion(const Solution& solution);

/// What pictures, tables and drawings of the cam show: cam_motion, and of a DRD cam that turns the dwell arcs
/// on either side of its rise, each half of what the rise leaves of the revolution. The first lies before cam
/// angle 0. Between their outer ends the scene gives no motion: the cam is open there.
[[nodiscard]] MotionChain drawn_motion(const Solution& solution);

/// Why a cam along drawn_motion is open; empty: its motion closes it.
[[nodiscard]] std::string open_because(const Solution& solution);

/// An angle of a motion, seen from one side.
struct MotionRow {
    double x = 0.0;
    Side side = Side::right;
};

/// Rows of motion.csv: every degree of 360 over the motion, its breakpoints and the places of its peaks;
/// twice where the jerk jumps, from the left and then from the right; and one at each x of `also`. Ascending.
[[nodiscard]] std::vector<MotionRow> motion_rows(const Motion& motion, const Peaks& peaks,
                                                 const std::vector<double>& also = {});

struct DeliveredRow {
    double x = 0.0;
    Side side = Side::right;
    MotionPoint motion;
    bool closing = false;             ///< of the dwell that closes the cam, after the motion itself
    std::vector<MechanismPoint> cam;  ///< by station; empty without a cam
    std::optional<FollowerLoads> loads;
    std::optional<DrivePoint> drive = {};  ///< of a motor in place of a cam
    std::optional<MotionPoint> output =
        {};  ///< where the output's motion is prescribed; `motion` is the cam's

    [[nodiscard]] const MotionPoint& output_motion() const { return output ? *output : motion; }
};

/// The output's motion where it is prescribed; beyond its end it rests there.
[[nodiscard]] std::optional<MotionPoint> output_at(const Solution& solution, double x, Side side);

/// By motion_rows, then the dwell that closes the cam. Empty where the solution has no motion.
struct Delivered {
    std::vector<DeliveredRow> rows;
    MotionScale scale;
    std::optional<MotionChain> whole;      ///< cam_motion; none: there is no cam
    std::shared_ptr<const CamPoints> cam;  ///< along drawn_motion; null: there is no cam

    [[nodiscard]] double begin() const { return rows.front().x; }
    [[nodiscard]] double end() const { return rows.back().x; }
    /// Of the first row at x or after it, to rounding; of the last one beyond the end.
    [[nodiscard]] std::size_t index_at(double x) const;
};

[[nodiscard]] Delivered sample_delivered(const Solution& solution);

/// One side of the cam along drawn_motion, each row with its point of that station alone. Of a cam that
/// drives both ways the force along the normal is 0 where the other side carries. There is a cam.
[[nodiscard]] std::vector<DeliveredRow> profile_rows(const Solution& solution, const Delivered& delivered,
                                                     const ProfileSampling& sampling, int station = 0);

/// Unless a number of points is given: a disk cam by the chord tolerance, other cams every tenth of a degree.
[[nodiscard]] ProfileSampling default_sampling(const CamPoints& cam);

}  // namespace camopt
