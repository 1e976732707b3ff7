// SPDX-License-Identifier: MIT
// Private to profiles/remote: the linkages and the cam's roller, generic over the scalar, so that double
// gives points and automatic differentiation gives partials.
//
// A link turns about a fixed pivot; its direction u is a unit vector, its rates are by the output s. A dyad
// puts the joint of a link on its circle at the coupler's length from a moving joint E: with v = E − pivot,
// arm c and coupler b
//   joint − pivot = p v ± q v⊥,   p = (v² + c² − b²)/(2 v²),   q = √(c²/v² − p²)   (+: left of v)
// and, f = ½ |joint − E|² being constant, its angle α(s) has
//   α₁ = −f_s/f_α,   α₂ = −(f_αα α₁² + 2 f_αs α₁ + f_ss)/f_α.
#pragma once

#include "profiles/remote/remote_layout.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt::remote {

template <class T>
struct Vector {
    T x, y;
};
template <class T>
Vector<T> sum(const Vector<T>& a, const Vector<T>& b) {
    return {T(a.x + b.x), T(a.y + b.y)};
}
template <class T>
Vector<T> difference(const Vector<T>& a, const Vector<T>& b) {
    return {T(a.x - b.x), T(a.y - b.y)};
}
template <class T>
Vector<T> scaled(const T& factor, const Vector<T>& a) {
    return {T(factor * a.x), T(factor * a.y)};
}
template <class T>
Vector<T> across(const Vector<T>& a) {  ///< turned by +90 degrees
    return {T(-a.y), a.x};
}
template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
    return T(a.x * b.x + a.y * b.y);
}
template <class T>
Vector<T> direction(const T& angle) {
    using std::cos;
    using std::sin;
    return {T(cos(angle)), T(sin(angle))};
}
template <class T>
Vector<T> turned(const Vector<T>& a, const Vector<T>& by) {  ///< by: a direction
    return {T(a.x * by.x - a.y * by.y), T(a.x * by.y + a.y * by.x)};
}

/// A joint and its derivatives by s.
template <class T>
struct Joint {
    Vector<T> at, first, second;
};

/// Where an arm of a link points, and the link's angle's derivatives by s.
template <class T>
struct Turning {
    Vector<T> direction;
    T first, second;
};

/// The joint at the end of an arm.
template <class T>
Joint<T> end_of(const Vector<T>& pivot, const T& arm, const Turning<T>& link) {
    const Vector<T> along = scaled(arm, link.direction), side = across(along);
    const T squared = link.first * link.first;
    return {sum(pivot, along), scaled(link.first, side),
            difference(scaled(link.second, side), scaled(squared, along))};
}

template <class T>
struct Dyad {
    Vector<T> pivot;
    T arm, coupler;
    double branch;  ///< +1: left of the line from the pivot to the far joint, −1: right
};

/// The relation of a dyad's arm to the far joint of its coupler.
template <class T>
Turning<T> follow(const Dyad<T>& dyad, const Joint<T>& far) {
    using std::sqrt;
    const Vector<T> v = difference(far.at, dyad.pivot);
    const T squared = dot(v, v);
    const T arm_squared = dyad.arm * dyad.arm;
    const T p = T(squared + arm_squared - dyad.coupler * dyad.coupler) / T(squared + squared);
    const T height = T(arm_squared / squared) - T(p * p);
    const T q = T(sqrt(height)) * dyad.branch;
    const Vector<T> arm = sum(scaled(p, v), scaled(q, across(v)));  // joint − pivot
    const Vector<T> swing = across(arm);
    const Vector<T> gap = difference(arm, v);  // joint − far joint
    const T f_a = dot(gap, swing), f_s = T(-dot(gap, far.first));
    const T f_aa = arm_squared - dot(gap, arm), f_as = T(-dot(swing, far.first));
    const T f_ss = dot(far.first, far.first) - dot(gap, far.second);
    const T first = T(-f_s) / f_a;
    const T mixed = T(f_as * first) * 2.0;
    const T pure = T(f_aa * first) * first;
    const T second = T(-T(pure + mixed + f_ss)) / f_a;
    return {{T(arm.x / dyad.arm), T(arm.y / dyad.arm)}, first, second};
}

