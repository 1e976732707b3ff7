// SPDX-License-Identifier: MIT
// What is absent keeps its default; overrides replace; limits remember their spelling.
#include "input/scene_reader.hpp"

#include "core/errors.hpp"
#include "input/keys/scene_keys.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "scene/written_limits.hpp"
#include "tests/input/scene_cases.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace camopt::input {
namespace scene_reader_test {

constexpr double pi = std::numbers::pi;
const KnownNames known = {.laws = {"cycloidal", "modified_sine"},
                          .solvers = {"ipopt", "nlopt.slsqp", "structured"},
                          .cam_formulas = cam_formulas};
const std::string drd = "motion.type = \"DRD\"\n";
const std::string jerk_only = "objective.jerk = 1\n";

Scene read(const std::string& toml, const std::vector<std::string>& overrides = {}) {
    return read_scene(toml, "s.toml", known, overrides);
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

TEST(SceneReader, LimitsByAngleFitEveryLift) {
    const auto normalised = [](const std::string& motion, const std::string& limit) {
        const LimitSpec limits = read(drd + jerk_only + motion + "limits." + limit + "\n").limits;
        for (const auto* one : {&limits.velocity, &limits.acceleration, &limits.jerk})
            if (*one) return (*one)->normalised;
        return 0.0;
    };
    const std::string inches = "motion.lift_in = 2\nmotion.rise_rad = 2\n";
    EXPECT_NEAR(normalised(inches, "velocity_in_rad = 1.5"), 1.5, 1e-14);     // 1.5 · 2 / 2
    EXPECT_NEAR(normalised(inches, "velocity_mm_rad = 38.1"), 1.5, 1e-14);    // 38.1 · 2 / 50.8
    EXPECT_NEAR(normalised(inches, "acceleration_in_rad2 = 2"), 4.0, 1e-14);  // 2 · 4 / 2
    EXPECT_NEAR(normalised(inches, "jerk_m_rad3 = 0.0254"), 4.0, 1e-14);      // 0.0254 · 8 / 0.0508
    const std::string degrees = "motion.lift_deg = 30\nmotion.rise_deg = 60\n";
    EXPECT_NEAR(normalised(degrees, "velocity_rad_rad = 0.75"), 1.5, 1e-14);  // 0.75 · 60 / 30
    EXPECT_NEAR(normalised(degrees, "velocity_deg_deg = 0.75"), 1.5, 1e-14);
    EXPECT_NEAR(normalised(degrees, "acceleration_rad_rad2 = 1"), 2 * pi / 3, 1e-14);  // (π/3)² / (π/6)
    EXPECT_NEAR(normalised(degrees, "acceleration_deg_deg2 = 0.05"), 6.0, 1e-13);      // 0.05 · 60² / 30
    EXPECT_NEAR(normalised(degrees, "jerk_rad_rad3 = 1"), 2 * pi * pi / 9, 1e-14);     // (π/3)³ / (π/6)
    EXPECT_NEAR(normalised(degrees, "jerk_deg_deg3 = 0.001"), 7.2, 1e-13);             // 0.001 · 60³ / 30
    const std::string crank = "motion.lift_mm = 20\nmotion.rise_crank_deg = 240\n";
    EXPECT_NEAR(normalised(crank, "velocity_mm_deg = 0.25"), 1.5, 1e-14);  // of the cam: 0.25 · 120 / 20
    EXPECT_THROW((void)normalised(degrees, "velocity_mm_rad = 1"), InputError);
    EXPECT_THROW((void)normalised(inches, "velocity_rad_rad = 1"), InputError);
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
    for (const AcceptedScene& one : all_accepted_scenes()) {
        if (!one.key.starts_with("limits.")) continue;
        SCOPED_TRACE(one.place + ": " + one.key);
        Scene scene = read(one.toml);
        const std::vector<std::string> written = words_of(scene.limits);
        if (written.empty() || written.front() != one.key) continue;
        EXPECT_EQ(words_of(with_written_limits(scene).limits), written);
        strip_words(scene.limits);
        EXPECT_EQ(words_of(with_written_limits(scene).limits), written);
        ++compared;
    }
    EXPECT_GE(compared, 30);
}

/// What stands behind "; did you mean " in the refusal of a scene.
std::string hint_for(const std::string& toml) {
    const std::string message = testing_support::refusal([&] { (void)read(toml); }),
                      words = "; did you mean ";
    const std::size_t at = message.find(words);
    return at == std::string::npos ? "no hint: " + message : message.substr(at + words.size());
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
