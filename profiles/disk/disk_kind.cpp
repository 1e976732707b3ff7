// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_spec.hpp"
#include "scene/cam_kind.hpp"
#include "scene/key_place.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

using enum KeyType;
using namespace spellings;

const Range arm_angle_range = {.low = 0.0, .high = 360.0, .low_included = false, .high_included = false};

// A row is read as a row.
// clang-format off
std::vector<KeyRow> cam_rows() {
    return {
        {"cam", "follower", text, plain, any, {}, "required",
         "What touches the cam. With a disk cam the lift of an oscillating follower is an angle, that of a translating "
         "one a length."},
        {"cam", "base_radius", number_or_range, length, positive, {}, "required",
         "Radius of the base circle, on which the follower rests at displacement 0; the prime circle is base + "
         "roller."},
        {"cam", "roller_radius", number_or_range, length, positive, {}, "required for rollers",
         "Radius of the roller; of disk cams `translating_roller` and `oscillating_roller` only."},
        {"cam", "offset", number_or_range, length, any, {}, "0",
         "x of the follower's axis, lift along +y; positive reduces the rise's pressure angle where the cam "
         "turns counterclockwise. `translating_roller` and `translating_knife` only."},
        {"cam", "center_distance", number_or_range, length, positive, {}, "required for oscillating",
         "From the cam's centre to the follower's pivot: oscillating followers."},
        {"cam", "arm_length", number_or_range, length, positive, {}, "required for oscillating_roller",
         "From the pivot to the roller's centre: `oscillating_roller`."},
        {"cam", "face_offset", number_or_range, length, any, {}, "0",
         "Distance of the flat face from its parallel through the pivot, positive towards the cam's centre; "
         "`oscillating_flat` only."},
        {"cam", "face_half_width", number, length, positive, {}, "unlimited",
         "Half the width of the flat face; the contact stays on it. `translating_flat` only."},
        {"cam", "face_radius", number, length, positive, {}, "unlimited",
         "Radius of a round flat face (a valve tappet): the line of contact, as long as `forces.contact_width`, stays "
         "on it. `translating_flat` only.", {}, Availability::now, "face_half_width"},
        called("how the roller is held", {"cam", "form", text, plain, any, {"open", "grooved", "conjugate"}, "\"open\"",
         "How the cam holds a roller. `open`: on one side, a force presses it on; `grooved`: in a groove between two "
         "flanks; `conjugate`: two disks on one shaft, each with a roller of the one follower. The last two drive both "
         "ways."}),
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
    };
}

std::vector<KeyRow> drawing_rows() {
    const auto title_text = [](std::string TitleBlock::*text) {
        return stored_in(&Scene::drawing, &DrawingSpec::title_block, text);
    };
    return {
        {"", "drawing", table, plain, any, {}, "no bore",
         "What the drawing and the solid of a disk cam need in addition to its profile.",
         stored_in(&Scene::drawing), Availability::needs_cam},
        called("bore diameter", {"drawing", "bore", number, length, positive, {}, "no hole",
         "Diameter of the bore; with its keyway inside the cam's least radius.",
         stored_in(&Scene::drawing, &DrawingSpec::bore)}),
        {"drawing", "keyway", table, plain, any, {}, "none", "A parallel keyway in the bore.",
         stored_in(&Scene::drawing, &DrawingSpec::keyway)},
        {"drawing", "thickness", number, length, positive, {}, "20 mm",
         "Thickness of the cam; `--thickness-mm` replaces it.", stored_in(&Scene::drawing, &DrawingSpec::thickness)},
        {"drawing", "groove_depth", number, length, positive, {}, "half the thickness",
         "How deep the groove of a `grooved` cam is, below the thickness.",
         stored_in(&Scene::drawing, &DrawingSpec::groove_depth)},
        called("datum mark, cam angle", {"drawing", "datum", number, angle, any, {}, "0",
         "Where the cam is marked: the ray that points along +y when the cam has turned by this cam angle. The "
         "drawing's table of radii counts from it, as the cam angle grows.",
         stored_in(&Scene::drawing, &DrawingSpec::datum)}),
        {"drawing", "density", number, density, positive, {}, "none", "Of the material: with it the drawing gives the mass.",
         stored_in(&Scene::drawing, &DrawingSpec::density)},
        {"drawing", "projection", text, plain, any, {"first_angle", "third_angle"}, "\"first_angle\"",
         "Method of projection: its symbol (ISO 5456-2) and the side from which the section is seen.",
         stored_in(&Scene::drawing, &DrawingSpec::projection)},
        {"drawing", "title_block", table, plain, any, {}, "empty", "Text of the title block in addition to the scene's title.",
         stored_in(&Scene::drawing, &DrawingSpec::title_block)},
        {"drawing.keyway", "width", number, length, positive, {}, "required", "Width of the keyway, below the bore's diameter.",
         stored_in(&Scene::drawing, &DrawingSpec::keyway, &Keyway::width)},
        {"drawing.keyway", "depth", number, length, positive, {}, "required",
         "How far its floor lies outside the bore's circle: the hub's depth t2 of a parallel key.",
         stored_in(&Scene::drawing, &DrawingSpec::keyway, &Keyway::depth)},
        called("cam angle of its middle", {"drawing.keyway", "at", number, angle, any, {}, "0",
         "Where its middle is: a cam angle, like `datum`.", stored_in(&Scene::drawing, &DrawingSpec::keyway, &Keyway::at)}),
        {"drawing.title_block", "part", text, plain, any, {}, "the title", "Name of the part.",
         title_text(&TitleBlock::part)},
        {"drawing.title_block", "material", text, plain, any, {}, "empty", "Material and treatment.",
         title_text(&TitleBlock::material)},
        {"drawing.title_block", "tolerance", text, plain, any, {}, "empty", "General tolerances.",
         title_text(&TitleBlock::tolerance)},
        {"drawing.title_block", "drawn_by", text, plain, any, {}, "empty", "Who drew it; the author of STEP files.",
         title_text(&TitleBlock::drawn_by)},
        {"drawing.title_block", "organisation", text, plain, any, {}, "empty", "Legal owner; also in STEP files.",
         title_text(&TitleBlock::organisation)},
        {"drawing.title_block", "number", text, plain, any, {}, "empty", "Drawing number.", title_text(&TitleBlock::number)},
        {"drawing.title_block", "revision", text, plain, any, {}, "empty", "Revision index.",
         title_text(&TitleBlock::revision)},
        {"drawing.title_block", "date", text, plain, any, {}, "empty", "Date of issue, as it is to be printed.",
         title_text(&TitleBlock::date)},
        {"drawing.title_block", "surface_finish", text, plain, any, {}, "empty", "Of the cam's surface: `Ra 0.8`.",
         title_text(&TitleBlock::surface_finish)},
        {"drawing.title_block", "profile_tolerance", text, plain, any, {}, "empty", "Of the cam's outline: `0.02`.",
         title_text(&TitleBlock::profile_tolerance)},
        {"drawing.title_block", "bore_fit", text, plain, any, {}, "empty", "Fit, after the diameter of the bore: `H7`.",
         title_text(&TitleBlock::bore_fit)},
        {"drawing.title_block", "keyway_tolerance", text, plain, any, {}, "empty", "After the width of the keyway: `JS9`.",
         title_text(&TitleBlock::keyway_tolerance)},
    };
}
// clang-format on

