// SPDX-License-Identifier: MIT
// A disk cam: follower, form, dimensions. m, rad; frames: profiles/disk/disk_cam.hpp.
#pragma once

#include "scene/cam_spec.hpp"

namespace camopt {

struct CamKind;
struct MotionSpec;
struct SceneFault;

/// cam.type of a disk cam.
inline constexpr const char* disk_type = "disk";

/// Form closure or force closure of the follower.
enum class CamForm {
    open,      ///< on one side: a force presses the follower on it
    grooved,   ///< its roller runs in a groove, between two flanks: the cam drives both ways
    conjugate  ///< two disks on one shaft, each with a roller of the one follower: the cam drives both ways
};

[[nodiscard]] const char* name_of(CamForm value);

/// The form of a disk cam and the numbers it needs; those of other forms are ignored. m, rad.
struct FormSpec {
    CamForm type = CamForm::open;
    double groove_clearance = 0.0;      ///< groove: its width less the roller's diameter, half on either side
    std::optional<double> groove_wall;  ///< groove: of its outer wall where it is thinnest; roller radius
    double roller_distance = 0.0;       ///< conjugate, translating: between the rollers' axes along the lift
    double arm_angle = 0.0;             ///< conjugate, oscillating: between the arms, in (0, 2π)
    /// Of the second roller, conjugate; none: as those of the first.
    std::optional<double> second_roller_radius, second_offset, second_arm_length;

    [[nodiscard]] bool is_grooved() const { return type == CamForm::grooved; }
    [[nodiscard]] bool is_conjugate() const { return type == CamForm::conjugate; }
    /// Form closure: the cam also drives the return, without a closing force.
    [[nodiscard]] bool drives_both_ways() const { return type != CamForm::open; }
};

/// A disk cam: cam centre at the origin, follower at the top (translating, lift along +y, axis at x = offset)
/// or with its pivot at (center_distance, 0) (oscillating). Prime radius = base radius + roller radius.
struct DiskSpec {
    FollowerType follower = FollowerType::translating_roller;
    Rotation rotation = Rotation::counterclockwise;
    std::array<Dimension, dimension_count> dimensions{};  ///< those that the follower does not have are 0
    std::optional<double> face_half_width = {};           ///< translating flat face, m: |s'| <= it
    FormSpec form = {};                                   ///< rollers only: others are open

    [[nodiscard]] Dimension& operator[](DimensionIndex index) {
        return dimensions[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] const Dimension& operator[](DimensionIndex index) const {
        return dimensions[static_cast<std::size_t>(index)];
    }
};

/// The dimensions of a follower, in the order of a CamSpec.
[[nodiscard]] std::vector<DimensionIndex> dimensions_of(FollowerType follower);

/// The given numbers of the form, as fixed dimensions with their keys.
[[nodiscard]] std::vector<CamDimension> form_dimensions(FollowerType follower, const FormSpec& form);

/// A number of a form by its name ("groove_wall"), m or rad; none: not given.
using FormNumbers = std::function<std::optional<double>(const char* name)>;
/// All of them; missing ones are 0 or none.
void set_numbers(FormSpec& form, const FormNumbers& given);

/// A number that this follower or form does not have; none: there is no such one.
[[nodiscard]] std::optional<SceneFault> foreign_fault(const DiskSpec& cam);

/// The cam as scenes store it, without formulas (disk_spec of disk_cam.hpp adds them): type "disk", the
/// choices "follower" and "form", a key for every dimension. Throws SceneError for a number that this
/// follower or form does not have.
[[nodiscard]] CamSpec blank_disk_spec(const DiskSpec& cam);

/// The inverse. Throws InputError for another type, and for an unknown follower or form.
[[nodiscard]] DiskSpec disk_of(const CamSpec& cam);

/// The first fault for every choice of its dimensions within their ranges; none: it can be built and moved.
[[nodiscard]] std::optional<SceneFault> disk_fault(const DiskSpec& cam, const MotionSpec& motion);

/// Disk cams with their followers, as scene files know them.
[[nodiscard]] CamKind disk_kind();

}  // namespace camopt
