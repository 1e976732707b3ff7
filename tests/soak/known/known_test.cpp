// SPDX-License-Identifier: MIT
#include "tests/report/temporary_folder.hpp"
#include "tests/soak/known/draft.hpp"
#include "tests/soak/known/judge.hpp"
#include "tests/soak/known/moved_scene.hpp"
#include "tests/soak/known/nonnegative.hpp"
#include "tests/soak/known/piecewise_space.hpp"
#include "tests/soak/known/scene_files.hpp"
#include "tests/soak/known/tally.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace camopt::soak {

namespace {

/// A cubic rise on six segments, at rest at both ends.
PiecewiseSpace rise_of_six() {
    PiecewiseSpace space(3);
    space.add_run({0.0, 1.0 / 6, 2.0 / 6, 0.5, 4.0 / 6, 5.0 / 6, 1.0}, 2);
    for (int order = 0; order < 3; ++order) {
        space.fix_begin(0, order, 0.0);
        space.fix_end(5, order, order == 0 ? 1.0 : 0.0);
    }
    return space;
}

/// The first scene of this class from a number on whose answer is of this kind.
KnownScene scene_with(int kind, bool feasible, long number = 0) {
    for (;; ++number) {
        const KnownScene scene = drawn_known_scene({1, kind, false}, number);
        if (scene.answer.feasible == feasible) return scene;
    }
}

TEST(PiecewiseSpace, MotionsMeetTheirConditions) {
    PiecewiseSpace space = rise_of_six();
    ASSERT_TRUE(space.close());
    EXPECT_EQ(space.freedom(), 3);  // n + 3 coefficients less six end conditions
    const Eigen::VectorXd motion = space.smoothest() + space.directions() * Eigen::Vector3d(0.1, -0.2, 0.3);
    for (int piece = 0; piece + 1 < space.pieces(); ++piece)
        for (int order = 0; order < 3; ++order) {
            const double left = space.row(derivative_alone(order), piece, space.end(piece)).dot(motion);
            EXPECT_NEAR(left, space.row(derivative_alone(order), piece + 1, space.end(piece)).dot(motion),
                        1e-12 * std::pow(6.0, order))
                << piece << ", order " << order;
        }
    EXPECT_NEAR(space.row(derivative_alone(0), 5, 1.0).dot(motion), 1.0, 1e-14);
    EXPECT_NEAR(space.row(derivative_alone(2), 0, 0.0).dot(motion), 0.0, 1e-12);
}

TEST(PiecewiseSpace, ContradictionIsFound) {
    PiecewiseSpace space = rise_of_six();
    space.fix_end(5, 0, 2.0);
    EXPECT_FALSE(space.close());
}

TEST(PiecewiseSpace, ExtremesAreExact) {
    PiecewiseSpace space(3);
    space.add_run({0.0, 2.0}, 2);
    space.fix_begin(0, 0, 0.0);
    space.fix_begin(0, 1, 0.0);
    space.fix_end(0, 0, 0.0);
    space.fix_end(0, 1, -4.0);  // y = x² (2 − x)
    ASSERT_TRUE(space.close());
    double most = 0.0;
    for (const Extreme& one : space.extremes(space.smoothest(), derivative_alone(0), 0))
        most = std::max(most, one.value);
    EXPECT_NEAR(most, 32.0 / 27.0, 1e-14);
    EXPECT_NEAR(space.integral().dot(space.smoothest()), 4.0 / 3.0, 1e-14);
    // ∫ (2·2 − 6x)² dx over [0, 2]
    PiecewiseSpace::Square square{0.0, Eigen::VectorXd::Zero(space.size())};
    space.add_square(space.smoothest(), derivative_alone(2), 1.0, 0, 1, square);
    // ∫ y''² + 2 (y'(2) − y'(0)) + 2
    EXPECT_NEAR(square.value, 32.0 - 8.0 + 2.0, 1e-12);
    EXPECT_NEAR(square.slope.dot(space.smoothest()), 32.0 - 4.0, 1e-12);
}

TEST(PiecewiseSpace, SquaresOfNarrowPiecesAreExact) {
    PiecewiseSpace space(3);
    space.add_run({0.0, 1.0, 1.0 + 1e-4, 2.0}, 2);
    space.fix_begin(0, 0, 0.0);
    space.fix_begin(0, 1, 0.0);
    space.fix_end(2, 0, 0.0);
    space.fix_end(2, 1, -4.0);
    space.fix_begin(0, 2, 4.0);
    space.fix_end(2, 2, -8.0);
    ASSERT_TRUE(space.close());
    PiecewiseSpace::Square square{0.0, Eigen::VectorXd::Zero(space.size())};
    space.add_square(space.smoothest(), derivative_alone(2), 0.0, 0, 3, square);
    EXPECT_NEAR(square.value, 32.0, 1e-9);
}

TEST(Balanced, MultipliersAreNotNegative) {
    Eigen::MatrixXd a(2, 3);
    a << 1.0, -1.0, 0.5, 0.0, 1.0, 2.0;
    const auto found = balanced(a, Eigen::Vector2d(-1.0, 3.0));
    ASSERT_TRUE(found.has_value());
    EXPECT_GE(found->minCoeff(), 0.0);
    EXPECT_NEAR((a * *found - Eigen::Vector2d(-1.0, 3.0)).norm(), 0.0, 1e-12);
    EXPECT_FALSE(balanced(a, Eigen::Vector2d(0.0, -1.0)).has_value());
}

TEST(KnownScenes, SameNumberMakesSameScene) {
    for (int kind = 0; kind < known_kinds; ++kind) {
        const KnownScene one = drawn_known_scene({3, kind, true}, 5),
                         other = drawn_known_scene({3, kind, true}, 5);
        EXPECT_FALSE(one.text.empty());
        EXPECT_EQ(one.text, other.text);
        EXPECT_NE(one.text, drawn_known_scene({3, kind, true}, 6).text);
    }
}

TEST(KnownScenes, WrongAnswerIsNoticed) {
    KnownScene scene = scene_with(0, true);
    EXPECT_EQ(judged(scene).judgement, Judgement::right) << scene.text;
    const double optimum = scene.answer.objective;
    for (const double change : {-1e-6, 1e-6}) {
        scene.answer.objective = optimum * (1.0 + change);
        EXPECT_EQ(judged(scene).judgement, Judgement::wrong) << change;
    }
    scene = scene_with(0, false);
    EXPECT_EQ(judged(scene).judgement, Judgement::right) << scene.text;
    scene.answer.feasible = true;
    EXPECT_EQ(judged(scene).judgement, Judgement::wrong);
    scene.answer.margin = 0.0;
    EXPECT_EQ(judged(scene).judgement, Judgement::wrong);
    scene.text += "unknown = 1\n";
    EXPECT_EQ(judged(scene).judgement, Judgement::refused);
}

TEST(KnownScenes, WrongAnswerOfMachineIsNoticed) {
    KnownScene machine = scene_with(machine_kind, true);
    EXPECT_GE(machine.axes.size(), 2U);
    EXPECT_NE(machine.text.find("[[clearance]]"), std::string::npos);
    EXPECT_EQ(judged(machine).judgement, Judgement::right) << machine.text;
    const double optimum = machine.answer.objective;
    for (const double change : {-1e-6, 1e-6}) {
        machine.answer.objective = optimum * (1.0 + change);
        EXPECT_EQ(judged(machine).judgement, Judgement::wrong) << change;
    }
    // Without its clearances the axes have other optima.
    machine.answer.objective = optimum;
    machine.text.erase(machine.text.find("[[clearance]]"));
    EXPECT_EQ(judged(machine).judgement, Judgement::wrong);
    machine = scene_with(machine_kind, false);
    EXPECT_EQ(judged(machine).judgement, Judgement::right) << machine.text;
    machine.axes.front().text += "unknown = 1\n";
    EXPECT_EQ(judged(machine).judgement, Judgement::refused);
}

TEST(KnownScenes, MachineIsWrittenAsFolder) {
    const test::TemporaryFolder folder;
    const KnownScene machine = scene_with(machine_kind, true);
    const std::filesystem::path file = write_scene(machine, folder.path(), "it", "# why\n");
    EXPECT_EQ(file, std::filesystem::path(folder.path()) / "it" / "machine.toml");
    for (const AxisFile& axis : machine.axes)
        EXPECT_EQ(std::filesystem::file_size(file.parent_path() / axis.name), axis.text.size());
    EXPECT_EQ(write_scene(scene_with(0, true), folder.path(), "it", "").filename(), "it.toml");
}

TEST(KnownScenes, MovedNumbersKeepWordsAndCounts) {
    Draw draw(1);
    EXPECT_EQ(moved_numbers(draw, "\"mm_s2 1.5\"", 0.1), "\"mm_s2 1.5\"");
    EXPECT_EQ(moved_numbers(draw, "12", 0.1), "12");
    const std::string moved = moved_numbers(draw, "{ min = -2.0, max_2 = 1e-3 }", 0.0);
    EXPECT_TRUE(moved.starts_with("{ min = -")) << moved;
    EXPECT_NE(moved, "{ min = -2.0, max_2 = 1e-3 }");
    EXPECT_NEAR(std::stod(moved.substr(8)), -2.0, 5e-16);
}

TEST(KnownTally, RunsGoOnWhereTheyStopped) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "camopt_known_tally_test.tsv";
    std::filesystem::remove(file);
    KnownScene scene;
    scene.kind = "rise";
    {
        KnownTally tally(file);
        tally.add(0, scene, {Judgement::right, "optimal", "", 0.0});
        tally.add(2, scene, {Judgement::wrong, "optimal", "", 0.0});  // 1 is not finished
        EXPECT_EQ(tally.next(), 1);
        tally.save();
    }
    KnownTally tally(file);
    EXPECT_EQ(tally.next(), 1);
    EXPECT_EQ(tally.count(Judgement::wrong), 0);
    tally.add(2, scene, {Judgement::open, "local", "", 0.0});
    tally.add(1, scene, {Judgement::right, "optimal", "", 0.0});
    EXPECT_EQ(tally.next(), 3);
    EXPECT_EQ(tally.scenes(), 3);
    EXPECT_EQ(tally.count(Judgement::open), 1);
    std::filesystem::remove(file);
}

}  // namespace

}  // namespace camopt::soak
