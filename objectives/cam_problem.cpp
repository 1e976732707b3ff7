// SPDX-License-Identifier: MIT
#include "objectives/cam_problem.hpp"

#include "core/errors.hpp"
#include "objectives/curve_bounds.hpp"
#include "objectives/rule_maxima.hpp"
#include "splines/extrema.hpp"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <random>

namespace camopt {

namespace {

// Samples of one rule closer than this part of their segment are one sample.
constexpr double same_sample = 1e-9;
// A maximum is bracketed by rows at this part of the distance to the nearest sample on either side.
constexpr double bracket = 0.25;

// In lifts: no cam follows a motion that strays farther, so proofs need not look there.
constexpr double farthest_displacement = 1e3;
// Random starting motions: this many loads, bending the smoothest motion by up to this part of a lift.
constexpr int random_loads = 3;
constexpr double farthest_random_move = 0.3;
constexpr int move_samples = 64;
// Steps with which the range of displacements is bounded.
constexpr int range_samples = 200;

/// max |a − b| over samples: only the size of a random move hangs on it.
double largest_move(const Motion& a, const Motion& b) {
    double largest = 0.0;
    for (int k = 0; k <= move_samples; ++k) {
        const double x = a.begin() + (a.end() - a.begin()) * k / move_samples;
        largest = std::max(largest, std::abs(a.at(x).derivative[0] - b.at(x).derivative[0]));
    }
    return largest;
}

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

/// Degree of a rule along a spline piece, as far as the first grid cares: curved ones like a high one.
int degree_along(const PointRule& rule, int spline_degree) {
    return rule.linear() ? spline_degree - rule.highest_order() : spline_degree;
}

}  // namespace

CamProblem::CamProblem(CamModel model) : CamProblem(std::move(model), {}) {}

CamProblem::CamProblem(CamModel model, std::vector<RuleSample> samples)
    : model_(std::make_shared<const CamModel>(std::move(model))), places_(model_->rules.size()) {
    projection_ = std::make_unique<EqualityProjection>(model_->design.equalities(), design_scales(*model_));
    start_grid();
    for (const RuleSample& sample : samples) add_sample(sample.rule, sample.at, sample.side);
    rebuild();
}

void CamProblem::start_grid() {
    for (int r = 0; r < static_cast<int>(model_->rules.size()); ++r) start_rule(r);
}

void CamProblem::start_rule(int index) {
    const PlacedRule& rule = model_->rules[index];
    const MotionFamily& family = model_->design;
    const int order = rule->highest_order();
    int last_stretch = -1;
    for (const MotionFamily::Piece& piece : family.pieces()) {
        if (rule.stretch >= 0 && rule.stretch != piece.stretch) continue;
        const bool first = piece.stretch != last_stretch;
        last_stretch = piece.stretch;
        const MotionFamily::Stretch& stretch = family.stretches()[piece.stretch];
        if (stretch.kind == StretchRequest::Kind::spline) {
            const SplineSpace& space = family.run_space(stretch.run);
            const int degree = degree_along(*rule, space.degree());
            const bool jumps = order > space.continuity();
            if (degree >= 1 || jumps) {
                if (first || jumps) add_sample(index, piece.begin, Side::right);
                if (degree >= 1) add_sample(index, piece.end, Side::left);
            }
            if (degree >= 2) add_sample(index, 0.5 * (piece.begin + piece.end), Side::right);
            continue;
        }
        // Where the motion is fixed, only the cam's dimensions can still move the rule.
        if (rule->parameters().empty() && stretch.from.columns.empty() && stretch.to.columns.empty())
            continue;
        const bool dwell = stretch.kind == StretchRequest::Kind::dwell;
        const int parts = dwell ? 1 : 4;
        for (int k = 0; k < parts; ++k) {
            add_sample(index, piece.begin + (k + 0.5) / parts * (piece.end - piece.begin), Side::right);
        }
    }
}

bool CamProblem::add_sample(int rule, double at, Side side) {
    const int index = model_->design.piece_of(at, side);
    const MotionFamily::Piece& piece = model_->design.pieces()[index];
    const double tolerance = same_sample * (piece.end - piece.begin);
    auto& places = places_[rule];
    const auto next = places.lower_bound({index, at - tolerance});
    if (next != places.end() && next->first.first == index && next->first.second <= at + tolerance) {
        return false;
    }
    places.emplace(std::pair{index, at}, static_cast<int>(samples_.size()));
    samples_.push_back({rule, at, side});
    return true;
}

void CamProblem::rebuild() {
    grid_ = std::make_unique<GridNlp>(model_, samples_);
}

Eigen::VectorXd CamProblem::design_values(const Eigen::VectorXd& x) const {
    return design_scales(*model_).cwiseProduct(x.head(model_->design.size()));
}

SplineCurve CamProblem::curve(const Eigen::VectorXd& x) const {
    return model_->design.run_curve(0, design_values(x));
}

MotionChain CamProblem::motion(const Eigen::VectorXd& x) const {
    return model_->design.motion(design_values(x));
}

/// The entries of least mean square jerk under a load: one linear system, always smooth.
Eigen::VectorXd CamProblem::smoothest(const Eigen::VectorXd& load) const {
    const MotionFamily& design = model_->design;
    const Eigen::Index size = design.size();
    const Eigen::Index rows = projection_->matrix().rows();
    const QuadraticForm energy = design.mean_square(3, model_->mean_square_weights(3));
    const Eigen::VectorXd scale = design_scales(*model_);
    const double unit = model_->jerk_reference * model_->jerk_reference;
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < energy.matrix.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator e(energy.matrix, column); e; ++e) {
            entries.emplace_back(e.row(), column, scale[e.row()] * scale[column] * e.value() / unit);
        }
    }
    const Eigen::SparseMatrix<double>& equality = projection_->matrix();
    for (int column = 0; column < equality.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator e(equality, column); e; ++e) {
            entries.emplace_back(size + e.row(), column, e.value());
            entries.emplace_back(column, size + e.row(), e.value());
        }
    }
    Eigen::SparseMatrix<double> system(size + rows, size + rows);
    system.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd right(size + rows);
    right << load - scale.cwiseProduct(energy.linear) / unit, -projection_->offset();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
    if (size == 0) return x;
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(system);
    if (factor.info() != Eigen::Success) return x;
    const Eigen::VectorXd solution = factor.solve(right);
    if (solution.allFinite()) x = solution.head(size);
    return x;
}

