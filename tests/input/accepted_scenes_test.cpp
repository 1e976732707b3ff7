// SPDX-License-Identifier: MIT
// Every key of a scene file in every unit arrives in the Scene: tests/input/accepted.
#include "core/text/parsing.hpp"
#include "input/keys/scene_keys.hpp"
#include "input/scene_document.hpp"
#include "input/scene_text.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "scene/cam_mechanism.hpp"
#include "tests/input/cam_points.hpp"
#include "tests/input/scene_cases.hpp"
#include "tests/support/same_scene.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>
#include <variant>

namespace camopt::input {
namespace accepted_scenes_test {

using Value = std::variant<double, std::string>;
using Get = std::function<Value(const Scene&)>;

Value value(const PeakLimit& limit) {
    return limit.normalised;
}
Value value(const WrittenLimit& limit) {
    return limit.value;
}
template <class T>
Value value(const T& member) {
    if constexpr (std::is_arithmetic_v<T>)
        return static_cast<double>(member);
    else if constexpr (std::is_enum_v<T>)
        return name_of(member);
    else if constexpr (std::is_same_v<T, std::string>)
        return member;
    else
        return static_cast<double>(member.size());
}
template <class T>
Value value(const std::optional<T>& member) {
    return value(member.value());
}

// A member under its own path: FIELD(forces->mass) is "forces.mass".
// clang-format off
#define FIELD(path) {#path, [](const Scene& s) { return value(s.path); }}
#define FIELD_AS(name, path) {name, [](const Scene& s) { return value(s.path); }}

std::map<std::string, Get> plain_members() {
    const std::vector<std::pair<std::string, Get>> written = {
        FIELD(title), FIELD(motion.type), FIELD(motion.lift), FIELD(motion.lift_is_angle), FIELD(motion.rise),
        FIELD(motion.speed), FIELD(motion.symmetric), FIELD(motion.via), FIELD(motion.segments), FIELD(motion.within_lift),
        FIELD(motion.monotone), FIELD(motion.closed), FIELD(motion.relative), FIELD(motion.phase),
        FIELD_AS("motion.return", motion.return_angle), FIELD_AS("motion.corridor", motion.corridors),
        FIELD_AS("motion.corridor.from", motion.corridors.at(0).from),
        FIELD_AS("motion.corridor.to", motion.corridors.at(0).to), FIELD_AS("motion.duration", motion.valve->duration),
        FIELD_AS("motion.opening", motion.valve->opening), FIELD_AS("motion.checking_height", motion.valve->checking_height),
        FIELD_AS("motion.lash", motion.valve->lash), FIELD_AS("motion.centerline", motion.valve->centerline),
        FIELD_AS("motion.rocker_ratio", motion.valve->ratio),
        FIELD_AS("motion.opening_ramp.height", motion.valve->opening_ramp.height),
        FIELD_AS("motion.opening_ramp.velocity", motion.valve->opening_ramp.velocity),
        FIELD_AS("motion.opening_ramp.end", motion.valve->opening_ramp.end),
        FIELD_AS("motion.closing_ramp.height", motion.valve->closing_ramp.height),
        FIELD_AS("motion.closing_ramp.velocity", motion.valve->closing_ramp.velocity),
        FIELD_AS("motion.closing_ramp.end", motion.valve->closing_ramp.end),
        FIELD_AS("motion.segments.angle", motion.segments.at(0).angle),
        FIELD_AS("motion.segments.kind", motion.segments.at(0).kind),
        FIELD_AS("motion.segments.law", motion.segments.at(0).law), FIELD_AS("motion.segments.to", motion.segments.at(0).to),
        FIELD_AS("motion.segments.via", motion.segments.at(0).via), FIELD(cam->type), FIELD(cam->rotation),
        FIELD(cam->face_half_width), FIELD(cam->face_radius), FIELD_AS("linkage.type", cam->choice("linkage")),
        FIELD(drawing->bore), FIELD(drawing->datum), FIELD(drawing->density), FIELD(drawing->groove_depth),
        FIELD(drawing->projection), FIELD(drawing->thickness), FIELD(drawing->keyway->at), FIELD(drawing->keyway->depth),
        FIELD(drawing->keyway->width), FIELD(drawing->title_block.bore_fit), FIELD(drawing->title_block.date),
        FIELD(drawing->title_block.drawn_by), FIELD(drawing->title_block.keyway_tolerance),
        FIELD(drawing->title_block.material), FIELD(drawing->title_block.number), FIELD(drawing->title_block.organisation),
        FIELD(drawing->title_block.part), FIELD(drawing->title_block.profile_tolerance), FIELD(drawing->title_block.revision),
        FIELD(drawing->title_block.surface_finish), FIELD(drawing->title_block.tolerance), FIELD(drive->cycle),
        FIELD(drive->force), FIELD(drive->friction), FIELD(drive->load), FIELD(drive->motor_inertia),
        FIELD(drive->transmission), FIELD_AS("drive.transmission max", drive->transmission_range.value()[1]),
        FIELD(drive->viscous), FIELD(dynamics->damping), FIELD(dynamics->damping_ratio),
        FIELD(dynamics->ground_damping), FIELD(dynamics->mass), FIELD(dynamics->prescribe), FIELD(dynamics->natural_frequency), FIELD(dynamics->preload), FIELD(dynamics->stiffness),
        FIELD_AS("dynamics.return_spring", dynamics->return_stiffness),
        FIELD_AS("dynamics.speed_range", dynamics->speed_range.value()[1]),
        FIELD_AS("dynamics.stage.damping", dynamics->stages.at(0).damping),
        FIELD_AS("dynamics.stage.mass", dynamics->stages.at(0).mass),
        FIELD_AS("dynamics.stage.stiffness", dynamics->stages.at(0).stiffness), FIELD(forces->cam_modulus),
        FIELD(forces->cam_poisson), FIELD(forces->contact_width), FIELD(forces->damping), FIELD(forces->follower_modulus),
        FIELD(forces->follower_poisson), FIELD(forces->mass), FIELD(forces->preload), FIELD(forces->spring_frequency),
        FIELD_AS("forces.preload max", forces->preload_range.value()[1]),
        FIELD_AS("forces.spring_rate max", forces->spring_rate_range.value()[1]), FIELD(forces->spring_rate), FIELD_AS("forces.load", forces->load.back()[1]),
        FIELD_AS("forces.speed_range", forces->speed_range.value()[1]), FIELD(limits.velocity), FIELD(limits.acceleration),
        FIELD(limits.jerk), FIELD(limits.cam_velocity), FIELD(limits.cam_acceleration), FIELD(limits.cam_jerk), FIELD(limits.cam_radius_min), FIELD(limits.concave_radius_min), FIELD(limits.contact_force_min),
        FIELD(limits.contact_force_max),
        FIELD(limits.dynamic_contact_force_min), FIELD(limits.hertz_pressure_max),
        FIELD_AS("limits.motor_curve", limits.motor_curve.at(1)[0]), FIELD(limits.motor_speed), FIELD(limits.motor_torque),
        FIELD_AS("limits.motor_torque max", limits.motor_torque_max),
        FIELD_AS("limits.motor_torque min", limits.motor_torque_min), FIELD(limits.motor_torque_rms),
        FIELD(limits.pressure_angle), FIELD(limits.residual), FIELD(limits.return_pressure_angle),
        FIELD(limits.rise_pressure_angle), FIELD(limits.spring_harmonic),
        FIELD_AS("limits.spring_harmonics", limits.spring_harmonics[1]), FIELD(limits.torque_max),
        FIELD(limits.undercut_margin), FIELD_AS("measured.angle", measured->angle.at(3)),
        FIELD_AS("measured.displacement", measured->displacement.at(3)), FIELD_AS("measured.of", measured_rows->of),
        FIELD_AS("measured.side", measured_rows->side), FIELD(measured->given),
        FIELD_AS("cam.piece", cam->pieces), FIELD_AS("cam.piece.to", cam->pieces.at(0).to.at(1)),
        FIELD_AS("cam.piece.from", cam->pieces.at(0).from.at(1)),
        FIELD_AS("cam.piece.center", cam->pieces.at(1).center.at(1)), FIELD(measured->excluded), FIELD(measured->name),
        FIELD(measured->start), FIELD_AS("measured.size", measured->angle),
        FIELD_AS("measured.zero", measured->place->zero.has_value()), FIELD(objective.acceleration), FIELD(objective.area),
        FIELD(objective.deviation), FIELD(objective.deviation_rms), FIELD(objective.dynamic_acceleration),
        FIELD(objective.jerk), FIELD_AS("objective.largest", objective.sought.value().key),
        FIELD_AS("objective.least", objective.sought.value().key), FIELD(objective.least_gap),
        FIELD(objective.peaks), FIELD(objective.motor_torque), FIELD(objective.motor_torque_rms), FIELD(objective.residual),
        FIELD(objective.rms_acceleration), FIELD(objective.rms_jerk), FIELD(objective.tie_break), FIELD(objective.torque),
        FIELD(objective.velocity), FIELD(objective.reference.acceleration), FIELD(objective.reference.area),
        FIELD(objective.reference.deviation), FIELD(objective.reference.deviation_rms),
        FIELD(objective.reference.dynamic_acceleration), FIELD(objective.reference.jerk), FIELD(objective.reference.law),
        FIELD(objective.reference.motor_torque), FIELD(objective.reference.motor_torque_rms),
        FIELD(objective.reference.numeric), FIELD(objective.reference.residual), FIELD(objective.reference.rms_acceleration),
        FIELD(objective.reference.rms_jerk), FIELD(objective.reference.torque), FIELD(objective.reference.velocity),
        FIELD(solver.explain_changes), FIELD(solver.explain_seconds), FIELD(solver.gap), FIELD(solver.max_seconds),
        FIELD(solver.name), FIELD(solver.options), FIELD(solver.seed), FIELD(solver.starts), FIELD(solver.tolerance),
        FIELD_AS("spline.breakpoints", spline.breakpoints.at(1)), FIELD_AS("spline.continuity", spline.smoothness()),
        FIELD(spline.degree), FIELD(spline.design), FIELD(spline.rest), FIELD(spline.free_knots), FIELD(spline.segments),
        FIELD_AS("tolerance.profile", tolerance->motion.at(0)), FIELD_AS("tolerance.slope", tolerance->motion.at(1)),
        FIELD_AS("tolerance.acceleration", tolerance->motion.at(2))};
    std::map<std::string, Get> members;
    for (auto [name, get] : written) {
        for (std::size_t at = name.find("->"); at != std::string::npos; at = name.find("->"))
            name.replace(at, 2, ".");
        members[name] = get;
    }
    return members;
}
#undef FIELD
#undef FIELD_AS
// clang-format on

void add_set_points(std::map<std::string, Get>& members) {
    const std::map<std::string, std::function<const SetPoint&(const Scene&)>> points = {
        {"motion.via", [](const Scene& s) -> const SetPoint& { return s.motion.via.at(0); }},
        {"motion.start", [](const Scene& s) -> const SetPoint& { return s.motion.start.value(); }},
        {"motion.end", [](const Scene& s) -> const SetPoint& { return s.motion.end.value(); }},
        {"motion.segments.via",
         [](const Scene& s) -> const SetPoint& { return s.motion.segments.at(0).via.at(0); }},
        {"motion.segments.end",
         [](const Scene& s) -> const SetPoint& { return s.motion.segments.at(0).end.value(); }}};
    for (const auto& [table, point] : points) {
        members[table + ".at"] = [=](const Scene& s) { return point(s).at; };
        members[table + ".from"] = [=](const Scene& s) { return point(s).at; };
        members[table + ".to"] = [=](const Scene& s) { return point(s).until.value(); };
        members[table + ".displacement"] = [=](const Scene& s) { return point(s).displacement.value(); };
        members[table + ".velocity"] = [=](const Scene& s) { return point(s).velocity.value(); };
        members[table + ".acceleration"] = [=](const Scene& s) { return point(s).acceleration.value(); };
    }
    // The upper bound; the other must be missing.
    const std::vector<std::string> orders = {"displacement", "velocity", "acceleration", "jerk"};
    for (std::size_t order = 0; order < orders.size(); ++order)
        members["motion.corridor." + orders[order]] = [order](const Scene& s) {
            const Corridor::Bounds& own = s.motion.corridors.at(0).bounds.at(order);
            EXPECT_FALSE(own.least);
            return own.most.value();
        };
}

/// Of a dimension or a number of the spring, perhaps in percent.
void add_tolerances(std::map<std::string, Get>& members) {
    for (const KeyRow& row : scene_keys()) {
        if (row.table != "tolerance" || members.contains("tolerance." + std::string(row.name))) continue;
        std::string name(row.name);
        if (const std::size_t percent = name.find("_percent"); percent != std::string::npos)
            name.resize(percent);
        members["tolerance." + std::string(row.name)] = [name](const Scene& s) {
            return s.tolerance->numbers.at(name).size;
        };
    }
}

/// What the scene holds under the name. Of a cam its words and its dimensions: the lower bound, "… max" the
/// upper one, "… unit" the unit.
Value member_of(const Scene& scene, std::string name) {
    static const std::map<std::string, Get> members = [] {
        std::map<std::string, Get> all = plain_members();
        add_set_points(all);
        add_tolerances(all);
        for (int i = 0; i < dimension_count; ++i)
            all[std::string("objective.") + name_of(static_cast<DimensionIndex>(i))] = [i](const Scene& s) {
                return s.objective.dimensions.at(static_cast<std::size_t>(i));
            };
        return all;
    }();
    if (const auto found = members.find(name); found != members.end()) return found->second(scene);
    name.erase(0, name.find('.') + 1);
    const bool upper = name.ends_with(" max"), unit = name.ends_with(" unit");
    name.resize(name.find_first_of(" ") == std::string::npos ? name.size() : name.find(' '));
    const Dimension* const found = scene.cam.value().find(name);
    if (found == nullptr) return scene.cam->choice(name);
    return unit ? found->unit : upper ? found->high : found->low;
}

/// "-pi/12", "0.9*pi/180".
double number_of(const std::string& text) {
    double number = 1.0;
    char sign = '*';
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find_first_of("*/", from), text.size());
        const std::string one = text.substr(from, to - from);
        const double factor = one == "pi"    ? std::numbers::pi
                              : one == "-pi" ? -std::numbers::pi
                                             : number_in(one).value();
        number = sign == '*' ? number * factor : number / factor;
        sign = to < text.size() ? text[to] : '*';
        from = to + 1;
    }
    return number;
}

