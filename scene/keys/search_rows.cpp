// SPDX-License-Identifier: MIT
// The rows of [spline] and [objective].
#include "scene/cost_table.hpp"
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"

#include <fmt/format.h>

namespace camopt::key_rows {
namespace {

using enum KeyType;
using namespace spellings;

/// Given breakpoints replace them; without the key an RR motion has as many over each stroke.
KeyPlace uniform_segments() {
    KeyPlace place = stored_in(&Scene::spline, &SplineSpec::segments);
    place.assign = [assign = place.assign](Scene& scene, const KeyValue& value, const KeyAt& at) {
        assign(scene, value, at);
        scene.spline.by_stroke = false;
    };
    return unless(std::move(place), [](const Scene& scene, const KeyAt&) {
        const SplineSpec& spline = scene.spline;
        return (spline.by_stroke && spline.segments == SplineSpec().segments) || !spline.breakpoints.empty();
    });
}

KeyPlace breakpoints_place() {
    KeyPlace place = stored_in(&Scene::spline, &SplineSpec::breakpoints);
    place.assign = [assign = place.assign](Scene& scene, const KeyValue& value, const KeyAt& at) {
        assign(scene, value, at);
        scene.spline.by_stroke = false;
    };
    return place;
}

KeyPlace knots_place() {
    return {.assign = [](Scene& scene, const KeyValue& value,
                         const KeyAt&) { scene.spline.free_knots = value == KeyValue("free"); },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                return scene.spline.free_knots ? "free" : "fixed";
            }};
}

// Two keys of one member: a scene is written with end_jerk where that can say it.
constexpr int without_jerk = 3;

KeyPlace end_jerk_place() {
    return {.assign = [](Scene& scene, const KeyValue& value,
                         const KeyAt&) { scene.spline.rest = value == KeyValue("zero") ? without_jerk : 2; },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                if (scene.spline.rest > without_jerk) return {};
                return scene.spline.rest == without_jerk ? "zero" : "free";
            }};
}

KeyPlace rest_place() {
    return unless(stored_in(&Scene::spline, &SplineSpec::rest),
                  [](const Scene& scene, const KeyAt&) { return scene.spline.rest <= without_jerk; });
}

// A row is read as a row.
// clang-format off
Rows spline() {
    return {
        {"spline", "degree", integer, plain, any, {"3", "5", "7"}, "3", "Degree of the spline.",
         stored_in(&Scene::spline, &SplineSpec::degree)},
        {"spline", "segments", integer, plain, Range::between(1, 65536), {}, "12",
         "Uniform segments over the rise (DRD), over rise and return (RR), or over each spline segment of a "
         "program. Without the key RR has six over the rise and six over the return.", uniform_segments()},
        {"spline", "breakpoints", numbers, plain, not_negative, {}, "uniform",
         "The breakpoints themselves, ascending from 0 to the end of the motion, in units of the rise; in a "
         "program from 0 to 1, in units of each spline segment.", breakpoints_place(), Availability::now, "segments"},
        called("breakpoints", {"spline", "knots", text, plain, any, {"fixed", "free"}, "\"fixed\"",
         "`\"free\"` makes the interior breakpoints design variables: those of `segments` or `breakpoints` are "
         "where the search starts, in a program the same for every spline segment. At most 256 segments.",
         knots_place()}),
        called("continuous derivatives", {"spline", "continuity", integer, plain, Range::between(2, 6), {}, "degree - 1",
         "Highest continuous derivative, from 2 (degree 7: 3) to degree - 1.", stored_in(&Scene::spline, &SplineSpec::continuity)}),
        called("jerk at the ends", {"spline", "end_jerk", text, plain, any, {"free", "zero"}, "\"free\"",
         "`\"zero\"`: y''' = 0 at both ends, so that the jerk does not jump at the dwells; degree 5 or 7. "
         "The same as `rest = 3`.", end_jerk_place()}),
        called("order of rest", {"spline", "rest", integer, plain, Range::between(2, 6), {}, "2",
         "Highest derivative that is 0 where the spline meets rest: at both ends (DRD, RR), at dwells and open ends of a "
         "program. From 2 to degree - 1.", rest_place(), Availability::now, "end_jerk"}),
        called("variables of the search", {"spline", "design", text, plain, any, {"auto", "ordinates", "coefficients", "states"}, "\"auto\"",
         "The variables of the search: displacements at the breakpoints (full continuity only), B-spline "
         "coefficients, or displacement and derivatives at the breakpoints.",
         stored_in(&Scene::spline, &SplineSpec::design)}),
    };
}

/// In the order of the manual: convex terms before others.
std::vector<const CostTerm*> listed_terms() {
    std::vector<const CostTerm*> terms;
    for (const CostTerm& term : cost_terms()) terms.push_back(&term);
    std::stable_partition(terms.begin(), terms.end(),
                          [](const CostTerm* term) { return term->kind != CostTerm::Kind::torque; });
    return terms;
}

Availability needs_of(const ResponseTerm& term) {
    return term.needs_dynamics() ? Availability::needs_dynamics
           : term.needs_drive()  ? Availability::needs_drive
                                 : Availability::now;
}

/// objective.least, objective.largest: one of both, one member.
KeyPlace sought_place(bool largest) {
    KeyPlace place;
    place.assign = [largest](Scene& scene, const KeyValue& value, const KeyAt&) {
        const auto& key = std::get<std::string>(value);
        scene.objective.sought = key.empty() ? std::nullopt : std::optional(SoughtKey{key, largest});
    };
    place.value = [largest](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
        const std::optional<SoughtKey>& sought = scene.objective.sought;
        if (!sought || sought->largest != largest) return std::nullopt;
        return sought->key;
    };
    return place;
}