Eigen::VectorXd CamProblem::start() const {
    // Close to every optimum, unique, and one linear system away. Dimensions start in the middle.
    const Eigen::Index size = model_->design.size();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(grid_->shape().variables());
    x.head(size) = smoothest(Eigen::VectorXd::Zero(size));
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        if (parameter.kind != Parameter::Kind::dimension) continue;
        x[size + static_cast<Eigen::Index>(p)] = 0.5 * (parameter.lower + parameter.upper);
    }
    return completed(x);
}

Eigen::VectorXd CamProblem::random_start(unsigned seed) const {
    const MotionFamily& design = model_->design;
    const Eigen::Index size = design.size();
    Eigen::VectorXd x = start();
    // Plain arithmetic on the engine: the standard's distributions differ from library to library.
    std::mt19937 engine(seed);
    const auto uniform = [&engine](double low, double high) {
        return low + (high - low) * static_cast<double>(engine()) / 4294967295.0;
    };
    const Eigen::VectorXd scale = design_scales(*model_);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(size);
    for (int k = 0; k < random_loads; ++k) {
        const AffineRow place = design.functional(uniform(design.begin(), design.end()), 0);
        const double force = uniform(-1.0, 1.0);
        for (std::size_t j = 0; j < place.columns.size(); ++j) {
            load[place.columns[j]] += force * place.weights[j] * scale[place.columns[j]];
        }
    }
    const Eigen::VectorXd bend = smoothest(load) - x.head(size);
    Eigen::VectorXd bent = x;
    bent.head(size) += bend;
    const double size_of_bend = largest_move(motion(bent), motion(x));
    if (size_of_bend > 0.0) x.head(size) += uniform(0.0, farthest_random_move) / size_of_bend * bend;
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        if (parameter.kind != Parameter::Kind::dimension) continue;
        x[size + static_cast<Eigen::Index>(p)] = uniform(parameter.lower, parameter.upper);
    }
    return completed(x);
}

