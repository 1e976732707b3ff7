// SPDX-License-Identifier: MIT
// The rows of [measured].
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"

namespace camopt::key_rows {
namespace {

using enum KeyType;
using namespace spellings;

template <class Member>
KeyPlace in_rows(Member member) {
    return stored_in(&Scene::measured_rows, member);
}

/// A word, or a table with an angle.
KeyPlace zero_place() {
    return {.assign =
                [](Scene& scene, const KeyValue& value, const KeyAt&) {
                    if (!scene.measured_rows) return;
                    if (const auto* const word = std::get_if<std::string>(&value))
                        scene.measured_rows->zero = *word;
                    else
                        scene.measured_rows->zero_angle.emplace();
                },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                if (!scene.measured_rows) return std::nullopt;
                return scene.measured_rows->zero_angle ? KeyValue() : KeyValue(scene.measured_rows->zero);
            }};
}

}  // namespace

// A row is read as a row.
// clang-format off
Rows of_measured() {
    return {
        called("table (CSV file)", {"measured", "table", text, plain, any, {}, "none",
         "A CSV file in the scene's folder (or a path from there), also one that camopt wrote. Its first line names "
         "the columns, in any order: `theta_deg`, `theta_rad` or `crank_deg`, the angle, and `s_mm`, `s_in`, `s_m`, "
         "`s_deg` or `s_rad`, or of points of a cam `x_mm` and `y_mm`, or `r_mm` or `z_mm` (`_in`, `_m`) and the angle; "
         "others are ignored.", in_rows(&MeasuredRows::table)}),
        {"measured", "columns", texts, plain, any, {}, "the file's first line",
         "Names of the columns, in the order of the file: of a file without such a line, or in place of it.",
         in_rows(&MeasuredRows::columns)},
        {"measured", "decimal", text, plain, any, {".", ","}, "\".\"",
         "Decimal point or comma of the file; with a comma, columns are separated by semicolons or tabs.",
         in_rows(&MeasuredRows::decimal)},
        {"measured", "scale", numbers, plain, any, {}, "1",
         "A number for each column of the file: what one unit of a cell is in the unit that the column's name says.",
         in_rows(&MeasuredRows::scale)},
        {"measured", "offset", numbers, plain, any, {}, "0",
         "A number for each column, added after `scale`, in the unit that the column's name says.",
         in_rows(&MeasuredRows::offset)},
        {"measured", "skip_lines", integer, plain, Range::between(0, 10000), {}, "0",
         "Lines at the beginning of the file that are not read. Needed only where they hold numbers: text above the "
         "names, or with `columns` above the first row, is passed over.", in_rows(&MeasuredRows::skip_lines)},
        {"measured", "theta", numbers, cam_angle, any, {}, "none",
         "The angles themselves, ascending or descending.", in_rows(&MeasuredRows::theta), Availability::now, "table"},
        {"measured", "s", numbers, lift, any, {}, "none", "The displacements at these angles.",
         in_rows(&MeasuredRows::s), Availability::now, "table"},
        {"measured", "x", numbers, length, any, {}, "none",
         "With `y`: points of the plane cam of `[cam]`, which become the motion of its follower. In the cam's frame: of a "
         "disk at cam angle 0 a pushed follower rises along +y, the pivot of a swinging one lies on +x.",
         in_rows(&MeasuredRows::x), Availability::needs_cam, "table"},
        {"measured", "y", numbers, length, any, {}, "none", "With `x`.", in_rows(&MeasuredRows::y), Availability::needs_cam, "table"},
        {"measured", "r", numbers, length, positive, {}, "none",
         "Such points in polar coordinates, with `theta` from +x counterclockwise.", in_rows(&MeasuredRows::r),
         Availability::needs_cam, "table"},
        {"measured", "z", numbers, length, any, {}, "none",
         "Of a three-dimensional cam, with `theta` about its axis: points of a flank, or of the groove's middle, on a "
         "cylinder about the axis.", in_rows(&MeasuredRows::z), Availability::needs_cam, "table"},
        {"measured", "of", text, plain, any, {"surface", "center"}, "\"surface\"",
         "What the points are on: the surface that the follower touches, or the path of the roller's centre (of a "
         "groove its middle).", in_rows(&MeasuredRows::of), Availability::needs_cam},
        {"measured", "side", integer, plain, Range::between(1, 2), {}, "1",
         "Of a cam with two sides (flanks of a groove, walls of a guide, conjugate disks): the one that the points are "
         "on, in the order of the reports.", in_rows(&MeasuredRows::side), Availability::needs_cam},
        {"measured", "radius", number, length, positive, {}, "at the roller's near end",
         "Of the cylinder that points `theta`, `z` are on.", in_rows(&MeasuredRows::radius), Availability::needs_cam},
        {"measured", "probe_radius", number, length, not_negative, {}, "0",
         "Points are the centres of a ball of this radius that touches the cam.", in_rows(&MeasuredRows::probe_radius),
         Availability::needs_cam},
        {"measured", "step", number, cam_angle, positive, {}, "none",
         "The angle from row to row, from 0 on, of displacements without angles.", in_rows(&MeasuredRows::step), Availability::now, "theta"},
        {"measured", "zero", text_or_table, plain, any, {"start", "nose"}, "\"start\"",
         "What angle 0 of the table is: the start of the motion, its nose (the end of the rise; in a program the "
         "middle of its largest displacement), or the cam angle `{ deg = 30 }` of the motion. Rows of one revolution "
         "may begin anywhere.", zero_place()},
        {"measured", "angles", text, plain, any, {"cam", "crank"}, "\"cam\"",
         "`\"crank\"`: `theta` and `step` are crank angles, two for one of the cam.", in_rows(&MeasuredRows::angles)},
        {"measured.zero", "deg", number, degrees, any, {}, "required", "Cam angle from the start of the motion.",
         in_rows(&MeasuredRows::zero_angle)},
        {"measured", "register", texts, plain, any, {"angle", "radius"}, "nothing",
         "What is not known of the table and searched: `\"angle\"`, the angle where the motion starts (instead of "
         "`zero`); `\"radius\"`, the displacement, or the base radius of points, where the motion has 0.", in_rows(&MeasuredRows::registered)},
        {"measured", "outliers", text, plain, any, {"keep", "exclude"}, "\"keep\"",
         "Rows far from their neighbours are named in reports. `\"exclude\"`: they are not used.",
         in_rows(&MeasuredRows::outliers)},
        called("used to", {"measured", "use", text, plain, any, {"compare", "start", "nearest", "given"}, "\"compare\"",
         "`\"compare\"`: what the optimum gains over it. `\"start\"`: searches begin from it, too. `\"nearest\"`: the "
         "optimum is the motion nearest to its rows (objective.deviation, or deviation_rms by `norm`). `\"given\"`: the "
         "motion is that of this cam, nothing is optimized.", in_rows(&MeasuredRows::use)}),
        {"measured", "norm", text, plain, any, {"peak", "rms"}, "\"peak\"",
         "Of `\"nearest\"`: the largest deviation, or the root mean square of all.", in_rows(&MeasuredRows::norm)},
        {"measured", "name", text, plain, any, {}, "the file's", "Its name in reports.", in_rows(&MeasuredRows::name)},
    };
}
// clang-format on

}  // namespace camopt::key_rows
