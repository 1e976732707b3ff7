// SPDX-License-Identifier: MIT
#include "objectives/laws/segment_law.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double same_velocity = 1e-9;  // of two laws that join, relative

[[noreturn]] void refuse(const MotionSpec& motion, std::size_t index, const std::string& found,
                         const std::string& allowed) {
    throw SceneError(
        {segment_key(index, "law"), fmt::format("\"{}\", {}", motion.segments[index].law, found), allowed});
}

/// A law where it ends, or begins, from inside.
MotionPoint end_of(const Law& law, bool at_end) {
    return at_end ? law.at(1.0, Side::left) : law.at(0.0, Side::right);
}

/// One segment of a program among its neighbours.
class SegmentLaw {
 public:
    SegmentLaw(const MotionSpec& motion, std::size_t index) : motion_(motion), index_(index) {}

    [[nodiscard]] std::shared_ptr<const Law> made() const {
        if (segment().takes_states()) return polynomial();
        std::shared_ptr<const Law> law = make_law(segment().law);
        if (!law->info().rests) require_same_velocities(*law);
        if (law->info().top != TopEnd::turning_point) return law;
        if (turned_at_begin()) return make_reversed(std::move(law));
        return law;
    }

    /// Of the motion where this segment ends, or begins.
    [[nodiscard]] JointState joint(bool after) const {
        const std::optional<std::size_t> other = neighbour(after);
        const std::size_t before = after ? index_ : other.value_or(index_);
        const std::optional<SetPoint>& given = other   ? motion_.segments[before].end
                                               : after ? motion_.end
                                                       : motion_.start;
        if (given) {
            const double angle = motion_.segments[before].angle;
            JointState state{given->velocity.value_or(0.0) / angle, {}};
            if (given->acceleration || !other)
                state.acceleration = given->acceleration.value_or(0.0) / (angle * angle);
            return state;
        }
        if (!other) return {};
        const ProgramSegment& beside = motion_.segments[*other];
        if (beside.kind != SegmentKind::law || beside.takes_states()) return {};
        const std::shared_ptr<const Law> law = make_law(beside.law);
        const MotionPoint point = end_of(*law, !after);
        const std::optional<double> rise = rise_of(*other);
        const auto in_lifts = [&rise](double derivative) -> std::optional<double> {
            if (derivative == 0.0) return 0.0;
            if (!rise) return {};
            return *rise * derivative;
        };
        return {in_lifts(point.derivative[1] / beside.angle),
                in_lifts(point.derivative[2] / (beside.angle * beside.angle))};
    }

 private:
    const MotionSpec& motion_;
    std::size_t index_;

    [[nodiscard]] const ProgramSegment& segment() const { return motion_.segments[index_]; }

    /// None: the motion begins or ends here.
    [[nodiscard]] std::optional<std::size_t> neighbour(bool after) const {
        const std::size_t count = motion_.segments.size();
        if (index_ == (after ? count - 1 : 0) && !motion_.periodic()) return {};
        return (index_ + (after ? 1 : count - 1)) % count;
    }

    /// Of a segment, in lifts; none: it is free.
    [[nodiscard]] std::optional<double> rise_of(std::size_t index) const {
        const std::size_t own = motion_.own_segments();
        const std::vector<std::optional<double>> levels = given_levels(motion_);
        const auto &from = levels[index % own], &to = levels[index % own + 1];
        if (!from || !to) return {};
        return *to - *from;
    }

    /// y' of a law or a dwell where it ends, or begins, in lifts by the cam angle; none: not known.
    [[nodiscard]] std::optional<double> velocity_of(std::size_t index, const Law* law, bool at_end) const {
        if (motion_.segments[index].kind == SegmentKind::dwell) return 0.0;
        const std::optional<double> rise = rise_of(index);
        if (law == nullptr || !rise) return {};
        return *rise * end_of(*law, at_end).derivative[1] / motion_.segments[index].angle;
    }