std::vector<KeyRow> disk_rows() {
    std::vector<KeyRow> rows = cam_rows();
    const std::vector<KeyRow> drawing = drawing_rows();
    rows.insert(rows.end(), drawing.begin(), drawing.end());
    return rows;
}

/// Other words that users write for the keys in [cam].
std::vector<CamSynonym> disk_synonyms() {
    return {{"base_circle", "base_radius"},        {"base_circle_radius", "base_radius"},
            {"prime_radius", "base_radius"},       {"eccentricity", "offset"},
            {"pivot_distance", "center_distance"}, {"arm", "arm_length"},
            {"lever_length", "arm_length"},        {"follower_type", "follower"}};
}

/// Other words for parts of the names of followers.
std::vector<CamSynonym> follower_part_synonyms() {
    return {{"swinging", "oscillating"},
            {"swing", "oscillating"},
            {"rocking", "oscillating"},
            {"pivoted", "oscillating"},
            {"reciprocating", "translating"},
            {"linear", "translating"},
            {"plane", "flat"},
            {"mushroom", "flat"},
            {"edge", "knife"},
            {"pointed", "knife"},
            {"wheel", "roller"}};
}

const char* touched_with(ContactKind contact) {
    if (contact == ContactKind::roller) return "a roller";
    return contact == ContactKind::flat ? "a flat face" : "a knife edge";
}

CamVariant variant(const Follower& follower) {
    CamVariant all;
    all.word = follower.name;
    all.spoken = fmt::format("the follower \"{}\"", follower.name);
    all.swings = follower.oscillates;
    all.touches_with = touched_with(follower.contact);
    all.spec = [type = follower.type] { return blank_disk_spec({.follower = type}); };
    int index = 0;
    for (int i = 0; i < dimension_count; ++i) {
        const auto which = static_cast<DimensionIndex>(i);
        CamNumber number{"cam", name_of(which), follower.has(which)};
        if (number.owned) number.index = index++;
        if (is_offset(which)) number.value = 0.0;
        all.numbers.push_back(std::move(number));
    }
    for (const char* key : {"face_half_width", "face_radius"})
        all.numbers.push_back({"cam", key, follower.has_face_width});
    const bool roller = follower.contact == ContactKind::roller;
    for (const char* key : {"groove_clearance", "groove_wall", "second_roller_radius"})
        all.numbers.push_back({"cam", key, roller});
    for (const char* key : {"roller_distance", "second_offset"})
        all.numbers.push_back({"cam", key, roller && !follower.oscillates});
    for (const char* key : {"arm_angle", "second_arm_length"})
        all.numbers.push_back({"cam", key, roller && follower.oscillates});
    all.choices.push_back({"cam", "form"});
    return all;
}

/// The width of a face, the numbers of a form.
CamSpec with_given(const CamSpec& spec, const std::map<std::string, double>& given) {
    DiskSpec disk = disk_of(spec);
    const auto number = [&given](const char* key) {
        const auto found = given.find(key);
        return found == given.end() ? std::nullopt : std::optional(found->second);
    };
    disk.face_half_width = number("face_half_width");
    set_numbers(disk.form, number);
    CamSpec whole = blank_disk_spec(disk);
    if (const std::optional<double> radius = number("face_radius")) whole.set_round_face(*radius, 0.0);
    return whole;
}

}  // namespace

CamKind disk_kind() {
    CamKind kind;
    kind.type = disk_type;
    kind.spoken = "a disk cam with its follower";
    kind.choosing_table = "cam";
    kind.choosing_key = "follower";
    for (const Follower& follower : followers) kind.variants.push_back(variant(follower));
    kind.with_angle = "an oscillating follower";
    kind.with_length = "a translating follower";
    kind.outputs = {CamOutput::outline, CamOutput::sheet, CamOutput::second_sheet, CamOutput::solid,
                    CamOutput::program};
    kind.rows = disk_rows();
    kind.also_called = disk_synonyms();
    kind.parts_called = follower_part_synonyms();
    kind.add_given = with_given;
    return kind;
}

}  // namespace camopt
