// SPDX-License-Identifier: MIT
#include "objectives/drive_rules.hpp"

#include "core/numbers/polynomial.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "objectives/rules/energy_rule.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"
#include "objectives/scene_family.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

using Kind = StretchRequest::Kind;

constexpr int parts_of_shape = 16;  // of a smooth piece of a law: sines squared are then exact to round-off
constexpr double same_joint = 1e-9;

int direction_of(const MotionFamily::Stretch& stretch) {
    if (stretch.kind == Kind::dwell) return 0;
    const double from = known_displacement(stretch.from).value_or(0.0);
    const double to = known_displacement(stretch.to).value_or(from);
    return to > from ? 1 : to < from ? -1 : 0;
}

/// One without bounds where there is no friction.
std::vector<DriveSpan> spans_of(const Scene& scene, const MotionFamily& family) {
    const DriveTorque torque = drive_torque(*scene.drive, scene.motion);
    if (torque.friction == 0.0) return {{-infinity, infinity, torque.constant}};
    const auto span = [&](double begin, double end, int direction) {
        return DriveSpan{begin, end, torque.constant + direction * torque.friction};
    };
    if (scene.motion.type != MotionType::program) {
        std::vector<DriveSpan> all = {span(0.0, 1.0, 1)};
        if (scene.motion.type == MotionType::rr) all.push_back(span(1.0, scene.motion.length(), -1));
        return all;
    }
    std::vector<DriveSpan> all;
    for (const MotionFamily::Stretch& stretch : family.stretches())
        all.push_back(span(stretch.begin, stretch.end, direction_of(stretch)));
    return all;
}

/// x that the root mean square is taken over.
double cycle_of(const Scene& scene, const MotionFamily& family) {
    return scene.motion.periodic() ? family.end() - family.begin()
                                   : scene.drive->cycle.value_or(units::turn) / scene.motion.unit_angle();
}

/// Weights of y', y'' and 1.
std::array<double, 3> torque_weights(const DriveTorque& torque, const DriveSpan& span, double factor) {
    return {factor * torque.velocity, factor * torque.acceleration, factor * span.constant};
}

/// Whether the quadrature is exact for a squared velocity on the piece.
bool is_exact(const MotionFamily& family, const MotionFamily::Piece& piece) {
    constexpr int most_of_quadrature = 9;
    if (piece.segment < 0) return false;
    const int run = family.stretches()[static_cast<std::size_t>(piece.stretch)].run;
    return 2 * (family.run_space(run).degree() - 1) <= most_of_quadrature;
}

/// Calls visit(begin, end) for the parts of [begin, end] between the ends of spans.
template <class Visit>
void visit_parts(const std::vector<DriveSpan>& spans, double begin, double end, Visit&& visit) {
    for (const DriveSpan& span : spans) {
        const double first = std::max(begin, span.begin), last = std::min(end, span.end);
        if (last - first > same_joint * (end - begin)) visit(first, last, span);
    }
}

