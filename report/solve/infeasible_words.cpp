// SPDX-License-Identifier: MIT
#include "report/solve/infeasible_words.hpp"

#include "core/text/list_text.hpp"
#include "report/view/cam_words.hpp"
#include "report/view/key_words.hpp"
#include "report/view/shown_units.hpp"
#include "report/view/view.hpp"
#include "scene/motion/set_points.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr double same_stretch = 0.1;   // of the motion: rows of a proof this close belong together
constexpr double same_point = 0.02;    // of the motion: a stretch shorter than this is a place
constexpr double worth_naming = 0.02;  // of a limit's heaviest row: lighter rows are left out
constexpr std::size_t most_stretches = 3;
constexpr int short_angle_digits = 3;

/// Where a limit is active.
struct ConflictStretch {
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
        KeyWords key = key_words(row.key, row.remark);
        key.limit = true;
        const std::string words = key.subject();
        auto limit = std::ranges::find(limits, words, &OneLimit::words);
        if (limit == limits.end()) limit = limits.insert(limit, {words, 0.0, {}});
        limit->weight += row.weight;
        limit->rows.push_back(row);
    }
    std::ranges::stable_sort(limits, std::greater{}, &OneLimit::weight);
    return limits;
}

/// The heaviest few, in the order of the cam angle.
std::vector<ConflictStretch> stretches_of(std::vector<ConflictReport> rows, double length) {
    const double least = worth_naming * rows.front().weight;
    std::erase_if(rows, [&](const ConflictReport& row) { return row.weight < least || std::isnan(row.at); });
    std::ranges::sort(rows, {}, &ConflictReport::at);
    std::vector<ConflictStretch> stretches;
    for (const ConflictReport& row : rows) {
        if (stretches.empty() || row.at > stretches.back().end + same_stretch * length)
            stretches.push_back({row.at, row.at, 0.0});
        stretches.back().end = row.at;
        stretches.back().weight += row.weight;
    }
    std::ranges::stable_sort(stretches, std::greater{}, &ConflictStretch::weight);
    if (stretches.size() > most_stretches) stretches.resize(most_stretches);
    std::ranges::sort(stretches, {}, &ConflictStretch::begin);
    return stretches;
}

/// "the pressure angle limit at 12 deg and from 40 to 55.5 deg"; without places where none are known
std::string text_of(const OneLimit& limit, const MotionSpec& motion) {
    const std::vector<ConflictStretch> stretches = stretches_of(limit.rows, motion.length());
    const std::string places = listed(stretches, " and ", [&](const ConflictStretch& stretch) {
        const bool is_place = stretch.end - stretch.begin < same_point * motion.length();
        const double middle = 0.5 * (stretch.begin + stretch.end);
        return stretch_words(motion, is_place ? middle : stretch.begin, is_place ? middle : stretch.end,
                             short_angle_digits);
    });
    return fmt::format("the {}{}{}", limit.words, places.empty() ? "" : " ", places);
}

/// The law that is the motion at x, from one given displacement to another; empty where a spline or a dwell
/// is or the splines decide how far the law moves.
std::string law_at(const MotionSpec& motion, double x) {
    double end = 0.0;
    std::optional<double> level = 0.0;
    for (const ProgramSegment& segment : motion.segments) {
        end += segment.angle / motion.unit_angle();
        const std::optional<double> to = segment.kind == SegmentKind::dwell ? level : segment.to;
        const bool given = level && to;
        if (x < end) return segment.kind == SegmentKind::law && given ? words_of(segment.law) : "";
        level = to;
    }
    return {};
}

/// The law that all rows of a limit lie in; empty where some do not, and of caps on the peaks of splines,
/// which have no place.
std::string law_of(const OneLimit& limit, const MotionSpec& motion) {
    constexpr std::array<std::string_view, 3> caps = {"limits.velocity", "limits.acceleration",
                                                      "limits.jerk"};
    if (std::ranges::find(caps, limit.rows.front().key) != caps.end()) return "";
    const std::string law = law_at(motion, limit.rows.front().at);
    const bool all = std::ranges::all_of(
        limit.rows, [&](const ConflictReport& row) { return law_at(motion, row.at) == law; });
    return all ? law : "";
}

bool has_key_of(const std::vector<std::string>& keys, const OneLimit& limit) {
    return std::ranges::any_of(keys, [&](const std::string& key) {
        return key_words(key).words == key_words(limit.rows.front().key).words;
    });
}

