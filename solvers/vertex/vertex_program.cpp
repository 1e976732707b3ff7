// SPDX-License-Identifier: MIT
#include "solvers/vertex/vertex_program.hpp"

#include "core/errors.hpp"

#include <Eigen/LU>

namespace camopt {

namespace {

// Rows have entries near one. A violation below this counts as satisfied.
constexpr double kept_side = 1e-10;
// Multipliers above minus this count as 0: the bound accounts for it.
constexpr double least_multiplier = 1e-10;
// Smaller pivots amplify round-off.
constexpr double least_pivot = 1e-9;
// Right-hand sides are perturbed by up to twice this.
constexpr double moved_by = 1e-9;
// Costs of the first phase are perturbed by this part of the largest, so that multipliers are distinct.
constexpr double moved_cost = 1e-5;
// Steps after which the inverse is recomputed.
constexpr int refactor_every = 50;
constexpr int most_steps_a_variable = 60;
constexpr int clock_every = 32;

}  // namespace

VertexProgram::VertexProgram(Eigen::VectorXd lower, Eigen::VectorXd upper)
    : lower_(std::move(lower)), upper_(std::move(upper)) {
    if (!lower_.allFinite() || !upper_.allFinite())
        throw ModelError("vertex program: found an infinite bound of a variable; allowed: finite ones");
    lower_on_.assign(static_cast<std::size_t>(lower_.size()), 0);
    upper_on_ = lower_on_;
}

void VertexProgram::add_row(const Eigen::VectorXd& a, double b) {
    const int row = rows();
    const double largest = a.size() > 0 ? a.cwiseAbs().maxCoeff() : 0.0;
    const double factor = largest > 0.0 ? std::exp2(-std::ilogb(largest)) : 1.0;
    normals_.add(factor * a);
    factor_.push_back(factor);
    side_.push_back(factor * b);
    noise_ ^= noise_ << 13;
    noise_ ^= noise_ >> 7;
    noise_ ^= noise_ << 17;
    const double share = 1.0 + static_cast<double>(noise_ >> 11) * 0x1p-53;
    moved_.push_back(side_.back() + moved_by * share * std::max(1.0, std::abs(side_.back())));
    row_on_.push_back(0);
    if (corner_.empty()) return;
    activity_.conservativeResize(row + 1);
    activity_[row] = normals_.dot(row, x_);
}

std::vector<int> VertexProgram::drop_rows(std::vector<char> kept) {
    std::vector<int> stay, place(static_cast<std::size_t>(rows()), -1);
    for (int i = 0; i < rows(); ++i) {
        const auto from = static_cast<std::size_t>(i);
        if (!kept[from] && !row_on_[from]) continue;
        const auto to = static_cast<int>(stay.size());
        place[from] = to;
        stay.push_back(i);
        if (to == i) continue;
        const auto at = static_cast<std::size_t>(to);
        factor_[at] = factor_[from];
        side_[at] = side_[from];
        moved_[at] = moved_[from];
        row_on_[at] = row_on_[from];
        if (!corner_.empty()) activity_[to] = activity_[i];
    }
    normals_.keep(stay);
    const auto left = static_cast<Eigen::Index>(stay.size());
    for (std::vector<double>* values : {&factor_, &side_, &moved_}) values->resize(stay.size());
    row_on_.resize(stay.size());
    if (!corner_.empty()) activity_.conservativeResize(left);
    for (Face& face : corner_)
        if (face >= 0) face = place[static_cast<std::size_t>(face)];
    return stay;
}

void VertexProgram::set_bounds(int j, double lower, double upper) {
    lower_[j] = lower;
    upper_[j] = upper;
    // The corner moves with its active bounds.
    if (corner_.empty() ||
        (!lower_on_[static_cast<std::size_t>(j)] && !upper_on_[static_cast<std::size_t>(j)]))
        return;
    if (!refactor()) corner_.clear();
}

double VertexProgram::slack(int row, const Eigen::VectorXd& x) const {
    const auto at = static_cast<std::size_t>(row);
    return (side_[at] - normals_.dot(row, x)) / factor_[at];
}

Eigen::VectorXd VertexProgram::normal(Face face) const {
    if (face >= 0) {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(lower_.size());
        normals_.each(face, [&](int column, double value) { row[column] = value; });
        return row;
    }
    const int j = (-1 - face) / 2;
    return Eigen::VectorXd::Unit(lower_.size(), j) * (face == lower_face(j) ? -1.0 : 1.0);
}

double VertexProgram::side(Face face) const {
    if (face >= 0) return moved_[static_cast<std::size_t>(face)];
    const int j = (-1 - face) / 2;
    return face == lower_face(j) ? -lower_[j] : upper_[j];
}

bool VertexProgram::on_face(Face face) const {
    if (face >= 0) return row_on_[static_cast<std::size_t>(face)] != 0;
    const int j = (-1 - face) / 2;
    return (face == lower_face(j) ? lower_on_ : upper_on_)[static_cast<std::size_t>(j)] != 0;
}

void VertexProgram::mark(Face face, char on) {
    if (face >= 0) {
        row_on_[static_cast<std::size_t>(face)] = on;
        return;
    }
    const int j = (-1 - face) / 2;
    (face == lower_face(j) ? lower_on_ : upper_on_)[static_cast<std::size_t>(j)] = on;
}

void VertexProgram::start_at_bounds(const Eigen::VectorXd& cost) {
    std::ranges::fill(row_on_, 0);
    std::ranges::fill(lower_on_, 0);
    std::ranges::fill(upper_on_, 0);
    corner_.clear();
    inverse_ = Eigen::MatrixXd::Zero(lower_.size(), lower_.size());
    x_.resize(lower_.size());
    for (Eigen::Index j = 0; j < lower_.size(); ++j) {
        const bool low = cost[j] >= 0.0;
        corner_.push_back(low ? lower_face(j) : upper_face(j));
        mark(corner_.back(), 1);
        inverse_(j, j) = low ? -1.0 : 1.0;
        x_[j] = low ? lower_[j] : upper_[j];
    }
    activity_ = normals_.times(x_);
    since_refactor_ = 0;
}

bool VertexProgram::refactor() {
    const auto size = lower_.size();
    Eigen::MatrixXd faces(size, size);
    Eigen::VectorXd sides(size);
    for (Eigen::Index k = 0; k < size; ++k) {
        faces.row(k) = normal(corner_[static_cast<std::size_t>(k)]).transpose();
        sides[k] = side(corner_[static_cast<std::size_t>(k)]);
    }
    inverse_ = faces.partialPivLu().inverse();
    if (!inverse_.allFinite()) return false;
    x_ = inverse_ * sides;
    x_ += inverse_ * (sides - faces * x_);
    activity_ = normals_.times(x_);
    since_refactor_ = 0;
    return true;
}

bool VertexProgram::exchange(Eigen::Index leaving, Face entering, const Eigen::VectorXd& rise) {
    const Eigen::VectorXd a = normal(entering);
    const Eigen::VectorXd shares = inverse_.transpose() * a;
    const Eigen::VectorXd column = inverse_.col(leaving) / shares[leaving];
    const double step = side(entering) - a.dot(x_);
    x_ += step * column;
    activity_ -= (step / shares[leaving]) * rise;
    inverse_ -= column * shares.transpose();
    inverse_.col(leaving) = column;
    Face& face = corner_[static_cast<std::size_t>(leaving)];
    mark(face, 0);
    face = entering;
    mark(face, 1);
    ++steps_;
    return ++since_refactor_ < refactor_every || refactor();
}

/// Dual simplex steps: the corner is optimal for the cost, but violates rows.
VertexProgram::Outcome VertexProgram::reach_feasible(const Eigen::VectorXd& cost,
                                                     const SolveControl& control) {
    const int most = most_steps_a_variable * variables();
    for (int count = 0; count < most; ++count) {
        if (count % clock_every == clock_every - 1 && control.ending()) return Outcome::ended;
        double worst = kept_side;
        std::optional<Face> entering;
        for (int i = 0; i < rows(); ++i) {
            const double excess = activity_[i] - moved_[static_cast<std::size_t>(i)];
            if (excess > worst && !row_on_[static_cast<std::size_t>(i)]) {
                worst = excess;
                entering = i;
            }
        }
        for (Eigen::Index j = 0; j < lower_.size(); ++j) {
            const double below = lower_[j] - x_[j], above = x_[j] - upper_[j];
            if (std::max(below, above) > worst) {
                const Face face = below > above ? lower_face(j) : upper_face(j);
                if (on_face(face)) continue;
                worst = std::max(below, above);
                entering = face;
            }
        }
        if (!entering) return Outcome::done;
        const Eigen::VectorXd multipliers = face_multipliers(cost);
        const Eigen::VectorXd shares = inverse_.transpose() * normal(*entering);
        Eigen::Index leaving = -1;
        double least = infinity;
        for (Eigen::Index k = 0; k < shares.size(); ++k) {
            if (shares[k] <= least_pivot) continue;
            const double ratio = std::max(0.0, multipliers[k]) / shares[k];
            const bool tie = leaving >= 0 && ratio <= least + 1e-12;
            if (ratio < least - 1e-12 || (tie && shares[k] > shares[leaving])) {
                least = std::min(ratio, least);
                leaving = k;
            }
        }
        if (leaving < 0) {
            ray_ = -shares;
            ray_face_ = *entering;
            return Outcome::infeasible;
        }
        if (!exchange(leaving, *entering, normals_.times(-inverse_.col(leaving)))) return Outcome::stuck;
    }
    return Outcome::stuck;
}

/// Primal simplex steps: the corner satisfies all rows.
VertexProgram::Outcome VertexProgram::reach_optimal(const Eigen::VectorXd& cost,
                                                    const SolveControl& control) {
    const int most = most_steps_a_variable * variables();
    for (int count = 0; count < most; ++count) {
        if (count % clock_every == clock_every - 1 && control.ending()) return Outcome::ended;
        const Eigen::VectorXd multipliers = face_multipliers(cost);
        if (multipliers.minCoeff() >= -least_multiplier) return Outcome::done;
        // Steepest-edge pricing: the edge of largest decrease of the cost relative to its length in x.
        Eigen::Index leaving = -1;
        (multipliers.array().min(0.0).square() / inverse_.colwise().squaredNorm().transpose().array())
            .maxCoeff(&leaving);
        const Eigen::VectorXd along = -inverse_.col(leaving);
        const Eigen::VectorXd rise = normals_.times(along);
        std::optional<Face> entering;
        double least = infinity, steepest = 0.0;
        const auto meet = [&](Face face, double room, double speed) {
            if (speed <= least_pivot) return;
            const double ratio = std::max(0.0, room) / speed;
            const bool tie = ratio <= least + 1e-12;
            if (ratio < least - 1e-12 || (tie && speed > steepest)) {
                least = std::min(least, ratio);
                steepest = speed;
                entering = face;
            }
        };
        for (int i = 0; i < rows(); ++i) {
            if (!row_on_[static_cast<std::size_t>(i)])
                meet(i, moved_[static_cast<std::size_t>(i)] - activity_[i], rise[i]);
        }
        for (Eigen::Index j = 0; j < lower_.size(); ++j) {
            if (along[j] > 0.0 && !on_face(upper_face(j))) meet(upper_face(j), upper_[j] - x_[j], along[j]);
            if (along[j] < 0.0 && !on_face(lower_face(j))) meet(lower_face(j), x_[j] - lower_[j], -along[j]);
        }
        if (!entering) return Outcome::stuck;
        if (!exchange(leaving, *entering, rise)) return Outcome::stuck;
    }
    return Outcome::stuck;
}

double VertexProgram::bound_of(const Eigen::VectorXd& cost,
                               const std::vector<std::pair<int, double>>& multipliers) const {
    const Eigen::Index size = cost.size();
    long double bound = 0.0L, sizes = 0.0L;
    std::vector<long double> reduced(cost.begin(), cost.end()), magnitude(reduced.size());
    for (Eigen::Index j = 0; j < size; ++j) magnitude[static_cast<std::size_t>(j)] = std::abs(cost[j]);
    for (const auto& [row, given] : multipliers) {
        const auto at = static_cast<std::size_t>(row);
        const long double multiplier = given / factor_[at];  // a power of two
        bound -= multiplier * side_[at];
        sizes += std::abs(multiplier * side_[at]);
        normals_.each(row, [&](int column, double value) {
            const long double term = multiplier * value;
            reduced[static_cast<std::size_t>(column)] += term;
            magnitude[static_cast<std::size_t>(column)] += std::abs(term);
        });
    }
    // As recomputed_bound (solvers/certificate): a double carries each term to half a unit in its last place.
    constexpr long double rounding = std::numeric_limits<double>::epsilon();
    for (Eigen::Index j = 0; j < size; ++j) {
        const long double slack = rounding * magnitude[static_cast<std::size_t>(j)];
        const auto least = [&](long double slope) { return slope * (slope > 0.0L ? lower_[j] : upper_[j]); };
        const long double slope = reduced[static_cast<std::size_t>(j)];
        bound += std::min(least(slope - slack), least(slope + slack));
    }
    return static_cast<double>(bound - rounding * (sizes + std::abs(bound)));
}

VertexBound VertexProgram::bound_at_corner(const Eigen::VectorXd& cost) const {
    VertexBound result;
    result.x = x_;
    Eigen::VectorXd multipliers = face_multipliers(cost);
    // Once more for the round-off.
    Eigen::VectorXd rest = cost;
    for (Eigen::Index k = 0; k < multipliers.size(); ++k)
        rest += multipliers[k] * normal(corner_[static_cast<std::size_t>(k)]);
    multipliers -= inverse_.transpose() * rest;
    for (Eigen::Index k = 0; k < multipliers.size(); ++k) {
        const Face face = corner_[static_cast<std::size_t>(k)];
        if (face >= 0 && multipliers[k] > 0.0)
            result.multipliers.emplace_back(face, multipliers[k] * factor_[static_cast<std::size_t>(face)]);
    }
    result.bound = bound_of(cost, result.multipliers);
    return result;
}

VertexBound VertexProgram::infeasible_bound() const {
    VertexBound result;
    if (ray_face_ >= 0)
        result.multipliers.emplace_back(ray_face_, factor_[static_cast<std::size_t>(ray_face_)]);
    for (Eigen::Index k = 0; k < ray_.size(); ++k) {
        const Face face = corner_[static_cast<std::size_t>(k)];
        if (face >= 0 && ray_[k] > 0.0)
            result.multipliers.emplace_back(face, ray_[k] * factor_[static_cast<std::size_t>(face)]);
    }
    const double excess = bound_of(Eigen::VectorXd::Zero(lower_.size()), result.multipliers);
    if (!(excess > 0.0)) return result;
    result.status = VertexBound::Status::infeasible;
    result.bound = infinity;
    return result;
}

VertexBound VertexProgram::minimize(const Eigen::VectorXd& cost, const SolveControl& control) {
    for (int attempt = 0; attempt < 2; ++attempt) {
        if (corner_.empty() || attempt > 0) {
            Eigen::VectorXd first = cost;
            const double size = std::max(1e-300, cost.cwiseAbs().maxCoeff());
            for (Eigen::Index j = 0; j < first.size(); ++j) {
                noise_ ^= noise_ << 13;
                noise_ ^= noise_ >> 7;
                noise_ ^= noise_ << 17;
                const double share = 0.5 + static_cast<double>(noise_ >> 11) * 0x1p-54;
                first[j] += (first[j] < 0.0 ? -1.0 : 1.0) * moved_cost * size * share /
                            std::max(1.0, upper_[j] - lower_[j]);
            }
            start_at_bounds(first);
            last_cost_ = first;
        }
        const Outcome feasible = reach_feasible(last_cost_, control);
        if (feasible == Outcome::infeasible) {
            VertexBound result = infeasible_bound();
            if (result.status == VertexBound::Status::infeasible || attempt > 0) {
                corner_.clear();
                return result;
            }
            continue;
        }
        const Outcome optimal = feasible == Outcome::done ? reach_optimal(cost, control) : feasible;
        if (optimal == Outcome::done) last_cost_ = cost;
        if (optimal == Outcome::stuck && attempt == 0) continue;
        VertexBound result = bound_at_corner(cost);
        if (optimal == Outcome::done)
            result.status = VertexBound::Status::optimal;
        else
            corner_.clear();
        return result;
    }
    return {};
}

}  // namespace camopt
