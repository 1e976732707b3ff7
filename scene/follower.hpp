// SPDX-License-Identifier: MIT
// The followers of a disk cam: one row each. All code that lists followers, or asks for their properties,
// reads the rows; the formulas are in profiles/disk.
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>

namespace camopt {

enum class FollowerType {
    translating_roller,
    translating_flat,
    translating_knife,
    oscillating_roller,
    oscillating_flat
};

/// The contact element.
enum class ContactKind { roller, edge, flat };

/// Index of a dimension in all vectors over the dimensions of a cam: values, partials.
enum class DimensionIndex { base_radius, roller_radius, offset, center_distance, arm_length, face_offset };
inline constexpr int dimension_count = 6;
[[nodiscard]] const char* name_of(DimensionIndex value);  ///< "base_radius", …
/// Offsets may be negative, and default to 0; lengths are positive and required.
[[nodiscard]] bool is_offset(DimensionIndex value);

/// A dimension in a sum: sign · d.
struct SignedDimension {
    DimensionIndex dimension;
    double sign;
};

struct Follower {
    FollowerType type;
    const char* name;
    bool oscillates;  ///< it swings: its lift is an angle
    ContactKind contact;
    bool has_face_width;                           ///< cam.face_half_width limits the contact offset
    std::array<bool, dimension_count> dimensions;  ///< by DimensionIndex: which it has

