// SPDX-License-Identifier: MIT
#include "core/numbers/robust_fit.hpp"
#include "core/text/parsing.hpp"
#include "input/row_reader.hpp"
#include "input/scene_parts.hpp"
#include "scene/unit_fault.hpp"

#include <fmt/format.h>

namespace camopt::input {

namespace {

/// Of the form of a file.
constexpr std::array<std::string_view, 5> file_keys = {"columns", "decimal", "skip_lines", "scale", "offset"};

/// As written in the scene.
std::vector<double> numbers_of(const Given& given) {
    std::vector<double> numbers;
    for (const Node& item : given.value().items) numbers.push_back(item.as_number());
    return numbers;
}

void require_unit_of_lift(const SceneSource& source, const Place& place, const std::string& key,
                          const Spelling& unit, const MotionSpec& motion) {
    const std::array names = {find_row("measured", "s")->names()};
    if (const auto fault = unit_fault(key, unit.unit, motion, names))
        source.fail(place, key, words_of(*fault));
}

/// The row of "measured.theta[17]"; nullopt for other members.
std::optional<std::size_t> row_of(std::string_view member) {
    const std::size_t open = member.find('[');
    if (open == std::string_view::npos || !member.ends_with(']')) return std::nullopt;
    const auto row = integer_in(member.substr(open + 1, member.size() - open - 2));
    return row ? std::optional(static_cast<std::size_t>(*row)) : std::nullopt;
}

Node array_of(const std::vector<double>& numbers, const Place& place) {
    Node array;
    array.kind = NodeKind::array;
    array.place = place;
    for (const double number : numbers) {
        Node item;
        item.kind = NodeKind::number;
        item.number = number;
        item.place = place;
        array.items.push_back(std::move(item));
    }
    return array;
}

TableForm table_form(const MeasuredRows& rows) {
    TableForm form;
    form.columns = rows.columns;
    form.scale = rows.scale;
    form.offset = rows.offset;
    form.decimal = rows.decimal.front();
    form.skipped = rows.skip_lines;
    form.by_step = rows.step.has_value();
    form.points = true;
    form.crank = rows.angles == "crank";
    return form;
}

/// The middle of the stretch at the largest displacement that the scene gives, rad; none: it gives none.
std::optional<double> nose_angle(const MotionSpec& motion) {
    if (motion.type != MotionType::program) return motion.rise;
    double angle = 0.0, lifts = 0.0, largest = 0.0, from = 0.0, to = 0.0;
    for (const ProgramSegment& segment : motion.segments) {
        const double begin = angle;
        angle += segment.angle;
        if (segment.kind != SegmentKind::dwell) lifts = segment.to.value_or(0.0);
        if (lifts > largest) {
            largest = lifts;
            from = to = angle;
        } else if (segment.kind == SegmentKind::dwell && lifts == largest && begin == to) {
            to = angle;
        }
    }
    return largest > 0.0 ? std::optional(0.5 * (from + to)) : std::nullopt;
}

/// The cam angle from the start of the motion that is 0 in the table, rad.
double zero_angle(const SceneSource& source, const MotionSpec& motion, const MeasuredRows& rows) {
    if (rows.zero_angle) return *rows.zero_angle;
    if (rows.zero == "start") return 0.0;
    const std::optional<double> nose = nose_angle(motion);
    if (!nose)
        source.fail(source.find("measured", "zero")->value().place, "measured.zero",
                    "found \"nose\" in a program that gives no displacement above 0; allowed: \"start\" or "
                    "{ deg = … }");
    return *nose;
}

// rad: rounding of angles and turns.
constexpr double same_angle = 1e-9;

/// Angles beyond the motion of one revolution, in the half revolution before or after its middle. True: some
/// were moved. `range`: of all angles, rad.
bool wrap(std::vector<double>& angle, double range, const MotionSpec& motion) {
    const double whole = motion.length() * motion.unit_angle(), middle = 0.5 * whole;
    const bool one_turn = std::max(whole, range) <= units::turn + same_angle && !motion.relative;
    bool moved = false;
    for (double& at : angle) {
        if (!one_turn || (at >= -same_angle && at <= whole + same_angle)) continue;
        const double turns = std::floor((at - middle) / units::turn + 0.5);
        at -= turns * units::turn;
        moved = moved || turns != 0.0;
    }
    return moved;
}

/// Two rows of one angle, 0 and 360 deg, are one; with two displacements neither is right.
void refuse_contradicting(const MeasuredInput& input, std::size_t i, std::size_t j) {
    constexpr double same = 1e-6;  // of the largest displacement
    const std::vector<double>& displacement = input.motion.displacement;
    double largest = 0.0;
    for (const double one : displacement) largest = std::max(largest, std::abs(one));
    if (std::abs(displacement[i] - displacement[j]) <= same * largest) return;
    const auto words = [&](std::size_t row) {
        const std::size_t own = input.rows[row];
        if (!input.table) return fmt::format("row {}", own + 1);
        return fmt::format("{} = {} in line {}", input.table->s_key, input.table->s.at(own),
                           input.table->lines.at(own));
    };
    throw SceneError({entry_key("measured.s", j),
                      fmt::format("two displacements at one angle of the cam: {} and {}", words(i), words(j)),
                      "one of them"});
}

/// Ascending angles on the motion's revolution. Others stay as they are, for the scene's validation.
/// wraps: an angle and the same a revolution later are one.
void arrange(MeasuredInput& input, const MotionSpec& motion, bool wraps) {
    std::vector<double>&angle = input.motion.angle, &displacement = input.motion.displacement;
    std::vector<std::size_t>& rows = input.rows;
    for (std::size_t i = rows.size(); i < angle.size(); ++i) rows.push_back(i);
    if (angle.size() != displacement.size() || angle.empty()) return;
    if (angle.front() > angle.back()) {
        std::ranges::reverse(angle);
        std::ranges::reverse(displacement);
        std::ranges::reverse(rows);
    }
    if (!wraps || !std::ranges::is_sorted(angle)) return;
    const double range = angle.back() - angle.front();
    wrap(input.motion.breaks, range, motion);
    std::ranges::sort(input.motion.breaks);
    if (!wrap(angle, range, motion)) return;
    std::vector<std::size_t> order(rows.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return angle[i]; });
    const auto again =  // 0 and 360 deg
        std::unique(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const bool same = angle[b] - angle[a] <= same_angle;
            if (same) refuse_contradicting(input, a, b);
            return same;
        });
    order.erase(again, order.end());
    const MeasuredInput before = input;
    const auto reorder = [&](auto& to, const auto& from) {
        to.clear();
        for (const std::size_t i : order) to.push_back(from[i]);
    };
    reorder(angle, before.motion.angle);
    reorder(displacement, before.motion.displacement);
    reorder(rows, before.rows);
}

