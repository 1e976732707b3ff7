// SPDX-License-Identifier: MIT
#include "objectives/scene_model.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/deviation_rules.hpp"
#include "objectives/drive_rules.hpp"
#include "objectives/laws/segment_law.hpp"
#include "objectives/motion_bounds.hpp"
#include "objectives/own_point_rule.hpp"
#include "objectives/response/response_rule.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/torque_rule.hpp"
#include "objectives/spring_rules.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Units for peaks that are capped but have no finite reference: those of the modified sine.
constexpr const char* fallback_law = "modified_sine";

struct WeightedPeak {
    Parameter::Kind kind;
    int order;
    double weight;
    const std::optional<PeakLimit>* limit;
    double reference;
};

/// References as given; a missing one is that of the fallback law, whose peaks are computed only then.
class References {
 public:
    [[nodiscard]] double of(const PeakFigure& figure, const Peaks& reference) {
        const double value = figure.of(reference);
        if (std::isfinite(value) && value > 0.0) return value;
        if (!fallback_) fallback_ = make_law(fallback_law)->peaks();
        return figure.of(*fallback_);
    }

 private:
    std::optional<Peaks> fallback_;
};

Parameter::Kind parameter_kind(CostTerm::Kind kind) {
    switch (kind) {
        case CostTerm::Kind::peak:
            return Parameter::Kind::peak;
        case CostTerm::Kind::torque:
            return Parameter::Kind::torque;
        case CostTerm::Kind::rms:
            break;
    }
    return Parameter::Kind::rms;
}

std::vector<WeightedPeak> weighted_peaks(const Scene& scene, const Peaks& reference, const CostUnits& units) {
    static const std::optional<PeakLimit> none;
    References references;
    std::vector<WeightedPeak> peaks;
    for (const CostTerm& term : cost_terms()) {
        const double unit = units.of_peak(peaks.size());
        const double weight = term.weight_in(scene.objective);
        // Quantities that can be capped have a unit even without a weight.
        const bool needs_unit = term.limit != nullptr || weight > 0.0;
        peaks.push_back({parameter_kind(term.kind), term.measured.order, unit * weight,
                         term.limit != nullptr ? &(scene.limits.*term.limit) : &none,
                         needs_unit ? unit * references.of(term.measured, reference) : 1.0});
    }
    return peaks;
}

void require_finite(const CostTerm& term, double weight, double value, const std::string& law) {
    if (weight > 0.0 && !(std::isfinite(value) && value > 0.0)) {
        throw SceneError(
            {"objective.reference",
             fmt::format("\"{}\", which has no finite {}, with the weight {}", law, term.name(), weight),
             fmt::format("a law whose {} is finite, numbers, or the weight 0", term.name())});
    }
}

std::unique_ptr<Law> reference_law(const std::string& key) {
    std::unique_ptr<Law> law = make_law(key);
    if (!law->info().rests)
        throw SceneError({"objective.reference", fmt::format("\"{}\", a law whose ends move", key),
                          "a law that rests at its ends, or numbers"});
    return law;
}

constexpr double overshoot = 0.25;  // of the given displacements: how far a typical motion exceeds them

/// least <= y <= most at the end of a segment.
void add_range(CamModel& model, int segment, double least, double most) {
    const double at = model.design.stretches()[static_cast<std::size_t>(segment)].end;
    for (const int sign : {1, -1}) {
        LinearBound bound{segment_key(segment, "to"), 0, sign, sign > 0 ? most : -least};
        bound.from = bound.until = at;
        bound.fields.which["segment"] = segment;
        model.rules.push_back(bound.rule());
    }
}

void add_program_scales(CamModel& model, const Scene& scene) {
    if (scene.motion.type != MotionType::program) return;
    model.stretch_scales = peak_scales(scene);
    const auto [least, most] = known_range(model.design);
    model.least_displacement = least - overshoot * std::max(1.0, most - least);
    model.most_displacement = most + overshoot * std::max(1.0, most - least);
    const FreeDisplacements free = free_displacements(scene, model.design);
    for (const int joint : free.joints) add_range(model, joint - 1, free.least, free.most);
}

