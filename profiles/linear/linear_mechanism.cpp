// SPDX-License-Identifier: MIT
#include "profiles/linear/linear_mechanism.hpp"

#include "core/errors.hpp"
#include "profiles/linear/linear_formulas.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;
using enum PlateNumber;

constexpr double right_angle = 0.5 * std::numbers::pi;
constexpr double stem_of_roller =
    3.0;  // a drawn stem is as long as the plate is high, at least so many radii

double number(std::span<const double> numbers, PlateNumber which) {
    return numbers[static_cast<std::size_t>(which)];
}

constexpr int place_of(PlateNumber which) {
    return static_cast<int>(which);
}

template <class T, class Source>
plate::Numbers<T> copied(const Source& source) {
    plate::Numbers<T> numbers;
    std::copy_n(source.begin(), plate_number_count, numbers.begin());
    return numbers;
}

class LinearMechanism final : public CamMechanism,
                              public LimitStructure,
                              public MechanismEnclosures,
                              public PlaneMechanism,
                              public DirectCam {
 public:
    explicit LinearMechanism(const CamSpec& spec)
        : form_{plate_follower(spec), spec.find(name_of(travel))->middle() < 0.0 ? -1.0 : 1.0} {}

    [[nodiscard]] std::string type() const override { return linear_type; }
    [[nodiscard]] bool swings() const override { return is_on_arm(form_.follower); }
    [[nodiscard]] Rotation rotation() const override { return Rotation::counterclockwise; }
    [[nodiscard]] int stations() const override { return 1; }
    [[nodiscard]] std::string station_name(int) const override { return {}; }
    [[nodiscard]] int roller_radius_at(int) const override {
        return has_roller() ? place_of(PlateNumber::roller_radius) : -1;
    }
    [[nodiscard]] std::optional<MechanismQuantity> radius_quantity() const override {
        return MechanismQuantity::pitch_curvature;
    }
    [[nodiscard]] const LimitStructure& limit_structure() const override { return *this; }
    [[nodiscard]] const MechanismEnclosures* enclosures() const override { return this; }
    [[nodiscard]] const PlaneMechanism* plane() const override { return this; }
    [[nodiscard]] const DirectCam* direct() const override { return this; }
    /// |c|: what the plate slides for every radian.
    [[nodiscard]] double length(std::span<const double> numbers) const override {
        return std::abs(slide_of(numbers));
    }
    [[nodiscard]] std::string fault(std::span<const double> numbers, double least,
                                    double most) const override {
        if (number(numbers, travel) * form_.sense <= 0.0) return "the travel of the plate must not be 0";
        for (const PlateNumber size : {base_height, PlateNumber::roller_radius, arm_length})
            if (has_number(form_.follower, size) && !(number(numbers, size) > 0.0))
                return fmt::format("{} must be above 0", name_of(size));
        if (!swings()) {
            const double lowest =
                number(numbers, base_height) + least * std::cos(number(numbers, inclination));
            return lowest > 0.0
                       ? std::string()
                       : fmt::format("the follower goes down to {:.6g} m below the plate's bottom", -lowest);
        }
        const double start = plate::rest_angle(copied<double>(numbers));
        if (std::isnan(start)) return "the arm does not reach the plate at displacement 0";
        if (start + least > -right_angle && start + most < right_angle) return {};
        return fmt::format(
            "the arm swings from {:.4g} to {:.4g} deg against the travel; it must stay between -90 and 90 "
            "deg",
            (start + least) / units::degree, (start + most) / units::degree);
    }
    /// A range of the travel on one side of 0, beside what every mechanism needs.
    [[nodiscard]] std::optional<SceneFault> find_fault(const CamSpec& spec,
                                                       const MotionSpec& motion) const override {
        const Dimension& given = *spec.find(name_of(travel));
        if (given.high >= given.low && !(given.low * given.high > 0.0))
            return SceneFault{given.key.empty() ? "cam.travel" : given.key,
                              given.is_variable()
                                  ? fmt::format("a range from {:g} to {:g}", given.low / given.unit,
                                                given.high / given.unit)
                                  : fmt::format("{:g}", given.low / given.unit),
                              "a travel that is not 0, or a range on one side of 0"};
        return CamMechanism::find_fault(spec, motion);
    }
    [[nodiscard]] MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int,
                                          std::span<const int> active) const override {
        return active.empty() ? expanded<3>(which, state, active)
                              : expanded<3 + plate_number_count>(which, state, active);
    }

    [[nodiscard]] bool binds(MechanismQuantity which, int) const override {
        return which != MechanismQuantity::regularity || has_roller();
    }
    [[nodiscard]] Curvature shape(MechanismQuantity which, const MechanismSetting& setting) const override {
        const bool across = which == MechanismQuantity::pressure_denominator && !swings();
        return across && !is_active(setting, inclination) ? Curvature::linear : Curvature::general;
    }
    /// sign · N cos φm − D sin φm = sign cos φm w + k |c| sin(ψ − k φm) with k = sign · σ.
    [[nodiscard]] Curvature pressure_shape(const PressureSide& side, const MechanismSetting& setting,
                                           double least, double most) const override {
        if (!swings()) return is_active(setting, inclination) ? Curvature::general : Curvature::linear;
        if (!setting.active.empty() || !std::isfinite(least) || !std::isfinite(most))
            return Curvature::general;
        const double start = plate::rest_angle(copied<double>(setting.dimensions));
        const double low = start + least, high = start + most;
        const bool convex = side.sign * form_.sense > 0.0
                                ? low - side.limit >= -std::numbers::pi && high <= side.limit
                                : low >= -side.limit && high + side.limit <= std::numbers::pi;
        return convex ? Curvature::convex : Curvature::general;
    }
    /// sign · w cos φm <= −k |c| sin(ψ − k φm) <= |c|.
    [[nodiscard]] Interval pressure_slopes(const PressureSide& side,
                                           std::span<const double> numbers) const override {
        const double most = std::abs(slide_of(numbers)) /
                            (std::cos(side.limit) * (swings() ? number(numbers, arm_length) : 1.0));
        const Interval all = Interval::everything();
        return side.sign > 0 ? Interval(all.lower, most) : Interval(-most, all.upper);
    }
    [[nodiscard]] bool leans_at_rest(int, const MechanismSetting& setting) const override {
        return swings() || number(setting.dimensions, inclination) != 0.0 || is_active(setting, inclination);
    }

    [[nodiscard]] std::optional<RangeOver> quantity_over(MechanismQuantity which,
                                                         const MechanismStateOver& state,
                                                         int) const override {
        const auto numbers = copied<RangeOver>(state.dimensions);
        return plate::quantity_of(over(state, state.acceleration), form_,
                                  plate::of(numbers, PlateNumber::roller_radius), which);
    }
    [[nodiscard]] std::optional<RangeOver> regularity_over(double margin, const MechanismStateOver& state,
                                                           int station) const override {
        if (!has_roller()) return MechanismEnclosures::regularity_over(margin, state, station);
        return plate::curvature_excess(over(state, 0.0), state.acceleration,
                                       state.dimensions[place_of(PlateNumber::roller_radius)], 1.0 - margin);
    }
    [[nodiscard]] std::optional<RangeOver> radius_over(const RangeOver& radius,
                                                       const MechanismStateOver& state, int) const override {
        return plate::curvature_excess(over(state, 0.0), state.acceleration, radius, 1.0);
    }
    [[nodiscard]] std::optional<RangeAlong> quantity_along(MechanismQuantity which,
                                                           const MechanismStateAlong& state,
                                                           int) const override {
        const auto numbers = copied<RangeAlong>(state.dimensions);
        const RangeAlong start = swings() ? plate::rest_angle(copied<double>(state.dimensions)) : 0.0;
        return plate::quantity_of(
            plate::roller<RangeAlong>(form_, numbers, start, state.s, state.velocity, state.acceleration),
            form_, plate::of(numbers, PlateNumber::roller_radius), which);
    }

    [[nodiscard]] MechanismPoint point(double theta, const MechanismState& state, int) const override {
        const auto own = at(state);
        const double across = own.across, along = own.along, speed = std::sqrt(own.speed_squared());
        const double angle = direction_angle(state), c = std::cos(angle), s = std::sin(angle);
        const Vector2d direction(s, c), left(-c, s);
        const Vector2d normal = (across * direction + form_.sense * along * left) / speed;
        const Vector2d pitch = center(state) + Vector2d(slide_of(state.dimensions) * theta, 0.0);
        const double radius = number(state.dimensions, PlateNumber::roller_radius);
        MechanismPoint point;
        point.theta = theta;
        point.pitch << pitch, 0.0;
        point.normal << normal, 0.0;
        point.contact = point.pitch - radius * point.normal;
        point.pressure_angle = std::atan2(along, across);
        point.pitch_curvature = own.curvature();
        point.cam_radius = 1.0 / point.pitch_curvature - radius;
        point.regularity = 1.0 - radius * point.pitch_curvature;
        return point;
    }

    [[nodiscard]] CamPose pose(const MechanismState& state) const override {
        return {0.0, {-slide_of(state.dimensions) * state.theta, 0.0}};
    }
    [[nodiscard]] bool is_plate() const override { return true; }
    /// A pushed follower is on a stem that is guided above the plate, a swinging one on an arm.
    [[nodiscard]] std::vector<MechanismShape> shapes(const MechanismState& state) const override {
        using Kind = MechanismShape::Kind;
        const std::span<const double> numbers = state.dimensions;
        const double radius = number(numbers, PlateNumber::roller_radius);
        const Vector2d tip = center(state);
        std::vector<MechanismShape> shapes = {{Kind::pivot, "plate_origin", {Vector2d::Zero()}}};
        if (swings()) {
            shapes.push_back({Kind::link, "arm", {tip, pivot(numbers)}});
            shapes.push_back({Kind::pivot, "arm_pivot", {pivot(numbers)}});
        } else {
            const double angle = number(numbers, inclination);
            const Vector2d up = std::max(number(numbers, base_height), stem_of_roller * radius) *
                                Vector2d(std::sin(angle), std::cos(angle));
            shapes.push_back({Kind::link, "stem", {tip, tip + up}});
            shapes.push_back({Kind::guide, "guide", {center({numbers, {}}) + up, tip + up}});
        }
        if (has_roller()) shapes.push_back({Kind::circle, "roller", {tip}, radius});
        return shapes;
    }

    [[nodiscard]] std::optional<double> slide(std::span<const double> numbers) const override {
        return length(numbers);
    }
    [[nodiscard]] std::vector<std::vector<SignedIndex>> reach() const override {
        if (!swings()) return {};
        const SignedIndex height{place_of(base_height), 1.0},
            roller{place_of(PlateNumber::roller_radius), 1.0}, above{place_of(pivot_height), 1.0},
            arm{place_of(arm_length), -1.0};
        const auto minus = [](SignedIndex one) { return SignedIndex{one.dimension, -one.sign}; };
        return {{height, roller, minus(above), arm}, {minus(height), minus(roller), above, arm}};
    }
    [[nodiscard]] DirectCamDrawing drawing(std::span<const double> numbers) const override {
        DirectCamDrawing drawing;
        drawing.follower = name_of(form_.follower);
        for (int i = 0; i < plate_number_count; ++i) {
            const auto which = static_cast<PlateNumber>(i);
            if (has_number(form_.follower, which))
                drawing.dimensions.push_back({name_of(which), number(numbers, which), which == inclination});
        }
        return drawing;
    }
    /// A pushed follower's frame is turned until its path is along +y.
    [[nodiscard]] std::optional<FollowerGeometry> follower(std::span<const double> numbers,
                                                           int) const override {
        const MechanismState rest{numbers, {}};
        FollowerGeometry found;
        if (swings()) {
            const double start = direction_angle(rest);
            found =
                follower_on_lever({pivot(numbers), number(numbers, arm_length),
                                   number(numbers, PlateNumber::roller_radius), std::numbers::pi - start});
            found.most_position = found.turn + right_angle;
        } else {
            found.contact = contact();
            found.roller_radius = number(numbers, PlateNumber::roller_radius);
            found.turn = -number(numbers, inclination);
            found.offset = found.seen(center(rest)).x();
            found.rest_distance = center(rest).norm();
        }
        found.slide = found.seen({-slide_of(numbers), 0.0});
        return found;
    }

 private:
    [[nodiscard]] bool has_roller() const { return form_.follower != PlateFollower::translating_knife; }
    [[nodiscard]] static bool is_active(const MechanismSetting& setting, PlateNumber which) {
        return std::ranges::find(setting.active, place_of(which)) != setting.active.end();
    }
    /// c, m.
    [[nodiscard]] static double slide_of(std::span<const double> numbers) {
        return number(numbers, travel) / units::turn;
    }
    /// ψ.
    [[nodiscard]] double direction_angle(const MechanismState& state) const {
        if (!swings()) return number(state.dimensions, inclination);
        return plate::rest_angle(copied<double>(state.dimensions)) + state.output.s;
    }
    [[nodiscard]] Vector2d pivot(std::span<const double> numbers) const {
        return {number(numbers, arm_length) * std::cos(direction_angle({numbers, {}})),
                number(numbers, pivot_height)};
    }
    /// Of the roller, or the edge, in the frame that stands still.
    [[nodiscard]] Vector2d center(const MechanismState& state) const {
        const double angle = direction_angle(state);
        if (swings())
            return pivot(state.dimensions) +
                   number(state.dimensions, arm_length) * Vector2d(-std::cos(angle), std::sin(angle));
        const double height =
            number(state.dimensions, base_height) + number(state.dimensions, PlateNumber::roller_radius);
        return Vector2d(0.0, height) + state.output.s * Vector2d(std::sin(angle), std::cos(angle));
    }
    [[nodiscard]] plate::Roller<double> at(const MechanismState& state) const {
        const auto numbers = copied<double>(state.dimensions);
        return plate::roller<double>(form_, numbers, swings() ? plate::rest_angle(numbers) : 0.0,
                                     state.output.s, state.output.velocity, state.output.acceleration);
    }
    [[nodiscard]] plate::Roller<RangeOver> over(const MechanismStateOver& state,
                                                const RangeOver& acceleration) const {
        const auto numbers = copied<RangeOver>(state.dimensions);
        return plate::roller<RangeOver>(form_, numbers,
                                        swings() ? plate::rest_angle(numbers) : RangeOver(0.0), state.s,
                                        state.velocity, acceleration);
    }
    /// By s, s', s'' and all numbers, of which the active ones are kept.
    template <int n>
    [[nodiscard]] MechanismValue expanded(MechanismQuantity which, const MechanismState& state,
                                          std::span<const int> active) const {
        using Number = SecondOrder<n>;
        constexpr int output = 3;
        plate::Numbers<Number> numbers;
        for (int i = 0; i < plate_number_count; ++i) {
            const double value = state.dimensions[i];
            numbers[i] = n > output ? variable<n>(value, n > output ? output + i : 0) : constant<n>(value);
        }
        const Number start = swings() ? plate::rest_angle(numbers) : Number(0.0);
        const Number found =
            plate::quantity_of(plate::roller<Number>(form_, numbers, start, variable<n>(state.output.s, 0),
                                                     variable<n>(state.output.velocity, 1),
                                                     variable<n>(state.output.acceleration, 2)),
                               form_, plate::of(numbers, PlateNumber::roller_radius), which);
        const auto size = static_cast<Eigen::Index>(output + active.size());
        const auto from = [&](Eigen::Index k) {
            return static_cast<std::size_t>(k < output ? k : output + active[k - output]);
        };
        MechanismValue result{found.value, MechanismValue::Gradient(size),
                              MechanismValue::Hessian(size, size)};
        for (Eigen::Index a = 0; a < size; ++a) {
            result.gradient(a) = found.first[from(a)];
            for (Eigen::Index b = 0; b < size; ++b)
                result.hessian(a, b) = found.second[found.pair(from(a), from(b))];
        }
        return result;
    }

    plate::Form form_;
};

}  // namespace

std::shared_ptr<const CamMechanism> linear_mechanism(const CamSpec& spec) {
    return std::make_shared<LinearMechanism>(spec);
}

CamSpec linear_spec(PlateFollower follower) {
    CamSpec spec = blank_linear_spec(follower);
    spec.make = linear_mechanism;
    return spec;
}

}  // namespace camopt