/// The largest |τ| / reference − q, as one rule of the whole motion. setting: the sign, the span.
WholeMotionRule motor_peak_rule(const Scene& scene, const MotionFamily& family, int parameter,
                                double reference) {
    struct OneSide {
        LinearBound bound;
        std::vector<double> setting;
    };
    const DriveTorque torque = drive_torque(*scene.drive, scene.motion);
    const std::vector<DriveSpan> spans = spans_of(scene, family);
    std::vector<OneSide> sides;
    for (std::size_t s = 0; s < spans.size(); ++s)
        for (const double sign : {1.0, -1.0}) {
            LinearBound bound{"motor_torque", 2};
            bound.weights = torque_weights(torque, spans[s], sign / reference);
            bound.from = spans[s].begin;
            bound.until = spans[s].end;
            sides.push_back({std::move(bound), {sign, static_cast<double>(s)}});
        }
    WholeMotionRule::Parts parts;
    parts.first.clear();
    for (const MotionFamily::Piece& piece : family.pieces()) {
        if (piece.copy) continue;
        for (const auto& [bound, setting] : sides) {
            const double begin = std::max(piece.begin, bound.from), end = std::min(piece.end, bound.until);
            if (!(end - begin > same_joint * (piece.end - piece.begin))) continue;
            parts.first.push_back({{0.0, begin, Side::right}, setting});
            parts.first.push_back({{0.0, 0.5 * (begin + end), Side::right}, setting});
            parts.first.push_back({{0.0, end, Side::left}, setting});
        }
    }
    parts.maxima = [sides](const Motion& motion, double q) {
        std::vector<WholeMotionRule::Place> all;
        for (const auto& [bound, setting] : sides) {
            const std::vector<Extremum> maxima = rule_maxima(LinearRule(bound), motion, {});
            const Extremum worst = largest_of(maxima);
            for (const Extremum& one : maxima)
                if (one.value > q && one.at != worst.at) all.push_back({one, setting});
            all.push_back({worst, setting});
        }
        return all;
    };
    parts.row = [sides](const MotionFamily& of, double at, Side side, WholeMotionRule::Setting setting) {
        const std::size_t index = 2 * static_cast<std::size_t>(setting[1]) + (setting[0] < 0.0 ? 1 : 0);
        const auto [velocity, acceleration, constant] = sides[index].bound.weights;
        const AffineRow sum = combined({constant, {}, {}}, velocity, of.functional(at, 1, side));
        return combined(sum, acceleration, of.functional(at, 2, side));
    };
    parts.remark = [](WholeMotionRule::Setting setting) {
        return setting[0] > 0.0 ? "torque +" : "torque -";
    };
    parts.which = [](WholeMotionRule::Setting setting) {
        return std::map<std::string, double>{{"torque", setting[0]}};
    };
    return {{"motor_torque", 2, false, true, {parameter}}, std::move(parts)};
}

/// Of the torque over the cycle.
class MotorEnergy {
 public:
    MotorEnergy(const Scene& scene, const MotionFamily& family)
        : torque_(drive_torque(*scene.drive, scene.motion)),
          spans_(spans_of(scene, family)),
          cycle_(cycle_of(scene, family)) {}

    [[nodiscard]] QuadraticForm form(const MotionFamily& family, double level) const {
        EnergySum sum(family.size());
        double length = 0.0, whole = 0.0;
        for (const MotionFamily::Piece& piece : family.pieces()) {
            whole += piece.end - piece.begin;
            if (piece.copy) continue;
            length += piece.end - piece.begin;
            visit_parts(spans_, piece.begin, piece.end, [&](double begin, double end, const DriveSpan& span) {
                const std::array<double, 3> weights = torque_weights(torque_, span, 1.0 / level);
                visit_quadrature(begin, end, is_exact(family, piece) ? 1 : parts_of_shape,
                                 [&](double x, double weight) {
                                     AffineRow row{weights[2], {}, {}};
                                     row = combined(row, weights[0], family.functional(x, 1));
                                     sum.add(combined(row, weights[1], family.functional(x, 2)), weight);
                                 });
            });
        }
        const double cycle = cycle_ * length / whole;  // copies are the same
        const double rest = torque_.constant / level;
        if (cycle > length) sum.add(AffineRow{rest, {}, {}}, cycle - length);
        return sum.form(1.0 / cycle);
    }

    [[nodiscard]] double rms(const Motion& motion) const {
        const std::vector<double> breakpoints = motion.breakpoints();
        double sum = 0.0;
        for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i)
            visit_parts(spans_, breakpoints[i], breakpoints[i + 1],
                        [&](double begin, double end, const DriveSpan& span) {
                            visit_quadrature(begin, end, parts_of_shape, [&](double x, double weight) {
                                const auto& y = motion.at(x).derivative;
                                const double torque =
                                    torque_.acceleration * y[2] + torque_.velocity * y[1] + span.constant;
                                sum += weight * torque * torque;
                            });
                        });
        const double rest = std::max(0.0, cycle_ - (motion.end() - motion.begin()));
        return std::sqrt((sum + rest * torque_.constant * torque_.constant) / cycle_);
    }

 private:
    DriveTorque torque_;
    std::vector<DriveSpan> spans_;
    double cycle_;
};

