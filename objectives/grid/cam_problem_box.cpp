// SPDX-License-Identifier: MIT
// Bounds valid for every motion at least as good as the incumbent, for proofs.
#include "objectives/grid/cam_problem.hpp"
#include "objectives/rules/linear_bound.hpp"

namespace camopt {

namespace {

// Proofs may relax the limits by the tolerance of the solve: bounds on motions assume limits relaxed by this,
// more than any tolerance in use.
constexpr double relaxed_limits = 1e-6;
// Steps for bounding the range of displacements.
constexpr int range_samples = 200;

/// y^{(r)} of the family over the normalised one: the largest and the smallest over the stretches.
double largest_stretch_factor(const CamModel& model, int order) {
    double largest = model.stretch_scales.empty() ? 1.0 : 0.0;
    for (const StretchScale& scale : model.stretch_scales) {
        largest = std::max(largest, scale.displacement / std::pow(scale.angle, order));
    }
    return largest;
}
double smallest_stretch_factor(const CamModel& model, int order) {
    double smallest = model.stretch_scales.empty() ? 1.0 : infinity;
    for (const StretchScale& scale : model.stretch_scales) {
        smallest = std::min(smallest, scale.displacement / std::pow(scale.angle, order));
    }
    return smallest;
}

/// Of a parameter of motions with |y| <= farthest. Only a lost area, 1 − the mean of y, has no end of its
/// own.
double least_value(const Parameter& parameter, double farthest) {
    if (parameter.kind == Parameter::Kind::dimension) return parameter.lower;
    return std::min(0.0, std::max(parameter.lower, (1.0 - farthest) / parameter.reference));
}

/// What −y^{(order)} and y^{(order)} can be on the splines by limits on them; infinite where one has none.
std::array<double, 2> limited_sides(const CamModel& model, int order, double relaxation) {
    const auto value = [](const PointRule& rule, int moved) {
        MotionPoint point;
        if (moved > 0) point.derivative[static_cast<std::size_t>(moved)] = 1.0;
        return rule.evaluate(point, {}).value;
    };
    std::array<double, 2> sides = {-infinity, -infinity};
    const auto& stretches = model.design.own_stretches();
    for (int s = 0; s < static_cast<int>(stretches.size()); ++s) {
        if (stretches[s].kind != StretchRequest::Kind::spline) continue;
        double least = -infinity, most = infinity;
        for (const PlacedRule& rule : model.rules) {
            const bool whole = (rule.stretch < 0 || rule.stretch == s) && rule.from <= stretches[s].begin &&
                               rule.until >= stretches[s].end;
            if (!whole || model.sees_other(rule) || !rule->limit() || !rule->linear() ||
                !rule->parameters().empty() || rule->highest_order() != order ||
                dynamic_cast<const LinearRule*>(rule.rule.get()) == nullptr)
                continue;
            const double rest = value(*rule, 0), slope = value(*rule, order) - rest;
            const bool alone = value(*rule, order == 2 ? 1 : 2) == rest;  // no sum of derivatives
            if (!alone || slope == 0.0) continue;
            double& side = slope > 0.0 ? most : least;
            const double bound = (relaxation - rest) / slope;
            side = slope > 0.0 ? std::min(side, bound) : std::max(side, bound);
        }
        sides = {std::max(sides[0], -least), std::max(sides[1], most)};
    }
    if (sides[1] == -infinity) sides.fill(infinity);  // only laws and dwells
    return sides;
}

/// What the terms cost at least.
double least_cost_of(const CamModel& model, double farthest) {
    double least = 0.0;
    for (const Parameter& parameter : model.parameters)
        if (parameter.weight > 0.0)
            least += std::min(0.0, parameter.weight * least_value(parameter, farthest));
    return least;
}

/// |y| between two known displacements D apart, at rest at one of them: y'' = ±2 Δ/D² somewhere between, so
/// |y''| <= 2 |Δ|/D² + D B_3, and y leaves the resting end by at most D²/2 of that.
double reach_of(const std::vector<KnownPoint>& points, const std::array<double, 4>& sup) {
    const auto rests = [&](double x) {
        return std::ranges::any_of(points, [&](const KnownPoint& one) { return one.x == x && one.at_rest; });
    };
    double reach = points.size() < 2 ? infinity : 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const KnownPoint &from = points[i], &to = points[i + 1];
        const double apart = to.x - from.x;
        if (!(apart > 0.0)) continue;
        if (!rests(from.x) && !rests(to.x)) return infinity;
        const double bend =
            std::min(sup[2], 2.0 * std::abs(to.y - from.y) / (apart * apart) + apart * sup[3]);
        reach = std::max(reach, std::max(std::abs(from.y), std::abs(to.y)) + 0.5 * apart * apart * bend);
    }
    return reach;
}

/// Bounds of y' and y'' from those of y and of higher derivatives. Divided differences
/// of y over a spline stretch of length l are y' and y''/2 at some points of it, so that
/// |y'| <= 2 B_0 / l + l B_2 and |y''| <= 16 B_0 / l² + l B_3.
void bound_lower_derivatives(const MotionFamily& family, std::array<double, 4>& sup) {
    double slope = 0.0, bend = 0.0;  // the largest over the splines
    for (const MotionFamily::Stretch& stretch : family.stretches()) {
        if (stretch.kind != StretchRequest::Kind::spline) continue;
        const double length = stretch.end - stretch.begin;
        const double own = std::min(sup[2], 16.0 * sup[0] / (length * length) + length * sup[3]);
        bend = std::max(bend, own);
        slope = std::max(slope, 2.0 * sup[0] / length + length * own);
    }
    if (!(slope > 0.0)) return;  // only laws and dwells
    sup[2] = std::min(sup[2], bend);
    sup[1] = std::min(sup[1], slope);
}

}  // namespace