/// The numbers of the table in the place of its name.
MeasuredTable rows_of_table(const SceneSource& source, const KnownNames& known, MeasuredInput& input,
                            Scene& scene) {
    MeasuredRows& rows = *scene.measured_rows;
    if (!known.folder)
        source.fail(source.find("measured", "table")->value().place, "measured.table",
                    fmt::format("found a file name in a scene that was not read from a file; allowed: the "
                                "numbers, {} and {}, or a scene file that names its table",
                                measured_key("theta"), measured_key("s")));
    input.table = read_measured_table(*known.folder / rows.table, table_form(rows));
    input.motion.name = std::filesystem::path(rows.table).filename().string();
    if (rows.name.empty()) rows.name = input.motion.name;
    rows.table.clear();
    rows.columns.clear();
    rows.scale.clear();
    rows.offset.clear();
    rows.decimal = MeasuredRows().decimal;
    rows.skip_lines = 0;
    const MeasuredTable& table = *input.table;
    const auto keep = [&](const std::string& key, const std::vector<double>& numbers, const Spelling& unit) {
        for (const auto& [name, target] : {std::pair{"theta", &rows.theta},
                                           {"s", &rows.s},
                                           {"x", &rows.x},
                                           {"y", &rows.y},
                                           {"r", &rows.r},
                                           {"z", &rows.z}}) {
            if (!key.starts_with(name)) continue;
            for (const double number : numbers) target->push_back(number * unit.factor);
            scene.written[joined_key("measured", name)] = unit;
        }
    };
    if (!table.theta_key.empty()) keep(table.theta_key, table.theta, table.theta_unit);
    keep(table.s_key, table.s, table.s_unit);
    return table;
}