/// Whether a shape begins (seen from the right) or ends with y' = 0.
bool rests_at(const Motion& shape, Side side) {
    constexpr double at_rest = 1e-9;  // of the mean velocity 1: less is round-off
    const double x = side == Side::right ? shape.begin() : shape.end();
    return std::abs(shape.at(x, side).derivative[1]) < at_rest;
}

bool ends_at_rest(const MotionSpec& motion) {
    return end_velocities(motion, false)[0] == 0.0 && end_velocities(motion, true)[0] == 0.0;
}

/// Displacements given by the scene: both ends, the top of RR, joints of a program next to a dwell or a law.
void add_known_points(CamModel& model, const Scene& scene) {
    const auto& stretches = model.design.stretches();
    std::vector<KnownPoint> points;
    for (std::size_t s = 0; s < stretches.size(); ++s) {
        const std::optional<double> from = known_displacement(stretches[s].from);
        const std::optional<double> to = known_displacement(stretches[s].to);
        if (!from || !to) return;  // one gap makes the whole unknown
        // A spline among others may pass its ends with a velocity; dwells, DRD and RR rest there, and most
        // laws.
        const bool rests = stretches.size() == 1 ? ends_at_rest(scene.motion)
                                                 : stretches[s].kind != StretchRequest::Kind::spline;
        const Motion* const shape = stretches[s].shape.get();
        points.push_back(
            {stretches[s].begin, *from, rests && (shape == nullptr || rests_at(*shape, Side::right))});
        points.push_back(
            {stretches[s].end, *to, rests && (shape == nullptr || rests_at(*shape, Side::left))});
    }
    if (scene.motion.type == MotionType::rr) points.insert(points.begin() + 1, {1.0, 1.0, true});
    model.known_points = std::move(points);
}

/// |y^{(order)}| <= most − error, the error of a made cam.
void add_cap(CamModel& model, const PeakLimit& limit, int order, double most, double error, int stretch) {
    const double bound = most - error;
    for (const int sign : {1, -1}) {
        LinearBound cap{limit.key, order, sign, bound, bound > 0.0 ? bound : most};
        cap.stretch = stretch;
        model.rules.push_back(cap.rule());
    }
}

/// A normalised limit on the motion of a made cam: in a program on each spline stretch.
void add_caps(CamModel& model, const PeakLimit& limit, int order, double error) {
    if (model.stretch_scales.empty()) return add_cap(model, limit, order, limit.normalised, error, -1);
    for (int s = 0; s < static_cast<int>(model.design.own_stretches().size()); ++s) {
        if (model.design.stretches()[s].kind != StretchRequest::Kind::spline) continue;
        const StretchScale& scale = model.stretch_scales[s];
        add_cap(model, limit, order, limit.normalised * scale.displacement / std::pow(scale.angle, order),
                error, s);
    }
}

/// The two rules that make parameter `index` the peak of |y^{(order)}|, or of |y' y''|: in a program on each
/// spline stretch.
void add_epigraph(CamModel& model, const WeightedPeak& source, int index) {
    const auto add = [&](const StretchScale& scale, int stretch) {
        const double moved = source.reference * scale.displacement;
        const double reference = source.kind == Parameter::Kind::torque
                                     ? moved * scale.displacement / std::pow(scale.angle, 3)
                                     : moved / std::pow(scale.angle, source.order);
        for (const int sign : {1, -1}) {
            if (source.kind == Parameter::Kind::torque) {
                model.rules.emplace_back(std::make_shared<TorqueRule>(sign, index, reference), stretch);
                continue;
            }
            LinearBound peak{std::string(sign > 0 ? "+" : "-") + derivative_names[source.order], source.order,
                             sign};
            peak.scale = reference;
            peak.peak = index;
            peak.stretch = stretch;
            peak.fields.key = derivative_names[source.order];
            model.rules.push_back(peak.rule());
        }
    };
    if (model.stretch_scales.empty()) return add({}, -1);
    for (int s = 0; s < static_cast<int>(model.design.own_stretches().size()); ++s)
        if (model.design.stretches()[s].kind == StretchRequest::Kind::spline) add(model.stretch_scales[s], s);
}

