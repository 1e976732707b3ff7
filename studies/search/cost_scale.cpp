// SPDX-License-Identifier: MIT
#include "studies/search/cost_scale.hpp"

#include "scene/cost_table.hpp"
#include "solvers/certificate/box_proof.hpp"
#include "studies/delivered/solution_report.hpp"

namespace camopt {

namespace {

// References this far from those of good motions, and objectives this far from one, are scaled.
constexpr int idle_reference_exponent = 7;
constexpr double least_idle_cost = 0.25, most_idle_cost = 64.0;
// Scaled costs lie below 1 where they were small (the gap is then no looser) and above it where they were
// large.
constexpr double large_cost = 8.0;

double power_of_two(double exponent) {
    return std::ldexp(1.0, static_cast<int>(exponent));
}

/// V, A and J of a stroke of length 1, and what remains of it beside its cruise.
struct StrokePeaks {
    double velocity = 2.0, acceleration = 8.0, jerk = 32.0, ramps = 0.5;
};

/// From rest to rest: its length in x and displacement in lifts, the units of its caps.
struct RestStroke {
    double length = 1.0, displacement = 1.0;
    bool of_program = false;  ///< then peaks, and caps that are not in time, are normalised by the stroke

    [[nodiscard]] double cap(const std::optional<PeakLimit>& limit, int order) const {
        if (!limit) return infinity;
        if (of_program && !limit->physical()) return limit->normalised;
        return limit->normalised * std::pow(length, order) / displacement;
    }
};

/// Those between given displacements.
std::vector<RestStroke> rest_strokes(const MotionSpec& motion) {
    if (motion.start || motion.end) return {};
    if (motion.type == MotionType::drd) return {RestStroke{}};
    if (motion.type == MotionType::rr) return {RestStroke{std::min(1.0, motion.length() - 1.0)}};
    std::vector<RestStroke> strokes;
    const std::vector<ProgramSegment>& segments = motion.segments;
    const auto rests = [&](std::size_t index) { return segments[index].kind == SegmentKind::dwell; };
    std::optional<double> at = 0.0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (rests(i)) continue;
        const std::optional<double> to = segments[i].to;
        const bool from_rest = i > 0 ? rests(i - 1) : !motion.periodic() || rests(segments.size() - 1);
        const bool to_rest = i + 1 < segments.size() ? rests(i + 1) : !motion.periodic() || rests(0);
        if (from_rest && to_rest && at && to && *at != *to)
            strokes.push_back({segments[i].angle / motion.unit_angle(), std::abs(*to - *at), true});
        at = to;
    }
    return strokes;
}

/// The least jerk within the caps, and its peaks, to a factor of a few: at the velocity V a cruise leaves
/// 1 − 1/V to the ramps, V/A + A/J = 1 − 1/V, and A = 2V / (1 − 1/V) takes the least J. Without caps, or
/// where they contradict, V = 2.
StrokePeaks forced_peaks(const LimitSpec& limits, const RestStroke& stroke) {
    constexpr double least_ramps = 1e-9;  // shorter ones are rounding of a contradiction
    const double most_acceleration = stroke.cap(limits.acceleration, 2);
    StrokePeaks forced;
    forced.velocity =
        std::min({forced.velocity, stroke.cap(limits.velocity, 1), std::sqrt(most_acceleration)});
    forced.ramps = 1.0 - 1.0 / forced.velocity;
    forced.acceleration = std::min(2.0 * forced.velocity / forced.ramps, most_acceleration);
    const double turning = forced.ramps - forced.velocity / forced.acceleration;
    if (!(forced.ramps > least_ramps && turning > least_ramps * forced.ramps)) return {};
    forced.jerk = std::min(forced.acceleration / turning, stroke.cap(limits.jerk, 3));
    return forced;
}

/// The figures of a good motion, to a factor of ten, by CostFigure: typical ones, or those that caps force on
/// a stroke.
std::vector<double> expected_figures(const Scene& scene) {
    constexpr double far = 16.0;  // times the typical figure
    std::vector<double> figures;
    for (const CostTerm& term : cost_terms()) figures.push_back(term.typical);
    for (const RestStroke& stroke : rest_strokes(scene.motion)) {
        const StrokePeaks forced = forced_peaks(scene.limits, stroke);
        for (std::size_t i = 0; i < figures.size(); ++i) {
            const CostTerm& term = cost_terms()[i];
            const bool torque = term.kind == CostTerm::Kind::torque;
            const int order = torque ? 3 : term.measured.order;
            double own = order == 1 ? forced.velocity : order == 2 ? forced.acceleration : forced.jerk;
            if (torque) own = forced.velocity * forced.acceleration;
            if (term.kind == CostTerm::Kind::rms) own *= std::sqrt(forced.ramps);
            if (own <= far * term.typical) continue;
            figures[i] = std::max(figures[i], stroke.of_program ? own : own / std::pow(stroke.length, order));
        }
    }
    return figures;
}

/// The objective of a motion with these figures.
double expected_cost(const Scene& scene, const std::vector<double>& figures, const Peaks& reference) {
    double cost = 0.0;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const CostTerm& term = cost_terms()[i];
        const double weight = term.weight_in(scene.objective);
        if (weight > 0.0)
            cost += weight * figures[i] /
                    (scene.objective.reference.*term.reference).value_or(term.measured.of(reference));
    }
    for (const ResponseTerm& term : response_terms()) cost += term.weight_in(scene.objective);
    for (const double weight : scene.objective.dimensions) cost += weight;
    for (const OwnTerm& term : scene.own_terms) cost += term.weight;
    return cost;
}