/// Reaches everywhere with any numbers: the cases try one number at a time.
class ReachingMechanism final : public CamMechanism {
 public:
    explicit ReachingMechanism(const CamSpec& spec) : cam_(cam_formulas(spec)) {}
    [[nodiscard]] std::string type() const override { return cam_->type(); }
    [[nodiscard]] bool swings() const override { return cam_->swings(); }
    [[nodiscard]] Rotation rotation() const override { return cam_->rotation(); }
    [[nodiscard]] int stations() const override { return cam_->stations(); }
    [[nodiscard]] std::string station_name(int station) const override { return cam_->station_name(station); }
    [[nodiscard]] int roller_radius_at(int station) const override { return cam_->roller_radius_at(station); }
    [[nodiscard]] std::optional<MechanismQuantity> radius_quantity() const override {
        return cam_->radius_quantity();
    }
    [[nodiscard]] const DirectCam* direct() const override { return cam_->direct(); }
    [[nodiscard]] std::optional<FollowerGeometry> follower(std::span<const double> numbers,
                                                           int station) const override {
        return cam_->follower(numbers, station);
    }
    [[nodiscard]] double length(std::span<const double> numbers) const override {
        return cam_->length(numbers);
    }
    [[nodiscard]] std::string fault(std::span<const double>, double, double) const override { return {}; }
    [[nodiscard]] MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int station,
                                          std::span<const int> active) const override {
        return cam_->quantity(which, state, station, active);
    }
    [[nodiscard]] MechanismPoint point(double theta, const MechanismState& state,
                                       int station) const override {
        return cam_->point(theta, state, station);
    }

 private:
    std::shared_ptr<const CamMechanism> cam_;
};

