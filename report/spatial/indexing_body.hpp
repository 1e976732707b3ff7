// SPDX-License-Identifier: MIT
// The groove of an indexing cam: what all rollers of the index take out of its turned body.
//
// In the cam frame a roller that has left the cam after a turn went where its neighbour begins, so all of
// them follow one path, that of one roller over an angle φ of as many turns as it takes it through the cam:
//   s(φ + 2π j) = s(φ) + j pitch
// At each φ the roller, a cylinder of radius r whose end is `floor` from its near end, leaves one line of the
// groove: t = 0 … 1 down the flank on the side where rollers come in, to 4 across the floor, to 5 up the
// other flank. Flanks are where it touches; where that is undercut, and on the floor, into which the edge of
// the roller's end digs as it turns: how far along n, along e, any place of the roller near φ reaches.
//
// The body is turned, as far as the near ends of rollers go between their places in the dwell:
//   a roller square to the cam's axis   ρ <= max |c|                 (ρ, z: about the cam's axis)
//   one whose near end runs on an arc   (a − ρ)² + (z − z0)² >= l²   (RollerArc: from_axis, z, radius)
// between ends at lower <= z <= upper, a quarter of the roller's radius beyond its grooves in the dwell,
// nearer where rollers could not leave the cam there: a choice, as is the radius, unless the scene gives the
// body (CamFlanks::body). m, rad.
#pragma once

#include "report/surface/triangle_mesh.hpp"
#include "scene/cam_flanks.hpp"

namespace camopt {

/// Over one turn the follower advances by one pitch: all rollers run through the cam one after the other.
/// Flanks and groove are then those of a roller from where it comes in to where it leaves.
[[nodiscard]] bool indexes(const CamFlanks& cam, const FollowerMotion& motion);

/// Below the roller's far end, that it does not rub on the floor of its groove.
inline constexpr double floor_clearance = 5e-4;  // m

/// s of all rollers as one over (from, to), which holds the motion's turn.
[[nodiscard]] FollowerMotion rollers_as_one(const FollowerMotion& motion, double from, double to);

class IndexingGroove {
 public:
    /// motion: one turn over which s grows by the pitch. Throws InputError for another, and for rollers that
    /// do not leave the cam by its ends.
    IndexingGroove(const CamFlanks& cam, const FollowerMotion& motion, double floor);

    /// From where a roller is about to come in to where it has left the body by its other end.
    [[nodiscard]] const FollowerMotion& path() const { return path_; }
    [[nodiscard]] double lower() const { return lower_; }
    [[nodiscard]] double upper() const { return upper_; }
    [[nodiscard]] double floor() const { return floor_; }

    /// A point of the line that is left at φ.
    [[nodiscard]] Eigen::Vector3d contact(double phi, double t) const;
    /// t where the first and the last flank leave the body's outside; below 0, above 5: beyond the near end.
    [[nodiscard]] double first(double phi) const { return top(phi, 0.0, 1.0); }
    [[nodiscard]] double last(double phi) const { return top(phi, 5.0, -1.0); }
    /// Radius of the turned outside, and how far a point lies inside of it (along the roller).
    [[nodiscard]] double outside(double z) const;
    [[nodiscard]] double depth(const Eigen::Vector3d& point) const;

    /// How the blank is turned before the groove is milled, for machinists. mm.
    [[nodiscard]] std::string turned_words() const;

 private:
    [[nodiscard]] double way_out_of_roller(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                                           double phi) const;
    [[nodiscard]] double depth_in_roller(const Eigen::Vector3d& point, double phi) const;
    [[nodiscard]] Eigen::Vector3d left_of(Eigen::Vector3d point, const Eigen::Vector3d& direction,
                                          double phi) const;
    [[nodiscard]] double top(double phi, double from, double inwards) const;
    void choose_ends(double middle, double pitch);
    [[nodiscard]] double way_out(double towards) const;

    CamFlanks cam_;
    FollowerMotion path_;
    double begin_ = 0.0, floor_ = 0.0, radius_ = 0.0, lower_ = 0.0, upper_ = 0.0;
    bool enters_above_ = false;  // rollers come in at the upper end
};

// The body of an indexing cam as a solid: what is turned (indexing_body.hpp), less the way of every roller.
//
// Vertices of flanks and floors lie on the true surface: they are points of lines along which a roller
// touches. Between them the solid is as far off as a chord. The bore is a choice of drawing. m, rad.

struct IndexingBodyOptions {
    int angles = 720;  ///< sections over one turn; >= 16
    int points = 12;   ///< along a flank, half of those across a floor or a rib; >= 2

    void validate() const;  ///< throws InputError
};

/// motion: one revolution over which s grows by the pitch of the rollers. Throws InputError for another, and
/// for rollers that do not leave the cam by its ends.
[[nodiscard]] TriangleMesh indexing_body(const CamFlanks& cam, const FollowerMotion& motion,
                                         const IndexingBodyOptions& options = {});

/// The same for pictures; none where rollers do not leave the cam by its ends.
[[nodiscard]] std::optional<TriangleMesh> drawn_indexing_body(const CamFlanks& cam,
                                                              const FollowerMotion& motion,
                                                              const IndexingBodyOptions& options);

/// The two rollers that hold the rib where the motion begins.
[[nodiscard]] TriangleMesh holding_rollers(const CamFlanks& cam, const FollowerMotion& motion);

}  // namespace camopt
