// SPDX-License-Identifier: MIT
// Random programs, each solved with a twin that asks for the same in other words: a turning point added where
// the strokes demand it anyway, twice the lift with half of each displacement, a dwell in two parts, a
// repeated part written out. What is proved of one holds for the other, and where both are optimal the
// objectives are equal within the gap.
#include "input/loading/load_scene.hpp"
#include "input/scene_reader.hpp"
#include "studies/solve/solve.hpp"
#include "tests/soak/draw.hpp"
#include "tests/support/long_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace camopt {
namespace random_twins_test {

using soak::Draw;

/// One segment: lifts, degrees, places in parts of the angle.
struct Segment {
    std::string kind = "spline";
    double angle = 0.0;
    std::optional<double> to = {};
    std::vector<std::array<double, 2>> displacements = {};  ///< set points
    std::optional<double> fast_at = {};  ///< a set point that moves as fast as limits.velocity allows
    bool steady = false;                 ///< it says that it does not accelerate there
    bool rests = false;                  ///< end = { velocity = 0 }
    bool stands = false;                 ///< … and acceleration = 0
};

struct Program {
    std::vector<Segment> segments;
    double lift = 10.0, area = 0.0;
    std::array<double, 3> weights{};  ///< of velocity, acceleration, jerk
    int degree = 5, pieces = 8, repeat = 1;
    bool within_lift = true, relative = false;
    std::optional<double> velocity, velocity_mm_s, acceleration;  ///< limits
};

std::string text_of(const Segment& segment, const Program& program) {
    std::string text = fmt::format("{{ kind = \"{}\", angle_deg = {:.17g}", segment.kind, segment.angle);
    if (segment.kind == "law") text += ", law = \"polynomial_345\"";
    if (segment.to) text += fmt::format(", to = {:.17g}", *segment.to);
    std::string points;
    for (const auto& [at, y] : segment.displacements)
        points +=
            fmt::format("{}{{ at = {:.17g}, displacement = {:.17g} }}", points.empty() ? "" : ", ", at, y);
    if (segment.fast_at)
        points +=
            fmt::format("{}{{ at = {:.17g}, velocity_mm_s = {:.17g}{} }}", points.empty() ? "" : ", ",
                        *segment.fast_at, *program.velocity_mm_s, segment.steady ? ", acceleration = 0" : "");
    if (!points.empty()) text += ", via = [" + points + "]";
    if (segment.rests)
        text += fmt::format(", end = {{ velocity = 0{} }}", segment.stands ? ", acceleration = 0" : "");
    return text + " }";
}

std::string text_of(const Program& program) {
    std::string text = fmt::format(
        "[motion]\ntype = \"program\"\nlift_mm = {:.17g}\nspeed_rpm = 60\nsegments = [\n", program.lift);
    for (const Segment& segment : program.segments) text += "  " + text_of(segment, program) + ",\n";
    text += "]\n";
    if (!program.within_lift) text += "within_lift = false\n";
    if (program.relative) text += "closed = \"relative\"\n";
    if (program.repeat > 1) text += fmt::format("repeat = {}\n", program.repeat);
    text +=
        fmt::format("[spline]\ndegree = {}\nsegments = {}\n[objective]\n", program.degree, program.pieces);
    text += "reference = { velocity = 2, acceleration = 6, jerk = 60, area = 0.5 }\n";
    if (program.area > 0.0) text += fmt::format("area = {:.17g}\n", program.area);
    constexpr std::array names = {"velocity", "acceleration", "jerk"};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (program.weights[i] > 0.0) text += fmt::format("{} = {:.17g}\n", names[i], program.weights[i]);
    text += "[limits]\n";
    if (program.velocity) text += fmt::format("velocity = {:.17g}\n", *program.velocity);
    if (program.velocity_mm_s) text += fmt::format("velocity_mm_s = {:.17g}\n", *program.velocity_mm_s);
    if (program.acceleration) text += fmt::format("acceleration = {:.17g}\n", *program.acceleration);
    return text + "[solver]\nmax_seconds = 20\nexplain_seconds = 0\n";
}

/// Angles of `count` segments that add up to a total, none short.
std::vector<double> angles_of(Draw& draw, int count, double total) {
    std::vector<double> angles;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) sum += angles.emplace_back(draw.between(1.0, 3.0));
    double left = total;
    for (int i = 0; i + 1 < count; ++i) {
        angles[i] = std::round(angles[i] / sum * total);
        left -= angles[i];
    }
    angles.back() = left;
    return angles;
}