Eigen::VectorXd CamProblem::own_parameters(int rule, const Eigen::VectorXd& x) const {
    return x.tail(static_cast<Eigen::Index>(model_->parameters.size()))(model_->rules[rule]->parameters());
}

/// The peaks of DRD and RR, whose normalised motion is the spline itself.
void CamProblem::complete_peaks(const SplineCurve& curve, Eigen::VectorXd& x) const {
    const Peaks peaks = peaks_of(curve);
    const std::array<double, 4> peak = {0.0, peaks.velocity.value, peaks.acceleration.value,
                                        peaks.jerk.value};
    const std::array<double, 4> rms = {0.0, peaks.rms_velocity, peaks.rms_acceleration, peaks.rms_jerk};
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        double& value = x[model_->design.size() + static_cast<Eigen::Index>(p)];
        if (parameter.kind == Parameter::Kind::peak) value = peak[parameter.order] / parameter.reference;
        if (parameter.kind == Parameter::Kind::rms) value = rms[parameter.order] / parameter.reference;
    }
}

/// The normalised peaks of a program: each the largest over its stretches, by the rules that define it.
void CamProblem::complete_program_peaks(const MotionChain& chain, Eigen::VectorXd& x) const {
    const Eigen::Index size = model_->design.size();
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        double& value = x[size + static_cast<Eigen::Index>(p)];
        if (parameter.kind == Parameter::Kind::peak) value = 0.0;
        if (parameter.kind != Parameter::Kind::rms) continue;
        const QuadraticForm form =
            model_->design.mean_square(parameter.order, model_->mean_square_weights(parameter.order));
        value = std::sqrt(std::max(0.0, form.value(design_values(x)))) / parameter.reference;
    }
    for (const PlacedRule& rule : model_->rules) {
        if (rule->limit() || rule->parameters().empty()) continue;
        double& peak = x[size + rule->parameters().front()];
        peak = std::max(peak,
                        largest_of(rule_maxima(rule, model_->design, chain, Eigen::VectorXd::Zero(1))).value);
    }
}

/// Peaks and root mean squares become those of the motion behind x; dimensions keep their range.
void CamProblem::complete_parameters(Eigen::VectorXd& x) const {
    if (model_->stretch_scales.empty()) {
        complete_peaks(curve(x), x);
    } else {
        complete_program_peaks(motion(x), x);
    }
    const Eigen::Index size = model_->design.size();
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        double& value = x[size + static_cast<Eigen::Index>(p)];
        if (parameter.kind == Parameter::Kind::dimension)
            value = std::clamp(value, parameter.lower, parameter.upper);
        if (parameter.kind == Parameter::Kind::magnitude) value = std::abs(x[size + parameter.order]);
    }
}

Eigen::VectorXd CamProblem::completed(const Eigen::VectorXd& x) const {
    Eigen::VectorXd full = x;
    const Eigen::Index size = model_->design.size();
    full.head(size) = projection_->project(x.head(size));
    if (full.allFinite()) complete_parameters(full);
    return full;
}

double CamProblem::objective(const Eigen::VectorXd& x) const {
    return grid_->cost(completed(x));
}

std::vector<Violation> CamProblem::violations(const Eigen::VectorXd& x, double slack) const {
    std::vector<Violation> found;
    const MotionChain chain = motion(x);
    const Eigen::VectorXd q = x.tail(static_cast<Eigen::Index>(model_->parameters.size()));
    for (int r = 0; r < static_cast<int>(model_->rules.size()); ++r) {
        const PlacedRule& rule = model_->rules[r];
        for (const Extremum& maximum : rule_maxima(rule, model_->design, chain, own_parameters(r, x))) {
            // What has no value (an arm that cannot reach) is as broken as can be.
            const double amount = std::isfinite(maximum.value) ? maximum.value / rule->scale() : infinity;
            if (amount > -slack) found.push_back({r, maximum, amount, rule->limit()});
        }
    }
    for (int k = 0; k < static_cast<int>(model_->parameter_rows.size()); ++k) {
        const ParameterRow& row = model_->parameter_rows[k];
        double value = -row.upper;
        for (std::size_t i = 0; i < row.parameters.size(); ++i)
            value += row.weights[i] * q[row.parameters[i]];
        const int rule = static_cast<int>(model_->rules.size()) + k;
        if (value / row.scale > -slack)
            found.push_back({rule, {value, model_->design.begin()}, value / row.scale, row.limit});
    }
    std::ranges::stable_sort(found, std::greater{}, &Violation::amount);
    return found;
}