std::shared_ptr<const WholeMotionRule> motor_energy_rule(std::string name, const Scene& scene,
                                                         const MotionFamily& family, double level, int term) {
    const auto energy = std::make_shared<const MotorEnergy>(scene, family);
    return energy_rule(std::move(name),
                       {[energy](const Motion& motion) { return energy->rms(motion); },
                        [energy](const MotionFamily& own, double of) { return energy->form(own, of); }},
                       level, term);
}

/// |τ n|: a polynomial on a spline.
class PowerRule final : public PointRule {
 public:
    PowerRule(const DriveTorque& torque, const DriveSpan& span, int sign)
        : PointRule({"power", 2, false}), torque_(torque), constant_(span.constant), sign_(sign) {}
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd&) const override {
        const double v = point.derivative[1], a = point.derivative[2], n = sign_ * torque_.speed;
        RuleValue rule{n * v * (torque_.acceleration * a + torque_.velocity * v + constant_),
                       Eigen::VectorXd::Zero(4), Eigen::MatrixXd::Zero(4, 4)};
        rule.gradient[1] = n * (torque_.acceleration * a + 2.0 * torque_.velocity * v + constant_);
        rule.gradient[2] = n * v * torque_.acceleration;
        rule.hessian(1, 1) = 2.0 * n * torque_.velocity;
        rule.hessian(1, 2) = rule.hessian(2, 1) = n * torque_.acceleration;
        return rule;
    }
    [[nodiscard]] Eigen::VectorXd along(const std::array<Eigen::VectorXd, 4>& derivatives,
                                        const Eigen::VectorXd&) const override {
        Eigen::VectorXd torque = torque_.velocity * derivatives[1];
        const auto shorter = std::min(torque.size(), derivatives[2].size());
        torque.head(shorter) += torque_.acceleration * derivatives[2].head(shorter);
        if (torque.size() > 0) torque[0] += constant_;
        return sign_ * torque_.speed * product(torque, derivatives[1]);
    }

 private:
    DriveTorque torque_;
    double constant_;
    int sign_;
};

/// The reference law in the place of every spline, between the displacements that are known.
MotionChain law_chain(const Scene& scene, const MotionFamily& family) {
    const std::shared_ptr<const Motion> law = make_law(scene.objective.reference.law);
    const auto part = [&](double begin, double end, std::shared_ptr<const Motion> shape, double from,
                          double to) {
        return ChainPart{begin, end, std::move(shape), begin, end - begin, from, to - from};
    };
    std::vector<ChainPart> parts;
    if (scene.motion.type != MotionType::program) {
        parts.push_back(part(0.0, 1.0, law, 0.0, 1.0));
        if (scene.motion.type == MotionType::rr)
            parts.push_back(part(1.0, scene.motion.length(), law, 1.0, 0.0));
        return MotionChain(std::move(parts));
    }
    double level = 0.0;
    for (const MotionFamily::Stretch& stretch : family.stretches()) {
        const double from = known_displacement(stretch.from).value_or(level);
        level = known_displacement(stretch.to).value_or(from);
        parts.push_back(part(stretch.begin, stretch.end,
                             stretch.kind == Kind::spline  ? law
                             : stretch.kind == Kind::shape ? stretch.shape
                                                           : nullptr,
                             from, level));
        if (!parts.back().shape) parts.back().y_scale = 1.0;
    }
    return MotionChain(std::move(parts));
}