/// The motions that bounds are for: of at most this cost (infinity: of any), within the limits relaxed by
/// `relaxation`. Without an incumbent, where it is not said that they hold, limits need not be satisfied.
struct CamProblem::Considered {
    double incumbent = infinity, relaxation = relaxed_limits;
    bool within_limits = std::isfinite(incumbent);

    [[nodiscard]] double slack() const { return std::max(relaxed_limits, relaxation); }
};

/// Bounds for these: on parameters, and through them on derivatives.
struct CamProblem::SupportedBounds {
    Eigen::VectorXd parameters;      ///< upper bounds, in units of their references
    std::array<double, 4> sup, rms;  ///< of |y^{(r)}| and of its root mean square, anywhere
    /// How fast y … y'' can rise, or how fast they can fall, by limits on the next derivative to one side.
    std::array<double, 3> one_sided;
};

/// From rest, τ = K_a y'' + K_v y' + K_0 ± K_f is a stable equation for y': over the length L of the motion
///   K_a |y'| <= ∫ |τ − K_0 ∓ K_f| dx <= sqrt(L) ||τ|| + L (|K_0| + K_f),
///   K_a ||y''|| <= ||τ|| + K_v ||y'|| + sqrt(L) (|K_0| + K_f),
/// with ||τ||² <= C · rms² over the cycle C, and the same of largest values with |τ| in place of ||τ||.
void CamProblem::bound_by_motor(const CamModel& model, SupportedBounds& known, double relaxation) {
    const MotorBounds& motor = *model.motor;
    const double most = 1.0 + 2.0 * relaxation, mass = motor.torque.acceleration;
    known.sup[1] = std::min(known.sup[1], most * motor.speed / motor.torque.speed);
    if (!motor.from_rest || !(mass > 0.0)) return;
    const auto bounded = [&](double limit, int parameter) {
        if (parameter < 0) return most * limit;
        const Parameter& own = model.parameters[parameter];
        return std::min(most * limit, known.parameters[parameter] * own.reference);
    };
    const double length = model.design.end() - model.design.begin(), root = std::sqrt(length);
    const double constant = std::abs(motor.torque.constant) + motor.torque.friction;
    const double norm = std::sqrt(motor.cycle) * bounded(motor.rms, motor.rms_parameter);
    const double peak = bounded(motor.peak, motor.peak_parameter);
    known.sup[1] =
        std::min({known.sup[1], (root * norm + length * constant) / mass, length * (peak + constant) / mass});
    known.sup[2] = std::min(known.sup[2], (peak + motor.torque.velocity * known.sup[1] + constant) / mass);
    double shortest = length;  // a mean over one run is at most that much larger
    for (int r = 0; r < model.design.runs(); ++r)
        shortest = std::min(shortest, model.design.run_space(r).end() - model.design.run_space(r).begin());
    const double bend = (norm + root * (motor.torque.velocity * known.sup[1] + constant)) / mass;
    known.rms[2] = std::min(known.rms[2], bend / std::sqrt(shortest));
}

/// |y| of every motion that counts.
double CamProblem::farthest(const Considered& motions) const {
    const CamModel& model = *model_;
    const double far =
        farthest_displacement * std::max(1.0, model.most_displacement - model.least_displacement);
    // Proofs over boxes state boxes of their own.
    if (!motions.within_limits || !grid_->shape().convex) return far;
    return std::min(far, model.held_displacement + motions.slack() * model.held_width);
}