std::string name_of_term(const WeightedPeak& source) {
    if (source.kind == Parameter::Kind::torque) return "peak torque";
    if (source.kind == Parameter::Kind::peak) return peak_words(source.order);
    return fmt::format("rms {}", derivative_names[source.order]);
}

/// What a figure of a law by its own angle and displacement is by the measure of the scene.
double by_own_measure(const PeakFigure& figure, const MotionFamily::Stretch& stretch,
                      const StretchScale& scale) {
    const std::optional<double> from = known_displacement(stretch.from), to = known_displacement(stretch.to);
    const double moved = from && to ? measured_displacement(*to - *from) : 1.0;
    return std::pow(moved / scale.displacement, figure.size_power) *
           std::pow(scale.angle / (stretch.end - stretch.begin), figure.width_power);
}

/// y'' of a stretch of a prescribed motion where it begins or ends, in lifts and units of x.
double end_acceleration(const MotionFamily::Stretch& stretch, bool at_end) {
    if (!stretch.shape) return 0.0;
    const MotionPoint point =
        at_end ? stretch.shape->at(1.0, Side::left) : stretch.shape->at(0.0, Side::right);
    const double rise = *known_displacement(stretch.to) - *known_displacement(stretch.from);
    return rise * point.derivative[2] / std::pow(stretch.end - stretch.begin, 2);
}

/// Peaks of a law of a prescribed motion. Whether y'' jumps at the ends of one that takes the states beside
/// it, or that turns back, is a matter of its neighbours.
Peaks prescribed_peaks(const MotionSpec& motion, std::span<const MotionFamily::Stretch> stretches,
                       std::size_t index) {
    constexpr double same_acceleration = 1e-9;
    const std::shared_ptr<const Law> law = segment_law(motion, index);
    const bool as_beside = motion.segments[index].takes_states() || law->info().top == TopEnd::turning_point;
    if (!as_beside) return law->peaks();
    Peaks peaks = find_peaks_without_impulses(*law);
    for (const bool after : {false, true}) {
        const bool outer = index == (after ? stretches.size() - 1 : 0) && !motion.periodic();
        const std::size_t other = (index + (after ? 1 : stretches.size() - 1)) % stretches.size();
        const double own = end_acceleration(stretches[index], after),
                     beside = outer ? 0.0 : end_acceleration(stretches[other], !after);
        if (std::abs(own - beside) <= same_acceleration * std::max(std::abs(own), std::abs(beside))) continue;
        peaks.jerk.value = infinity;
        derivative_mean(peaks, 3) = infinity;
    }
    return peaks;
}

/// V, A, J of a prescribed motion are the largest over its laws: constants of the cost, and caps on each law.
void add_prescribed_peaks(CamModel& model, const Scene& scene, const Peaks& reference) {
    const std::span<const MotionFamily::Stretch> stretches = model.design.stretches();
    std::vector<Peaks> peaks(stretches.size());
    for (std::size_t s = 0; s < stretches.size(); ++s)
        if (stretches[s].kind == StretchRequest::Kind::shape)
            peaks[s] = prescribed_peaks(scene.motion, stretches, s);
    for (const CostTerm& term : cost_terms()) {
        const double weight = term.weight_in(scene.objective);
        const std::optional<PeakLimit>* const limit =
            term.limit != nullptr ? &(scene.limits.*term.limit) : nullptr;
        double largest = 0.0, squares = 0.0, width = 0.0;
        for (int s = 0; s < static_cast<int>(model.design.stretches().size()); ++s) {
            const MotionFamily::Stretch& stretch = model.design.stretches()[s];
            if (stretch.kind != StretchRequest::Kind::shape) continue;
            const StretchScale& scale = model.stretch_scales[s];
            const std::string& law = scene.motion.segments[s].law;
            const double own = term.measured.of(peaks[s]) * by_own_measure(term.measured, stretch, scale);
            if (weight > 0.0 && !std::isfinite(own))
                throw SceneError(
                    {fmt::format("objective.{}", term.name()),
                     fmt::format("{} with the law \"{}\", which has no finite {}", weight, law, term.name()),
                     "0, or another law"});
            largest = std::max(largest, own);
            squares += own * own * (stretch.end - stretch.begin);
            width += stretch.end - stretch.begin;
            if (limit == nullptr || !*limit || (*limit)->physical()) continue;
            const double most =
                (*limit)->normalised * scale.displacement / std::pow(scale.angle, term.measured.order);
            add_cap(model, **limit, term.measured.order, most, scene.motion_error(term.measured.order), s);
        }
        const double figure = term.kind == CostTerm::Kind::rms ? std::sqrt(squares / width) : largest;
        if (weight > 0.0) model.cost_constant += weight * figure / term.measured.of(reference);
    }
}

