// SPDX-License-Identifier: MIT
#include "shop/exports/workshop_options.hpp"

#include "input/key_file.hpp"
#include "scene/key_place.hpp"

namespace camopt {

namespace {

using enum KeyType;
using namespace spellings;

template <class Member>
KeyPlace of_plate(Member member) {
    return stored_in(&WorkshopOptions::plate, member);
}

template <class... Path>
KeyPlace of_program(Path... path) {
    return stored_in(&WorkshopOptions::nc, path...);
}

template <class Member>
KeyPlace of_milling(Member member) {
    return of_program(&NcChoice::milling, member);
}

/// Written as the diameter.
KeyPlace blank_radius() {
    return {.assign = [](WorkshopOptions& options, const KeyValue& value,
                         const KeyAt& /*at*/) { options.nc.blank.radius = 0.5 * std::get<double>(value); },
            .value = [](const WorkshopOptions& options, const KeyAt& /*at*/) -> std::optional<KeyValue> {
                if (!options.nc.blank.radius) return std::nullopt;
                return 2.0 * *options.nc.blank.radius;
            }};
}

// A row is read as a row.
// clang-format off
std::vector<KeyRow> plate_rows() {
    constexpr int most_sections = 1000;
    return {
        {"", "tolerance", number, length, positive, {}, "0.001", "Of the arcs of profile.dxf, to either side of the exact curve",
         stored_in(&WorkshopOptions::dxf_tolerance)},
        {"", "thickness", number, length, positive, {}, "drawing.thickness_mm, else 20", "Thickness of a plane cam",
         of_plate(&CamSheetOptions::thickness)},
        {"", "bore", number, length, positive, {}, "drawing.bore_mm, else no bore", "Diameter of a plane cam's bore",
         of_plate(&CamSheetOptions::bore)},
        {"", "sections", integer, plain, Range::between(2, most_sections), {}, "9", "Points of a flank along the roller",
         stored_in(&WorkshopOptions::sections)},
    };
}

std::vector<KeyRow> controller_rows() {
    constexpr int most_points = 100'000;
    return {
        {"", "points", integer, plain, Range::between(2, most_points), {}, "the joints of the motion; as many as a solid needs",
         "Points over one revolution of an electronic cam, of flanks and of solids", stored_in(&WorkshopOptions::points)},
    };
}

std::vector<KeyRow> program_rows() {
    return {
        {"", "post", text, plain, any, {}, "a generic one", "File of a post-processor (TOML, docs/nc.md)", of_program(&NcChoice::post)},
        {"", "cutter", number, length, positive, {}, "the roller's, for plane cams 16 mm", "Diameter of the cutter",
         of_program(&NcChoice::cutter_diameter)},
        {"", "blank_diameter", number, length, positive, {}, "the cam's and the allowance on either side", "Diameter of the blank",
         blank_radius()},
        {"", "blank_from", number, length, any, {}, "where the cam does, drums less the allowance",
         "Where the blank begins along the cam's axis, from the origin", of_program(&NcChoice::blank, &BlankChoice::lower)},
        {"", "blank_to", number, length, any, {}, "likewise", "Where the blank ends", of_program(&NcChoice::blank, &BlankChoice::upper)},
        {"", "blank_allowance", number, length, not_negative, {}, "5",
         "Allowance of the blank over the cam where its size is not given: around it, for drums also at the ends",
         of_program(&NcChoice::blank, &BlankChoice::allowance)},
        {"", "clearance", number, length, any, {}, "20", "Height of the plane of rapids above the blank, at any angle of the table",
         of_program(&NcChoice::clearance)},
        {"", "safe", number, length, any, {}, "2", "Least distance of rapids from the blank; closer moves are feeds",
         of_program(&NcChoice::safe_distance)},
        {"", "gouge", number, length, any, {}, "0.01",
         "A program that enters the finished cam deeper (apart from chords and printed digits) is refused", of_program(&NcChoice::gouge_tolerance)},
        {"", "stock", number, length, any, {}, "0", "Left on the flanks for the next pass", of_program(&NcChoice::stock)},
        {"", "z_offset", number, length, any, {}, "0", "Subtracted from Z on a machine with five axes", of_program(&NcChoice::z_offset)},
        {"", "chord", number, length, any, {}, "0.001", "Largest deviation of the cutter from its path between two blocks",
         of_program(&NcChoice::chord_tolerance)},
        {"", "feed", number, feed, any, {}, "300", "Feed of the cutter's tip in the cam", of_program(&NcChoice::feed)},
        {"", "rotary", number, rotary_speed, any, {}, "0: no limit", "Largest speed of a rotary axis", of_program(&NcChoice::rotary_speed)},
        {"", "spindle_rpm", number, plain, any, {}, "0: none is written, and the program notes this", "Spindle speed",
         of_program(&NcChoice::spindle_rpm)},
        {"", "rough_step_over", number, length, any, {}, "half the cutter's diameter", "Largest distance between two roughing passes",
         of_milling(&MillingChoice::step_over)},
        {"", "rough_step_down", number, length, any, {}, "half the cutter's diameter", "Largest depth of a roughing layer",
         of_milling(&MillingChoice::step_down)},
        {"", "finish_allowance", number, length, any, {}, "0.3, in a groove at most the clearance of the cutter",
         "What roughing leaves for the finishing pass, in addition to the stock", of_milling(&MillingChoice::finish_allowance)},
        {"", "full_depth", boolean, plain, any, {}, "false",
         "No roughing: the finishing pass cuts the full depth, and the program warns of the slot", of_milling(&MillingChoice::full_depth)},
        {"", "direction", text, plain, any, {"climb", "conventional"}, "climb; a cutter as large as a drum's roller cuts both",
         "Climb or conventional milling", of_milling(&MillingChoice::direction)},
        {"", "spindle", text, plain, any, {"clockwise", "counterclockwise"}, "clockwise",
         "Direction of rotation, seen from the spindle: clockwise (M3) or counterclockwise (M4)", of_milling(&MillingChoice::spindle)},
        {"", "compensation", text, plain, any, {"none", "control"}, "none",
         "none: the program is the path of the cutter's centre; control: of a plane cam, the contour with G41 or G42 and D",
         of_milling(&MillingChoice::compensation)},
        {"", "compensation_register", integer, plain, any, {}, "the tool's number, or 1", "D of G41 and G42",
         of_milling(&MillingChoice::compensation_register)},
        {"", "tool_number", integer, plain, any, {}, "no tool call, and the program notes this", "Calls the tool (T, M6)",
         of_milling(&MillingChoice::tool_number)},
        {"", "lead", number, length, any, {}, "the cutter's radius",
         "Radius of the quarter circles into and out of a plane cam's contour; of a closed groove the length of the move to its flank",
         of_milling(&MillingChoice::lead_radius)},
        {"", "ramp", number, angle, any, {}, "3", "Ramp angle of the cutter along a drum's groove; 90: straight",
         of_milling(&MillingChoice::ramp_angle)},
    };
}
// clang-format on

/// All rows, and where each group ends.
struct Rows {
    std::vector<KeyRow> all;
    std::array<std::size_t, 4> ends = {};

    Rows() {
        std::size_t group = 0;
        for (std::vector<KeyRow>& rows : std::array{plate_rows(), controller_rows(), program_rows()}) {
            std::ranges::move(rows, std::back_inserter(all));
            ends[++group] = all.size();
        }
    }
};

const Rows& rows() {
    static const Rows made;
    return made;
}

}  // namespace

std::span<const KeyRow> workshop_rows(WorkGroup group) {
    const auto which = static_cast<std::size_t>(group);
    return std::span(rows().all).subspan(rows().ends[which], rows().ends[which + 1] - rows().ends[which]);
}

std::span<const KeyRow> workshop_rows() {
    return rows().all;
}

WorkshopOptions workshop_options(std::span<const std::pair<std::string, std::string>> settings) {
    WorkshopOptions options;
    input::read_keys(settings, rows().all, options);
    return options;
}

}  // namespace camopt
