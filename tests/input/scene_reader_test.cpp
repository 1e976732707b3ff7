// SPDX-License-Identifier: MIT
// Every key in every unit arrives in the Scene; what is absent keeps its default; overrides replace.
#include "input/scene_reader.hpp"

#include "core/errors.hpp"
#include "input/keys/scene_keys.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "scene/written_limits.hpp"
#include "tests/input/scene_key_cases.hpp"
#include "tests/output/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

namespace camopt::input {
namespace scene_reader_test {

constexpr double pi = std::numbers::pi;
const KnownNames known = {.laws = {"cycloidal", "modified_sine"},
                          .solvers = {"ipopt", "nlopt.slsqp", "structured"},
                          .cam_formulas = cam_formulas,
                          .law_shape = [](const std::string&) {
                              return [](double t) {
                                  return std::array{t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t)};
                              };
                          }};
const std::string drd = "motion.type = \"DRD\"\n";
const std::string jerk_only = "objective.jerk = 1\n";

/// Where measured.csv lies.
std::filesystem::path folder_of_tables() {
    static const test::TemporaryFolder own;  // tests run beside one another
    const std::filesystem::path folder = own.path();
    std::ofstream(folder / "measured.csv")
        << "s_mm,theta_rad\n0,0\n1,0.2\n3,0.5\n7,0.8\n12,1.1\n17,1.4\n19,1.7\n20,2\n";
    return folder;
}

Scene read(const std::string& toml, const std::vector<std::string>& overrides = {}) {
    static const KnownNames with_folder = [] {
        KnownNames names = known;
        names.folder = folder_of_tables();
        return names;
    }();
    return read_scene(toml, "s.toml", with_folder, overrides);
}

std::vector<KeyCase> key_cases() {
    std::vector<KeyCase> all;
    for (const auto& part :
         {motion_cases(), valve_cases(), segment_cases(), set_point_cases(), measured_cases(), spline_cases(),
          objective_cases(), dimension_weight_cases(), cam_cases(), remote_cases(), spatial_cases(),
          inverse_cases(), force_cases(), limit_cases(), cam_limit_cases(), drawing_cases(), dynamics_cases(),
          drive_cases(), solver_cases()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// A set point, or a region, with this key.
std::string point_with(const std::string& key, const std::string& value) {
    std::string beside = "at = 0.5";
    if (key.starts_with("at")) beside = "velocity = 1";
    if (key.starts_with("from")) beside = "velocity = 1, to = 0.875";
    if (key.starts_with("to")) beside = "velocity = 1, from = 0.125";
    return "{ " + beside + ", " + key + " = " + value + " }";
}

/// A stage of an elastic follower with this key.
std::string stage_with(const std::string& key, const std::string& value) {
    const bool turns = key.starts_with("inertia") || key.ends_with("rad");
    std::string members = key + " = " + value;
    if (!key.starts_with("mass") && !key.starts_with("inertia"))
        members += turns ? ", inertia_kg_m2 = 1" : ", mass_kg = 1";
    if (!key.starts_with("stiffness")) members += turns ? ", stiffness_nm_rad = 4" : ", stiffness_n_m = 4";
    return "dynamics.stage = [{ " + members + " }]\n";
}

/// The smallest scene that holds the key.
std::string scene_with(const KeyCase& c) {
    const std::string via = "motion.via.", segment = "motion.segments.";
    std::string toml = c.rest;
    if (c.key.starts_with(via))
        toml += "motion.via = [" + point_with(c.key.substr(via.size()), c.value) + "]\n";
    else if (c.key.starts_with(segment + "via."))
        toml += "motion.segments = [{ kind = \"spline\", angle_rad = 2, to = 1, via = [" +
                point_with(c.key.substr(segment.size() + 4), c.value) + "] }]\n";
    else if (c.key.starts_with(segment + "end."))
        toml += "motion.segments = [{ kind = \"spline\", angle_rad = 2, to = 1, end = { " +
                c.key.substr(segment.size() + 4) + " = " + c.value +
                " } }, { kind = \"spline\", angle_deg = 100, to = 0.25 }]\n";
    else if (const std::string corridor = "motion.corridor."; c.key.starts_with(corridor))
        toml += "motion.corridor = [{ " + c.key.substr(corridor.size()) + " = " + c.value +
                (c.key.find("displacement") == std::string::npos && c.value.find("max") == std::string::npos
                     ? ", displacement = { min = -1 }"
                     : "") +
                " }]\n";
    else if (c.key.starts_with(segment))
        toml += "motion.segments = [{ " + c.key.substr(segment.size()) + " = " + c.value +
                (c.key.find("angle") == std::string::npos ? ", angle_deg = 120" : "") +
                (c.key != segment + "kind"
                     ? ", kind = \"" + std::string(c.key == segment + "law" ? "law" : "spline") + "\""
                     : "") +
                " }, { kind = \"spline\", angle_deg = 100, to = 0.25 }]\n";
    else if (const std::string stage = "dynamics.stage."; c.key.starts_with(stage))
        toml += stage_with(c.key.substr(stage.size()), c.value);
    else
        toml += c.key + " = " + c.value + "\n";
    if (c.key != "motion.type" && c.rest.find("motion.type") == std::string::npos) toml += drd;
    if (c.key.starts_with("objective.reference.") && !c.key.ends_with(".jerk"))
        toml += "objective.reference.jerk = 69\n";
    return c.key == "objective.jerk" ? toml : toml + jerk_only;
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
    [[nodiscard]] int roller_radius() const override { return cam_->roller_radius(); }
    [[nodiscard]] bool planar() const override { return cam_->planar(); }
    [[nodiscard]] bool is_direct() const override { return cam_->is_direct(); }
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
    [[nodiscard]] std::vector<MechanismShape> shapes(const MechanismState& state) const override {
        return cam_->shapes(state);
    }

 private:
    std::shared_ptr<const CamMechanism> cam_;
};

TEST(SceneReader, EveryKeyArrivesInSiUnits) {
    KnownNames reaching = known;
    reaching.folder = folder_of_tables();
    reaching.cam_formulas = [](const CamSpec& spec) { return std::make_shared<ReachingMechanism>(spec); };
    for (const KeyCase& c : key_cases()) {
        SCOPED_TRACE(c.key);
        const Scene scene = read_scene(scene_with(c), "s.toml", reaching, {});
        EXPECT_NEAR(c.got(scene), c.expected, 1e-13 * std::abs(c.expected));
    }
}

TEST(SceneReader, CoversEveryKeyOfTheTable) {
    std::set<std::string> tried, written;
    for (const KeyCase& c : key_cases()) tried.insert(c.key);
    for (const KeyRow& row : scene_keys()) {
        if (row.type == KeyType::table) continue;
        for (const Spelling& spelling : row.spellings)
            written.insert((row.table.empty() ? "" : std::string(row.table) + ".") + row.key(spelling));
    }
    EXPECT_EQ(tried, written);
}

TEST(SceneReader, MissingKeysKeepDefaults) {
    const Scene scene = read(drd + jerk_only);
    EXPECT_EQ(scene.title, "");
    EXPECT_EQ(scene.motion.lift, 1e-3);
    EXPECT_FALSE(scene.motion.lift_is_angle);
    EXPECT_DOUBLE_EQ(scene.motion.rise, pi);
    EXPECT_FALSE(scene.motion.return_angle || scene.motion.speed || scene.motion.symmetric);
    EXPECT_EQ(scene.spline.degree, 3);
    EXPECT_EQ(scene.spline.segments, 12);
    EXPECT_EQ(scene.spline.smoothness(), 2);
    EXPECT_EQ(scene.objective.velocity, 0.0);
    EXPECT_EQ(scene.objective.reference.law, "modified_sine");
    EXPECT_FALSE(scene.objective.reference.numeric);
    EXPECT_EQ(scene.objective.tie_break, TieBreak::rms_jerk);
    EXPECT_FALSE(scene.limits.velocity || scene.limits.acceleration || scene.limits.jerk);
    EXPECT_EQ(scene.solver.name, "auto");
    EXPECT_EQ(scene.solver.tolerance, 1e-9);
    EXPECT_FALSE(scene.solver.gap);
    EXPECT_EQ(scene.solver.wanted_gap(), 1e-7);
    EXPECT_EQ(scene.solver.wanted_gap(false), 1e-4);
    EXPECT_EQ(scene.solver.max_seconds, 60.0);
    EXPECT_TRUE(scene.solver.options.empty());
}

TEST(SceneReader, LimitRemembersItsSpelling) {
    const Scene scene =
        read(drd + jerk_only + "motion.lift_mm = 20\nmotion.speed_rad_s = 10\nlimits.velocity_in_s = 10\n");
    const PeakLimit& limit = scene.limits.velocity.value();
    EXPECT_EQ(limit.key, "limits.velocity_in_s");
    EXPECT_EQ(limit.given, 10.0);
    EXPECT_EQ(limit.unit, "in/s");
    EXPECT_NEAR(limit.unit_per_normalised(), 0.02 * 10 / pi / 0.0254, 1e-12);
}

TEST(SceneReader, OptionsKeepTheirTypes) {
    const auto options =
        read(drd + jerk_only + "[solver.options]\na = 1\nb = 0.5\nc = true\nd = \"e\"\n").solver.options;
    EXPECT_EQ(std::get<long long>(options.at("a")), 1);
    EXPECT_EQ(std::get<double>(options.at("b")), 0.5);
    EXPECT_EQ(std::get<bool>(options.at("c")), true);
    EXPECT_EQ(std::get<std::string>(options.at("d")), "e");
}

TEST(SceneReader, TheProgramOfTheContractArrives) {
    const Scene scene = read(jerk_only +
                             "[motion]\n"
                             "type = \"program\"\n"
                             "lift_mm = 80\n"
                             "[[motion.segments]]\n"
                             "kind = \"dwell\"\n"
                             "angle_deg = 60\n"
                             "[[motion.segments]]\n"
                             "kind = \"spline\"\n"
                             "angle_deg = 120\n"
                             "to_mm = 80\n"
                             "[[motion.segments]]\n"
                             "kind = \"law\"\n"
                             "law = \"cycloidal\"\n"
                             "angle_deg = 90\n"
                             "to = 0.5\n"
                             "[[motion.segments]]\n"
                             "kind = \"spline\"\n"
                             "angle_deg = 45\n"
                             "[[motion.segments]]\n"
                             "kind = \"dwell\"\n"
                             "angle_deg = 30\n"
                             "[[motion.segments]]\n"
                             "kind = \"dwell\"\n"
                             "angle_deg = 15\n"
                             "[spline]\n"
                             "breakpoints = [0, 0.5, 1]\n");
    ASSERT_EQ(scene.motion.segments.size(), 6U);
    EXPECT_TRUE(scene.motion.closed);
    EXPECT_EQ(scene.motion.segments[1].to, 1.0);
    EXPECT_EQ(scene.motion.segments[2].law, "cycloidal");
    EXPECT_EQ(scene.motion.segments[2].to, 0.5);
    EXPECT_FALSE(scene.motion.segments[3].to);
    EXPECT_DOUBLE_EQ(scene.motion.unit_angle(), 2 * pi / 3);
    EXPECT_DOUBLE_EQ(scene.motion.length(), 3.0);
}

TEST(SceneReader, ProgramTimeLimitsUseFirstSpline) {
    const Scene scene = read(jerk_only +
                             "motion.type = \"program\"\n"
                             "motion.lift_mm = 20\n"
                             "motion.speed_rad_s = 10\n"
                             "motion.closed = false\n"
                             "motion.segments = [{ kind = \"dwell\", angle_rad = 1 },\n"
                             "  { kind = \"spline\", angle_rad = 2, to = 1 }]\n"
                             "limits.velocity_mm_s = 180\n");
    EXPECT_NEAR(scene.limits.velocity.value().normalised, 1.8, 1e-14);
    EXPECT_TRUE(scene.limits.velocity->in_time());
}

const std::string knife =
    "motion.lift_mm = 10\ncam.type = \"disk\"\ncam.follower = \"translating_knife\"\ncam.base_radius_mm = "
    "40\n";

TEST(SceneReader, DimensionRemembersItsSpelling) {
    const Scene scene = read(drd + jerk_only + knife + "cam.offset_in = { min = 0, max = 1 }\n");
    const Dimension& offset = *scene.cam.value().find(DimensionIndex::offset);
    EXPECT_TRUE(offset.is_variable());
    EXPECT_EQ(offset.key, "cam.offset_in");
    EXPECT_EQ(offset.unit, 0.0254);
    const Dimension& base = *scene.cam.value().find(DimensionIndex::base_radius);
    EXPECT_FALSE(base.is_variable());
    EXPECT_EQ(base.key, "cam.base_radius_mm");
    EXPECT_EQ(scene.cam.value().find(DimensionIndex::roller_radius), nullptr);
}

TEST(SceneReader, SceneRemembersItsLengthUnit) {
    EXPECT_EQ(read(drd + jerk_only).length_unit, LengthUnit::millimetre);
    EXPECT_EQ(read(drd + jerk_only + "motion.lift_in = 1\n").length_unit, LengthUnit::inch);
    EXPECT_EQ(read(drd + jerk_only + "motion.lift_m = 1\n").length_unit, LengthUnit::millimetre);
    const std::string swing = drd + jerk_only +
                              "motion.lift_deg = 20\ncam.type = \"disk\"\ncam.follower = "
                              "\"oscillating_flat\"\ncam.face_offset_mm = 0\n";
    EXPECT_EQ(read(swing + "cam.base_radius_in = 1\ncam.center_distance_in = 4\n").length_unit,
              LengthUnit::inch);
    EXPECT_EQ(read(swing + "cam.base_radius_mm = 25\ncam.center_distance_in = 4\n").length_unit,
              LengthUnit::millimetre);
}

TEST(SceneReader, CamLimitRemembersItsSpelling) {
    const Scene scene = read(drd + jerk_only + knife + "limits.pressure_angle_deg = 30\n");
    const WrittenLimit& limit = scene.limits.pressure_angle.value();
    EXPECT_EQ(limit.key, "limits.pressure_angle_deg");
    EXPECT_DOUBLE_EQ(limit.given(), 30.0);
    EXPECT_EQ(limit.unit, "deg");
}

TEST(SceneReader, VariableDimensionSufficesAsObjective) {
    const Scene scene =
        read(drd + "objective.offset = 1\n" + knife + "cam.offset_mm = { min = -5, max = 5 }\n");
    EXPECT_EQ(scene.objective.jerk, 0.0);
}

TEST(SceneReader, MissingForcesAndDimensionsKeepDefaults) {
    const Scene scene = read(drd + jerk_only + knife + "motion.speed_rpm = 60\n[forces]\n");
    EXPECT_EQ(scene.cam.value().rotation, Rotation::counterclockwise);
    EXPECT_FALSE(scene.cam->face_half_width);
    EXPECT_EQ(scene.cam->find(DimensionIndex::offset)->low, 0.0);
    EXPECT_EQ(scene.forces.value().mass, 0.0);
    EXPECT_EQ(scene.forces->cam_modulus, 210e9);
    EXPECT_FALSE(scene.forces->contact_width);
    const Scene plain = read(drd + jerk_only);
    EXPECT_FALSE(plain.cam || plain.forces || plain.solver.starts || plain.limits.pressure_angle);
}

TEST(Overrides, ReplaceAddAndTakeBareWords) {
    const Scene scene =
        read(drd + jerk_only, {"motion.type=RR", "motion.rise_deg = 90", "solver.name=nlopt.slsqp",
                               "solver.options.max_iter=7", "title=\"two words\""});
    EXPECT_EQ(scene.motion.type, MotionType::rr);
    EXPECT_DOUBLE_EQ(scene.motion.rise, pi / 2);
    EXPECT_EQ(scene.solver.name, "nlopt.slsqp");
    EXPECT_EQ(std::get<long long>(scene.solver.options.at("max_iter")), 7);
    EXPECT_EQ(scene.title, "two words");
}

TEST(Overrides, ReplaceEverySynonym) {
    const std::string toml = drd + jerk_only + "motion.lift_in = 1\nspline.breakpoints = [0, 0.5, 1]\n";
    const Scene scene = read(toml, {"motion.lift_mm=4", "spline.segments=24"});
    EXPECT_DOUBLE_EQ(scene.motion.lift, 0.004);
    EXPECT_TRUE(scene.spline.breakpoints.empty());
    EXPECT_EQ(scene.spline.segments, 24);
    EXPECT_DOUBLE_EQ(read(toml, {"motion.lift_mm=4", "motion.lift_mm=5"}).motion.lift, 0.005);
}

TEST(Overrides, ReachTheEntriesOfArrays) {
    const std::string toml = jerk_only +
                             "motion.type = \"program\"\n"
                             "motion.lift_mm = 20\n"
                             "motion.segments = [{ kind = \"spline\", angle_deg = 120, to_mm = 5 },\n"
                             "  { kind = \"spline\", angle_deg = 240 }]\n";
    const Scene scene =
        read(toml, {"motion.segments[0].to=0.75", "motion.segments[0].angle_deg=90",
                    "motion.segments[1]={ kind = \"dwell\", angle_deg = 200 }", "motion.closed=false"});
    EXPECT_EQ(scene.motion.segments.at(0).to, 0.75);
    EXPECT_DOUBLE_EQ(scene.motion.segments.at(0).angle, pi / 2);
    EXPECT_EQ(scene.motion.segments.at(1).kind, SegmentKind::dwell);
    const std::string points = drd + jerk_only + "spline.breakpoints = [0, 0.5, 1]\n";
    EXPECT_EQ(read(points, {"spline.breakpoints[1]=0.25"}).spline.breakpoints.at(1), 0.25);
}

TEST(Overrides, SetCamsAndTheirLimits) {
    const Scene scene = read(drd + jerk_only + knife + "cam.offset_in = 1\n",
                             {"cam.base_radius_mm={min=20,max=60}", "cam.base_radius_mm.max=50",
                              "cam.offset_mm=-3", "cam.rotation=clockwise", "limits.pressure_angle_deg=30"});
    EXPECT_DOUBLE_EQ(scene.cam.value().find(DimensionIndex::base_radius)->low, 0.02);
    EXPECT_DOUBLE_EQ(scene.cam.value().find(DimensionIndex::base_radius)->high, 0.05);
    EXPECT_DOUBLE_EQ(scene.cam.value().find(DimensionIndex::offset)->low, -0.003);
    EXPECT_EQ(scene.cam.value().rotation, Rotation::clockwise);
    EXPECT_DOUBLE_EQ(scene.limits.pressure_angle.value().given(), 30.0);
}

TEST(Overrides, FixInvalidFile) {
    EXPECT_EQ(read(drd + jerk_only + "spline.degree = 4\n", {"spline.degree=5"}).spline.degree, 5);
}

/// What a scene file says of a limit: key, number, unit.
std::vector<std::string> words_of(const LimitSpec& limits) {
    std::vector<std::string> words;
    for (const auto* limit : {&limits.velocity, &limits.acceleration, &limits.jerk})
        if (*limit) words = {(*limit)->key, std::to_string((*limit)->given), (*limit)->unit};
    for (const auto* limit :
         {&limits.pressure_angle, &limits.rise_pressure_angle, &limits.return_pressure_angle,
          &limits.cam_radius_min, &limits.concave_radius_min, &limits.undercut_margin,
          &limits.contact_force_min, &limits.torque_max, &limits.hertz_pressure_max})
        if (*limit) words = {(*limit)->key, std::to_string((*limit)->given()), (*limit)->unit};
    return words;
}

/// The same limit with nothing but its number and its unit, as an embedder writes it.
void strip_words(LimitSpec& limits) {
    for (auto* limit : {&limits.velocity, &limits.acceleration, &limits.jerk})
        if (*limit) **limit = PeakLimit((*limit)->normalised, {}, 0.0, (*limit)->unit);
    for (auto* limit : {&limits.pressure_angle, &limits.rise_pressure_angle, &limits.return_pressure_angle,
                        &limits.cam_radius_min, &limits.concave_radius_min, &limits.undercut_margin,
                        &limits.contact_force_min, &limits.torque_max, &limits.hertz_pressure_max})
        if (*limit) **limit = WrittenLimit((*limit)->value, {}, 1.0, (*limit)->unit);
}

TEST(SceneReader, CppLimitUsesWordsOfManual) {
    int compared = 0;
    for (const auto& part : {limit_cases(), cam_limit_cases()})
        for (const KeyCase& c : part) {
            SCOPED_TRACE(c.key);
            Scene scene = read(scene_with(c));
            const std::vector<std::string> written = words_of(scene.limits);
            if (written.empty() || written.front() != c.key) continue;
            EXPECT_EQ(words_of(with_written_limits(scene).limits), written);
            strip_words(scene.limits);
            EXPECT_EQ(words_of(with_written_limits(scene).limits), written);
            ++compared;
        }
    EXPECT_GE(compared, 30);
}

/// What stands behind "; did you mean " in the refusal of a scene.
std::string hint_for(const std::string& toml) {
    try {
        (void)read(toml);
    } catch (const InputError& error) {
        const std::string message = error.what(), words = "; did you mean ";
        const std::size_t at = message.find(words);
        return at == std::string::npos ? "no hint: " + message : message.substr(at + words.size());
    }
    return "accepted";
}

TEST(SceneReader, WordsFromElsewhereGetAHint) {
    const auto follower = [](const std::string& word) {
        return hint_for(drd + jerk_only + "cam.type = \"disk\"\ncam.follower = \"" + word + "\"\n");
    };
    EXPECT_EQ(follower("flat"), "'translating_flat' or 'oscillating_flat'?");
    EXPECT_EQ(follower("roller"), "'translating_roller' or 'oscillating_roller'?");
    EXPECT_EQ(follower("oscillating"), "'oscillating_roller' or 'oscillating_flat'?");
    EXPECT_EQ(follower("Translating_Flat"), "'translating_flat'?");
    EXPECT_EQ(follower("swinging roller"), "'oscillating_roller'?");
    EXPECT_EQ(follower("transalting_knife"), "'translating_knife'?");
    EXPECT_EQ(hint_for(drd + jerk_only + "motion.swing_deg = 20\n"), "'lift_deg'?");
    EXPECT_EQ(hint_for(drd + jerk_only + "motion.stroke = 20\n"), "'lift_mm'?");
    EXPECT_EQ(hint_for(drd + jerk_only + "cam.type = \"disk\"\ncam.base_circle_radius_mm = 20\n"),
              "'base_radius_mm'?");
    const auto motion = [](const std::string& word) {
        return hint_for("motion.type = \"" + word + "\"\n" + jerk_only);
    };
    const std::string program = "'program', with its rises, returns and dwells as [[motion.segments]]?";
    EXPECT_EQ(motion("DRDR"), program);
    EXPECT_EQ(motion("DRDRD"), program);
    EXPECT_EQ(motion("rdf"), program);
    EXPECT_EQ(motion("DRRD"), "'RR'?");
    EXPECT_EQ(motion("drd"), "'DRD'?");
    EXPECT_EQ(motion("programm"), "'program'?");
    EXPECT_EQ(motion("sideways").substr(0, 8), "no hint:");
    EXPECT_EQ(hint_for(drd + "objective = { jerk = 1, reference = \"sine\" }\n"), "'modified_sine'?");
    EXPECT_EQ(hint_for(drd + jerk_only + "solver.name = \"slsqp\"\n"), "'nlopt.slsqp'?");
    EXPECT_EQ(hint_for(drd + jerk_only + "cam = { type = \"disk\", rotation = \"ccw\" }\n"),
              "'counterclockwise'?");
}

TEST(FollowerKinds, MatchKeyTable) {
    std::set<std::string> words, keys;
    for (const FollowerKind& kind : follower_kinds()) {
        EXPECT_TRUE(words.insert(kind.cam_type + "/" + kind.word).second) << kind.word;
        words.insert(kind.cam_type);
        words.insert(kind.word);
        keys.insert(kind.keys.begin(), kind.keys.end());
    }
    for (const KeyRow& row : scene_keys()) {
        const bool chooses = (row.table == "cam" && (row.name == "type" || row.name == "follower")) ||
                             (row.table == "linkage" && row.name == "type");
        for (const std::string_view choice : row.choices)
            EXPECT_TRUE(!chooses || words.contains(std::string(choice))) << choice;
        const bool number = row.type == KeyType::number || row.type == KeyType::number_or_range;
        if (!number || (row.table != "cam" && row.table != "linkage")) continue;
        const std::string key = row.key(row.spellings.front());
        EXPECT_TRUE(keys.contains(row.table == "cam" ? key : "linkage." + key)) << key;
    }
}

}  // namespace scene_reader_test
}  // namespace camopt::input