void add_peaks(CamModel& model, const Scene& scene, const Peaks& reference, const CostUnits& units) {
    const bool prescribed = scene.motion.prescribed();
    if (prescribed) add_prescribed_peaks(model, scene, reference);
    for (const WeightedPeak& source : weighted_peaks(scene, reference, units)) {
        const bool peak = source.kind == Parameter::Kind::peak;
        if (peak) model.entry_scale[source.order] = source.reference;
        if (peak && source.order == 3) model.jerk_reference = source.reference;
        const std::optional<PeakLimit>& limit = *source.limit;
        const double error = limit ? scene.motion_error(source.order) : 0.0;
        const bool caps_motion = limit && limit->physical() && !model.stretch_scales.empty();
        if (caps_motion) add_cap(model, *limit, source.order, limit->normalised, error, -1);
        if (limit && error > 0.0 && !caps_motion && !prescribed) add_caps(model, *limit, source.order, error);
        if (prescribed || (source.weight == 0.0 && (!limit || caps_motion || error > 0.0))) continue;
        const int index = static_cast<int>(model.parameters.size());
        model.parameters.push_back(
            {name_of_term(source), source.kind, source.order, source.reference, source.weight});
        if (source.kind != Parameter::Kind::rms) add_epigraph(model, source, index);
        if (peak && limit && !caps_motion && error == 0.0) {
            const double upper = limit->normalised / source.reference;
            model.parameter_rows.push_back({limit->key, {index}, {1.0}, upper, true, upper});
        }
    }
}

/// |q| of parameter `of` as a separate parameter: q − t <= 0, −q − t <= 0.
void add_magnitude(CamModel& model, int of, double weight) {
    const Parameter source = model.parameters[of];
    const int index = static_cast<int>(model.parameters.size());
    model.parameters.push_back(
        {"magnitude of " + source.name, Parameter::Kind::magnitude, of, source.reference, weight});
    for (const double sign : {1.0, -1.0}) {
        model.parameter_rows.push_back(
            {"magnitude of " + source.name, {of, index}, {sign, -1.0}, 0.0, false, 1.0});
    }
}

/// The numbers of the spring that are ranges: variables with places after the dimensions of the cam.
void add_spring(CamModel& model, CamVariables& cam, const ForceSpec& forces) {
    for (std::size_t k = 0; k < spring_numbers.size(); ++k) {
        const auto& range = forces.*spring_numbers[k].range;
        if (!range) continue;
        const auto [low, high] = *range;
        const double reference = std::max(std::abs(low), std::abs(high));
        cam.spring[k] = static_cast<int>(cam.cam.dimensions.size());
        cam.cam.dimensions.push_back(forces.*spring_numbers[k].number);
        cam.variables.push_back({cam.spring[k], static_cast<int>(model.parameters.size()), reference});
        model.parameters.push_back({spring_numbers[k].key, Parameter::Kind::dimension, 0, reference, 0.0,
                                    low / reference, high / reference});
    }
}

