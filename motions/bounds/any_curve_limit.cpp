// SPDX-License-Identifier: MIT
#include "motions/bounds/any_curve_limit.hpp"

#include "core/errors.hpp"
#include "motions/bounds/geometric_program.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// What a peak is in the program: an unknown; a number; for A the most that still helps (a² = VJ, d² = 2VJ);
/// without bound.
enum class Role { unknown, fixed, helpful, infinite };

/// Caps this near to what is just possible are met.
constexpr double relative_rounding = 1e-13;

/// Weights and caps of a half of length 1, and the roles its peaks take.
struct Half {
    MotionType type = MotionType::drd;
    double velocity_weight = 0.0, acceleration_weight = 0.0, jerk_weight = 0.0;
    std::optional<double> velocity_cap, acceleration_cap, jerk_cap;
    Role acceleration = Role::unknown;
    Role jerk = Role::unknown;
};

struct Solution {
    GeometricProgramStatus status = GeometricProgramStatus::not_converged;
    double velocity = 0.0;
    std::optional<double> acceleration, jerk;
    double up = 0.0, down = 0.0;  ///< RR: a and d
};

/// Writes products of powers of V, the accelerations and J with the roles already put in.
class Writer {
 public:
    explicit Writer(const Half& half) : half_(half) {
        if (half.jerk == Role::unknown) jerk_ = count_++;
        if (half.acceleration == Role::helpful) return;
        if (half.acceleration == Role::unknown) peak_ = count_++;
        if (half.type == MotionType::rr) {
            up_ = count_++;
            down_ = count_++;
        }
    }

    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] int jerk_index() const { return jerk_; }
    [[nodiscard]] int peak_index() const { return peak_; }
    [[nodiscard]] int up_index() const { return up_; }
    [[nodiscard]] int down_index() const { return down_; }

    /// coefficient V^v a^up d^down J^j; in a DRD motion a = d = A. Terms that vanish are left out.
    void add(Posynomial& to, double coefficient, double v, double up, double down, double j) const {
        if (half_.jerk == Role::infinite && j < 0.0) return;
        Monomial term{coefficient, std::vector<double>(static_cast<std::size_t>(count_), 0.0)};
        const double down_factor = half_.type == MotionType::rr ? 2.0 : 1.0;
        if (half_.acceleration == Role::helpful) {
            term.coefficient *= std::pow(down_factor, 0.5 * down);
            v += 0.5 * (up + down);
            j += 0.5 * (up + down);
        } else if (half_.type == MotionType::rr) {
            term.exponents[up_] = up;
            term.exponents[down_] = down;
        } else {
            multiply_peak(term, up + down);
        }
        term.exponents[0] = v;
        if (half_.jerk == Role::unknown) term.exponents[jerk_] = j;
        if (half_.jerk == Role::fixed) term.coefficient *= std::pow(*half_.jerk_cap, j);
        to.push_back(std::move(term));
    }

    /// RR: a / A <= 1 (up) or d / A <= 1.
    void add_below_peak(std::vector<Posynomial>& to, bool up) const {
        Monomial term{1.0, std::vector<double>(static_cast<std::size_t>(count_), 0.0)};
        multiply_peak(term, -1.0);
        term.exponents[up ? up_ : down_] = 1.0;
        to.push_back({term});
    }

    /// A² <= 4VJ: never active, for A² = 2VJ already is all that helps; it keeps A from running away.
    void add_peak_bound(std::vector<Posynomial>& to) const {
        Monomial term = single(peak_, 0.25);
        term.exponents[peak_] = 2.0;
        term.exponents[0] = -1.0;
        if (half_.jerk == Role::unknown) term.exponents[jerk_] = -1.0;
        if (half_.jerk == Role::fixed) term.coefficient /= *half_.jerk_cap;
        to.push_back({term});
    }

    /// coefficient times one unknown.
    [[nodiscard]] Monomial single(int index, double coefficient) const {
        Monomial term{coefficient, std::vector<double>(static_cast<std::size_t>(count_), 0.0)};
        term.exponents[index] = 1.0;
        return term;
    }

 private:
    void multiply_peak(Monomial& term, double power) const {
        if (half_.acceleration == Role::unknown) term.exponents[peak_] += power;
        if (half_.acceleration == Role::fixed) term.coefficient *= std::pow(*half_.acceleration_cap, power);
    }

    const Half& half_;
    int count_ = 1;  ///< V is unknown 0
    int jerk_ = -1, peak_ = -1, up_ = -1, down_ = -1;
};

