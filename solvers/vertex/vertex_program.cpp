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
// A step may leave rows violated, or multipliers negative, by this: half of what counts as satisfied.
constexpr double passed_by = 0.5e-10;
// Smaller pivots, relative to the largest entry, are round-off: taken, they make a singular corner.
constexpr double least_pivot = 1e-7;
// Right-hand sides are perturbed by up to twice this.
constexpr double moved_by = 1e-9;
// Costs of dual steps are perturbed by up to twice this part of the largest, so that multipliers are
// distinct.
constexpr double moved_cost = 0.5e-5;
// Steps after which the inverse is recomputed.
constexpr int refactor_every = 50;
constexpr int most_steps_a_variable = 60;
constexpr int clock_every = 32;
// Live rows a variable to begin with; violated ones join them at once by this part of the variables.
constexpr int most_live = 8;
constexpr double most_woken = 0.1;

/// The longest step that passes no row by more than `passed_by`, and of the rows met within it that of the
/// largest pivot: of nearly parallel rows, met at nearly the same step, two would make a singular corner.
/// Source: P. Harris, Pivot selection methods of the Devex LP code, Math. Program. 5 (1973).
class RatioTest {
 public:
    explicit RatioTest(double least) : steepest_(least) {}
    /// First of all rows: the room and the speed at which a step uses it up.
    void limit(double room, double speed) {
        const double most = std::max(0.0, room) + passed_by;
        if (most < longest_ * speed && speed > steepest_) longest_ = most / speed;
    }
    /// Then of all rows: the best yet.
    [[nodiscard]] bool takes(double room, double speed) {
        if (speed <= steepest_ || room > longest_ * speed) return false;
        steepest_ = speed;
        return true;
    }

 private:
    double longest_ = infinity, steepest_;
};

}  // namespace

VertexProgram::VertexProgram(Eigen::VectorXd lower, Eigen::VectorXd upper)
    : lower_(std::move(lower)), upper_(std::move(upper)) {
    if (!lower_.allFinite() || !upper_.allFinite())
        throw ModelError("vertex program: found an infinite bound of a variable; allowed: finite ones");
    lower_on_.assign(static_cast<std::size_t>(lower_.size()), 0);
    upper_on_ = lower_on_;
}

double VertexProgram::noise() {
    noise_ ^= noise_ << 13;
    noise_ ^= noise_ >> 7;
    noise_ ^= noise_ << 17;
    return 1.0 + static_cast<double>(noise_ >> 11) * 0x1p-53;
}

void VertexProgram::add_row(const Eigen::VectorXd& a, double b) {
    const int row = rows();
    const double largest = a.size() > 0 ? a.cwiseAbs().maxCoeff() : 0.0;
    const double factor = largest > 0.0 ? std::exp2(-std::ilogb(largest)) : 1.0;
    normals_.add(factor * a);
    factor_.push_back(factor);
    side_.push_back(factor * b);
    moved_.push_back(side_.back() + moved_by * noise() * std::max(1.0, std::abs(side_.back())));
    row_on_.push_back(0);
    is_live_.push_back(0);
    if (!corner_.empty()) make_live(row);
}

void VertexProgram::make_live(int row) {
    is_live_[static_cast<std::size_t>(row)] = 1;
    live_.push_back(row);
    live_normals_.add(normals_, row);
    room_.conservativeResize(room_.size() + 1);
    room_[room_.size() - 1] = moved_[static_cast<std::size_t>(row)] - normals_.dot(row, x_);
}

void VertexProgram::keep_live(const std::vector<int>& rows) {
    std::ranges::fill(is_live_, 0);
    live_.clear();
    live_normals_ = {};
    room_.resize(0);
    for (const int row : rows) make_live(row);
}

/// Of too many live rows those of the most room, apart from the corner's.
void VertexProgram::rest_idle_rows() {
    const int most = most_live * variables();
    if (static_cast<int>(live_.size()) <= 2 * most) return;
    std::vector<std::pair<double, int>> rooms;
    for (std::size_t k = 0; k < live_.size(); ++k)
        rooms.emplace_back(on_face(live_[k]) ? -infinity : room_[static_cast<Eigen::Index>(k)], live_[k]);
    std::ranges::nth_element(rooms, rooms.begin() + most);
    std::vector<int> stay;
    stay.reserve(static_cast<std::size_t>(most));
    for (int k = 0; k < most; ++k) stay.push_back(rooms[static_cast<std::size_t>(k)].second);
    std::ranges::sort(stay);
    keep_live(stay);
}

/// The rows that the corner violates most, of those that steps have not looked at. False: there is none.
bool VertexProgram::wake_violated_rows() {
    const Eigen::VectorXd activity = normals_.times(x_);
    std::vector<std::pair<double, int>> violated;
    for (int i = 0; i < rows(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        const double room = moved_[row] - activity[i];
        if (room < -kept_side && !is_live_[row]) violated.emplace_back(room, i);
    }
    const auto most =
        std::min(violated.size(), static_cast<std::size_t>(std::ceil(most_woken * variables())));
    std::ranges::partial_sort(violated, violated.begin() + static_cast<std::ptrdiff_t>(most));
    for (std::size_t k = 0; k < most; ++k) make_live(violated[k].second);
    return most > 0;
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
    }
    normals_.keep(stay);
    for (std::vector<double>* values : {&factor_, &side_, &moved_}) values->resize(stay.size());
    row_on_.resize(stay.size());
    is_live_.resize(stay.size());
    for (Face& face : corner_)
        if (face >= 0) face = place[static_cast<std::size_t>(face)];
    std::vector<int> live;
    for (const int row : live_)
        if (place[static_cast<std::size_t>(row)] >= 0) live.push_back(place[static_cast<std::size_t>(row)]);
    keep_live(live);
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
    keep_live({});
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
    room_ = -live_normals_.times(x_);
    for (std::size_t k = 0; k < live_.size(); ++k)
        room_[static_cast<Eigen::Index>(k)] += moved_[static_cast<std::size_t>(live_[k])];
    since_refactor_ = 0;
    return true;
}