KnownNames reaching() {
    KnownNames names = {.laws = {"cycloidal", "modified_sine"},
                        .solvers = {"ipopt", "nlopt.slsqp", "structured"},
                        .cam_formulas = [](const CamSpec& spec) -> std::shared_ptr<const CamMechanism> {
                            if (!spec.pieces.empty() || spec.type == "cylindrical") return cam_formulas(spec);
                            return std::make_shared<ReachingMechanism>(spec);
                        },
                        .law_shape =
                            [](const std::string&) {
                                return [](double t) {
                                    return std::array{t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t)};
                                };
                            }};
    names.folder = source_folder() + "/tests/input/accepted";
    return names;
}

class AcceptedScenes : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(AcceptedScenes, ArriveInSiUnits) {
    const KnownNames names = reaching();
    const std::vector<AcceptedScene> all = accepted_scenes(GetParam());
    EXPECT_GT(all.size(), 5U);
    for (const AcceptedScene& one : all) {
        SCOPED_TRACE(one.place + ": " + one.key + "\n" + one.toml);
        const Value got = member_of(read_scene(one.toml, "s.toml", names, {}), one.field);
        if (const auto* const number = std::get_if<double>(&got)) {
            const double expected = number_of(one.expected);
            EXPECT_NEAR(*number, expected, 1e-13 * std::abs(expected));
        } else {
            EXPECT_EQ(std::get<std::string>(got), one.expected);
        }
    }
}