/// Of a scene whose laws fix every displacement.
constexpr const char* prescribed_words = "the prescribed motion with any cam of this scene";

/// "motion.start" or "motion.end" where a state given there violates the limit by itself.
std::string end_beyond(const OneLimit& limit, const Scene& scene) {
    for (const bool at_end : {false, true}) {
        if (!(at_end ? scene.motion.end : scene.motion.start)) continue;
        const std::array<double, 2> given = end_velocities(scene.motion, at_end);
        for (std::size_t order = 1; order <= given.size(); ++order) {
            const std::optional<PeakLimit>& most = peak_limit_of(scene.limits, static_cast<int>(order));
            const bool whole = most && (most->physical() || scene.motion.type != MotionType::program);
            if (whole && most->key == limit.rows.front().key && std::abs(given[order - 1]) > most->normalised)
                return at_end ? "motion.end" : "motion.start";
        }
    }
    return {};
}

/// "spline of 4 quintic segments": the motions that a verdict speaks of.
std::string spline_words(const Scene& scene) {
    const SplineSpec& spline = scene.spline;
    const bool uniform = spline.breakpoints.empty();
    const std::size_t segments =
        uniform ? static_cast<std::size_t>(spline.segments) : spline.breakpoints.size() - 1;
    return fmt::format("spline of {} {} {}{}{}", segments,
                       spline.degree == 3   ? "cubic"
                       : spline.degree == 5 ? "quintic"
                                            : "septic",
                       segments == 1 ? "segment" : "segments",
                       scene.motion.type == MotionType::program ? " in each of its parts" : "",
                       uniform ? "" : " on these breakpoints");
}

std::string alone_sentence(const OneLimit& limit, const std::string& words, const Solution& solution) {
    const std::string law = law_of(limit, solution.scene.motion);
    const bool prescribed = solution.scene.motion.prescribed();
    if (!law.empty())
        return fmt::format("{} cannot be satisfied: the motion there is the law {}{}.", words, law,
                           prescribed ? "" : ", regardless of the splines");
    if (const std::string end = end_beyond(limit, solution.scene); !end.empty())
        return fmt::format("{} cannot be satisfied: {} alone violates it.", words, end);
    if (prescribed) return fmt::format("{} cannot be satisfied by {}.", words, prescribed_words);
    const bool any = solution.explanation && has_key_of(solution.explanation->any_motion, limit);
    const bool moving = solution.scene.motion.start || solution.scene.motion.end;
    const char* const makes = moving ? "with the given start and end that makes the lift in its angle"
                                     : "that makes the lift in its angle";
    if (any) return fmt::format("{} cannot be satisfied by any motion {}.", words, makes);
    return fmt::format("{} cannot be satisfied by any {} {}.", words, spline_words(solution.scene), makes);
}

/// Of those that are impossible by themselves.
std::string alone_sentences(const std::vector<OneLimit>& limits, const Solution& solution) {
    std::string text;
    for (const OneLimit& limit : limits)
        append_item(text, alone_sentence(limit, capitalised(text_of(limit, solution.scene.motion)), solution),
                    " ");
    return text;
}

std::string undecided_words(const std::string& key) {
    return key == together_key ? "all limits together" : key_words(key).words;
}

void tell_hopeless(std::vector<std::string>& all, const std::vector<Relaxation>& rows) {
    std::vector<Relaxation> ruled_out, tried;
    for (const Relaxation& row : rows)
        if (!row.needed) (row.ruled_out ? ruled_out : tried).push_back(row);
    if (!ruled_out.empty())
        all.push_back(fmt::format("Changes proved ineffective separately: {}.", hopeless_changes(ruled_out)));
    if (!tried.empty())
        all.push_back(fmt::format("Changes tried separately without success: {}.", hopeless_changes(tried)));
}

/// Changes that suffice together.
std::string joint_sentence(const Solution& solution) {
    if (!solution.explanation || solution.explanation->together.empty()) return {};
    return fmt::format("A combined change that suffices: {}.",
                       listed(solution.explanation->together, " and ", change_words));
}

void tell_finest(std::vector<std::string>& all, const Explanation& explanation) {
    if (explanation.finest > 0)
        all.push_back(fmt::format("More segments were tried without success, up to {}.", explanation.finest));
}