/// Time and cruise: the constraints of the header; then the jerk's: a² <= VJ, d² <= 2VJ.
void add_motion(std::vector<Posynomial>& to, const Half& half, const Writer& writer) {
    const bool rr = half.type == MotionType::rr;
    Posynomial time, cruise;
    writer.add(time, 1.0, -1, 0, 0, 0);
    if (rr) {
        writer.add(time, 0.5, 1, -1, 0, 0);
        writer.add(time, 0.5, 0, 1, 0, -1);
        writer.add(time, 0.5, 1, 0, -1, 0);
        writer.add(time, 1.0 / 24.0, -1, 0, 3, -2);
        writer.add(cruise, 1.0, 1, -1, 0, 0);
        writer.add(cruise, 1.0, 0, 1, 0, -1);
        writer.add(cruise, 1.0, 1, 0, -1, 0);
        writer.add(cruise, 0.5, 0, 0, 1, -1);
    } else {
        writer.add(time, 1.0, 1, -1, 0, 0);
        writer.add(time, 1.0, 0, 1, 0, -1);
        writer.add(cruise, 1.0, 2, -1, 0, 0);
        writer.add(cruise, 1.0, 1, 1, 0, -1);
    }
    to.push_back(std::move(time));
    to.push_back(std::move(cruise));
    if (half.jerk == Role::infinite || half.acceleration == Role::helpful) return;
    Posynomial up;
    writer.add(up, 1.0, -1, 2, 0, -1);
    to.push_back(std::move(up));
    if (!rr) return;
    Posynomial down;
    writer.add(down, 0.5, -1, 0, 2, -1);
    to.push_back(std::move(down));
}

GeometricProgram program_of(const Half& half, const Writer& writer) {
    GeometricProgram program;
    program.variables = writer.count();
    const auto weigh = [&](int index, double weight) {
        if (index >= 0 && weight > 0.0) program.objective.push_back(writer.single(index, weight));
    };
    const auto cap = [&](int index, const std::optional<double>& limit) {
        if (index >= 0 && limit) program.constraints.push_back({writer.single(index, 1.0 / *limit)});
    };
    weigh(0, half.velocity_weight);
    weigh(writer.peak_index(), half.acceleration_weight);
    weigh(writer.jerk_index(), half.jerk_weight);
    // Caps alone: any point will do, and the least velocity is one.
    if (program.objective.empty()) program.objective.push_back(writer.single(0, 1.0));
    add_motion(program.constraints, half, writer);
    if (half.type == MotionType::rr && half.acceleration != Role::helpful) {
        writer.add_below_peak(program.constraints, true);
        writer.add_below_peak(program.constraints, false);
        if (half.jerk != Role::infinite && half.acceleration == Role::unknown)
            writer.add_peak_bound(program.constraints);
    }
    cap(0, half.velocity_cap);
    cap(writer.peak_index(), half.acceleration_cap);
    cap(writer.jerk_index(), half.jerk_cap);
    return program;
}