/// "motion.segments[0].angle_deg" as its row is named: "motion.segments.angle_deg".
std::string without_indices(std::string_view key) {
    std::string plain;
    bool inside = false;
    for (const char letter : key) {
        inside = letter == '[' || (inside && letter != ']');
        if (!inside && letter != ']') plain += letter;
    }
    return plain;
}

const KeyRow* row_of(std::string_view key) {
    const std::size_t dot = key.rfind('.');
    return dot == std::string_view::npos ? match_key("", key).row
                                         : match_key(key.substr(0, dot), key.substr(dot + 1)).row;
}

TEST_P(AcceptedScenes, AreWrittenAsTheyWereRead) {
    const KnownNames names = reaching();
    std::size_t in_their_units = 0;
    const std::vector<AcceptedScene> all = accepted_scenes(GetParam());
    for (const AcceptedScene& one : all) {
        SCOPED_TRACE(one.place + ": " + one.key + "\n" + one.toml);
        const Scene scene = read_scene(one.toml, "s.toml", names, {});
        const std::string text = scene_text(scene);
        SCOPED_TRACE(text);
        const Scene again = read_scene(text, "again.toml", names, {});
        EXPECT_EQ(testing_support::differing_parts(scene, again), "");
        EXPECT_EQ(scene_text(again), text);
        for (const WrittenKey& key : keys_written_in(text, "again.toml"))
            if (row_of(without_indices(key.key)) == row_of(one.key)) {
                EXPECT_EQ(without_indices(key.key), one.key);
                ++in_their_units;
                break;
            }
    }
    // Others have their default, or are numbers of a table.
    EXPECT_GE(in_their_units, all.size() * 3 / 4);
}