/// Without its weights; measured by itself.
WrittenBound written_bound(const LimitRow& row, const WrittenLimit& limit, int sign) {
    WrittenBound bound;
    bound.key = limit.key;
    bound.order = 2;
    bound.sign = sign;
    bound.bound = bound.scale = limit.value;
    bound.name = row.name;
    bound.unit = limit.unit;
    bound.given = limit.given();
    bound.per_normalised = 1.0 / limit.unit_value;
    bound.magnitude = row.side == nullptr;
    return bound;
}

void add_torque_bounds(std::vector<WrittenBound>& all, const Scene& scene,
                       const std::vector<DriveSpan>& spans) {
    const DriveTorque torque = drive_torque(*scene.drive, scene.motion);
    for (const LimitedFigure figure :
         {LimitedFigure::motor_torque, LimitedFigure::motor_torque_min, LimitedFigure::motor_torque_max}) {
        const LimitRow& row = limit_row(figure);
        const std::optional<WrittenLimit>& limit = row.in(scene.limits);
        if (!limit) continue;
        for (const DriveSpan& span : spans)
            for (const int sign : {1, -1}) {
                if (row.side != nullptr && (sign < 0) != row.is_least()) continue;
                WrittenBound bound = written_bound(row, *limit, sign);
                if (row.is_least()) bound.bound = -limit->value;
                bound.weights = torque_weights(torque, span, sign);
                bound.from = span.begin;
                bound.until = span.end;
                // A bound near 0 is measured by the torques of a good motion.
                if (row.side != nullptr)
                    bound.scale = torque.acceleration > 0.0 ? 6.0 * torque.acceleration
                                                            : std::max(std::abs(bound.bound), 1.0);
                all.push_back(std::move(bound));
            }
    }
}

void add_curve_bounds(std::vector<WrittenBound>& all, const Scene& scene,
                      const std::vector<DriveSpan>& spans) {
    const MotorCurve& curve = scene.limits.motor_curve;
    const DriveTorque torque = drive_torque(*scene.drive, scene.motion);
    const auto add = [&](const DriveSpan& span, std::array<double, 3> weights, std::string remark,
                         std::map<std::string, double> which) {
        WrittenBound bound;
        bound.name = "motor_curve";
        bound.key = "limits.motor_curve";
        bound.order = 2;
        bound.bound = bound.given = 1.0;
        bound.magnitude = true;
        bound.weights = weights;
        bound.remark = std::move(remark);
        bound.fields.which = std::move(which);
        bound.from = span.begin;
        bound.until = span.end;
        all.push_back(std::move(bound));
    };
    const auto sign_word = [](double sign) { return sign > 0.0 ? '+' : '-'; };
    for (const DriveSpan& span : spans)
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            const double fall = (curve[i][1] - curve[i + 1][1]) / (curve[i + 1][0] - curve[i][0]);
            const double most = curve[i][1] + fall * curve[i][0];  // |τ| + fall · |n| <= most
            for (const double sign : {1.0, -1.0})
                for (const double way : {1.0, -1.0}) {
                    if (fall == 0.0 && way < 0.0) continue;
                    std::array<double, 3> weights = torque_weights(torque, span, sign / most);
                    weights[0] += way * fall * torque.speed / most;
                    add(span, weights,
                        fmt::format("pairs {} and {}, torque {}, speed {}", i + 1, i + 2, sign_word(sign),
                                    sign_word(way)),
                        {{"pair", static_cast<double>(i)}, {"torque", sign}, {"speed", way}});
                }
        }
    for (const double sign : {1.0, -1.0})
        add({-infinity, infinity, 0.0}, {sign * torque.speed / curve.back()[0], 0.0, 0.0},
            fmt::format("last speed, {}", sign_word(sign)), {{"speed", sign}});
}

}  // namespace

DriveAlong::DriveAlong(const Scene& scene) : torque_(drive_torque(*scene.drive, scene.motion)) {
    spans_ = spans_of(scene, scene_family(scene, DesignKind::states));
    if (scene.prescribes_output())
        of_output_ =
            torque_.acceleration * (torque_of_output(scene).weights[0] - cam_of_output(scene).weights[0]);
}

