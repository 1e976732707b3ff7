// SPDX-License-Identifier: MIT
// Paper 000: which entries of Table 1 agree, which digits are misprinted, and the whole report.
#include "benchmarks/papers/paper_000_parts.hpp"
#include "benchmarks/papers/papers.hpp"
#include "core/units.hpp"
#include "profiles/inverse/reference_machine.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace camopt {

namespace paper_000_test {

using namespace feeding_paper;

double printed_number(const PrintedRow& row, int column) {
    return std::stod(std::string(row.cells[static_cast<std::size_t>(column)]));
}

double computed(const PrintedRow& row, int column) {
    return computed_row(row)[static_cast<std::size_t>(column)];
}

const Misprint* misprint_at(const PrintedRow& row, int column) {
    for (const Misprint& misprint : misprints())
        if (misprint.time == row.time && misprint.column == column) return &misprint;
    return nullptr;
}

TEST(Paper000, AgreementAsCounted) {
    const Agreement found = agreement();
    EXPECT_EQ(found.entries, 48);
    EXPECT_EQ(found.rounded, 25);
    EXPECT_EQ(found.close, 43);
}

TEST(Paper000, WhatIsNotFlaggedAgrees) {
    for (const PrintedRow& row : printed_rows()) {
        if (!row.moving) continue;
        for (int column = theta; column < columns; ++column) {
            if (misprint_at(row, column) != nullptr) continue;
            const double printed = printed_number(row, column),
                         difference = std::abs(computed(row, column) - printed);
            const double half = half_digit(row.cells[static_cast<std::size_t>(column)]);
            EXPECT_TRUE(difference <= 5.0 * half || difference <= 0.003 * std::abs(printed))
                << row.time << ' ' << column_info(column).symbol;
        }
    }
}

TEST(Paper000, FlaggedValuesContradictAndOursAgree) {
    int seen = 0;
    for (const PrintedRow& row : printed_rows()) {
        for (int column = 0; column < columns; ++column) {
            const Misprint* misprint = misprint_at(row, column);
            if (misprint == nullptr) continue;
            ++seen;
            const double printed = printed_number(row, column), ours = computed(row, column);
            EXPECT_TRUE(printed < misprint->least || printed > misprint->most) << row.time;
            EXPECT_TRUE(ours >= misprint->least && ours <= misprint->most) << row.time << ' ' << ours;
        }
    }
    EXPECT_EQ(seen, 9);
    EXPECT_EQ(misprints().size(), 9U);
}

/// The row's own Y says which theta is meant.
TEST(Paper000, FeederIdentifiesMisprintedAngles) {
    const FeederLinkage linkage = linkage_of(forward_stroke().solution().cam->cam.dimensions);
    const auto angle_at = [&](double inches) {
        return body_motion(linkage, {inches * units::inch, 0.0, 0.0}).body.angle / units::degree;
    };
    EXPECT_NEAR(angle_at(1.125), -6.06, 0.005);
    EXPECT_NEAR(angle_at(1.256), -6.48, 0.005);
    EXPECT_NEAR(angle_at(2.042), -9.01, 0.005);
    EXPECT_NEAR(angle_at(2.039), -9.00, 0.005);
}

TEST(Paper000, ReturnIsADeceleration) {
    int agreeing = 0, moving = 0;
    for (const PrintedRow& row : printed_rows()) {
        if (instant_of(row.time) < 0.158 || instant_of(row.time) > 0.21) continue;
        ++moving;
        agreeing += std::abs(computed(row, distance) - printed_number(row, distance)) <= 0.001;
    }
    EXPECT_EQ(moving, 6);
    EXPECT_EQ(agreeing, 5);  // the sixth is printed 5.000
    // Accelerated from rest, the roller would be far from where the table has it.
    const double since = 0.178 - 0.158;
    EXPECT_NEAR(13.982 - 0.5 * 2496.4 * since * since, 13.483, 0.001);
}

const PaperReport& report() {
    static const PaperReport whole = paper_000();
    return whole;
}

const PaperTable& table(const std::string& key) {
    return *std::ranges::find(report().tables, key, &PaperTable::key);
}

double number(const PaperTable& table, std::size_t row, const std::string& column) {
    const auto place = std::ranges::find(table.columns, column, &PaperColumn::key) - table.columns.begin();
    return std::get<double>(table.rows[row][static_cast<std::size_t>(place)]);
}

TEST(Paper000, ReportIsWhole) {
    EXPECT_TRUE(report().faults.empty());
    EXPECT_EQ(table("table_1").rows.size(), 91U);
    EXPECT_EQ(table("misprints").rows.size(), 9U);
    EXPECT_FALSE(report().assumptions.empty());
    for (const PaperTable& one : report().tables) {
        EXPECT_FALSE(one.rows.empty()) << one.key;
        for (const auto& row : one.rows) EXPECT_EQ(row.size(), one.columns.size()) << one.key;
    }
    for (const PaperFigure& figure : report().figures) {
        EXPECT_FALSE(figure.series.empty()) << figure.key;
        for (const PaperSeries& series : figure.series)
            EXPECT_EQ(series.x.size(), series.y.size()) << figure.key;
    }
}

TEST(Paper000, GuideFiguresCoverForwardStroke) {
    for (const char* key : {"guides_acceleration", "guides_curvature", "guides_pressure_angle"}) {
        const PaperFigure& figure = *std::ranges::find(report().figures, key, &PaperFigure::key);
        for (const PaperSeries& series : figure.series) {
            SCOPED_TRACE(std::string(key) + ", " + series.title);
            ASSERT_GT(series.x.size(), 200U);
            const double length = series.x.back() - series.x.front();
            EXPECT_LE(series.x.front(), 5.25);  // inches, where the feeder leaves its rest
            EXPECT_GE(series.x.back(), 12.898);
            for (std::size_t i = 1; i < series.x.size(); ++i) {
                const double step = series.x[i] - series.x[i - 1];
                EXPECT_GE(step, 0.0);
                EXPECT_LE(step, length / 150.0) << series.x[i];
            }
        }
    }
}

/// Eqs. 9 to 12 on the arcs as the scenes have them, against the motion of the given guides.
TEST(Paper000, MotionFollowsThePapersFormulas) {
    for (const FeederStroke* stroke : {&forward_stroke(), &return_stroke()}) {
        EXPECT_EQ(stroke->solution().certificate.reason, Reason::given_cam);
        const std::vector<CamPiece>& pieces = stroke->solution().scene.cam->pieces;
        for (const std::size_t i : {1U, 2U}) {
            const auto in = [](double metres) { return metres / units::inch; };
            const std::vector<double>&from = pieces[i - 1].to, &to = pieces[i].to, &center = pieces[i].center;
            const test::ArcGuide arc{in(std::hypot(from[0], from[1])), in(std::hypot(to[0], to[1])),
                                     in(center[0]), in(center[1]),
                                     in(std::hypot(to[0] - center[0], to[1] - center[1]))};
            int compared = 0;
            for (double time = stroke->begin(); time < stroke->end(); time += 1e-4) {
                const FeederState state = stroke->at(time);
                const double distance = in(state.roller.distance);
                if (distance < arc.from + 0.01 || distance > arc.to - 0.01) continue;
                ++compared;
                const BodyMotion body = arc.body(state.roller);
                EXPECT_NEAR(state.body.angle, body.angle, 1e-11);
                EXPECT_NEAR(state.body.velocity, body.velocity, 1e-7);
                EXPECT_NEAR(state.body.acceleration, body.acceleration, 1e-3);
            }
            EXPECT_GT(compared, 100);
        }
    }
}

/// What the roller's acceleration and the guide's curvature make of the feeder jumps where arcs begin.
TEST(Paper000, AccelerationJumpsWhereArcsJoin) {
    ASSERT_EQ(forward_stroke().joints().size(), 3U);
    double largest = 0.0;
    for (const double time : forward_stroke().joints()) {
        const FeederState left = forward_stroke().at(time, Side::left), right = forward_stroke().at(time);
        EXPECT_NEAR(left.feeder.s, right.feeder.s, 1e-12);
        EXPECT_NEAR(left.feeder.velocity, right.feeder.velocity, 1e-7);
        largest = std::max(largest, std::abs(right.feeder.acceleration - left.feeder.acceleration));
    }
    EXPECT_GT(largest, 7000.0 * units::inch);
}

/// Its printed rows are multiples of 0.00158 s: 100 steps, 101 nodes.
TEST(Paper000, NodesConvergeAwayFromJointsOnly) {
    EXPECT_EQ(testing_support::refusal([] { (void)node_method(forward_stroke(), 2); }),
              "2 nodes were requested; central differences need at least 3");
    double velocity = 1e9, away = 1e9;
    for (const int nodes : {101, 401, 1601}) {
        const NodeMethodError error = node_method_error(forward_stroke(), nodes);
        EXPECT_LT(error.velocity, 0.5 * velocity);
        EXPECT_LT(error.acceleration_away, 0.5 * away);
        EXPECT_GT(error.acceleration, 50.0);  // theta'' jumps by 399 rad/s² between the arcs
        velocity = error.velocity;
        away = error.acceleration_away;
    }
    EXPECT_LT(velocity, 1e-2);
}

TEST(Paper000, ForwardSimulations) {
    const PaperTable& forward = table("forward_simulation");
    ASSERT_EQ(forward.rows.size(), 2U);
    for (const std::size_t row : {0U, 1U}) EXPECT_LT(number(forward, row, "relative"), 1e-6);
}

TEST(Paper000, BestGuideBeatsLinesAndArcs) {
    const PaperTable& guides = table("guides");
    EXPECT_EQ(std::get<std::string>(guides.rows[0][0]), "lines and arcs");
    const std::size_t best = 3;
    EXPECT_EQ(std::get<std::string>(guides.rows[best][0]), "best spline 0.4 0.4 0.2, same path");
    EXPECT_LT(number(guides, best, "velocity_in_s"), 0.84 * number(guides, 0, "velocity_in_s"));
    EXPECT_LT(number(guides, best, "acceleration_in_s2"), 0.68 * number(guides, 0, "acceleration_in_s2"));
    EXPECT_LT(number(guides, best, "pressure_angle_deg"), number(guides, 0, "pressure_angle_deg") - 3.0);
    EXPECT_GT(number(guides, 0, "step_in_s2"), 7000.0);
    for (std::size_t row = 1; row < guides.rows.size(); ++row) {
        EXPECT_EQ(number(guides, row, "step_in_s2"), 0.0);
        EXPECT_GT(number(guides, row, "least_radius_in"), 0.5);  // rounder than the roller
    }
}

}  // namespace paper_000_test

}  // namespace camopt
