// SPDX-License-Identifier: MIT
#include "output/infeasible_words.hpp"

#include "core/units.hpp"
#include "output/key_words.hpp"
#include "output/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace camopt {

namespace {

constexpr double same_stretch = 0.1;   // of the motion: rows of a proof this close belong together
constexpr double same_place = 0.02;    // of the motion: a stretch shorter than this is a place
constexpr double worth_naming = 0.02;  // of a limit's heaviest row: lighter rows are left out
constexpr std::size_t most_stretches = 3;
constexpr int angle_digits = 3;

/// Where a limit bites.
struct Stretch {
    double begin = 0.0, end = 0.0, weight = 0.0;  ///< x
};

/// The rows of one limit.
struct OneLimit {
    std::string words;
    double weight = 0.0;
    std::vector<ConflictReport> rows;  ///< heaviest first
};

std::vector<OneLimit> limits_of(const std::vector<ConflictReport>& conflict) {
    std::vector<OneLimit> limits;
    for (const ConflictReport& row : conflict) {
        const std::string words = key_words(row.key).words;
        auto limit = std::ranges::find(limits, words, &OneLimit::words);
        if (limit == limits.end()) limit = limits.insert(limit, {words, 0.0, {}});
        limit->weight += row.weight;
        limit->rows.push_back(row);
    }
    std::ranges::stable_sort(limits, std::greater{}, &OneLimit::weight);
    return limits;
}

/// The heaviest few, in the order of the cam angle.
std::vector<Stretch> stretches_of(std::vector<ConflictReport> rows, double length) {
    const double least = worth_naming * rows.front().weight;
    std::erase_if(rows, [&](const ConflictReport& row) { return row.weight < least; });
    std::ranges::sort(rows, {}, &ConflictReport::at);
    std::vector<Stretch> stretches;
    for (const ConflictReport& row : rows) {
        if (stretches.empty() || row.at > stretches.back().end + same_stretch * length)
            stretches.push_back({row.at, row.at, 0.0});
        stretches.back().end = row.at;
        stretches.back().weight += row.weight;
    }
    std::ranges::stable_sort(stretches, std::greater{}, &Stretch::weight);
    if (stretches.size() > most_stretches) stretches.resize(most_stretches);
    std::ranges::sort(stretches, {}, &Stretch::begin);
    return stretches;
}

/// "the pressure angle limit at 12 deg and from 40 to 55.5 deg"
std::string text_of(const OneLimit& limit, const MotionSpec& motion) {
    const double degrees_per_x = motion.unit_angle() / units::degree;
    const auto degrees = [&](double x) { return short_text(degrees_per_x * x, angle_digits); };
    const std::vector<Stretch> stretches = stretches_of(limit.rows, motion.length());
    std::string places;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const Stretch& stretch = stretches[i];
        if (i > 0) places += i + 1 < stretches.size() ? ", " : " and ";
        places += stretch.end - stretch.begin < same_place * motion.length()
                      ? fmt::format("at {} deg", degrees(0.5 * (stretch.begin + stretch.end)))
                      : fmt::format("from {} to {} deg", degrees(stretch.begin), degrees(stretch.end));
    }
    return fmt::format("the {} limit {}", limit.words, places);
}

/// The law that is the motion at x; empty where a spline or a dwell is.
std::string law_at(const MotionSpec& motion, double x) {
    double end = 0.0;
    for (const ProgramSegment& segment : motion.segments) {
        end += segment.angle / motion.unit_angle();
        if (x < end) return segment.kind == SegmentKind::law ? words_of(segment.law) : "";
    }
    return {};
}

std::string alone_sentence(const OneLimit& limit, const std::string& words, const MotionSpec& motion) {
    const std::string law = law_at(motion, limit.rows.front().at);
    if (law.empty()) return words + " cannot be kept by any motion that makes the lift in its angle.";
    return fmt::format("{} cannot be kept: the motion there is the law {}, whatever the splines do.", words,
                       law);
}

}  // namespace

std::string conflict_sentence(const Solution& solution) {
    const std::vector<OneLimit> limits = limits_of(solution.conflict);
    if (limits.empty()) return {};
    const MotionSpec& motion = solution.scene.motion;
    std::string first = text_of(limits.front(), motion);
    first.front() = 'T';
    if (limits.size() == 1) return alone_sentence(limits.front(), first, motion);
    std::string others;
    for (std::size_t i = 1; i < limits.size(); ++i)
        others += (i > 1 ? " and " : "") + text_of(limits[i], motion);
    return fmt::format("{} fights {}: no motion keeps all of them.", first, others);
}

std::string sufficient_changes(const std::vector<Relaxation>& rows) {
    std::string text;
    for (const Relaxation& row : rows)
        if (row.needed) text += (text.empty() ? "" : ", or ") + needed_words(row);
    return text;
}

std::string hopeless_changes(const std::vector<Relaxation>& rows) {
    std::string text;
    for (const Relaxation& row : rows)
        if (!row.needed) text += (text.empty() ? "" : ", ") + key_words(row.key).words;
    return text;
}

std::vector<std::string> infeasible_remarks(const Solution& solution) {
    std::vector<std::string> all;
    const std::string conflict = conflict_sentence(solution);
    if (!conflict.empty()) all.push_back(conflict);
    if (solution.relaxation.empty()) return all;
    const std::string changes = sufficient_changes(solution.relaxation);
    const std::string hopeless = hopeless_changes(solution.relaxation);
    all.push_back(changes.empty() ? "No change of one limit or dimension alone helps."
                                  : fmt::format("One of these alone would do: {}.", changes));
    if (!changes.empty() && !hopeless.empty())
        all.push_back(fmt::format("No change of one of these alone helps: {}.", hopeless));
    return all;
}

bool is_told_in_words(const Scene& scene) {
    return scene.cam.has_value() || scene.mechanism.has_value() || scene.motion.type == MotionType::program;
}

}  // namespace camopt