double CamProblem::least_cost(double incumbent) const {
    return least_cost_of(*model_, supported_bounds({incumbent}).sup[0]);
}

/// Less area is lost the higher y can be, and the less area is lost, the larger the peaks that bound y may
/// be: from a bound that is too far, passes close in.
CamProblem::SupportedBounds CamProblem::supported_bounds(const Considered& motions) const {
    constexpr int passes = 6;
    constexpr double gain = 0.9;
    SupportedBounds known = bounds_within(farthest(motions), motions);
    const bool counts = std::isfinite(motions.incumbent) && grid_->shape().convex;
    for (int pass = 0; pass < passes && counts && least_cost_of(*model_, known.sup[0]) < 0.0; ++pass) {
        const double reach = reach_of(model_->known_points, known.sup);
        if (!(reach < gain * known.sup[0])) break;
        known = bounds_within(reach, motions);
    }
    return known;
}

/// Of motions with |y| <= farthest.
CamProblem::SupportedBounds CamProblem::bounds_within(double farthest, const Considered& motions) const {
    const CamModel& model = *model_;
    const double relaxation = motions.relaxation;
    const auto parameters = static_cast<Eigen::Index>(model.parameters.size());
    SupportedBounds known{Eigen::VectorXd::Constant(parameters, infinity), {}, {}, {}};
    known.sup.fill(infinity);
    known.rms.fill(infinity);
    known.one_sided.fill(infinity);
    known.sup[0] = farthest;
    // A term costs at most what the incumbent leaves it where every other one is at its least.
    const double least = least_cost_of(model, farthest);
    for (Eigen::Index p = 0; p < parameters; ++p) {
        const Parameter& parameter = model.parameters[p];
        known.parameters[p] = parameter.upper;
        if (!(parameter.weight > 0.0)) continue;
        const double own = std::min(0.0, parameter.weight * least_value(parameter, known.sup[0]));
        known.parameters[p] =
            std::min(known.parameters[p], (motions.incumbent - least + own) / parameter.weight);
    }
    for (const ParameterRow& row : model.parameter_rows) {
        if (std::ranges::any_of(row.weights, [](double weight) { return weight < 0.0; })) continue;
        for (std::size_t k = 0; k < row.parameters.size(); ++k) {
            if (row.weights[k] <= 0.0) continue;
            const double slack = row.limit ? relaxation * row.scale : 0.0;
            double& bound = known.parameters[row.parameters[k]];
            bound = std::min(bound, (row.upper + slack) / row.weights[k]);
        }
    }
    for (Eigen::Index p = 0; p < parameters; ++p) {
        const Parameter& parameter = model.parameters[p];
        const bool peak = parameter.kind == Parameter::Kind::peak;
        if (!peak && parameter.kind != Parameter::Kind::rms) continue;
        double& bound = (peak ? known.sup : known.rms)[parameter.order];
        const double normalised = known.parameters[p] * parameter.reference;
        bound = std::min(bound, normalised * largest_stretch_factor(model, parameter.order));
    }
    for (int order = 1; order < 4 && motions.within_limits; ++order) {
        const auto [falls, rises] = limited_sides(model, order, motions.slack());
        known.sup[order] = std::min(known.sup[order], std::max(std::abs(falls), std::abs(rises)));
        known.one_sided[order - 1] = std::max(0.0, std::min(falls, rises));
    }
    if (model.motor) bound_by_motor(model, known, relaxation);
    bound_lower_derivatives(model.design, known.sup);
    return known;
}

