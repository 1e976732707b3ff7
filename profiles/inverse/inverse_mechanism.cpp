// SPDX-License-Identifier: MIT
#include "profiles/inverse/inverse_mechanism.hpp"

#include "core/errors.hpp"
#include "profiles/inverse/inverse_formulas.hpp"
#include "profiles/inverse/inverse_spec.hpp"
#include "scene/cam_flanks.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using enum InverseNumber;
constexpr int station_count = 2;
constexpr int angle_column = 3;   // of the partials: s, s', s'', θ, numbers
constexpr int reach_places = 64;  // displacements at which the reach is tested
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

double number(std::span<const double> numbers, InverseNumber which) {
    return numbers[static_cast<std::size_t>(which)];
}

/// +1 on the left wall, −1 on the right one.
double wall_sign(int station) {
    return station == 0 ? 1.0 : -1.0;
}

/// The roller at a cam angle, over any scalar.
template <class T>
inverse::Roller<T> roller_at(const std::array<T, inverse_number_count>& numbers, const T& theta) {
    using std::sqrt;
    const auto of = [&](InverseNumber which) { return numbers[static_cast<std::size_t>(which)]; };
    const T begin = sqrt(T(of(roller_from) - of(roller_rest)));
    const T rate = T(sqrt(T(of(roller_end) - of(roller_rest)))) / of(roller_angle);
    const T root = begin + T(rate * theta);
    return {T(of(roller_rest) + T(root * root)), T(2.0 * T(root * rate)), T(2.0 * T(rate * rate))};
}

/// The arguments of a quantity besides numbers.
struct Wall {
    inverse::Branch branch;
    double side = 1.0;
};

template <class T>
T value_of(MechanismQuantity which, const std::array<T, inverse_number_count>& numbers,
           const inverse::Feeder<T>& output, const T& theta, const Wall& wall) {
    const auto of = [&](InverseNumber index) { return numbers[static_cast<std::size_t>(index)]; };
    const inverse::Roller<T> roller = roller_at<T>(numbers, theta);
    if (which == MechanismQuantity::pressure_denominator) return roller.velocity;
    const inverse::LinkageNumbers<T> linkage{of(pin_distance), of(rocker_pivot_x), of(rocker_pivot_y),
                                             of(feeder_offset)};
    const auto body = inverse::backwards<T>(
        linkage, wall.branch, {T(output.position + of(feeder_start)), output.velocity, output.acceleration});
    if (which == MechanismQuantity::pressure_numerator) return -T(roller.distance * body.velocity);
    const T curvature = wall.side * inverse::guide_curvature<T>(roller, body);
    if (which == MechanismQuantity::pitch_curvature) return curvature;
    if (which != MechanismQuantity::regularity) refuse_quantity(inverse_type);
    return T(1.0) - T(of(roller_radius) * curvature);
}

GuideNode node_at(std::span<const double> numbers, const FollowerState& output, double theta) {
    const FollowerState feeder{output.s + number(numbers, feeder_start), output.velocity,
                               output.acceleration};
    return wanted_guide(linkage_of(numbers), state_of(stroke_of(numbers), theta), feeder);
}

/// A mechanism over a box: its roller, its linkage, its feeder without the derivatives of its motion.
struct InverseOver {
    std::array<RangeOver, inverse_number_count> numbers;
    inverse::Roller<RangeOver> roller;
    inverse::LinkageNumbers<RangeOver> linkage;
    inverse::Branch branch;
    RangeOver position;

    explicit InverseOver(const MechanismStateOver& state) {
        std::vector<double> middle;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            numbers[i] = state.dimensions[i];
            middle.push_back(0.5 * (numbers[i].value.lower + numbers[i].value.upper));
        }
        const auto of = [&](InverseNumber which) { return numbers[static_cast<std::size_t>(which)]; };
        roller = roller_at<RangeOver>(numbers, RangeOver(state.theta));
        linkage = {of(pin_distance), of(rocker_pivot_x), of(rocker_pivot_y), of(feeder_offset)};
        branch = inverse::branch_of(linkage_of(middle));
        position = state.s + of(feeder_start);
    }
    [[nodiscard]] inverse::Backwards<RangeOver> body(const RangeOver& velocity,
                                                     const RangeOver& acceleration) const {
        return inverse::backwards<RangeOver>(linkage, branch, {position, velocity, acceleration});
    }
    /// dθ/ds of the body, which is also the coefficient of s'' in θ''.
    [[nodiscard]] RangeOver ratio() const { return body(1.0, 0.0).velocity; }
};

