// SPDX-License-Identifier: MIT
// Progress and cancel callbacks of solves, what they throw, and solves side by side.
#include "solvers/registry.hpp"
#include "tests/bindings/c/c_face.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <vector>

namespace camopt {
namespace c_callbacks_test {

using namespace testing_support;

/// A solve of some seconds: many starts of a problem that is not convex.
constexpr const char* long_toml =
    "[motion]\ntype = \"DRD\"\n[spline]\ndegree = 5\nsegments = 40\n"
    "[objective]\ntorque = 1\njerk = 0.01\n[solver]\nstarts = 500\nmax_seconds = 100\n";

struct Watch {
    int asked = 0, cancel_at = -1;  ///< the number of the question that is answered with yes
    int reports = 0;
    double seconds = -1.0;
    std::string first;
    int rounds = 0;
    double incumbent = 0.0;
    bool throws_a_number = false;
};

int cancel(void* user) {
    Watch& watch = *static_cast<Watch*>(user);
    return ++watch.asked == watch.cancel_at ? 1 : 0;
}

void report(const camopt_progress* progress, void* user) {
    Watch& watch = *static_cast<Watch*>(user);
    EXPECT_EQ(progress->size, sizeof(camopt_progress));
    EXPECT_GE(progress->seconds, watch.seconds);
    watch.seconds = progress->seconds;
    if (watch.reports++ == 0) watch.first = progress->message;
    if (progress->round > watch.rounds) watch.rounds = progress->round;
    if (std::isfinite(progress->incumbent)) watch.incumbent = progress->incumbent;
}

int throw_in_cancel(void* user) {
    if (static_cast<Watch*>(user)->throws_a_number) throw 7;
    throw std::runtime_error("the button is gone");
}

void throw_in_progress(const camopt_progress*, void*) {
    throw std::runtime_error("the window is closed");
}

camopt_solve_options watched(Watch& watch) {
    camopt_solve_options options{};
    options.size = sizeof options;
    options.progress = report;
    options.cancel = cancel;
    options.user = &watch;
    return options;
}

TEST(CCallbacks, ReceiveProgress) {
    Watch watch;
    const camopt_solve_options options = watched(watch);
    const CSolution c = c_solved(c_scene_of_file("cam_roller"), &options);
    EXPECT_GT(watch.reports, 0);
    EXPECT_GT(watch.asked, 0);
    EXPECT_EQ(watch.first.substr(0, 8), "round 1:") << watch.first;
    const camopt_summary summary = summary_of(c);
    EXPECT_EQ(summary.verdict, CAMOPT_OPTIMAL);
    EXPECT_GE(watch.rounds, 1);
    EXPECT_GE(summary.exchange_rounds, 1);
    EXPECT_NEAR(watch.incumbent, summary.objective, 0.1);
    EXPECT_EQ(summary.objective, summary_of(c_solved_file("cam_roller")).objective);
}

TEST(CCallbacks, CancelBeforeAnythingWasFound) {
    Watch watch;
    watch.cancel_at = 1;
    const camopt_solve_options options = watched(watch);
    const camopt_summary summary = summary_of(c_solved(c_scene(paper_toml), &options));
    EXPECT_EQ(summary.has_motion, 0);
    EXPECT_EQ(summary.verdict, CAMOPT_FAILED);
    EXPECT_EQ(summary.interrupted, 1);
    EXPECT_TRUE(std::isnan(summary.objective));
    EXPECT_EQ(watch.asked, 1);  // once said is said
}

TEST(CCallbacks, CancelALongSearch) {
    Watch watch;
    watch.cancel_at = 300;
    const camopt_solve_options options = watched(watch);
    const CSolution c = c_solved(c_scene(long_toml), &options);
    const camopt_summary summary = summary_of(c);
    EXPECT_EQ(watch.asked, watch.cancel_at);
    EXPECT_LT(summary.seconds_total, 60.0);
    EXPECT_EQ(summary.interrupted, 1);
    if (summary.has_motion != 0) {
        EXPECT_TRUE(std::isfinite(summary.objective));
        EXPECT_NE(summary.verdict, CAMOPT_FAILED);
    }
}

TEST(CCallbacks, ThrowNothingAcross) {
    for (const char* const toml : {paper_toml, long_toml}) {
        const CScene scene = c_scene(toml);
        Watch watch;
        camopt_solve_options options = watched(watch);
        camopt_solution* solution = nullptr;
        options.cancel = throw_in_cancel;
        EXPECT_EQ(camopt_solve(scene.get(), &options, &solution), CAMOPT_ERROR_CALLBACK);
        EXPECT_STREQ(camopt_error_text(), "a callback threw: the button is gone");
        watch.throws_a_number = true;
        EXPECT_EQ(camopt_solve(scene.get(), &options, &solution), CAMOPT_ERROR_CALLBACK);
        EXPECT_STREQ(camopt_error_text(), "a callback threw an exception that is not a std::exception");
        options.cancel = nullptr;
        options.progress = throw_in_progress;
        EXPECT_EQ(camopt_solve(scene.get(), &options, &solution), CAMOPT_ERROR_CALLBACK);
        EXPECT_STREQ(camopt_error_text(), "a callback threw: the window is closed");
        EXPECT_EQ(solution, nullptr);
    }
}

TEST(CCallbacks, ThrowNothingThroughAnyBackend) {
    for (const SolverEntry& entry : solver_entries()) {
        const CScene scene = c_scene(paper_toml);
        EXPECT_OK(camopt_set_text(scene.get(), "solver.name", entry.name.c_str()));
        Watch watch;
        camopt_solve_options options = watched(watch);
        options.cancel = throw_in_cancel;
        camopt_solution* solution = nullptr;
        const camopt_error code = camopt_solve(scene.get(), &options, &solution);
        EXPECT_EQ(code, entry.available ? CAMOPT_ERROR_CALLBACK : CAMOPT_ERROR_UNAVAILABLE)
            << entry.name << ": " << camopt_error_text();
        EXPECT_EQ(solution, nullptr);
    }
}

TEST(CThreads, ConcurrentSolvesEqualSequentialOnes) {
    const CScene plain = c_scene(paper_toml), cam = c_scene_of_file("cam_roller");
    const auto lists = [](const CSolution& c) {
        return text_of(c, CAMOPT_CERTIFICATE_JSON) + text_of(c, CAMOPT_MOTION_CSV);
    };
    const std::string plain_alone = lists(c_solved(plain)), cam_alone = lists(c_solved(cam));
    constexpr int rounds = 5;
    std::vector<std::string> found(static_cast<std::size_t>(4 * rounds));
    const auto work = [&](std::size_t first) {
        for (std::size_t i = first; i < found.size(); i += 2)
            found[i] = lists(c_solved(i / 2 % 2 == 0 ? plain : cam));  // both threads, the same handles
    };
    std::thread one(work, 0U), other(work, 1U);
    one.join();
    other.join();
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(found[i], i / 2 % 2 == 0 ? plain_alone : cam_alone) << i;
}

}  // namespace c_callbacks_test
}  // namespace camopt