void add_cam(CamModel& model, const Scene& scene) {
    const std::optional<CamSpec>& spec = scene.cam;
    if (!spec) return;
    auto cam = std::make_shared<CamVariables>();
    cam->cam = {spec->formulas(), spec->middle()};
    cam->scale = {scene.motion.lift, scene.motion.unit_angle()};
    for (std::size_t d = 0; d < spec->dimensions.size(); ++d) {
        const Dimension& dimension = spec->dimensions[d].value;
        const double weight = dimension_weight(scene, spec->dimensions[d].name);
        if (!dimension.is_variable()) {
            model.cost_constant += weight * std::abs(dimension.low);
            continue;
        }
        const double reference = std::max(std::abs(dimension.low), std::abs(dimension.high));
        const int index = static_cast<int>(model.parameters.size());
        const bool signless = dimension.low >= 0.0;
        model.parameters.push_back({spec->dimensions[d].name, Parameter::Kind::dimension, 0, reference,
                                    signless ? weight * reference : 0.0, dimension.low / reference,
                                    dimension.high / reference});
        if (!signless && weight > 0.0) add_magnitude(model, index, weight * reference);
        cam->variables.push_back({static_cast<int>(d), index, reference});
    }
    if (scene.forces) add_spring(model, *cam, *scene.forces);
    model.cam = cam;
    add_reach_rows(model, *spec);
    for (const auto& rule : cam_limits(scene, *cam)) model.rules.emplace_back(rule);
}

/// Rules and terms that see another motion than the output's.
void add_seeing(SeenMotion seen, CamModel& model, const Scene& scene, void (*add)(CamModel&, const Scene&)) {
    const std::size_t rules = model.rules.size(), parameters = model.parameters.size();
    add(model, scene);
    for (std::size_t r = rules; r < model.rules.size(); ++r) model.rules[r].seen = seen;
    for (std::size_t p = parameters; p < model.parameters.size(); ++p) model.parameters[p].seen = seen;
}

}  // namespace

Peaks reference_peaks(const Scene& scene) {
    const Reference& reference = scene.objective.reference;
    Peaks peaks;
    if (!reference.numeric) peaks = reference_law(reference.law)->peaks();
    for (const CostTerm& term : cost_terms())
        if (const std::optional<double>& number = reference.*term.reference)
            term.measured.in(peaks) = *number;
    const std::string law = reference.numeric ? "numbers" : reference.law;
    for (const CostTerm& term : cost_terms())
        require_finite(term, term.weight_in(scene.objective), term.measured.of(peaks), law);
    return peaks;
}

double dimension_unit(const Scene& scene) {
    const CamSpec& cam = scene.cam.value();
    const auto formulas = cam.formulas();
    return formulas->swings() ? scene.motion.lift * formulas->length(cam.middle()) : scene.motion.lift;
}

double dimension_weight(const Scene& scene, const std::string& name) {
    for (int d = 0; d < dimension_count; ++d) {
        const double weight = scene.objective.dimensions[static_cast<std::size_t>(d)];
        // The unit requires the complete cam: computed only on demand.
        if (weight > 0.0 && name == name_of(static_cast<DimensionIndex>(d)))
            return weight / dimension_unit(scene);
    }
    return 0.0;
}

CamModel scene_model(const Scene& scene, DesignKind kind, const Peaks& reference, const HeldStrokes& strokes,
                     const CostUnits& units) {
    CamModel model(scene_family(scene, kind, strokes.directions));
    if (scene.prescribes_output()) {
        model.to_cam = cam_of_output(scene);
        model.cam_motion = model.design.cam_motions(model.to_cam);
        if (scene.drive) model.torque_motion = model.design.cam_motions(torque_of_output(scene));
    }
    add_program_scales(model, scene);
    add_known_points(model, scene);
    add_peaks(model, scene, reference, units);
    add_motion_bounds(model, scene);
    add_stroke_rules(model, scene, strokes);
    set_entry_factors(model, scene);
    add_seeing(SeenMotion::cam, model, scene, add_cam);
    add_own_rules(model, scene);
    add_seeing(SeenMotion::cam, model, scene, add_response_rules);
    add_seeing(SeenMotion::torque, model, scene, add_drive_rules);
    add_seeing(SeenMotion::cam, model, scene, add_spring_rules);
    add_deviation_terms(model, scene);
    model.cost_constant /= units.cost;
    for (Parameter& parameter : model.parameters) parameter.weight /= units.cost;
    return model;
}

CamModel convex_part(const CamModel& model, ConvexOver range) {
    CamModel part = model;
    std::erase_if(part.rules, [&](const PlacedRule& rule) {
        const auto [least, most] = range == ConvexOver::sensible_motion ? model.expected_range(rule)
                                                                        : std::array{-infinity, infinity};
        return rule->curvature(least, most) == Curvature::general;
    });
    return part;
}

}  // namespace camopt
