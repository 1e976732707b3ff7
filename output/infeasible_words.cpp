// SPDX-License-Identifier: MIT
#include "output/infeasible_words.hpp"

#include "core/units.hpp"
#include "output/key_words.hpp"
#include "output/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr double one_place = 0.02;    // of the motion: rows of a proof this close speak of one place
constexpr double worth_naming = 0.2;  // of a limit's heaviest row: lighter places are left out
constexpr std::size_t most_places = 3;
constexpr int angle_digits = 4;

/// The rows of one limit.
struct LimitSide {
    std::string words;
    double weight = 0.0;
    std::vector<ConflictReport> places;  ///< heaviest first
};

std::vector<LimitSide> sides_of(const Solution& solution) {
    std::vector<LimitSide> sides;
    const double near = one_place * solution.scene.motion.length();
    for (const ConflictReport& row : solution.conflict) {
        const std::string words = key_words(row.key).words;
        auto side = std::ranges::find(sides, words, &LimitSide::words);
        if (side == sides.end()) side = sides.insert(side, {words, 0.0, {}});
        side->weight += row.weight;
        const bool known = std::ranges::any_of(
            side->places, [&](const ConflictReport& place) { return std::abs(place.at - row.at) <= near; });
        const bool light = !side->places.empty() && row.weight < worth_naming * side->places.front().weight;
        if (!known && !light && side->places.size() < most_places) side->places.push_back(row);
    }
    std::ranges::stable_sort(sides, std::greater{}, &LimitSide::weight);
    return sides;
}

std::string text_of(LimitSide side, double degrees_per_x) {
    std::ranges::sort(side.places, {}, &ConflictReport::at);
    std::string places;
    for (std::size_t i = 0; i < side.places.size(); ++i) {
        if (i > 0) places += i + 1 < side.places.size() ? ", " : " and ";
        places += short_text(degrees_per_x * side.places[i].at, angle_digits);
    }
    return fmt::format("the {} limit at {} deg", side.words, places);
}

}  // namespace

std::string conflict_sentence(const Solution& solution) {
    const std::vector<LimitSide> sides = sides_of(solution);
    if (sides.empty()) return {};
    const double degrees_per_x = solution.scene.motion.unit_angle() / units::degree;
    std::string first = text_of(sides.front(), degrees_per_x);
    first.front() = 'T';
    if (sides.size() == 1)
        return first + " cannot be kept by any motion that makes the lift within its angle.";
    std::string others;
    for (std::size_t i = 1; i < sides.size(); ++i)
        others += (i > 1 ? " and " : "") + text_of(sides[i], degrees_per_x);
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
    return scene.cam.has_value() || scene.motion.type == MotionType::program;
}

}  // namespace camopt