class InverseMechanism final : public CamMechanism,
                               public LimitStructure,
                               public MechanismEnclosures,
                               public PlaneMechanism {
 public:
    explicit InverseMechanism(std::optional<double> return_angle) : return_angle_(return_angle) {}

    [[nodiscard]] std::string type() const override { return inverse_type; }
    [[nodiscard]] bool swings() const override { return false; }
    [[nodiscard]] Rotation rotation() const override { return Rotation::counterclockwise; }
    [[nodiscard]] int stations() const override { return station_count; }
    [[nodiscard]] std::string station_name(int station) const override {
        return station == 0 ? "left wall" : "right wall";
    }
    [[nodiscard]] bool binds(MechanismQuantity which, int station) const override {
        return which == MechanismQuantity::regularity || station == 0;
    }
    [[nodiscard]] int roller_radius_at(int) const override {
        return static_cast<int>(InverseNumber::roller_radius);
    }
    [[nodiscard]] const LimitStructure& limit_structure() const override { return *this; }
    [[nodiscard]] const MechanismEnclosures* enclosures() const override { return this; }
    [[nodiscard]] const PlaneMechanism* plane() const override { return this; }
    [[nodiscard]] double length(std::span<const double> numbers) const override {
        return number(numbers, roller_end);
    }
    [[nodiscard]] std::string fault(std::span<const double> numbers, double least,
                                    double most) const override {
        const double rest = number(numbers, roller_rest), from = number(numbers, roller_from),
                     to = number(numbers, roller_end);
        if (!(rest >= 0.0 && from > rest && to > from))
            return fmt::format(
                "the roller rests at {:.6g} m, is at {:.6g} m where the rise begins and at {:.6g} m at the "
                "end of its stroke; these must ascend",
                rest, from, to);
        if (!(number(numbers, roller_angle) > 0.0)) return "the cam angle of the roller's stroke must be > 0";
        try {
            linkage_of(numbers).validate();
        } catch (const InputError& error) {
            return error.what();
        }
        for (int i = 0; i <= reach_places; ++i) {
            const double s = least + (most - least) * i / reach_places;
            const InverseFault found = node_at(numbers, {s, 0.0, 0.0}, 0.0).fault;
            if (found != InverseFault::none)
                return fmt::format("the feeder's linkage does not reach displacement {:.6g} m: {}", s,
                                   name_of(found));
        }
        return {};
    }
    [[nodiscard]] MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int station,
                                          std::span<const int> active) const override {
        if (node_at(state.dimensions, state.output, state.theta).fault != InverseFault::none) {
            const auto size = static_cast<Eigen::Index>(3 + active.size());
            return {nowhere, Eigen::VectorXd::Constant(size, nowhere),
                    Eigen::MatrixXd::Constant(size, size, nowhere)};
        }
        return active.empty() ? expanded<4>(which, state, station, active)
                              : expanded<4 + inverse_number_count>(which, state, station, active);
    }
    /// Over cos φ · L |dθ/ds|: ∓ s' and a function of s.
    [[nodiscard]] std::optional<RangeOver> pressure_over(double limit, int sign,
                                                         const MechanismStateOver& state,
                                                         int /*station*/) const override {
        const InverseOver own(state);
        const RangeOver lever = own.roller.distance * own.ratio(), turned = sign_of(lever);
        const RangeOver cosine = cos(Interval(limit)), sine = sin(Interval(limit));
        return -sign * (turned * state.velocity) - (sine * own.roller.velocity) / (cosine * (turned * lever));
    }
    /// margin − 1 ± r κ times (1 + L² ψ'²)^(3/2) L'²/(r L |dθ/ds|): linear in s''.
    [[nodiscard]] std::optional<RangeOver> regularity_over(double margin, const MechanismStateOver& state,
                                                           int station) const override {
        const InverseOver own(state);
        const auto still = inverse::guide_bend<RangeOver>(own.roller, own.body(state.velocity, 0.0));
        const RangeOver cubed = cube_of_root(squared(still.tangent) + RangeOver(1.0));
        const RangeOver radius = own.numbers[static_cast<std::size_t>(InverseNumber::roller_radius)];
        const RangeOver lever = own.roller.distance * own.ratio(), turned = sign_of(lever);
        const RangeOver room = wall_sign(station) * still.top + (margin - 1.0) * (cubed / radius);
        return room * squared(own.roller.velocity) / (turned * lever) -
               wall_sign(station) * (turned * state.acceleration);
    }
    [[nodiscard]] std::optional<RangeAlong> quantity_along(MechanismQuantity which,
                                                           const MechanismStateAlong& state,
                                                           int station) const override {
        std::array<RangeAlong, inverse_number_count> numbers;
        std::copy_n(state.dimensions.begin(), inverse_number_count, numbers.begin());
        const Wall wall{inverse::branch_of(linkage_of(state.dimensions)), wall_sign(station)};
        return value_of<RangeAlong>(which, numbers, {state.s, state.velocity, state.acceleration},
                                    state.theta, wall);
    }
    [[nodiscard]] MechanismPoint point(double theta, const MechanismState& state,
                                       int station) const override {
        const GuideNode found = node_at(state.dimensions, state.output, theta);
        MechanismPoint point;
        point.theta = theta;
        point.pitch = point.contact = point.normal = Eigen::Vector3d::Constant(nowhere);
        point.pressure_angle = point.pitch_curvature = point.cam_radius = point.regularity = nowhere;
        if (found.fault != InverseFault::none) return point;
        const PolarNode& node = found.node;
        const double radius = number(state.dimensions, InverseNumber::roller_radius),
                     side = wall_sign(station);
        const double tangent = node.distance * node.slope, secant = std::sqrt(1.0 + tangent * tangent);
        point.pressure_angle = std::atan(tangent);
        const double direction = node.angle + point.pressure_angle;
        const Eigen::Vector3d left(-std::sin(direction), std::cos(direction), 0.0);
        point.pitch = {node.distance * std::cos(node.angle), node.distance * std::sin(node.angle), 0.0};
        point.contact = point.pitch + side * radius * left;
        point.normal = -side * left;  // out of the body, towards the roller
        point.pitch_curvature = side * (node.distance * node.bend + node.slope * (2.0 + tangent * tangent)) /
                                (secant * secant * secant);
        point.cam_radius = 1.0 / point.pitch_curvature - radius;
        point.regularity = 1.0 - radius * point.pitch_curvature;
        return point;
    }
    /// The rotation of the body given by its guide.
    [[nodiscard]] CamPose pose(const MechanismState& state) const override {
        const GuideNode found = node_at(state.dimensions, state.output, state.theta);
        return {found.fault == InverseFault::none ? -found.node.angle : nowhere};
    }
    /// Body with its pin, slotted rocker, feeder; the roller, which moves along +x.
    [[nodiscard]] std::vector<MechanismShape> shapes(const MechanismState& state) const override {
        using Kind = MechanismShape::Kind;
        using Eigen::Vector2d;
        const FeederLinkage linkage = linkage_of(state.dimensions);
        const FeederMotion moved = feeder_motion(linkage, {pose(state).turn, 0.0, 0.0});
        if (moved.fault != InverseFault::none) return {};
        const Vector2d pivot = linkage.rocker_pivot;
        const double line = pivot.x() + linkage.feeder_offset, start = number(state.dimensions, feeder_start);
        const Vector2d feeder(line, start + state.output.s);
        const Vector2d roller(state_of(stroke_of(state.dimensions), state.theta).distance, 0.0);
        return {{Kind::pivot, "body_pivot", {Vector2d::Zero()}},
                {Kind::link, "body", {Vector2d::Zero(), moved.pin}},
                {Kind::link, "rocker", {moved.pin, pivot, feeder}},
                {Kind::pivot, "rocker_pivot", {pivot}},
                {Kind::guide, "feeder", {Vector2d(line, start), feeder}},
                {Kind::circle, "roller", {roller}, number(state.dimensions, InverseNumber::roller_radius)}};
    }
    /// The feeder's rest is where its displacement counts from.
    [[nodiscard]] std::optional<RollerGuide> guide(std::span<const double> numbers) const override {
        const FeederLinkage linkage = linkage_of(numbers);
        const RollerStroke stroke = stroke_of(numbers);
        RollerGuide guide;
        guide.roller_radius = number(numbers, InverseNumber::roller_radius);
        guide.distance = [stroke](double theta) { return state_of(stroke, theta).distance; };
        guide.cam_angle = [stroke](double distance) { return time_at(stroke, distance); };
        guide.angle = [linkage, start = number(numbers, feeder_start)](const FollowerState& output) {
            return -body_motion(linkage, {output.s + start, output.velocity, output.acceleration}).body.angle;
        };
        guide.ratio = [linkage](double angle) {
            return std::abs(feeder_motion(linkage, {-angle, 1.0, 0.0}).feeder.velocity);
        };
        if (return_angle_) guide.return_rate = number(numbers, roller_angle) / *return_angle_;
        return guide;
    }

 private:
    std::optional<double> return_angle_;

    template <int n>
    static MechanismValue expanded(MechanismQuantity which, const MechanismState& state, int station,
                                   std::span<const int> active) {
        std::array<SecondOrder<n>, inverse_number_count> numbers;
        for (int i = 0; i < inverse_number_count; ++i) {
            const auto place = static_cast<std::size_t>(i);
            const double value = state.dimensions[place];
            numbers[place] = n > 4 ? variable<n>(value, n > 4 ? 4 + i : 0) : constant<n>(value);
        }
        const inverse::Feeder<SecondOrder<n>> output{variable<n>(state.output.s, 0),
                                                     variable<n>(state.output.velocity, 1),
                                                     variable<n>(state.output.acceleration, 2)};
        const Wall wall{inverse::branch_of(linkage_of(state.dimensions)), wall_sign(station)};
        const auto value =
            value_of<SecondOrder<n>>(which, numbers, output, variable<n>(state.theta, angle_column), wall);
        const auto size = static_cast<Eigen::Index>(3 + active.size());
        const auto from = [&](Eigen::Index k) {
            return static_cast<std::size_t>(k < 3 ? k : 4 + active[static_cast<std::size_t>(k - 3)]);
        };
        MechanismValue result{value.value, Eigen::VectorXd(size), Eigen::MatrixXd(size, size)};
        for (Eigen::Index a = 0; a < size; ++a) {
            result.gradient(a) = value.first[from(a)];
            for (Eigen::Index b = 0; b < size; ++b)
                result.hessian(a, b) = value.second[value.pair(from(a), from(b))];
        }
        result.by_angle = value.first[angle_column];
        return result;
    }
};

}  // namespace