Box CamProblem::box(double incumbent, double relaxation) const {
    const CamModel& model = *model_;
    const MotionFamily& family = model.design;
    const SupportedBounds known = supported_bounds({incumbent, relaxation, true});
    Box box;
    box.upper = Eigen::VectorXd::Constant(grid_->shape().variables(), infinity);
    // Displacements at joints are bounded by the velocity and the known start.
    const double reach = std::min(known.sup[0], known.sup[1] * (family.end() - family.begin()));
    const std::array<double, 3> joint_bound = {reach, known.sup[1], known.sup[2]};
    std::array<double, 4> own{};  // bounds on |y^{(r)}| over all runs
    for (int r = 0; r < family.runs(); ++r) {
        const DesignVector& run = family.run(r);
        KnownBounds bounds{known.sup, known.rms, run.begin_state(), run.end_state()};
        if (family.first_joint_entry() < family.size()) {
            bounds.rms.fill(infinity);
            bounds.begin_state = bounds.end_state = joint_bound;
        }
        // From the state at the beginning and to that at the end.
        const double length = run.space().end() - run.space().begin();
        for (int order = 0; order < 3; ++order) {
            const double ends =
                std::max(std::abs(bounds.begin_state[order]), std::abs(bounds.end_state[order]));
            bounds.sup[order] = std::min(bounds.sup[order], ends + known.one_sided[order] * length);
        }
        const Eigen::MatrixXd derivatives = derivative_bounds(run.space(), bounds);
        box.upper.segment(family.first_entry(r), run.size()) = run.entry_bounds(derivatives);
        for (int order = 0; order < 4; ++order) {
            own[order] = std::max(own[order], derivatives.row(order).maxCoeff());
        }
    }
    // A joint is an end of a run: where no limit bounds a derivative there, its spline does.
    for (int entry = family.first_joint_entry(); entry < family.size(); ++entry) {
        const int order = family.order(entry);
        box.upper[entry] = std::min(joint_bound[order], own[order]);
    }
    box.upper.head(family.size()) = box.upper.head(family.size()).cwiseQuotient(design_scales(model));
    box.lower = -box.upper;
    for (std::size_t p = 0; p < model.parameters.size(); ++p) {
        const Parameter& parameter = model.parameters[p];
        const Eigen::Index variable = family.size() + static_cast<Eigen::Index>(p);
        box.upper[variable] = known.parameters[static_cast<Eigen::Index>(p)];
        box.lower[variable] = least_value(parameter, known.sup[0]);
        if (parameter.kind == Parameter::Kind::magnitude) {
            const Parameter& of = model.parameters[parameter.order];
            box.upper[variable] =
                std::min(box.upper[variable], std::max(std::abs(of.lower), std::abs(of.upper)));
        }
        if (parameter.kind != Parameter::Kind::peak && parameter.kind != Parameter::Kind::rms) continue;
        // A peak without another bound may be taken as the curve's own.
        const double largest = own[parameter.order] / smallest_stretch_factor(model, parameter.order);
        box.upper[variable] = std::min(box.upper[variable], largest / parameter.reference);
    }
    return box;
}

/// From the nearest known points on either side, with the bounds on velocity and, from rest, on acceleration:
/// how far y can move.
std::array<double, 2> CamProblem::displacement_range(double incumbent) const {
    const std::vector<KnownPoint>& points = model_->known_points;
    if (points.size() < 2) return {-infinity, infinity};
    const SupportedBounds known = supported_bounds({incumbent});
    SlopeRange slope{-known.sup[1], known.sup[1]};
    for (const PlacedRule& rule : model_->rules) {
        // Without an incumbent the limits need not be satisfied.
        if (!std::isfinite(incumbent) || !rule.holds_everywhere() || model_->sees_other(rule)) continue;
        const SlopeRange own = rule->slope_range();
        slope.least = std::max(slope.least, own.least - relaxed_limits * std::abs(own.least));
        slope.most = std::min(slope.most, own.most + relaxed_limits * std::abs(own.most));
    }
    /// How far y can move away with a slope of at most `steepest`.
    const auto reach = [&](const KnownPoint& from, double distance, double steepest) {
        const double by_velocity = std::max(0.0, steepest) * distance;
        return from.at_rest ? std::min(by_velocity, 0.5 * known.sup[2] * distance * distance) : by_velocity;
    };
    std::array<double, 2> range = {infinity, -infinity};
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const KnownPoint& from = points[i];
        const KnownPoint& to = points[i + 1];
        for (int k = 0; k < range_samples; ++k) {
            // Over each small step both reaches are largest at its far ends.
            const double step = (to.x - from.x) / range_samples;
            const double near = step * (k + 1), far = step * (range_samples - k);
            const double floor =
                std::max(from.y - reach(from, near, -slope.least), to.y - reach(to, far, slope.most));
            const double ceiling =
                std::min(from.y + reach(from, near, slope.most), to.y + reach(to, far, -slope.least));
            range[0] = std::min(range[0], floor);
            range[1] = std::max(range[1], ceiling);
        }
    }
    return range;
}

bool CamProblem::convex(double incumbent) const {
    if (!grid_->shape().convex) return false;
    if (std::ranges::all_of(model_->rules, [](const PlacedRule& rule) { return rule->linear(); }))
        return true;
    const std::array<double, 2> range = displacement_range(incumbent);
    const SupportedBounds known = supported_bounds({incumbent});
    return std::ranges::all_of(model_->rules, [&](const PlacedRule& rule) {
        const auto [least, most] = model_->seen_range(rule, range, {known.sup[1], known.sup[2]});
        return rule->curvature(least, most) != Curvature::general;
    });
}

}  // namespace camopt