    /// An end that moves is joined by a spline, which takes its velocity, by a law of the same velocity, or
    /// stands where a motion begins or ends.
    void require_same_velocities(const Law& law) const {
        for (const bool after : {false, true}) {
            const std::optional<std::size_t> other = neighbour(after);
            if (!other) continue;
            const ProgramSegment& beside = motion_.segments[*other];
            if (beside.kind == SegmentKind::spline || beside.takes_states()) continue;
            const std::shared_ptr<const Law> next =
                beside.kind == SegmentKind::law ? make_law(beside.law) : nullptr;
            const auto own = velocity_of(index_, &law, after),
                       theirs = velocity_of(*other, next.get(), !after);
            const bool goes_on =
                own && theirs &&
                std::abs(*own - *theirs) <= same_velocity * std::max(std::abs(*own), std::abs(*theirs));
            if (goes_on) continue;
            refuse(motion_, index_,
                   fmt::format("a law whose ends move, next to {} of kind \"{}\"{}", segment_key(*other),
                               name_of(beside.kind),
                               own && theirs && *theirs != 0.0 ? " with another velocity" : ""),
                   "spline segments next to it, which join with its velocity, or a law that has it");
        }
    }

    /// Whether the motion turns back at once where this segment ends, or begins.
    [[nodiscard]] bool turns(bool after) const {
        const std::optional<std::size_t> other = neighbour(after);
        if (!other || motion_.segments[*other].kind == SegmentKind::dwell) return false;
        const std::optional<double> own = rise_of(index_), next = rise_of(*other);
        return own && next && *own * *next < 0.0;
    }

    /// Whether the law's top lies at the begin of the segment.
    [[nodiscard]] bool turned_at_begin() const {
        const bool at_begin = turns(false), at_end = turns(true);
        if (at_begin != at_end) return at_begin;
        refuse(motion_, index_,
               at_end ? "a law that turns back at its top, between two turning points"
                      : "a law that turns back at its top, where this motion does not turn",
               "a law that ends at rest; this one where the motion turns back at once at one end of the "
               "segment");
    }

    [[nodiscard]] std::shared_ptr<const Law> polynomial() const {
        const JointState begin = joint(false), end = joint(true);
        const std::optional<double> rise = rise_of(index_);
        if (!rise)
            refuse(motion_, index_, "of a free displacement",
                   "a displacement `to` of it and of the one before");
        if (*rise == 0.0)
            refuse(motion_, index_, "that ends at the displacement where it begins",
                   "another displacement; a spline makes a motion without a rise");
        if (!begin.velocity || !end.velocity)
            refuse(motion_, index_, "next to a law that moves on by a free displacement",
                   "a displacement `to` of that law");
        return polynomial_between({begin, end}, *rise, segment().angle);
    }
};

}  // namespace

std::shared_ptr<const Law> segment_law(const MotionSpec& motion, std::size_t index) {
    return SegmentLaw(motion, index).made();
}

std::array<JointState, 2> joint_states(const MotionSpec& motion, std::size_t index) {
    const SegmentLaw segment(motion, index);
    return {segment.joint(false), segment.joint(true)};
}

std::shared_ptr<const Law> polynomial_between(const std::array<JointState, 2>& ends, double rise,
                                              double width) {
    const double velocity = width / rise, acceleration = velocity * width;
    EndStates states{ends[0].velocity.value() * velocity, ends[1].velocity.value() * velocity};
    if (ends[0].acceleration) states.start_acceleration = *ends[0].acceleration * acceleration;
    if (ends[1].acceleration) states.end_acceleration = *ends[1].acceleration * acceleration;
    return make_polynomial(states);
}

std::vector<std::optional<double>> given_levels(const MotionSpec& motion) {
    const std::size_t count = motion.own_segments();
    std::vector<std::optional<double>> levels(count + 1);
    levels[0] = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const ProgramSegment& segment = motion.segments[i];
        levels[i + 1] = segment.kind == SegmentKind::dwell ? levels[i] : segment.to;
    }
    if (motion.closed) levels[count] = 0.0;
    for (std::size_t i = count; i > 0 && motion.segments[i - 1].kind == SegmentKind::dwell; --i)
        levels[i - 1] = levels[i];
    return levels;
}

}  // namespace camopt