/// The arrays as a table without a file.
MeasuredTable rows_of_scene(const SceneSource& source, const Node& measured) {
    const auto x = source.find("measured", "x"), y = source.find("measured", "y"),
               r = source.find("measured", "r"), z = source.find("measured", "z"),
               s = r   ? r
                   : z ? z
                       : source.find("measured", "s"),
               theta = source.find("measured", "theta");
    const bool by_step = source.find("measured", "step").has_value();
    if (x.has_value() != y.has_value())
        source.fail(measured.place, joined_key("measured", measured_key(x ? "y" : "x")),
                    fmt::format("missing; allowed: {} with {}", measured_key("x"), measured_key("y")));
    if (!x && (!s || (!theta && !by_step)))
        source.fail(measured.place,
                    joined_key("measured", measured_key(theta || by_step ? "s"
                                                        : s              ? "theta"
                                                                         : "table")),
                    fmt::format("missing; allowed: table, or {} with {} or {}", measured_key("s"),
                                measured_key("theta"), measured_key("step")));
    for (const std::string_view name : file_keys)
        if (const auto given = source.find("measured", name))
            source.fail(given->member->place, joined_key("measured", name),
                        "found without a file; allowed: only with measured.table");
    const auto &first = x ? x : theta, &second = x ? y : s;
    MeasuredTable rows;
    rows.s = numbers_of(*second);
    rows.s_key = second->member->name;
    rows.s_unit = *second->spelling;
    if (!first) return rows;
    rows.theta = numbers_of(*first);
    rows.theta_key = first->member->name;
    rows.theta_unit = *first->spelling;
    return rows;
}

/// Pieces of the cam are in the place of rows.
MeasuredTable rows_of_pieces(const SceneSource& source) {
    for (const std::string_view name :
         {"table", "theta", "s", "x", "y", "r", "z", "step", "of", "probe_radius"})
        if (const auto given = source.find("measured", name))
            source.fail(given->member->place, joined_key("measured", given->member->name),
                        "found together with cam.piece; allowed: one of the two");
    return {};
}

RegisterRequest asked_for(const MeasuredRows& rows) {
    const auto asks = [&](const char* word) {
        return std::ranges::find(rows.registered, word) != rows.registered.end();
    };
    return {asks("angle"), asks("radius")};
}

/// The motion is that of a whole revolution, which ends where it began.
bool on_whole_turns(const MotionSpec& motion) {
    return motion.type == MotionType::rr || (motion.periodic() && !motion.relative);
}

/// The scene's cam under its follower, with points in the form that [measured] says.
std::shared_ptr<const CamUnderFollower> follower_on_points(const SceneSource& source, const Scene& scene) {
    const Place place = source.table("measured")->place;
    if (!scene.cam)
        source.fail(place, "measured",
                    fmt::format("found points of a cam where the scene has no cam; allowed: {}, or [cam]",
                                measured_key("s")));
    for (const CamDimension& dimension : scene.cam->dimensions)
        if (dimension.value.is_variable() &&
            !(dimension.name == "base_radius" && asked_for(*scene.measured_rows).radius))
            source.fail_member(
                "cam." + dimension.name,
                "found a range with points of the cam in [measured]; allowed: a number; for the "
                "base radius also register = [\"radius\"] in [measured]");
    for (const char* const name : {"zero", "angles"})
        if (const auto given = source.find("measured", name))
            source.fail(given->member->place, joined_key("measured", name),
                        "found with points of the cam; allowed: with displacements; register = [\"angle\"] "
                        "finds the angle of points");
    const MeasuredRows& rows = *scene.measured_rows;
    const MotionSpec& motion = scene.motion;
    return cam_under_follower(
        *scene.cam,
        {rows.probe_radius, rows.of == "center", rows.side - 1, on_whole_turns(motion), rows.radius},
        motion.lift);
}

/// The motion of the scene's follower on points or pieces.
void roll(SurfaceMotion motion, MeasuredInput& input) {
    input.motion.angle = std::move(motion.angle);
    input.motion.displacement = std::move(motion.displacement);
    input.motion.untouched = motion.untouched;
    input.motion.breaks = std::move(motion.breaks);
    input.rows = std::move(motion.rows);
}