/// A linkage with its numbers: from output s to the direction of the roller's arm.
template <class T>
struct Linkage {
    RemoteLinkage type = RemoteLinkage::lever;
    double lever_branch = 1.0, rocker_branch = 1.0;
    std::array<T, remote_dimension_count> dimensions;

    const T& operator[](RemoteDimension index) const { return dimensions[static_cast<std::size_t>(index)]; }
    [[nodiscard]] Vector<T> at(RemoteDimension x, RemoteDimension y) const {
        return {(*this)[x], (*this)[y]};
    }
    [[nodiscard]] Vector<T> lever_pivot() const {
        return at(RemoteDimension::lever_pivot_x, RemoteDimension::lever_pivot_y);
    }
    [[nodiscard]] Vector<T> rocker_pivot() const {
        return at(RemoteDimension::rocker_pivot_x, RemoteDimension::rocker_pivot_y);
    }

    [[nodiscard]] Turning<T> swinging_output(const T& s) const {
        return {direction(T((*this)[RemoteDimension::output_angle] + s)), T(s * 0.0 + 1.0), T(s * 0.0)};
    }
    [[nodiscard]] Joint<T> slider(const T& s) const {
        const Vector<T> way = direction((*this)[RemoteDimension::slider_angle]);
        const T zero = s * 0.0;
        return {
            sum(at(RemoteDimension::slider_x, RemoteDimension::slider_y), scaled(s, way)), way, {zero, zero}};
    }
    [[nodiscard]] Dyad<T> lever_dyad() const {
        return {lever_pivot(), (*this)[RemoteDimension::lever_arm], (*this)[RemoteDimension::coupler],
                lever_branch};
    }
    [[nodiscard]] Dyad<T> rocker_dyad() const {
        return {rocker_pivot(), (*this)[RemoteDimension::rocker_output_arm],
                (*this)[RemoteDimension::second_coupler], rocker_branch};
    }
    /// Its output arm; two dyads.
    [[nodiscard]] Turning<T> rocker(const T& s) const { return follow(rocker_dyad(), slider(s)); }
    /// The joint of the coupler far from the lever; absent for a lever alone.
    [[nodiscard]] Joint<T> far_joint(const T& s) const {
        if (type == RemoteLinkage::lever_coupler_slider) return slider(s);
        Turning<T> input = swinging_output(s);
        if (type == RemoteLinkage::lever_coupler_lever_coupler_slider) {
            input = rocker(s);
            input.direction = turned(input.direction, direction((*this)[RemoteDimension::rocker_angle]));
        }
        return end_of(rocker_pivot(), (*this)[RemoteDimension::rocker_input_arm], input);
    }
    [[nodiscard]] Turning<T> roller_arm(const T& s) const {
        if (type == RemoteLinkage::lever) return swinging_output(s);
        Turning<T> arm = follow(lever_dyad(), far_joint(s));
        arm.direction = turned(arm.direction, direction(T(-(*this)[RemoteDimension::lever_angle])));
        return arm;
    }
};

/// The roller's centre C in the frame of its arm, from the cam's centre: along the arm and across it (at +90
/// degrees), and the arm's angle's derivatives by the cam angle. σ: the cam's sense. With the velocity
/// V = C' − σ z × C in the cam frame the outward normal is n = σ z × V/|V|, so that
///   n · along |V| = C_along − σ l ψ',   n · across |V| = C_across.
template <class T>
struct RollerState {
    T along, across, arm, velocity, acceleration;
    double sense = 1.0;
    T ratio;  ///< of the arm's angle to the output: ψ_s