DrivePoint DriveAlong::at(const MotionPoint& point, Side side, const MotionPoint* output) const {
    const DriveSpan* own = &spans_.front();
    for (const DriveSpan& span : spans_)
        if (side == Side::right ? point.x >= span.begin - same_joint : point.x > span.begin + same_joint)
            own = &span;
    const double of_load = output != nullptr ? of_output_ * output->derivative[2] : 0.0;
    return {torque_.acceleration * point.derivative[2] + torque_.velocity * point.derivative[1] +
                own->constant + of_load,
            torque_.speed * point.derivative[1]};
}

namespace {

/// τ n, sampled between the breakpoints: of two motions it is no rule of one point.
Extremum largest_power(const DriveTorque& torque, double constant, const Motion& motor, const Motion& load) {
    return largest_along(motor.breakpoints(), [&](double x, Side side) {
        const double moved = torque.acceleration * load.at(x, side).derivative[2] + constant;
        return std::abs(torque.speed * motor.at(x, side).derivative[1] * moved);
    });
}

/// `motor`: whose velocity is the motor's; `load`: whose acceleration takes its torque. Mostly one motion.
DriveFigures figures_of(const Scene& scene, const Motion& motor, const Motion& load) {
    const MotionFamily family = scene_family(scene, DesignKind::states);
    const DriveTorque torque = drive_torque(*scene.drive, scene.motion);
    const std::vector<DriveSpan> spans = spans_of(scene, family);
    DriveFigures figures;
    figures.torque.at = figures.speed.at = figures.power.at = figures.share_of_curve.at = motor.begin();
    for (const auto& place : motor_peak_rule(scene, family, 0, 1.0).maxima(load, {}))
        raise_to(figures.torque, place.where);
    if (&motor != &load) raise_to(figures.power, largest_power(torque, spans.front().constant, motor, load));
    for (const DriveSpan& span : spans)
        for (const int sign : {1, -1}) {
            if (&motor != &load) break;
            for (const Extremum& one : rule_maxima(PowerRule(torque, span, sign), motor, {}))
                if (one.at >= span.begin && one.at <= span.end) raise_to(figures.power, one);
        }
    LinearBound speed;
    speed.order = 2;
    for (const double sign : {1.0, -1.0}) {
        speed.weights = {sign * torque.speed, 0.0, 0.0};
        raise_to(figures.speed, extreme_of(speed, motor));
    }
    std::vector<WrittenBound> curve;
    if (!scene.limits.motor_curve.empty()) add_curve_bounds(curve, scene, spans);
    for (const WrittenBound& bound : curve) raise_to(figures.share_of_curve, extreme_of(bound, motor));
    figures.rms_torque = MotorEnergy(scene, family).rms(load);
    return figures;
}

/// The load and the motor as one: what a law asks for in the place of a prescribed output.
Scene with_rigid_load(Scene scene) {
    if (!scene.prescribes_output()) return scene;
    scene.drive.value().load += scene.dynamics->mass;
    scene.dynamics.reset();
    return scene;
}

}  // namespace

DriveFigures drive_figures(const Scene& scene, const Motion& motion) {
    if (!scene.prescribes_output()) return figures_of(scene, motion, motion);
    const auto& output = dynamic_cast<const MotionChain&>(motion);
    return figures_of(scene, combined(output, cam_of_output(scene)),
                      combined(output, torque_of_output(scene)));
}

