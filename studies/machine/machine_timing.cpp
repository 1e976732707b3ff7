// SPDX-License-Identifier: MIT
// Segment angles given as ranges in the axes of a machine: a pattern search around the program of fixed
// angles.
//
// A step takes an angle d from one segment of an axis and gives it to another one; d is halved where no step
// helps. From several starts; the result is a local optimum, its proof is that of the angles found. Where the
// speed is searched, other angles are asked one thing first: is there a motion at a speed above the best one?
#include "studies/machine/machine_build.hpp"

#include <fmt/format.h>

#include <random>

namespace camopt {

namespace {

constexpr int most_starts = 3;
constexpr double first_part = 0.25;                 // of the widest range: the first step
constexpr double least_step = 0.1 * units::degree;  // the last one
constexpr double rough_gap = 2e-3, telling = 1e-6;  // relative: of trials; what counts as better
constexpr double least_gain = 2e-4;                 // relative: of a speed, to be worth other angles
constexpr double part_of_time = 0.7;                // of the whole, for the search

/// A pair of segments of one axis that an angle can be moved between.
struct Exchange {
    std::size_t axis = 0, from = 0, to = 0;
};

std::vector<ProgramSegment>& segments_of(MachineSpec& machine, std::size_t axis) {
    return machine.axes[axis].scene.motion.segments;
}

std::vector<Exchange> exchanges_of(const MachineSpec& machine) {
    std::vector<Exchange> all;
    for (std::size_t a = 0; a < machine.axes.size(); ++a) {
        const MotionSpec& motion = machine.axes[a].scene.motion;
        for (std::size_t i = 0; i < motion.own_segments(); ++i)
            for (std::size_t j = 0; j < motion.own_segments(); ++j)
                if (i != j && motion.segments[i].angle_range && motion.segments[j].angle_range)
                    all.push_back({a, i, j});
    }
    return all;
}

/// Moves the angle as far as the ranges allow; how far.
double move(MachineSpec& machine, const Exchange& pair, double angle) {
    std::vector<ProgramSegment>& segments = segments_of(machine, pair.axis);
    const std::size_t own = machine.axes[pair.axis].scene.motion.own_segments();
    const ProgramSegment &from = segments[pair.from], &to = segments[pair.to];
    angle = std::min({angle, from.angle - from.angle_range->least, to.angle_range->most - to.angle});
    if (!(angle > 0.0)) return 0.0;
    for (std::size_t k = 0; k < segments.size(); k += own) {  // copies are the same
        segments[k + pair.from].angle -= angle;
        segments[k + pair.to].angle += angle;
    }
    return angle;
}

/// The same machine with its angles as they are.
MachineSpec with_fixed_angles(MachineSpec machine) {
    for (AxisSpec& axis : machine.axes)
        for (ProgramSegment& segment : axis.scene.motion.segments) segment.angle_range.reset();
    return machine;
}

class TimingSearch {
 public:
    TimingSearch(const MachineOptions& options, const SolveControl& control, const FixedMachine& fixed)
        : options_(options), control_(control.sooner(part_of_time * options_.max_seconds)), fixed_(fixed) {
        options_.explain = false;
        options_.speed_gap = std::max(options_.speed_gap, rough_gap);
    }

    /// Of the angles given, and the machine with the best found.
    MachineSpec run(const MachineSpec& given, MachineTiming& timing) {
        const std::vector<Exchange> pairs = exchanges_of(given);
        for (const Exchange& pair : pairs) {
            const AngleRange& range = *given.axes[pair.axis].scene.motion.segments[pair.from].angle_range;
            widest_ = std::max(widest_, range.most - range.least);
        }
        Scored best = scored(given, {});
        timing.given = best.value;
        best = improved(std::move(best), pairs);
        for (unsigned start = 1; start < most_starts && !control_.ending(); ++start) {
            Scored other = improved(scored(shuffled(given, pairs, start), {}), pairs);
            if (better(other, best)) best = std::move(other);
        }
        timing.tried = tried_;
        timing.complete = !control_.ending();
        return std::move(best.machine);
    }

 private:
    struct Scored {
        MachineSpec machine;
        std::optional<double> value;  ///< speed, or total objective; none: no motions
    };