Solution solve_with_roles(const Half& half) {
    const Writer writer(half);
    const GeometricProgramResult result = solve(program_of(half, writer));
    Solution solution;
    solution.status = result.status;
    if (result.status != GeometricProgramStatus::optimal) return solution;
    solution.velocity = result.variables[0];
    if (half.jerk == Role::unknown) solution.jerk = result.variables[writer.jerk_index()];
    if (half.jerk == Role::fixed) solution.jerk = half.jerk_cap;
    if (half.acceleration == Role::unknown) solution.acceleration = result.variables[writer.peak_index()];
    if (half.acceleration == Role::fixed) solution.acceleration = half.acceleration_cap;
    if (half.acceleration == Role::helpful) {
        const double factor = half.type == MotionType::rr ? 2.0 : 1.0;
        solution.acceleration = std::sqrt(factor * solution.velocity * *solution.jerk);
        solution.up = std::sqrt(solution.velocity * *solution.jerk);
        solution.down = *solution.acceleration;
    } else if (half.type == MotionType::rr) {
        solution.up = result.variables[writer.up_index()];
        solution.down = result.variables[writer.down_index()];
    }
    return solution;
}

/// What single caps (and A with V) exclude whatever the jerk. From rest to rest V > 1; bang-bang acceleration
/// needs A >= 4, or V²/(V - 1) where V < 2, and more than that with bounded jerk; J >= 32 (DRD), 12 + 6√2
/// (RR).
bool caps_exclude(const Half& half) {
    if (half.velocity_cap && *half.velocity_cap <= 1.0) return true;
    const double v = std::min(2.0, half.velocity_cap.value_or(2.0));
    const double least_acceleration = v * v / (v - 1.0);
    const bool limit_counts = half.jerk == Role::infinite;
    if (half.acceleration_cap && (limit_counts ? *half.acceleration_cap < least_acceleration
                                               : *half.acceleration_cap <= least_acceleration)) {
        return true;
    }
    const double least_jerk = half.type == MotionType::drd ? 32.0 : 12.0 + 6.0 * std::sqrt(2.0);
    return half.jerk_cap && *half.jerk_cap < least_jerk * (1.0 - relative_rounding);
}

/// More jerk never harms, so a weightless one stands at its cap or at infinity. A weightless acceleration
/// takes the most that helps, or its cap where that is less (the least objective is convex in log A).
Solution solve_half(Half half) {
    // No curve from rest to rest keeps to the mean velocity.
    if (half.velocity_cap && *half.velocity_cap <= 1.0)
        return {GeometricProgramStatus::infeasible, 0.0, {}, {}};
    half.jerk = half.jerk_weight > 0.0 ? Role::unknown : half.jerk_cap ? Role::fixed : Role::infinite;
    if (caps_exclude(half)) return {GeometricProgramStatus::infeasible, 0.0, {}, {}};
    if (half.acceleration_weight > 0.0) {
        half.acceleration = Role::unknown;
        return solve_with_roles(half);
    }
    if (half.jerk != Role::infinite) {
        half.acceleration = Role::helpful;
        const Solution free = solve_with_roles(half);
        const bool within =
            !half.acceleration_cap || (free.acceleration && *free.acceleration <= *half.acceleration_cap);
        if (free.status != GeometricProgramStatus::optimal || within) return free;
    } else if (!half.acceleration_cap) {
        return {GeometricProgramStatus::optimal, 1.0, {}, {}};
    }
    half.acceleration = Role::fixed;
    return solve_with_roles(half);
}

std::vector<double> double_s_breakpoints(double velocity, double acceleration, double jerk) {
    const double ramp = acceleration / jerk;
    const double fall = std::max(ramp, velocity / acceleration);
    const double rest = std::min(0.5, fall + ramp);
    return {0.0, ramp, fall, rest, 1.0 - rest, 1.0 - fall, 1.0 - ramp, 1.0};
}