FeederLinkage linkage_of(std::span<const double> numbers) {
    return {number(numbers, pin_distance),
            number(numbers, pin_angle),
            {number(numbers, rocker_pivot_x), number(numbers, rocker_pivot_y)},
            number(numbers, feeder_offset)};
}

RollerStroke stroke_of(std::span<const double> numbers) {
    std::array<double, inverse_number_count> copy{};
    for (std::size_t i = 0; i < copy.size(); ++i) copy[i] = numbers[i];
    const auto start = roller_at<double>(copy, 0.0);
    const double rest = number(numbers, roller_rest);
    const double before =
        std::sqrt((number(numbers, roller_from) - rest) / (number(numbers, roller_end) - rest));
    return {0.0,
            (1.0 - before) * number(numbers, roller_angle),
            0.0,
            start.distance,
            start.velocity,
            start.acceleration};
}

CamSpec inverse_spec() {
    CamSpec spec = blank_inverse_spec();
    spec.make = inverse_mechanism;
    return spec;
}

std::shared_ptr<const CamMechanism> inverse_mechanism(const CamSpec& spec) {
    if (spec.type != inverse_type)
        throw InputError(fmt::format("a mechanism of type \"{}\"; allowed: \"inverse\"", spec.type));
    return std::make_shared<InverseMechanism>(return_angle(spec));
}

}  // namespace camopt