bool is_near_one(double cost) {
    return cost == 0.0 || (cost >= least_idle_cost && cost <= most_idle_cost);  // 0: nothing is weighed
}

void scale_proof(DualityProof& proof, double factor) {
    if (proof.statement != "objective") return;
    proof.cost *= factor;
    proof.constant *= factor;
    proof.multipliers *= factor;
    proof.bound *= factor;
}

/// Cases that share a proof share it still.
void scale_cases(std::vector<CaseProof>& cases, double factor) {
    std::map<const DualityProof*, std::shared_ptr<const DualityProof>> scaled;
    for (CaseProof& part : cases) {
        part.bound *= factor;
        if (!part.proof) continue;
        std::shared_ptr<const DualityProof>& known = scaled[part.proof.get()];
        if (!known) {
            auto proof = std::make_shared<DualityProof>(*part.proof);
            scale_proof(*proof, factor);
            known = std::move(proof);
        }
        part.proof = known;
    }
}

/// Of the parts' multipliers those of the row on the cost keep their value: it is scaled as the cost is.
std::shared_ptr<const BoxProof> scaled_box_proof(const BoxProof& given, double factor) {
    auto proof = std::make_shared<BoxProof>(given);
    proof->cost *= factor;
    proof->constant *= factor;
    proof->bound *= factor;
    const auto is_cost = [&](int step) {
        return given.steps[static_cast<std::size_t>(step)].kind == BoxStep::Kind::cost;
    };
    for (BoxStep& step : proof->steps) {
        if (step.kind == BoxStep::Kind::cost) {
            step.weights *= factor;
            step.side *= factor;
        }
        for (auto& [index, multiplier] : step.multipliers)
            if (is_cost(index)) multiplier /= factor;
    }
    for (BoxPart& part : proof->parts) {
        if (!part.infeasible) part.bound *= factor;
        for (auto& [index, multiplier] : part.multipliers) {
            if (is_cost(index)) multiplier /= factor;
            if (!part.infeasible) multiplier *= factor;
        }
    }
    return proof;
}

}  // namespace

CostScale::CostScale(const Scene& scene, const Peaks& reference) : scaled_(scene) {
    const std::vector<double> figures = expected_figures(scene);
    scale_references(figures, reference);
    scale_weights(figures, reference);
}

/// Numbers far from the figures, and laws where these are far from those of any law.
void CostScale::scale_references(const std::vector<double>& figures, const Peaks& reference) {
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const CostTerm& term = cost_terms()[i];
        std::optional<double>& number = scaled_.objective.reference.*term.reference;
        const bool by_law = !number && (term.limit != nullptr || term.weight_in(scaled_.objective) > 0.0);
        if (!number && !by_law) continue;
        const double of_law = term.measured.of(reference);
        const double known = number.value_or(std::isfinite(of_law) && of_law > 0.0 ? of_law : term.typical);
        const double exponent = std::round(std::log2(known / figures[i]));
        if (std::abs(exponent) <= idle_reference_exponent) continue;
        number = known / power_of_two(exponent);
        scaled_.objective.*term.weight /= power_of_two(exponent);
        idle_ = false;
    }
}

bool CostScale::are_near_one(const Scene& scene, const Peaks& reference) {
    return is_near_one(expected_cost(scene, expected_figures(scene), reference));
}

void CostScale::scale_weights(const std::vector<double>& figures, const Peaks& reference) {
    const double cost = expected_cost(scaled_, figures, reference);
    if (is_near_one(cost)) return;
    idle_ = false;
    factor_ =
        power_of_two(cost < 1.0 ? std::ceil(std::log2(cost)) : std::floor(std::log2(cost / large_cost)));
    for (const CostTerm& term : cost_terms()) scaled_.objective.*term.weight /= factor_;
    for (const ResponseTerm& term : response_terms()) scaled_.objective.*term.weight /= factor_;
    for (double& weight : scaled_.objective.dimensions) weight /= factor_;
    for (OwnTerm& term : scaled_.own_terms) term.weight /= factor_;
}

void CostScale::restore(Solution& solution, const Scene& scene, const Peaks& reference) const {
    set_scene(solution, scene);
    solution.reference_peaks = reference;
    for (std::size_t i = 0; i < solution.own_terms.size(); ++i) {
        OwnTermReport& term = solution.own_terms[i];
        const auto row =
            std::ranges::find(response_terms(), std::string_view(term.name),
                              [](const ResponseTerm& one) { return std::string_view(one.name); });
        term.weight = term.of_scene ? row->weight_in(scene.objective) : scene.own_terms[i].weight;
    }
    if (solution.train)
        for (ResponseTermReport& term : solution.train->terms) term.weight *= factor_;
    if (solution.any_curve_limit) solution.any_curve_limit->objective *= factor_;
    Certificate& certificate = solution.certificate;
    certificate.objective *= factor_;
    if (certificate.stationarity) *certificate.stationarity *= factor_;
    scale_cases(certificate.cases, factor_);
    if (certificate.box_proof) certificate.box_proof = scaled_box_proof(*certificate.box_proof, factor_);
    if (!certificate.lower_bound) return;
    *certificate.lower_bound *= factor_;
    if (certificate.gap)
        certificate.gap =
            std::max(*certificate.gap, relative_gap(certificate.objective, *certificate.lower_bound));
    if (certificate.proof) scale_proof(*certificate.proof, factor_);
}

}  // namespace camopt