/// As C and Python do, and --set.
TEST_P(AcceptedScenes, AreSetByPrograms) {
    const KnownNames names = reaching();
    std::size_t count = 0;
    const std::vector<AcceptedScene> all = accepted_scenes(GetParam());
    for (const AcceptedScene& one : all) {
        SCOPED_TRACE(one.place + ": " + one.key + "\n" + one.toml);
        const Scene scene = read_scene(one.toml, "s.toml", names, {});
        const std::vector<WrittenKey> keys = keys_written_in(one.toml, "s.toml");
        const auto key = std::ranges::find(
            keys, one.key, [](const WrittenKey& written) { return without_indices(written.key); });
        if (key == keys.end()) continue;
        SceneDocument document(one.toml, "s.toml", names);
        const std::vector<std::string> setting = {key->key + "=" + key->value};
        EXPECT_EQ(testing_support::differing_parts(scene, document.scene(setting)), "");
        document.unset(key->key);
        document.set(key->key, TomlValue{key->value});
        EXPECT_EQ(testing_support::differing_parts(scene, document.scene()), "");
        ++count;
    }
    EXPECT_GE(count, all.size() * 3 / 4);
}

INSTANTIATE_TEST_SUITE_P(Files, AcceptedScenes,
                         testing::ValuesIn(case_files(source_folder() + "/tests/input/accepted")),
                         [](const auto& info) { return info.param.stem().string(); });

TEST(SceneReader, CamPointsArriveInEveryUnit) {
    const KnownNames names = reaching();
    for (const CamPointKey& one : cam_point_keys()) {
        SCOPED_TRACE(one.key);
        const Scene scene = read_scene(one.toml, "s.toml", names, {});
        const Scene again = read_scene(scene_text(scene), "again.toml", names, {});
        EXPECT_EQ(testing_support::differing_parts(scene, again), "");
        const MeasuredMotion& measured = scene.measured.value();
        const double angle = 20.0 * std::numbers::pi / 36.0;
        const auto row =
            std::ranges::min_element(measured.angle, {}, [&](double at) { return std::abs(at - angle); });
        const double lift = measured.displacement.at(static_cast<std::size_t>(row - measured.angle.begin()));
        EXPECT_NEAR(lift, 0.01 * angle, 1e-15);
    }
}

TEST(SceneReader, CoversEveryKeyOfTheTable) {
    std::set<std::string> tried, written;
    for (const AcceptedScene& one : all_accepted_scenes()) tried.insert(one.key);
    for (const CamPointKey& one : cam_point_keys()) tried.insert(one.key);
    for (const KeyRow& row : scene_keys()) {
        if (row.type == KeyType::table) continue;
        for (const Spelling& spelling : row.spellings)
            written.insert((row.table.empty() ? "" : std::string(row.table) + ".") + row.key(spelling));
    }
    EXPECT_EQ(tried, written);
}

}  // namespace accepted_scenes_test
}  // namespace camopt::input