Rows objective() {
    Rows rows;
    for (const CostTerm* term : listed_terms())
        rows.push_back({"objective", term->name(), number, plain, not_negative, {}, "0", term->weight_meaning,
                        stored_in(&Scene::objective, term->weight)});
    for (const ResponseTerm& term : response_terms())
        rows.push_back({"objective", term.name, number, plain, not_negative, {}, "0", term.weight_meaning,
                        stored_in(&Scene::objective, term.weight), needs_of(term)});
    rows.push_back(called("what peaks are of", {"objective", "peaks", text, plain, any, {"strokes", "motion"}, "\"strokes\"",
        "Of a program: velocity, acceleration and jerk of each stroke by its own angle and displacement, a stroke being the splines "
        "from rest to rest; `\"motion\"`: of the whole motion, by the lift and the angle of the first spline. DRD and RR: the same.",
        stored_in(&Scene::objective, &ObjectiveSpec::peaks)}));
    rows.push_back(called("least value of a number", {"objective", "least", text, plain, any, {}, "none",
        "A key, such as `\"limits.pressure_angle_deg\"`: its least value for which motions exist is found and proved; the weights "
        "then choose among these motions. Any cap of [limits], given or not, and other numbers of the scene.",
        sought_place(false)}));
    rows.push_back(called("largest value of a number", {"objective", "largest", text, plain, any, {}, "none",
        "The same for what is better large: `\"limits.cam_radius_min_mm\"`, `\"motion.speed_rpm\"`.",
        sought_place(true), Availability::now, "least"}));
    rows.push_back({"objective", "least_gap", number, plain, Range::between(1e-7, 0.1), {}, "1e-4",
        "Relative distance between the value found and the value at which no motion exists.",
        stored_in(&Scene::objective, &ObjectiveSpec::least_gap)});
    return rows;
}

/// The first is the default.
std::vector<std::string_view> tie_break_words() {
    std::vector<std::string_view> words;
    words.reserve(std::size(tie_breaks));
    for (const TieBreak value : tie_breaks) words.emplace_back(name_of(value));
    return words;
}

Rows dimension_weights() {
    const auto dimension_weight = [](DimensionIndex dimension) {
        return stored_in(&Scene::objective, &ObjectiveSpec::dimensions, static_cast<std::size_t>(dimension));
    };
    return {
        {"objective", "base_radius", number, plain, not_negative, {}, "0",
         "Weight of the base radius divided by the lift (oscillating: by lift in rad · centre distance).",
         dimension_weight(DimensionIndex::base_radius),
         Availability::needs_cam},
        {"objective", "roller_radius", number, plain, not_negative, {}, "0",
         "Weight of the roller radius, divided likewise.",
         dimension_weight(DimensionIndex::roller_radius), Availability::needs_cam},
        {"objective", "offset", number, plain, not_negative, {}, "0",
         "Weight of the offset's magnitude, divided likewise.",
         dimension_weight(DimensionIndex::offset), Availability::needs_cam},
        {"objective", "center_distance", number, plain, not_negative, {}, "0",
         "Weight of the centre distance, divided likewise.",
         dimension_weight(DimensionIndex::center_distance), Availability::needs_cam},
        {"objective", "arm_length", number, plain, not_negative, {}, "0",
         "Weight of the arm length, divided likewise.",
         dimension_weight(DimensionIndex::arm_length), Availability::needs_cam},
        {"objective", "face_offset", number, plain, not_negative, {}, "0",
         "Weight of the face offset, divided likewise.",
         dimension_weight(DimensionIndex::face_offset), Availability::needs_cam},
    };
}

/// The name of a law, or a table of numbers.
KeyPlace reference_place() {
    return {.assign =
                [](Scene& scene, const KeyValue& value, const KeyAt&) {
                    Reference& reference = scene.objective.reference;
                    reference.numeric = !std::holds_alternative<std::string>(value);
                    if (!reference.numeric) reference.law = std::get<std::string>(value);
                },
            .value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
                const Reference& reference = scene.objective.reference;
                return reference.numeric ? KeyValue() : KeyValue(reference.law);
            }};
}

KeyPlace reference_number(std::optional<double> Reference::*number) {
    return stored_in(&Scene::objective, &ObjectiveSpec::reference, number);
}

Rows reference() {
    static const std::string first_tie_break = fmt::format("\"{}\"", name_of(tie_breaks.front()));
    Rows rows = {
        called("reference law", {"objective", "reference", text_or_table, plain, any, {}, "\"modified_sine\"",
         "What every term is divided by: the peaks of a law of the catalogue, or a table of numbers.", reference_place()}),
        called("choice among equal curves", {"objective", "tie_break", text, plain, any, tie_break_words(), first_tie_break,
         "Among curves equally good within the tolerance take the one of least ∫ y'''²; `\"none\"` keeps "
         "the solver's point.", stored_in(&Scene::objective, &ObjectiveSpec::tie_break)}),
    };
    for (const CostTerm* term : listed_terms())
        rows.push_back({"objective.reference", term->name(), number, plain, positive, {}, "none",
                        term->reference_meaning, reference_number(term->reference)});
    for (const ResponseTerm& term : response_terms())
        rows.push_back({"objective.reference", term.name, number, plain, positive, {}, "none",
                        term.reference_meaning, reference_number(term.reference), needs_of(term)});
    return rows;
}
// clang-format on

}  // namespace

Rows of_search() {
    return joined(spline(), objective(), dimension_weights(), reference());
}

}  // namespace camopt::key_rows