int CamProblem::refine(std::span<const Violation> worst) {
    const std::size_t before = samples_.size();
    const MotionFamily& family = model_->design;
    for (const Violation& violation : worst) {
        if (violation.rule >= static_cast<int>(places_.size()))
            continue;  // rows on parameters are always there
        const double at = violation.where.at;
        const int piece = family.piece_of(at, violation.where.side);
        const auto& places = places_[violation.rule];
        double left = family.pieces()[piece].begin;
        double right = family.pieces()[piece].end;
        const auto after = places.lower_bound({piece, at});
        if (after != places.end() && after->first.first == piece) right = after->first.second;
        if (after != places.begin() && std::prev(after)->first.first == piece) {
            left = std::prev(after)->first.second;
        }
        if (!add_sample(violation.rule, at, violation.where.side)) continue;
        if (at - left > 0.0) add_sample(violation.rule, at - bracket * (at - left), Side::right);
        if (right - at > 0.0) add_sample(violation.rule, at + bracket * (right - at), Side::right);
    }
    const int added = static_cast<int>(samples_.size() - before);
    if (added > 0) rebuild();
    return added;
}

/// What a curve of at most the incumbent's cost cannot exceed: parameters, and with them derivatives.
struct CamProblem::SupportedBounds {
    Eigen::VectorXd parameters;      ///< upper bounds, in units of their references
    std::array<double, 4> sup, rms;  ///< of |y^{(r)}| and of its root mean square, anywhere
};

CamProblem::SupportedBounds CamProblem::supported_bounds(double incumbent, double relaxation) const {
    const CamModel& model = *model_;
    const auto parameters = static_cast<Eigen::Index>(model.parameters.size());
    SupportedBounds known{Eigen::VectorXd::Constant(parameters, infinity), {}, {}};
    known.sup.fill(infinity);
    known.rms.fill(infinity);
    known.sup[0] = farthest_displacement * std::max(1.0, model.most_displacement - model.least_displacement);
    for (Eigen::Index p = 0; p < parameters; ++p) {
        const Parameter& parameter = model.parameters[static_cast<std::size_t>(p)];
        known.parameters[p] = parameter.upper;
        if (parameter.weight > 0.0) {  // every term of the cost is at least 0, dimensions at their lower ends
            known.parameters[p] = std::min(known.parameters[p], incumbent / parameter.weight);
        }
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
        const Parameter& parameter = model.parameters[static_cast<std::size_t>(p)];
        const bool peak = parameter.kind == Parameter::Kind::peak;
        if (!peak && parameter.kind != Parameter::Kind::rms) continue;
        double& bound = (peak ? known.sup : known.rms)[parameter.order];
        const double normalised = known.parameters[p] * parameter.reference;
        bound = std::min(bound, normalised * largest_stretch_factor(model, parameter.order));
    }
    return known;
}