    [[nodiscard]] constexpr bool has(DimensionIndex dimension) const {
        return dimensions[static_cast<std::size_t>(dimension)];
    }
};

/// Every follower, by FollowerType, in the order in which they are listed.
// clang-format off
inline constexpr std::array<Follower, 5> followers = {{
    //                                                                                 base, roller, offset, centre, arm, face offset
    {FollowerType::translating_roller, "translating_roller", false, ContactKind::roller, false, {true, true, true, false, false, false}},
    {FollowerType::translating_flat, "translating_flat", false, ContactKind::flat, true, {true, false, false, false, false, false}},
    {FollowerType::translating_knife, "translating_knife", false, ContactKind::edge, false, {true, false, true, false, false, false}},
    {FollowerType::oscillating_roller, "oscillating_roller", true, ContactKind::roller, false, {true, true, false, true, true, false}},
    {FollowerType::oscillating_flat, "oscillating_flat", true, ContactKind::flat, false, {true, false, false, true, false, true}},
}};
// clang-format on
[[nodiscard]] constexpr const Follower& follower_of(FollowerType type) {
    return followers[static_cast<std::size_t>(type)];
}
/// The cam can be built at rest if each of these sums is below 0.
[[nodiscard]] std::vector<std::vector<SignedDimension>> reach_of(FollowerType type);

[[nodiscard]] constexpr const char* name_of(FollowerType value) {
    return follower_of(value).name;
}
[[nodiscard]] constexpr bool is_oscillating(FollowerType value) {
    return follower_of(value).oscillates;
}
[[nodiscard]] constexpr bool has_roller(FollowerType value) {
    return follower_of(value).contact == ContactKind::roller;
}
[[nodiscard]] constexpr bool has_edge(FollowerType value) {
    return follower_of(value).contact == ContactKind::edge;
}
[[nodiscard]] constexpr bool has_flat_face(FollowerType value) {
    return follower_of(value).contact == ContactKind::flat;
}
/// A flat face that is pushed straight: its pressure angle is 0 and its contact offset is proportional to s'.
[[nodiscard]] constexpr bool has_pushed_face(FollowerType value) {
    return has_flat_face(value) && !is_oscillating(value);
}
/// A flat face on an arm: it may reverse.
[[nodiscard]] constexpr bool has_turning_face(FollowerType value) {
    return has_flat_face(value) && is_oscillating(value);
}
/// Whether a follower of this type has this dimension at all.
[[nodiscard]] constexpr bool has_dimension(FollowerType follower, DimensionIndex dimension) {
    return follower_of(follower).has(dimension);
}
/// The followers that have it, in words for messages: "translating_roller" or "translating_knife", in quotes.
[[nodiscard]] std::string followers_with(DimensionIndex dimension);
/// The same of cam.face_half_width.
[[nodiscard]] std::string followers_with_face_width();

// A follower as a forward check places it on finished points of a cam: its shape and its guide, independent
// of the formulas that generate a cam. m, rad.
//
// Frame: fixed; its origin is the cam's centre. It is the mechanism's own frame rotated by −turn and
// then, where `mirrored`, reflected in the x axis, so that a swinging follower has its pivot on the +x axis
// and moves away from the cam where its position grows.
//   pushed:   along +y at x = offset; its position is y of the roller's centre, of the edge or of the face
//   swinging: about the pivot (pivot_distance, 0); its position is ψ, the angle at the pivot from the line to
//             the cam's centre up to the arm. The roller's centre is at pivot + arm · (−cos ψ, sin ψ); a flat
//             face is the line of the arm, displaced by face_offset towards the cam's centre
// The lift is the position less that at output 0, where the follower is rest_distance away from the cam's
// centre: with p = rest_distance, a = pivot_distance, l = arm, e = offset and f = face_offset
//   pushed:   y0 = p (flat), √(p² − e²)        swinging: sin ψ0 = (p + f)/a (flat),
//                                              cos ψ0 = (a² + l² − p²)/(2 a l)

struct FollowerGeometry {
    ContactKind contact = ContactKind::roller;
    bool swings = false;
    double roller_radius = 0.0;                                 ///< 0: no roller
    double offset = 0.0;                                        ///< pushed; may be negative
    double pivot_distance = 0.0, arm = 0.0, face_offset = 0.0;  ///< swinging
    /// From the cam's centre at output 0: the roller's centre, the edge, the line of the face.
    double rest_distance = 0.0;
    double turn = 0.0;  ///< of the frame
    /// How the cam slides in this frame, m for every radian; none: it turns about the origin.
    std::optional<Eigen::Vector2d> slide = {};
    /// Of a cam that reaches below the pivot: positions from here on are those of the arm's other side.
    double most_position = std::numeric_limits<double>::infinity();
    bool mirrored = false;  ///< the frame
    /// The points are the outer flank of a groove: the roller is at the least position at which it touches
    /// one of them from inside, instead of the largest from outside.
    bool from_inside = false;
    bool falls = false;  ///< without a linkage: the output is −lift, not the lift
    /// The output s for the angle of the arm from +x in the mechanism's own frame; NaN out of reach. None:
    /// the follower itself is the output.
    std::function<double(double arm_angle)> linkage = {};

    /// y0 or ψ0: the position at output 0.
    [[nodiscard]] double rest_position() const { return position_at(rest_distance); }
    /// The position at this distance from the cam's centre, and the reverse.
    [[nodiscard]] double position_at(double distance) const;
    [[nodiscard]] double distance_at(double position) const;
    /// A point of the mechanism's own frame, with the cam's centre as the origin, in this frame.
    [[nodiscard]] Eigen::Vector2d seen(const Eigen::Vector2d& own) const;
    /// The angle of the arm from +x in the mechanism's own frame where it is at ψ in this one.
    [[nodiscard]] double arm_angle(double psi) const {
        return turn + (mirrored ? -1.0 : 1.0) * (std::numbers::pi - psi);
    }
};

/// A lever that carries a roller, both at output 0.
struct RollerLever {
    Eigen::Vector2d pivot;  ///< seen from the cam's centre
    double arm = 0.0, roller_radius = 0.0;
    double angle = 0.0;  ///< of the arm, from +x
};

/// The follower formed by a roller on a lever, without its linkage.
[[nodiscard]] FollowerGeometry follower_on_lever(const RollerLever& lever);

}  // namespace camopt