void require_as_many(const SceneSource& source, const MeasuredTable& table) {
    if (table.theta.size() != table.s.size())
        source.fail(source.table("measured")->place, "measured",
                    fmt::format("found {} numbers in {} and {} in {}; allowed: as many", table.theta.size(),
                                table.theta_key, table.s.size(), table.s_key));
}

/// Displacements over the angle from the start of the motion.
void place_rows(const SceneSource& source, const Scene& scene, const MeasuredTable& table,
                MeasuredInput& input) {
    const MeasuredRows& rows = *scene.measured_rows;
    const auto written = source.find("measured", "table"), s = source.find("measured", "s");
    require_unit_of_lift(source, written ? written->value().place : s->member->place,
                         joined_key("measured", written ? written->member->name : s->member->name),
                         table.s_unit, scene.motion);
    for (const char* const name : {"probe_radius", "of", "side", "radius"})
        if (const auto given = source.find("measured", name))
            source.fail(given->member->place, "measured." + given->member->name,
                        "found with displacements; allowed: with points of the cam");
    const bool halved = rows.angles == "crank" && table.theta_unit.unit != "crank deg";
    const double zero = zero_angle(source, scene.motion, rows),
                 factor = table.theta_unit.factor * (halved ? 0.5 : 1.0);
    for (const double theta : table.theta) input.motion.angle.push_back(zero + theta * factor);
    for (const double lift : table.s) input.motion.displacement.push_back(lift * table.s_unit.factor);
}

/// on: the follower on points of the cam; null: the rows are displacements.
void register_table(const SceneSource& source, const Scene& scene, const KnownNames& known,
                    const CamUnderFollower* on, MeasuredMotion& measured) {
    const RegisterRequest request = asked_for(*scene.measured_rows);
    if (!request.angle && !request.radius) return;
    if (const auto zero = source.find("measured", "zero"); zero && request.angle)
        source.fail(zero->member->place, "measured.zero",
                    "found together with register = [\"angle\"], which searches it; allowed: one of the two");
    MeasuredPlace place = register_rows(scene.motion, known, request, measured);
    // Only a cam that turns is turned on the table; others are moved along.
    place.points = on != nullptr && is_turning(*on);
    if (place.points && place.angle) place.angle->value *= -sense_of(scene.cam->formulas()->rotation());
    if (on != nullptr && place.zero) place.base_radius = base_radius_for(*on, place.zero->value);
    measured.place = std::move(place);
}

constexpr std::size_t least_judged = 16;  // rows: fewer have no neighbourhood to judge them by

/// Rows far from their neighbours: named, or left out as well.
void judge_rows(bool exclude, MeasuredInput& input) {
    std::vector<double>&angle = input.motion.angle, &displacement = input.motion.displacement;
    input.motion.excluded = exclude;
    if (angle.size() != displacement.size() || angle.size() < least_judged || !std::ranges::is_sorted(angle))
        return;
    const double span = angle.back() - angle.front(), step = span / static_cast<double>(angle.size() - 1);
    const bool closed = span + 2.0 * step > units::turn && span < units::turn + same_angle;
    const std::vector<LocalFit> fits = local_fits(angle, displacement, closed ? units::turn : 0.0);
    std::vector<std::size_t> found = outliers_of(displacement, fits);
    for (const std::size_t i : found)
        input.motion.outliers.push_back({static_cast<int>(input.rows[i]) + 1, angle[i], fits[i].off});
    if (!input.motion.excluded) return;
    for (; !found.empty(); found.pop_back()) {  // from the last, so that the others keep their places
        const auto at = static_cast<std::ptrdiff_t>(found.back());
        angle.erase(angle.begin() + at);
        displacement.erase(displacement.begin() + at);
        input.rows.erase(input.rows.begin() + at);
    }
}

}  // namespace