/// Strokes up to `highest`, dwells and laws between some of them; set points within their strokes.
Program random_program(Draw& draw, double highest) {
    Program program;
    program.degree = draw.one_of<int>({3, 5, 5});
    program.pieces = draw.whole(5, 10);
    program.relative = highest > 1.0 && draw.chance(0.5);
    program.repeat = !program.relative && draw.chance(0.15) ? draw.whole(2, 3) : 1;
    const int count = draw.whole(2, 5);
    const std::vector<double> angles = angles_of(draw, count, 360.0 / program.repeat);
    double level = 0.0;
    for (int i = 0; i < count; ++i) {
        Segment segment;
        segment.angle = angles[static_cast<std::size_t>(i)];
        const bool last = i + 1 == count, first = i == 0;
        if (!first && !last && draw.chance(0.25)) {
            segment.kind = "dwell";
            program.segments.push_back(segment);
            continue;
        }
        double to = std::round(100.0 * draw.between(0.1, highest)) / 100.0;
        if (last && !program.relative) to = 0.0;
        if (std::abs(to - level) < 0.05) to = level + (level > 0.5 ? -0.3 : 0.3);
        if (last && !program.relative && std::abs(level) < 0.05) to = 0.0;
        if (!first && !last && draw.chance(0.15)) segment.kind = "law";
        segment.to = to;
        const int points = segment.kind == "spline" && draw.chance(0.5) ? draw.whole(1, 2) : 0;
        for (int k = 0; k < points; ++k) {
            const double at = (k + draw.between(0.3, 0.7)) / points;
            segment.displacements.push_back({at, level + (to - level) * (at * at * (3.0 - 2.0 * at))});
        }
        level = to;
        program.segments.push_back(segment);
    }
    program.weights = {draw.chance(0.3) ? draw.unit() : 0.0, draw.chance(0.5) ? draw.unit() : 0.0,
                       0.05 + draw.unit()};
    if (draw.chance(0.25)) program.velocity = draw.between(1.9, 2.6);
    if (draw.chance(0.2)) program.acceleration = draw.between(7.0, 12.0);
    return program;
}

Program scaled(Program program) {
    program.lift *= 2.0;
    for (Segment& segment : program.segments) {
        if (segment.to) *segment.to *= 0.5;
        for (auto& [at, y] : segment.displacements) y *= 0.5;
    }
    program.area *= 2.0;
    return program;
}

/// The displacement at the start of each segment, and at the end.
std::vector<double> levels_of(const Program& program) {
    std::vector<double> levels = {0.0};
    for (const Segment& segment : program.segments) levels.push_back(segment.to.value_or(levels.back()));
    return levels;
}

/// Says so where strokes reverse, or rests between two of one direction.
Program with_states_said(Program program) {
    if (!program.within_lift) return program;
    const std::vector<double> levels = levels_of(program);
    const std::size_t count = program.segments.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        Segment &own = program.segments[i], &other = program.segments[next];
        if (own.kind != "spline" || other.kind != "spline") continue;
        const double turned = (levels[i + 1] - levels[i]) * (levels[next + 1] - levels[next]);
        if (turned < 0.0) own.rests = true;
        if (own.rests && turned > 0.0) own.stands = true;
    }
    for (Segment& segment : program.segments) segment.steady = segment.fast_at.has_value();
    return program;
}

Program with_split_dwells(const Program& program) {
    Program split = program;
    split.segments.clear();
    for (const Segment& segment : program.segments) {
        split.segments.push_back(segment);
        if (segment.kind != "dwell") continue;
        split.segments.back().angle *= 0.5;
        split.segments.push_back(split.segments.back());
    }
    return split;
}

Program written_out(const Program& program) {
    Program whole = program;
    whole.repeat = 1;
    for (int copy = 1; copy < program.repeat; ++copy)
        whole.segments.insert(whole.segments.end(), program.segments.begin(), program.segments.end());
    return whole;
}

struct Pair {
    Program one, other;
    double higher = 0.0;  ///< the other's objective, by definition
};

Pair pair_of(Program program, int number) {
    switch (number % 4) {
        case 0: {
            const double higher = program.area / 0.5;
            return {program, scaled(program), higher};
        }
        case 1:
            return {program, with_split_dwells(with_states_said(program))};
        case 2:
            return {program, written_out(with_states_said(program))};
        default:
            return {program, with_states_said(program)};
    }
}