    [[nodiscard]] T normal_along() const { return T(along - T(arm * velocity) * sense); }
    [[nodiscard]] const T& normal_across() const { return across; }
    [[nodiscard]] T speed() const {
        using std::sqrt;
        const T a = normal_along();
        return T(sqrt(T(a * a + across * across)));
    }
    /// κ |V|³ = −σ V × V', V' in the cam frame.
    [[nodiscard]] T turning() const {
        const T v_along = across * sense, v_across = T(-normal_along()) * sense;
        const T swing = arm * velocity;
        const T a_along = T(swing * (2.0 * sense)) - T(swing * velocity) - along;
        const T a_across = T(arm * acceleration) - across;
        return T(T(T(v_along * a_across) - T(v_across * a_along)) * (-sense));
    }
    [[nodiscard]] T curvature() const {
        const T w = speed();
        return turning() / T(T(w * w) * w);
    }
};

/// The output's state through the linkage; arm: linkage.roller_arm(output[0]), the expensive part.
template <class T>
RollerState<T> roller_state(const Linkage<T>& linkage, const Turning<T>& arm, const std::array<T, 3>& output,
                            double sense) {
    const Vector<T> pivot =
        difference(linkage.lever_pivot(), linkage.at(RemoteDimension::center_x, RemoteDimension::center_y));
    const T& length = linkage[RemoteDimension::roller_arm];
    const T velocity = arm.first * output[1];
    const T acceleration = T(T(arm.second * output[1]) * output[1]) + T(arm.first * output[2]);
    return {T(dot(pivot, arm.direction) + length),
            dot(pivot, across(arm.direction)),
            length,
            velocity,
            acceleration,
            sense,
            arm.first};
}

}  // namespace camopt::remote

namespace camopt {

// Private to profiles/remote: the formulas of a mechanism with its numbers.

template <class T>
struct RemoteEvaluation {
    remote::Linkage<T> linkage;
    double sense = 1.0, side = 1.0;
    PressurePoint pressure_point = PressurePoint::roller_center;

    RemoteEvaluation(const RemoteLayout& layout, const std::array<T, remote_dimension_count>& dimensions)
        : linkage{layout.linkage, layout.lever_branch, layout.rocker_branch, dimensions},
          sense(sense_of(layout.rotation)),
          side(layout.side),
          pressure_point(layout.pressure_point) {}

    [[nodiscard]] remote::RollerState<T> roller(const std::array<T, 3>& output) const {
        return roller(linkage.roller_arm(output[0]), output);
    }
    [[nodiscard]] remote::RollerState<T> roller(const remote::Turning<T>& arm,
                                                const std::array<T, 3>& output) const {
        return remote::roller_state(linkage, arm, output, sense);
    }
    [[nodiscard]] T numerator(const remote::RollerState<T>& roller) const {
        const T along = roller.normal_along();
        if (pressure_point == PressurePoint::roller_center) return T(along * side);
        const T radius = T(linkage[RemoteDimension::roller_radius] / roller.arm);
        return T(along - T(radius * roller.speed())) * side;
    }
    [[nodiscard]] T denominator(const remote::RollerState<T>& roller) const {
        return T(roller.normal_across() * side);
    }
    [[nodiscard]] T regularity(const remote::RollerState<T>& roller) const {
        return T(-T(linkage[RemoteDimension::roller_radius] * roller.curvature())) + 1.0;
    }
};

namespace remote {

inline std::array<double, remote_dimension_count> numbers(std::span<const double> dimensions) {
    std::array<double, remote_dimension_count> all{};
    std::copy_n(dimensions.begin(), remote_dimension_count, all.begin());
    return all;
}

inline std::array<double, 3> numbers(const FollowerState& state) {
    return {state.s, state.velocity, state.acceleration};
}

inline RemoteEvaluation<double> evaluation(const RemoteLayout& layout, std::span<const double> dimensions) {
    return {layout, numbers(dimensions)};
}

}  // namespace remote
}  // namespace camopt