/// The half of length `width` before x = 1 and its mirror image, within [0, length].
std::vector<double> rise_and_return_breakpoints(const Solution& half, double width, double length) {
    const double ramp = half.up / *half.jerk, braking = half.down / *half.jerk;
    const double fall = std::max(ramp, half.velocity / half.up);
    const double brake =
        std::max(fall + ramp, 1.0 - half.velocity / half.down - 0.5 * braking);  // rounding of no cruise
    const std::array points = {0.0, ramp, fall, fall + ramp, brake, brake + braking};
    std::vector<double> before, after;  // x = 1
    if (width < length - 1.0) after.push_back(length);
    if (width < 1.0) before.push_back(0.0);
    for (const double point : points) {
        const double distance = width * (1.0 - std::min(point, 1.0));
        before.push_back(1.0 - distance);
        after.push_back(1.0 + distance);
    }
    before.insert(before.end(), after.rbegin(), after.rend());
    return before;
}

void require(bool sound, const char* name, double found, const char* allowed) {
    if (!sound)
        throw InputError(fmt::format("any-curve limit: {} = {} found, allowed {}", name, found, allowed));
}

std::optional<double> times(const std::optional<double>& value, double factor) {
    return value ? std::optional<double>(*value * factor) : std::nullopt;
}

}  // namespace

void AnyCurveLimitInput::validate() const {
    const auto weight = [](const char* name, double value) {
        require(value >= 0.0 && std::isfinite(value), name, value, ">= 0 and finite");
    };
    weight("velocity_weight", velocity_weight);
    weight("acceleration_weight", acceleration_weight);
    weight("jerk_weight", jerk_weight);
    if (velocity_weight + acceleration_weight + jerk_weight <= 0.0)
        throw InputError("any-curve limit: all weights are 0, at least one must be > 0");
    const auto cap = [](const char* name, const std::optional<double>& value) {
        if (value) require(*value > 0.0 && std::isfinite(*value), name, *value, "> 0 and finite");
    };
    cap("velocity_cap", velocity_cap);
    cap("acceleration_cap", acceleration_cap);
    cap("jerk_cap", jerk_cap);
    if (type == MotionType::drd) require(length == 1.0, "length", length, "1 for DRD");
    if (type == MotionType::rr)
        require(length > 1.0 && std::isfinite(length), "length", length, "> 1 for RR");
}

AnyCurveLimit any_curve_limit(const AnyCurveLimitInput& input) {
    input.validate();
    const double tau = input.type == MotionType::rr ? std::min(1.0, input.length - 1.0) : 1.0;
    Half half;
    half.type = input.type;
    half.velocity_weight = input.velocity_weight / tau;
    half.acceleration_weight = input.acceleration_weight / (tau * tau);
    half.jerk_weight = input.jerk_weight / (tau * tau * tau);
    half.velocity_cap = times(input.velocity_cap, tau);
    half.acceleration_cap = times(input.acceleration_cap, tau * tau);
    half.jerk_cap = times(input.jerk_cap, tau * tau * tau);

    const Solution solution = solve_half(half);
    AnyCurveLimit limit;
    if (solution.status == GeometricProgramStatus::infeasible) {
        limit.status = AnyCurveStatus::infeasible;
        limit.objective = std::numeric_limits<double>::infinity();
    }
    if (solution.status != GeometricProgramStatus::optimal) return limit;
    limit.status = solution.jerk ? AnyCurveStatus::reached : AnyCurveStatus::approached;
    limit.velocity = solution.velocity / tau;
    limit.acceleration = times(solution.acceleration, 1.0 / (tau * tau));
    limit.jerk = times(solution.jerk, 1.0 / (tau * tau * tau));
    limit.objective = input.velocity_weight * *limit.velocity +
                      input.acceleration_weight * limit.acceleration.value_or(0.0) +
                      input.jerk_weight * limit.jerk.value_or(0.0);
    if (!solution.jerk) return limit;
    limit.breakpoints = input.type == MotionType::drd
                            ? double_s_breakpoints(solution.velocity, *solution.acceleration, *solution.jerk)
                            : rise_and_return_breakpoints(solution, tau, input.length);
    return limit;
}

}  // namespace camopt