Pair reversing(int number) {
    Draw draw(4801, static_cast<std::uint64_t>(number));
    Program program = random_program(draw, 1.0);
    for (std::size_t i = 0; i + 1 < program.segments.size(); ++i)  // rests between strokes of one direction
        if (program.segments[i].kind == "spline" && program.segments[i + 1].kind == "spline" &&
            draw.chance(0.3))
            program.segments[i].rests = true;
    if (draw.chance(0.2)) {  // a set point at the limit
        for (Segment& segment : program.segments) {
            if (segment.kind != "spline" || !segment.displacements.empty() || segment.to == 0.0) continue;
            const std::size_t index = static_cast<std::size_t>(&segment - program.segments.data());
            const double moved = *segment.to - levels_of(program)[index];
            if (moved <= 0.0) continue;
            double fastest = 0.0;
            const std::vector<double> levels = levels_of(program);
            for (std::size_t i = 0; i < program.segments.size(); ++i)
                fastest = std::max(fastest, 1.95 * program.lift * std::abs(levels[i + 1] - levels[i]) *
                                                360.0 / program.segments[i].angle);
            program.velocity_mm_s = fastest;
            program.velocity.reset();
            if (1.95 * program.lift * moved * 360.0 / segment.angle < fastest) continue;
            segment.fast_at = draw.between(0.4, 0.6);
        }
    }
    return pair_of(std::move(program), number);
}

Pair with_area(int number) {
    Draw draw(4802, static_cast<std::uint64_t>(number));
    Program program = random_program(draw, draw.one_of<double>({1.0, 1.8, 3.0}));
    program.area = draw.between(0.1, 2.0);
    if (draw.chance(0.2)) {  // bounded: a mean that is higher by h costs at least h of the jerk
        program.within_lift = false;
        program.area = draw.between(0.02, 0.1);
        program.weights[2] = 1.0;
    }
    return pair_of(std::move(program), number);
}

struct Counts {
    int optimal = 0, infeasible = 0, refused = 0, open = 0;
};

std::optional<Solution> solved(const Program& program, std::string& refusal) {
    try {
        return solve(input::read_scene(text_of(program), "twin.toml", known_names(), {}));
    } catch (const InputError& error) {
        refusal = error.what();
        return {};
    }
}

/// What is proved of one holds for the other.
void expect_agreement(const Solution& one, const Solution& other, double higher) {
    const Certificate &proof = one.certificate, &found = other.certificate;
    constexpr double within = 3e-7;  // both gaps, and the tolerance of the limits
    if (proof.verdict == Verdict::infeasible) {
        EXPECT_EQ(other.motion, nullptr) << "proved infeasible, and solved: " << found.objective;
    }
    if (proof.lower_bound && other.motion && found.verdict != Verdict::failed) {
        EXPECT_LE(*proof.lower_bound + higher,
                  found.objective + within * std::max(1.0, std::abs(found.objective)))
            << "a bound that the twin is below";
    }
    EXPECT_NE(proof.verdict, Verdict::failed) << proof.reason;
}

void judge(const Pair& pair, Counts& counts) {
    SCOPED_TRACE("\n" + text_of(pair.one) + "\n# the twin\n" + text_of(pair.other));
    std::string refusal, refusal_of_other;
    const std::optional<Solution> one = solved(pair.one, refusal),
                                  other = solved(pair.other, refusal_of_other);
    EXPECT_EQ(one.has_value(), other.has_value()) << refusal << refusal_of_other;
    if (!one || !other) {
        ++counts.refused;
        return;
    }
    expect_agreement(*one, *other, pair.higher);
    expect_agreement(*other, *one, -pair.higher);
    const auto both = [&](Verdict verdict) {
        return one->certificate.verdict == verdict && other->certificate.verdict == verdict;
    };
    const bool decided = both(Verdict::optimal) || both(Verdict::infeasible);
    ++(both(Verdict::optimal) ? counts.optimal : decided ? counts.infeasible : counts.open);
    if (!decided)
        fmt::print("undecided: {} {:.9g}, {} {:.9g}\n{}# the twin\n{}", name_of(one->certificate.verdict),
                   one->certificate.objective, name_of(other->certificate.verdict),
                   other->certificate.objective, text_of(pair.one), text_of(pair.other));
}

void judge_all(Pair (*draw)(int), int count) {
    Counts counts;
    for (int number = 0; number < count; ++number) judge(draw(number), counts);
    fmt::print("{} pairs: {} optimal, {} infeasible, {} refused, {} undecided\n", count, counts.optimal,
               counts.infeasible, counts.refused, counts.open);
    EXPECT_GE(10 * (counts.optimal + counts.infeasible), 9 * count) << "most pairs are decided";
}

TEST(RandomTwins, ReversingProgramsAgree) {
    judge_all(reversing, testing_support::scenes_to_try(8, 200));
}

TEST(RandomTwins, ProgramsWithAreaAgree) {
    judge_all(with_area, testing_support::scenes_to_try(8, 100));
}

}  // namespace random_twins_test
}  // namespace camopt