bool VertexProgram::exchange(Eigen::Index leaving, Face entering, const Eigen::VectorXd& shares,
                             const Eigen::VectorXd& rise) {
    const Eigen::VectorXd column = inverse_.col(leaving) / shares[leaving];
    const double step = side(entering) - normal(entering).dot(x_);
    x_ += step * column;
    room_ += (step / shares[leaving]) * rise;
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
        for (Eigen::Index k = 0; k < room_.size(); ++k) {
            const int row = live_[static_cast<std::size_t>(k)];
            if (room_[k] < -worst && !on_face(row)) {
                worst = -room_[k];
                entering = row;
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
        RatioTest test(least_pivot * shares.cwiseAbs().maxCoeff());
        for (Eigen::Index k = 0; k < shares.size(); ++k) test.limit(multipliers[k], shares[k]);
        for (Eigen::Index k = 0; k < shares.size(); ++k)
            if (test.takes(multipliers[k], shares[k])) leaving = k;
        if (leaving < 0) {
            ray_ = -shares;
            ray_face_ = *entering;
            return Outcome::infeasible;
        }
        if (!exchange(leaving, *entering, shares, live_normals_.times(-inverse_.col(leaving))))
            return Outcome::stuck;
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
        const Eigen::VectorXd rise = live_normals_.times(along);
        std::optional<Face> entering;
        RatioTest test(least_pivot * along.cwiseAbs().maxCoeff());
        const auto each = [&](const auto& visit) {
            for (Eigen::Index k = 0; k < rise.size(); ++k)
                visit(live_[static_cast<std::size_t>(k)], room_[k], rise[k]);
            for (Eigen::Index j = 0; j < lower_.size(); ++j) {
                visit(upper_face(j), upper_[j] - x_[j], along[j]);
                visit(lower_face(j), x_[j] - lower_[j], -along[j]);
            }
        };
        each([&](Face, double room, double speed) { test.limit(room, speed); });
        each([&](Face face, double room, double speed) {
            if (test.takes(room, speed)) entering = face;
        });
        if (!entering) return Outcome::stuck;
        const Eigen::VectorXd shares = inverse_.transpose() * normal(*entering);
        if (!exchange(leaving, *entering, shares, rise)) return Outcome::stuck;
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
    double sum = 0.0;  // of the multipliers of rows scaled to size 1
    const auto add = [&](Face face, double multiplier) {
        if (face < 0 || !(multiplier > 0.0)) return;
        result.multipliers.emplace_back(face, multiplier * factor_[static_cast<std::size_t>(face)]);
        sum += multiplier;
    };
    add(ray_face_, 1.0);
    for (Eigen::Index k = 0; k < ray_.size(); ++k) add(corner_[static_cast<std::size_t>(k)], ray_[k]);
    const double excess = bound_of(Eigen::VectorXd::Zero(lower_.size()), result.multipliers);
    if (!(excess > least_contradiction * sum)) return result;
    result.status = VertexBound::Status::infeasible;
    result.bound = infinity;
    return result;
}

/// Near to the given cost, and the corner is optimal for it: all its multipliers are above 0 and distinct, so
/// that dual steps do not stall.
Eigen::VectorXd VertexProgram::cost_of_corner(const Eigen::VectorXd& cost) {
    const double size = moved_cost * std::max(1e-300, cost.cwiseAbs().maxCoeff());
    const Eigen::VectorXd multipliers = face_multipliers(cost);
    Eigen::VectorXd moved = cost;
    for (Eigen::Index k = 0; k < multipliers.size(); ++k)
        moved -=
            (std::max(0.0, -multipliers[k]) + size * noise()) * normal(corner_[static_cast<std::size_t>(k)]);
    return moved;
}

/// From the last corner to one that satisfies the live rows, from there to that of the cost, and on while it
/// violates others.
VertexProgram::Outcome VertexProgram::reach(const Eigen::VectorXd& cost, const SolveControl& control) {
    do {
        if (control.ending()) return Outcome::ended;
        Outcome outcome = reach_feasible(cost_of_corner(cost), control);
        if (outcome == Outcome::done) outcome = reach_optimal(cost, control);
        if (outcome != Outcome::done) return outcome;
    } while (wake_violated_rows());
    return Outcome::done;
}

VertexBound VertexProgram::minimize(const Eigen::VectorXd& cost, const SolveControl& control) {
    for (const bool again : {true, false}) {
        if (corner_.empty() || !again)
            start_at_bounds(cost);
        else
            rest_idle_rows();
        const Outcome outcome = reach(cost, control);
        if (outcome == Outcome::stuck && again) continue;
        VertexBound result = outcome == Outcome::infeasible ? infeasible_bound() : bound_at_corner(cost);
        if (outcome == Outcome::infeasible && again && result.status != VertexBound::Status::infeasible)
            continue;
        if (outcome == Outcome::done)
            result.status = VertexBound::Status::optimal;
        else
            corner_.clear();
        return result;
    }
    return {};
}

}  // namespace camopt