    /// `to_pass`: what does not come above this speed needs no value.
    [[nodiscard]] Scored scored(MachineSpec machine, std::optional<double> to_pass) {
        ++tried_;
        Scored result{std::move(machine), {}};
        MachineSpec fixed = with_fixed_angles(result.machine);
        try {
            if (to_pass && fixed.searches_speed()) {
                fixed.least_speed = *to_pass * (1.0 + least_gain);
                if (fixed.least_speed < fixed.most_speed)
                    result.value = fixed_.passing(fixed, options_, control_);
                return result;
            }
            const MachineSolution found = fixed_.solve(fixed, options_, control_);
            if (!found.axes.empty())
                result.value = result.machine.searches_speed() ? found.speed : found.certificate.objective;
        } catch (const InputError&) {  // these angles make no scene: a stroke too short for its set points
        }
        return result;
    }

    [[nodiscard]] static bool better(const Scored& tried, const Scored& known) {
        if (!tried.value || !known.value) return tried.value.has_value() && !known.value;
        const double gain = tried.machine.searches_speed()
                                ? *tried.value / *known.value - 1.0
                                : (*known.value - *tried.value) / std::abs(*known.value);
        return gain > telling;
    }

    [[nodiscard]] Scored improved(Scored best, const std::vector<Exchange>& pairs) {
        for (double step = first_part * widest_; step >= least_step && !control_.ending(); step *= 0.5) {
            bool helped = true;
            while (helped && !control_.ending()) {
                helped = false;
                for (const Exchange& pair : pairs) {
                    if (control_.ending()) break;
                    MachineSpec moved = best.machine;
                    if (move(moved, pair, step) < 0.5 * std::min(step, least_step)) continue;
                    Scored next = scored(std::move(moved), best.value);
                    if (!better(next, best)) continue;
                    best = std::move(next);
                    helped = true;
                }
            }
        }
        return best;
    }

    [[nodiscard]] MachineSpec shuffled(MachineSpec machine, const std::vector<Exchange>& pairs,
                                       unsigned seed) const {
        std::mt19937 engine(seed);
        for (const Exchange& pair : pairs) {
            const double part = static_cast<double>(engine()) / 4294967295.0;
            move(machine, pair, part * widest_ / static_cast<double>(pairs.size()));
        }
        return machine;
    }

    MachineOptions options_;
    SolveControl control_;
    const FixedMachine& fixed_;
    double widest_ = 0.0;
    int tried_ = 0;
};

}  // namespace

bool searches_timing(const MachineSpec& machine) {
    return !exchanges_of(machine).empty();
}

MachineSolution solve_with_timing(const MachineSpec& machine, const MachineOptions& options,
                                  const SolveControl& control, const FixedMachine& fixed) {
    MachineTiming timing;
    const MachineSpec best = TimingSearch(options, control, fixed).run(machine, timing);
    MachineSolution solution =
        fixed.solve(with_fixed_angles(best), options, control.sooner(options.max_seconds));
    for (const AxisSpec& axis : machine.axes) {
        std::vector<bool>& searched = timing.searched.emplace_back();
        for (const ProgramSegment& segment : axis.scene.motion.segments)
            searched.push_back(segment.angle_range.has_value());
    }
    if (!solution.axes.empty() && solution.certificate.verdict == Verdict::optimal)
        solution.certificate.verdict = Verdict::local;
    const double now = machine.searches_speed() ? solution.speed : solution.certificate.objective;
    const auto shown = [&](double value) {
        return machine.searches_speed() ? fmt::format("{:.6g} rpm", value / units::revolution_per_minute)
                                        : fmt::format("a total objective of {:.6g}", value);
    };
    if (!solution.axes.empty())
        solution.notes.push_back(
            timing.given
                ? fmt::format("segment angles were searched ({} tried{}): {} instead of {} with the angles "
                              "given, {:.3g} % better; a local optimum, the proof is that of these angles",
                              timing.tried, timing.complete ? "" : ", the time was over", shown(now),
                              shown(*timing.given),
                              100.0 * std::abs(now - *timing.given) / std::abs(*timing.given))
                : fmt::format("segment angles were searched ({} tried): with the angles given no motions "
                              "were found",
                              timing.tried));
    solution.timing = timing;
    return solution;
}

}  // namespace camopt