Box CamProblem::box(double incumbent, double relaxation) const {
    const CamModel& model = *model_;
    const MotionFamily& family = model.design;
    const SupportedBounds known = supported_bounds(incumbent, relaxation);
    Box box;
    box.upper = Eigen::VectorXd::Constant(grid_->shape().variables(), infinity);
    // Displacements at joints lie within what the velocity allows from the known beginning.
    const double reach = known.sup[1] * (family.end() - family.begin());
    const std::array<double, 3> joint_bound = {reach, known.sup[1], known.sup[2]};
    for (int entry = family.first_joint_entry(); entry < family.size(); ++entry) {
        box.upper[entry] = joint_bound[family.order(entry)];
    }
    std::array<double, 4> own{};  // bounds on |y^{(r)}| over all runs
    for (int r = 0; r < family.runs(); ++r) {
        const DesignVector& run = family.run(r);
        KnownBounds bounds{known.sup, known.rms, run.begin_state(), run.end_state()};
        if (family.first_joint_entry() < family.size()) {
            bounds.rms.fill(infinity);
            bounds.begin_state = bounds.end_state = joint_bound;
        }
        const Eigen::MatrixXd derivatives = derivative_bounds(run.space(), bounds);
        box.upper.segment(family.first_entry(r), run.size()) = run.entry_bounds(derivatives);
        for (int order = 0; order < 4; ++order) {
            own[order] = std::max(own[order], derivatives.row(order).maxCoeff());
        }
    }
    box.upper.head(family.size()) = box.upper.head(family.size()).cwiseQuotient(design_scales(model));
    box.lower = -box.upper;
    for (std::size_t p = 0; p < model.parameters.size(); ++p) {
        const Parameter& parameter = model.parameters[p];
        const Eigen::Index variable = family.size() + static_cast<Eigen::Index>(p);
        box.upper[variable] = known.parameters[static_cast<Eigen::Index>(p)];
        box.lower[variable] = parameter.kind == Parameter::Kind::dimension ? parameter.lower : 0.0;
        if (parameter.kind == Parameter::Kind::magnitude) {
            const Parameter& of = model.parameters[static_cast<std::size_t>(parameter.order)];
            box.upper[variable] =
                std::min(box.upper[variable], std::max(std::abs(of.lower), std::abs(of.upper)));
        }
        if (parameter.kind != Parameter::Kind::peak && parameter.kind != Parameter::Kind::rms) continue;
        // A peak nothing else bounds may be taken as the curve's own.
        const double largest = own[parameter.order] / smallest_stretch_factor(model, parameter.order);
        box.upper[variable] = std::min(box.upper[variable], largest / parameter.reference);
    }
    return box;
}

/// From the nearer end of the motion with the bounds on velocity and acceleration: how far y can go.
std::array<double, 2> CamProblem::displacement_range(double incumbent) const {
    const SupportedBounds known = supported_bounds(incumbent, 0.0);
    const MotionFamily& family = model_->design;
    std::array<double, 2> range = {infinity, -infinity};
    const bool at_rest = family.stretches().size() == 1;  // the acceleration counts from a standstill only
    for (const MotionFamily::Stretch& stretch : family.stretches()) {
        const bool known_ends = stretch.from.columns.empty() && stretch.to.columns.empty() &&
                                std::isfinite(stretch.from.offset) && std::isfinite(stretch.to.offset);
        if (!known_ends) return {-infinity, infinity};
        const double from = stretch.from.offset, to = stretch.to.offset;
        range = {std::min({range[0], from, to}), std::max({range[1], from, to})};
        if (stretch.kind != StretchRequest::Kind::spline) continue;
        const double length = stretch.end - stretch.begin;
        const auto reach = [&](double distance) {
            const double by_velocity = known.sup[1] * distance;
            return at_rest ? std::min(by_velocity, 0.5 * known.sup[2] * distance * distance) : by_velocity;
        };
        for (int k = 0; k < range_samples; ++k) {
            // Over each small step both reaches are largest at its far ends.
            const double near = length * (k + 1) / range_samples,
                         far = length * (range_samples - k) / range_samples;
            range[0] = std::min(range[0], std::max(from - reach(near), to - reach(far)));
            range[1] = std::max(range[1], std::min(from + reach(near), to + reach(far)));
        }
    }
    return range;
}

bool CamProblem::convex(double incumbent) const {
    if (!grid_->shape().convex) return false;
    if (std::ranges::all_of(model_->rules, [](const PlacedRule& rule) { return rule->linear(); }))
        return true;
    const std::array<double, 2> range = displacement_range(incumbent);
    return std::ranges::all_of(model_->rules, [&](const PlacedRule& rule) {
        return rule->curvature(range[0], range[1]) != Curvature::general;
    });
}

}  // namespace camopt