std::optional<MeasuredInput> read_measured(const SceneSource& source, Scene& scene, const KnownNames& known) {
    const Node* const node = source.table("measured");
    if (!node || !scene.measured_rows) return std::nullopt;
    MeasuredInput input;
    const MeasuredRows& rows = *scene.measured_rows;
    input.motion.start = rows.use == "start";
    input.motion.given = rows.use == "given";
    const bool pieces = scene.cam && !scene.cam->pieces.empty();
    MeasuredTable table = pieces               ? rows_of_pieces(source)
                          : rows.table.empty() ? rows_of_scene(source, *node)
                                               : rows_of_table(source, known, input, scene);
    if (const auto step = source.find("measured", "step")) {
        for (std::size_t i = 0; i < table.s.size(); ++i)
            table.theta.push_back(static_cast<double>(i) * step->value().as_number());
        table.theta_unit = *step->spelling;
    }
    try {
        std::shared_ptr<const CamUnderFollower> on;
        if (pieces || table.is_points()) on = follower_on_points(source, scene);
        if (pieces) {
            roll(motion_on_pieces(scene.cam->pieces, *on), input);
        } else if (on) {
            require_as_many(source, table);
            std::vector<Eigen::Vector2d> points = points_of(table);
            if (is_guide(*on) && !rows.registered.empty() && !table.is_axial())
                input.motion.place = register_guide(scene.motion, asked_for(rows), points, *on);
            roll(motion_on_points(points, table.is_axial(), *on), input);
        } else {
            place_rows(source, scene, table, input);
        }
        if (!input.motion.place) register_table(source, scene, known, on.get(), input.motion);
        arrange(input, scene.motion, !on || is_turning(*on) || on_whole_turns(scene.motion));
    } catch (const SceneError& error) {
        fail_in_measured(source, input, error.fault());
    }
    if (!pieces) judge_rows(rows.outliers == "exclude", input);  // those of pieces are exact
    if (!rows.name.empty()) input.motion.name = rows.name;
    return input;
}

void fail_in_measured(const SceneSource& source, const MeasuredInput& measured, const SceneFault& fault) {
    const bool theta = fault.member.starts_with("measured.theta");
    if (theta && source.find("cam", "piece"))
        source.fail_member("cam.piece", fmt::format("found a path with its end at {}; allowed: {}",
                                                    fault.found, fault.allowed));
    if (!theta && fault.member != "measured.s" && !fault.member.starts_with("measured.s["))
        source.fail_member(fault.member, words_of(fault));
    std::optional<std::size_t> row = row_of(fault.member);
    if (row && !measured.rows.empty()) row = measured.rows.at(*row);
    if (!measured.table) {
        const char* const first = source.find("measured", "x") ? "x" : "theta";
        const char* const second = first[0] == 'x'                ? "y"
                                   : source.find("measured", "r") ? "r"
                                   : source.find("measured", "z") ? "z"
                                                                  : "s";
        const char* const name = theta ? first : second;
        source.fail_member(row ? entry_key(joined_key("measured", name), *row) : joined_key("measured", name),
                           words_of(fault));
    }
    const MeasuredTable& table = *measured.table;
    const std::string line = row ? fmt::format(":{}", table.lines.at(*row)) : std::string();
    const std::string key = table.is_points() ? "points" : theta ? table.theta_key : table.s_key;
    throw PlacedError(
        source.find("measured", "table")->value().place,
        fmt::format("{}{}: {}: {}", table.file, line, key.empty() ? "measured.step" : key, words_of(fault)));
}

void write_out_tables(Node& root, const std::filesystem::path& folder) {
    Member* const measured = root.find("measured");
    if (!measured || measured->value.kind != NodeKind::table) return;
    std::vector<Member>& members = measured->value.members;
    const auto written =
        std::ranges::find_if(members, [](const Member& member) { return member.name == "table"; });
    if (written == members.end() || written->value.kind != NodeKind::text) return;
    const std::string file = written->value.text;
    const Place place = written->place;
    Scene scene;
    SceneSource source;
    source.root.members.push_back(*measured);
    try {
        check_given_keys(source);
    } catch (const InputError&) {
        return;  // its reader says what is wrong
    }
    read_rows(source, scene);
    const MeasuredTable table = read_measured_table(folder / file, table_form(*scene.measured_rows));
    std::erase_if(members, [](const Member& member) {
        return member.name == "table" || std::ranges::find(file_keys, member.name) != file_keys.end();
    });
    if (!measured->value.find("name")) {
        Node name = text_node(std::filesystem::path(file).filename().string());
        name.place = place;
        members.push_back({"name", place, std::move(name)});
    }
    if (!table.theta_key.empty()) members.push_back({table.theta_key, place, array_of(table.theta, place)});
    members.push_back({table.s_key, place, array_of(table.s, place)});
}

}  // namespace camopt::input