/// The set points without which there is a motion, as they were written.
void tell_set_points(std::vector<std::string>& all, const Solution& solution) {
    const MotionSpec& motion = solution.scene.motion;
    std::vector<std::string> words;
    for (const PlacedPoint& point : placed_points(motion)) {
        if (std::ranges::find(solution.explanation->set_points, point.member) ==
            solution.explanation->set_points.end())
            continue;
        for (int order = 0; order < 3; ++order)
            if (point.wanted[order])
                words.push_back(fmt::format("{} ({})", words_of(motion, point, order), point.member));
    }
    if (words.empty()) return;
    const bool one = solution.explanation->set_points.size() == 1;
    all.push_back(fmt::format("{}: {}.",
                              one ? "Without this set point there is a motion"
                                  : "Without any one of these set points there is a motion",
                              fmt::join(words, "; ")));
}

void tell_time(std::vector<std::string>& all, const Explanation& explanation) {
    const std::string seconds = short_text(explanation.seconds, 2),
                      allowed = short_text(explanation.allowed, 3);
    const char* const limit =
        explanation.own_limit ? "solver.explain_seconds" : "the rest of solver.max_seconds";
    std::string text;
    switch (explanation.end) {
        case ExplanationEnd::complete:
            text = fmt::format("The search for changes took {} s.", seconds);
            break;
        case ExplanationEnd::enough:
            text = fmt::format(
                "The search for changes took {} s and ended with these (solver.explain_changes); others may "
                "help.",
                seconds);
            break;
        case ExplanationEnd::time_limit:
            text = fmt::format("The search for changes ended after {} s of {} s ({}); others may suffice.",
                               seconds, allowed, limit);
            break;
        case ExplanationEnd::interrupted:
            text = fmt::format("The search for changes was interrupted after {} s; others may suffice.",
                               seconds);
            break;
    }
    if (!explanation.unsettled.empty())
        text += fmt::format(" Not decided: {}.", listed(explanation.unsettled, ", ", undecided_words));
    all.push_back(std::move(text));
}

}  // namespace

std::string conflict_sentence(const Solution& solution) {
    const std::vector<OneLimit> limits = limits_of(solution.conflict);
    if (limits.empty()) return {};
    const MotionSpec& motion = solution.scene.motion;
    std::vector<OneLimit> alone;
    for (const OneLimit& limit : limits) {
        const bool known = solution.explanation && has_key_of(solution.explanation->alone, limit);
        if (limits.size() == 1 || known) alone.push_back(limit);
    }
    if (!alone.empty()) return alone_sentences(alone, solution);
    const bool prescribed = motion.prescribed();
    return fmt::format(
        "{} conflicts with {}: {} satisfies all limits.", capitalised(text_of(limits.front(), motion)),
        listed(std::span(limits).subspan(1), " and ",
               [&](const OneLimit& limit) { return text_of(limit, motion); }),
        prescribed ? "no cam of this scene for the prescribed motion" : "no " + spline_words(solution.scene));
}

std::string sufficient_changes(const std::vector<Relaxation>& rows) {
    std::string text;
    for (const Relaxation& row : rows)
        if (row.needed) append_item(text, change_words(row), ", or ");
    return text;
}

std::string hopeless_changes(const std::vector<Relaxation>& rows) {
    std::string text;
    for (const Relaxation& row : rows)
        if (!row.needed) append_item(text, key_words(row.key).words);
    return text;
}

std::string relaxation_sentence(const Relaxation& row) {
    if (!row.needed)
        return fmt::format("{} = {}: {} alone helps", row.key, short_text(row.given),
                           row.ruled_out ? "no change of this limit" : "no value tried of it");
    return fmt::format("{} = {}: {}", row.key, short_text(row.given), change_words(row));
}

std::vector<std::string> infeasible_remarks(const Solution& solution) {
    std::vector<std::string> all;
    const std::string conflict = conflict_sentence(solution);
    if (!conflict.empty()) all.push_back(conflict);
    const std::string changes = sufficient_changes(solution.relaxation);
    if (!changes.empty()) all.push_back(fmt::format("Any one of these changes suffices: {}.", changes));
    tell_hopeless(all, solution.relaxation);
    if (!solution.explanation) return all;
    tell_set_points(all, solution);
    if (const std::string together = joint_sentence(solution); !together.empty()) all.push_back(together);
    tell_finest(all, *solution.explanation);
    tell_time(all, *solution.explanation);
    return all;
}

}  // namespace camopt
