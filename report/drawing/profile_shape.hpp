// SPDX-License-Identifier: MIT
// A whole plane cam as a function of the cam angle: what drawings are made from. SI units; signs as in
// scene/cam_mechanism.hpp.
//
// Cam frame: the cam's centre is the origin. At θ = 0 a disk cam's is the frame that stands still, in which a
// pushed follower rises along +y; it turns with the cam, by σθ about +z. All points lie at z = 0.
#pragma once

#include "report/view/cam_presentation.hpp"
#include "report/view/view.hpp"

namespace camopt {

struct ProfileShape {
    DrivenMechanism cam;
    std::optional<DirectCamDrawing> direct = {};     ///< of a cam that touches its follower itself
    CamPictureRow picture = {};                      ///< what a picture of it shows
    std::function<MechanismPoint(double theta)> at;  ///< of station 0
    /// Of station 1, the other side of a cam that drives both ways; empty: there is none.
    std::function<MechanismPoint(double theta)> other = {};
    std::function<FollowerState(double theta)> output;  ///< what the cam moves, there
    std::vector<double> knots;  ///< θ where the motion changes its formula, begin and end included; ascending
    bool closed = true;         ///< the end of the cam is its beginning; false: it is open
    double start = 0.0;         ///< θ where the motion begins: dwell may lie before it
    std::string open_because = {};  ///< what is missing where it is open; empty: nothing is said of it
    /// m: of a flat face that is pushed straight; none: it is drawn as wide as the contact needs, and wider.
    std::optional<double> face_half_width = {};
    std::optional<double> least_radius = {};  ///< m: of a cam whose base radius is no dimension
    ShownUnit length = unit_named<"mm">;      ///< in which its drawings are labelled

    [[nodiscard]] double begin() const { return knots.front(); }
    [[nodiscard]] double end() const { return knots.back(); }

    [[nodiscard]] const CamMechanism& formulas() const { return *cam.formulas; }
    /// Of a plane cam; of one that does not touch its follower itself, of the outline (plane_shape).
    [[nodiscard]] double base_radius() const {
        return least_radius ? *least_radius : cam.formulas->base_radius(cam.dimensions).value();
    }
    [[nodiscard]] bool has_roller() const { return cam.formulas->roller_radius() >= 0; }
    /// Of the roller at a station, m; 0: there is none.
    [[nodiscard]] double roller_radius(int station = 0) const {
        if (!has_roller()) return 0.0;
        return cam.dimensions[static_cast<std::size_t>(cam.formulas->roller_radius_at(station))];
    }
    [[nodiscard]] double prime_radius() const { return base_radius() + roller_radius(); }
    /// The follower touches with a flat face, on an arm or pushed straight.
    [[nodiscard]] bool has_face() const {
        return formulas().radius_quantity() == MechanismQuantity::cam_radius;
    }
    [[nodiscard]] bool has_pushed_face() const { return has_face() && !cam.formulas->swings(); }
    /// A body with the outline above, its sides and its bottom.
    [[nodiscard]] bool is_plate() const { return picture.outline == CamOutline::plate; }
    [[nodiscard]] bool is_grooved() const { return direct && direct->groove_wall; }
    /// Its two sides are disks on one shaft.
    [[nodiscard]] bool has_two_disks() const { return other && direct && !direct->pieces.empty(); }

    [[nodiscard]] MechanismState state(double theta) const { return {cam.dimensions, output(theta), theta}; }
    /// The parts of the mechanism in the frame that stands still.
    [[nodiscard]] std::vector<MechanismShape> parts(double theta) const {
        return formulas().plane()->shapes(state(theta));
    }
    /// A point that stands still, in the cam frame as it is at θ, whose centre stays where it is.
    [[nodiscard]] Eigen::Vector2d turned_back(const Eigen::Vector2d& fixed, double theta) const;
};

/// x and y of a point or a direction of a plane cam.
[[nodiscard]] inline Eigen::Vector2d in_plane(const Eigen::Vector3d& vector) {
    return vector.head<2>();
}

/// The other side as its own shape; the shape must have one.
[[nodiscard]] ProfileShape other_side(const ProfileShape& shape);

/// Of the disk that a groove is cut into, m: the greatest of its outer flank and the wall; none: no groove.
[[nodiscard]] std::optional<double> rim_radius(const ProfileShape& shape);

/// What is made in one piece: the cam, or each of DirectCamDrawing::pieces with its least radius as its base
/// circle. Keeps what the shape keeps.
[[nodiscard]] std::vector<ProfileShape> made_pieces(const ProfileShape& shape);

/// Closed where the motion takes one revolution and its end meets its begin.
[[nodiscard]] ProfileShape profile_shape(const std::shared_ptr<const CamPoints>& points);
[[nodiscard]] inline ProfileShape profile_shape(const DrivenMechanism& cam, const MotionChain& motion,
                                                const MotionScale& scale) {
    return profile_shape(std::make_shared<CamPoints>(cam, motion, scale));
}

/// Of a solution's plane cam along its drawn motion; none: there is no plane cam.
[[nodiscard]] std::optional<ProfileShape> plane_shape(const View& view);
/// The same; none too where the cam does not touch its follower itself (DirectCam).
[[nodiscard]] std::optional<ProfileShape> delivered_shape(const View& view);

/// `steps` angles or more, evenly over the shape, with every knot seen from inside its two neighbours:
/// piece by piece, both ends included.
[[nodiscard]] std::vector<std::vector<MechanismPoint>> profile_pieces(const ProfileShape& shape, int steps);

/// Where the cam is about to undercut: θ of each sign change of the regularity, ascending.
[[nodiscard]] std::vector<double> cusp_angles(const ProfileShape& shape);

}  // namespace camopt