std::vector<WrittenBound> drive_bounds(const Scene& scene, const MotionFamily& family) {
    std::vector<WrittenBound> all;
    if (!scene.drive) return all;
    const std::vector<DriveSpan> spans = spans_of(scene, family);
    add_torque_bounds(all, scene, spans);
    for (WrittenBound& bound : all) bound.seen = SeenMotion::torque;
    if (const auto& limit = scene.limits.motor_speed)
        for (const int sign : {1, -1}) {
            WrittenBound bound = written_bound(limit_row(LimitedFigure::motor_speed), *limit, sign);
            bound.weights = {sign * drive_torque(*scene.drive, scene.motion).speed, 0.0, 0.0};
            bound.seen = SeenMotion::cam;
            all.push_back(std::move(bound));
        }
    if (!scene.limits.motor_curve.empty()) add_curve_bounds(all, scene, spans);
    return all;
}

double drive_reference(const Scene& scene, const MotionFamily& family, const ResponseTerm& term) {
    const Reference& reference = scene.objective.reference;
    if (const std::optional<double>& number = reference.*term.reference) return *number;
    const std::string key = fmt::format("objective.reference.{}", term.name);
    if (reference.numeric)
        throw SceneError({key, "no number",
                          fmt::format("a number > 0, because objective.{} = {}", term.name,
                                      term.weight_in(scene.objective))});
    const MotionChain law = law_chain(scene, family);
    const DriveFigures figures = figures_of(with_rigid_load(scene), law, law);
    const double own =
        term.figure == ResponseFigure::motor_torque ? figures.torque.value : figures.rms_torque;
    if (own > 0.0 && std::isfinite(own)) return own;
    throw SceneError({"objective.reference",
                      fmt::format("\"{}\", whose {} on this scene is {:.6g}", reference.law, term.name, own),
                      fmt::format("another law, or objective.reference as numbers, with {} > 0", term.name)});
}

void add_drive_rules(CamModel& model, const Scene& scene) {
    if (!scene.drive) return;
    const LimitSpec& limits = scene.limits;
    MotorBounds& motor = model.motor.emplace();
    motor.torque = drive_torque(*scene.drive, scene.motion);
    motor.cycle = cycle_of(scene, model.design);
    const std::vector<KnownPoint>& points = model.known_points;
    motor.from_rest = scene.motion.periodic()
                          ? std::ranges::any_of(points, &KnownPoint::at_rest)
                          : !points.empty() && points.front().at_rest && !scene.motion.start &&
                                points.front().x <= model.design.begin() + same_joint;
    if (limits.motor_torque_rms) motor.rms = limits.motor_torque_rms->value;
    if (limits.motor_torque) motor.peak = limits.motor_torque->value;
    if (limits.motor_speed) motor.speed = limits.motor_speed->value;
    if (!limits.motor_curve.empty()) {
        motor.peak = std::min(motor.peak, limits.motor_curve.front()[1]);
        motor.speed = std::min(motor.speed, limits.motor_curve.back()[0]);
    }
    for (const ResponseTerm& term : response_terms()) {
        const double weight = term.weight_in(scene.objective);
        if (!term.needs_drive() || !(weight > 0.0)) continue;
        const bool peak = term.figure == ResponseFigure::motor_torque;
        const double reference = drive_reference(scene, model.design, term);
        const int index = static_cast<int>(model.parameters.size());
        Parameter parameter{term.name, peak ? Parameter::Kind::response : Parameter::Kind::energy, 0,
                            reference, weight};
        if (peak)
            parameter.defined_by = std::make_shared<const WholeMotionRule>(
                motor_peak_rule(scene, model.design, index, reference));
        else
            parameter.defined_by = motor_energy_rule(term.name, scene, model.design, reference, index);
        (peak ? motor.peak_parameter : motor.rms_parameter) = index;
        if (peak) model.rules.emplace_back(parameter.defined_by);
        model.parameters.push_back(std::move(parameter));
    }
    if (const auto& limit = scene.limits.motor_torque_rms)
        model.rules.emplace_back(motor_energy_rule(limit->key, scene, model.design, limit->value, -1));
    if (scene.prescribes_output())
        model.motor.reset();  // its bounds are of a motor that moves all of the load
}

}  // namespace camopt
