// SPDX-License-Identifier: MIT
// The rows of the key table for [cam], [dynamics] and [drawing].
#include "input/keys/key_spellings.hpp"
#include "profiles/kinds/cam_kinds.hpp"

namespace camopt::input {

namespace {

using enum KeyType;
using namespace spellings;

const Range poisson_ratio = {.low = 0.0, .high = 0.5, .high_included = false};
const Range arm_angle_range = {.low = 0.0, .high = 360.0, .low_included = false, .high_included = false};
const Range damping_ratios = Range::between(0.0, 2.0);
constexpr auto needs_cam = Availability::needs_cam;

/// Allowed values of cam.follower, over all kinds.
std::vector<std::string_view> words_of_followers() {
    std::vector<std::string_view> words;
    for (const CamKind& kind : cam_kinds())
        for (const CamVariant& variant : kind.variants)
            if (kind.choosing_table == "cam" && kind.choosing_key == "follower")
                words.emplace_back(variant.word);
    return words;
}

}  // namespace

// A row is read as a row.
// clang-format off
std::vector<KeyRow> cam_rows() {
    return {
        {"cam", "type", text, plain, any, cam_types(), "required",
         "The kind of cam: a disk cam with its follower, one whose lever moves the output through a linkage, a barrel "
         "cam with its index, a cylindrical cam, an inverse cam with its feeder."},
        {"cam", "follower", text, plain, any,
         words_of_followers(),
         "required",
         "`rotating` and `translating` are for cylindrical cams, the others for disks. "
         "What touches the cam. The lift of an oscillating or rotating follower is an angle, that of the others a length."},
        {"cam", "base_radius", number_or_range, length, positive, {}, "required",
         "Radius of the base circle, on which the follower rests at displacement 0; the prime circle is base + "
         "roller."},
        {"cam", "roller_radius", number_or_range, length, positive, {}, "required for rollers",
         "Radius of the roller; of disk cams `translating_roller` and `oscillating_roller` only."},
        {"cam", "offset", number_or_range, length, any, {}, "0",
         "x of the follower's axis, lift along +y; positive reduces the rise's pressure angle where the cam "
         "turns counterclockwise. `translating_roller` and `translating_knife` only."},
        {"cam", "center_distance", number_or_range, length, positive, {}, "required for oscillating",
         "From the cam's centre to the follower's pivot: oscillating followers; cylindrical: a rotating one. Barrel: "
         "from the cam's axis to the rollers' near end."},
        {"cam", "arm_length", number_or_range, length, positive, {}, "required for oscillating_roller, rotating, barrel",
         "From the pivot to the roller's centre: `oscillating_roller`; to its near end: `rotating`; barrel: the index "
         "radius, from the index's axis to the rollers'."},
        {"cam", "face_offset", number_or_range, length, any, {}, "0",
         "Distance of the flat face from its parallel through the pivot, positive towards the cam's centre; "
         "`oscillating_flat` only."},
        {"cam", "face_half_width", number, length, positive, {}, "unlimited",
         "Half the width of the flat face; the contact stays on it. `translating_flat` only."},
        {"cam", "form", text, plain, any, {"open", "grooved", "conjugate"}, "\"open\"",
         "How the cam holds a roller. `open`: on one side, a force presses it on; `grooved`: in a groove between two "
         "flanks; `conjugate`: two disks on one shaft, each with a roller of the one follower. The last two drive both "
         "ways."},
        {"cam", "groove_clearance", number, length, not_negative, {}, "0",
         "Width of the groove less the roller's diameter, half of it on either side; `grooved` only."},
        {"cam", "groove_wall", number, length, positive, {}, "the roller radius",
         "Least thickness of the wall around the groove: the rim of the disk in drawings; `grooved` only."},
        {"cam", "roller_distance", number, length, positive, {}, "required for conjugate, translating",
         "Between the axes of the two rollers, measured along the lift."},
        {"cam", "arm_angle", number, angle, arm_angle_range, {}, "required for conjugate, oscillating",
         "Between the arms of the two rollers."},
        {"cam", "second_roller_radius", number, length, positive, {}, "that of the first",
         "Radius of the second roller; `conjugate` only."},
        {"cam", "second_offset", number, length, any, {}, "that of the first",
         "x of the second roller's path; `conjugate` and `translating_roller` only."},
        {"cam", "second_arm_length", number, length, positive, {}, "that of the first",
         "From the pivot to the second roller's centre; `conjugate` and `oscillating_roller` only."},
        {"cam", "rotation", text, plain, any, {"counterclockwise", "clockwise"}, "\"counterclockwise\"",
         "The sense in which the cam turns."},
    };
}

std::vector<KeyRow> force_rows() {
    return {
        {"forces", "mass", number, mass, not_negative, {}, "0",
         "Mass that the cam accelerates; translating followers."},
        {"forces", "inertia", number, inertia, not_negative, {}, "0",
         "Moment of inertia about the pivot; oscillating followers.", Availability::now, "mass"},
        {"forces", "spring_rate", number, spring_rate, not_negative, {}, "0",
         "Rate of the return spring: per length for translating, per angle for oscillating followers."},
        {"forces", "preload", number, force_or_moment, any, {}, "0",
         "Force (translating) or moment (oscillating) that presses the follower against the cam at displacement 0, "
         "at rest: spring, weight, load."},
        {"forces", "contact_width", number, length, positive, {}, "none",
         "Width of the line of contact; the Hertz pressure needs it."},
        {"forces", "cam_modulus", number, modulus, positive, {}, "210 GPa", "Young's modulus of the cam."},
        {"forces", "follower_modulus", number, modulus, positive, {}, "210 GPa",
         "Young's modulus of the roller or the face."},
        {"forces", "cam_poisson", number, plain, poisson_ratio, {}, "0.3", "Poisson's ratio of the cam."},
        {"forces", "follower_poisson", number, plain, poisson_ratio, {}, "0.3",
         "Poisson's ratio of the roller or the face."},
    };
}

std::vector<KeyRow> dimension_weight_rows() {
    return {
        {"objective", "base_radius", number, plain, not_negative, {}, "0",
         "Weight of the base radius divided by the lift (oscillating: by lift in rad · centre distance).",
         needs_cam},
        {"objective", "roller_radius", number, plain, not_negative, {}, "0",
         "Weight of the roller radius, divided likewise.", needs_cam},
        {"objective", "offset", number, plain, not_negative, {}, "0",
         "Weight of the offset's magnitude, divided likewise.", needs_cam},
        {"objective", "center_distance", number, plain, not_negative, {}, "0",
         "Weight of the centre distance, divided likewise.", needs_cam},
        {"objective", "arm_length", number, plain, not_negative, {}, "0",
         "Weight of the arm length, divided likewise.", needs_cam},
        {"objective", "face_offset", number, plain, not_negative, {}, "0",
         "Weight of the face offset, divided likewise.", needs_cam},
    };
}

std::vector<KeyRow> dynamics_rows() {
    return {
        {"dynamics", "mass", number, mass, positive, {}, "needed", "Moved at the output; of a lift that is a length."},
        {"dynamics", "inertia", number, inertia, positive, {}, "needed",
         "The same where the lift is an angle.", Availability::now, "mass"},
        {"dynamics", "natural_frequency", number, frequency, positive, {}, "or a stiffness",
         "Of the output on its spring, with the cam (or the stage before it) held and the return spring on; undamped."},
        {"dynamics", "stiffness", number, train_spring, positive, {}, "or a natural frequency",
         "Of the spring between the output and the mass or cam before it.", Availability::now, "natural_frequency"},
        {"dynamics", "damping_ratio", number, plain, damping_ratios, {}, "0",
         "Damping of the output in parts of critical."},
        {"dynamics", "damping", number, damper, not_negative, {}, "0", "The same as a damper.",
         Availability::now, "damping_ratio"},
        {"dynamics", "return_spring", number, train_spring, not_negative, {}, "0",
         "Rate of the spring that presses the output back to the cam."},
        {"dynamics", "preload", number, force_or_moment, not_negative, {}, "0",
         "What the return spring presses with at displacement 0. Without spring and preload the cam guides the follower in both directions."},
        {"dynamics", "speed_range", numbers, speed, positive, {}, "motion.speed",
         "Two speeds: terms and limits of the train hold from the first to the second."},
        {"dynamics", "stage", tables, plain, any, {}, "none",
         "Masses between cam and output, at most three, from the cam on."},
        {"dynamics.stage", "mass", number, mass, positive, {}, "needed", "Of this mass."},
        {"dynamics.stage", "inertia", number, inertia, positive, {}, "needed",
         "The same where the lift is an angle.", Availability::now, "mass"},
        {"dynamics.stage", "stiffness", number, train_spring, positive, {}, "required",
         "Of the spring to the mass or cam before it."},
        {"dynamics.stage", "damping_ratio", number, plain, damping_ratios, {}, "0",
         "c / (2 sqrt(k m)) of this mass on this spring."},
    };
}

std::vector<KeyRow> drawing_rows() {
    return {
        {"drawing", "bore", number, length, positive, {}, "no hole",
         "Diameter of the bore; with its keyway inside the cam's least radius."},
        {"drawing", "keyway", table, plain, any, {}, "none", "A parallel keyway in the bore."},
        {"drawing", "thickness", number, length, positive, {}, "20 mm",
         "Thickness of the cam; `--thickness-mm` replaces it."},
        {"drawing", "groove_depth", number, length, positive, {}, "half the thickness",
         "How deep the groove of a `grooved` cam is, below the thickness."},
        {"drawing", "datum", number, angle, any, {}, "0",
         "Where the cam is marked: the ray that points along +y when the cam has turned by this cam angle. The "
         "drawing's table of radii counts from it, as the cam angle grows."},
        {"drawing", "title_block", table, plain, any, {}, "empty", "Text of the title block in addition to the scene's title."},
        {"drawing.keyway", "width", number, length, positive, {}, "required", "Width of the keyway, below the bore's diameter."},
        {"drawing.keyway", "depth", number, length, positive, {}, "required",
         "How far its floor lies outside the bore's circle: the hub's depth t2 of a parallel key."},
        {"drawing.keyway", "at", number, angle, any, {}, "0",
         "Where its middle is: a cam angle, like `datum`."},
        {"drawing.title_block", "part", text, plain, any, {}, "the title", "Name of the part."},
        {"drawing.title_block", "material", text, plain, any, {}, "empty", "Material and treatment."},
        {"drawing.title_block", "tolerance", text, plain, any, {}, "empty", "General tolerances."},
        {"drawing.title_block", "drawn_by", text, plain, any, {}, "empty", "Who drew it."},
    };
}
// clang-format on

}  // namespace camopt::input
