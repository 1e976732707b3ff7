// SPDX-License-Identifier: MIT
#include "core/text/quantity_text.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "profiles/spatial/spatial_formulas.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

constexpr int station_count = 2 * mechanism_heights;
constexpr double rounding = 1e-12;  // of a length that just fits

/// From the roller's near end, as a part of its length: two stations per height, one per flank.
double share_of(int station) {
    const int height = station / 2;
    return static_cast<double>(height) / (mechanism_heights - 1);
}

int flank_of(int station) {
    return station % 2 == 0 ? 1 : -1;
}

RollerStation station_of(const SpatialCam& cam, int station) {
    return {share_of(station) * cam.roller_length, flank_of(station)};
}

/// A number of the body that the groove does not fit. `passes`: rollers come in and leave by its ends.
std::optional<SceneFault> body_fault(const SpatialCam& cam, const DrumExtent& groove, bool passes,
                                     LengthUnit unit) {
    const DrumBody& body = cam.form.body;
    const auto text = [unit](double length) { return length_text(length, unit); };
    if (passes && body.wall)
        return SceneFault{"cam.groove_wall", "a wall at the ends of a cam whose rollers leave by them",
                          "leave it out"};
    if (passes && body.diameter && cam.follower == SpatialFollower::cylindrical_rotating)
        return SceneFault{"cam.body_diameter", "the diameter of a body that is turned to an arc",
                          "leave it out: its outside follows the rollers' near ends"};
    const double floor = 2.0 * groove.floor_radius, outside = 2.0 * groove.outer_radius;
    if (body.diameter && !(*body.diameter > floor && *body.diameter <= outside * (1.0 + rounding)))
        return SceneFault{
            "cam.body_diameter", text(*body.diameter),
            fmt::format("above {}, on which the roller's far end runs, and at most {}, its near end",
                        text(floor), text(outside))};
    const double needed = groove.upper - groove.lower + 2.0 * body.wall.value_or(0.0);
    if (!passes && body.length && !(*body.length >= needed * (1.0 - rounding)))
        return SceneFault{"cam.body_length", text(*body.length),
                          fmt::format("at least {}, the length of the groove{}", text(needed),
                                      body.wall ? " and its two walls" : "")};
    return {};
}

/// Slopes of the variables of spatial_quantity by one number of the mechanism. The station's height enters
/// every formula together with the dimension it is counted from: ρ = center_distance − h or arm_length + h.
Eigen::Matrix<double, spatial_variables, 1> direction_of(const SpatialCam& cam, int number, int station) {
    Eigen::Matrix<double, spatial_variables, 1> direction;
    direction.setZero();
    switch (static_cast<SpatialNumber>(number)) {
        case SpatialNumber::roller_length: {
            const double share = share_of(station);
            if (cam.follower == SpatialFollower::cylindrical_rotating)
                direction(column_of(SpatialDimension::arm_length)) = share;
            else
                direction(column_of(SpatialDimension::center_distance)) = -share;
            break;
        }
        case SpatialNumber::start:
            direction(0) = 1.0;
            break;
        case SpatialNumber::axial_offset:
            break;
        case SpatialNumber::roller_radius:
        case SpatialNumber::arm_length:
        case SpatialNumber::center_distance:
        case SpatialNumber::lateral_offset:
            direction(3 + number) = 1.0;
    }
    return direction;
}

class SpatialMechanism final : public CamMechanism, public LimitStructure, public MechanismEnclosures {
 public:
    SpatialMechanism(SpatialFollower follower, Rotation rotation, DrumForm form)
        : follower_(follower), rotation_(rotation), form_(form) {}

    [[nodiscard]] std::string type() const override {
        return follower_ == SpatialFollower::barrel ? barrel_type : cylindrical_type;
    }
    [[nodiscard]] bool swings() const override { return camopt::swings(follower_); }
    [[nodiscard]] Rotation rotation() const override { return rotation_; }
    [[nodiscard]] int stations() const override { return station_count; }
    [[nodiscard]] std::string station_name(int station) const override {
        return fmt::format("{:.0f} % of the roller, flank {}", 100.0 * share_of(station),
                           station % 2 == 0 ? "+" : "-");
    }
    [[nodiscard]] bool binds(MechanismQuantity which, int station) const override {
        if (which == MechanismQuantity::regularity) return true;
        return station == 0 || station == station_count - 2;
    }
    /// The pressure angle is largest at an end of the roller; the first location of undercut varies.
    [[nodiscard]] bool has_all_stations(MechanismQuantity which) const override {
        return which != MechanismQuantity::regularity;
    }
    [[nodiscard]] int roller_radius_at(int) const override {
        return static_cast<int>(SpatialNumber::roller_radius);
    }
    [[nodiscard]] double surface_offset(std::span<const double> dimensions, int) const override {
        return cam(dimensions).groove_radius();
    }
    [[nodiscard]] bool carries_load() const override { return true; }
    [[nodiscard]] int side_of(int station) const override {
        return flank_of(station) * spatial_formulas::sign_of_b(sort()) > 0.0 ? 0 : 1;
    }
    [[nodiscard]] std::string side_name(int side) const override {
        return side_of(0) == side ? "flank +" : "flank -";
    }
    [[nodiscard]] const LimitStructure& limit_structure() const override { return *this; }
    [[nodiscard]] const MechanismEnclosures* enclosures() const override { return this; }
    [[nodiscard]] double length(std::span<const double> dimensions) const override {
        return dimensions[static_cast<std::size_t>(SpatialNumber::center_distance)];
    }
    [[nodiscard]] std::string fault(std::span<const double> dimensions, double least,
                                    double most) const override {
        return geometry_fault(cam(dimensions), least, most);
    }
    /// And a body that holds the groove, with every dimension in its middle.
    [[nodiscard]] std::optional<SceneFault> find_fault(const CamSpec& spec,
                                                       const MotionSpec& motion) const override {
        if (auto found = CamMechanism::find_fault(spec, motion)) return found;
        const auto [least, most] = motion.displacements();
        const bool passes = swings() && (motion.type == MotionType::drd || motion.relative);
        const SpatialCam own = cam(spec.middle());
        const bool inches = spec.find(name_of_number(SpatialNumber::roller_radius))->unit == units::inch;
        return body_fault(own, drum_extent(own, least, most), passes,
                          inches ? LengthUnit::inch : LengthUnit::millimetre);
    }

    [[nodiscard]] MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int station,
                                          std::span<const int> active) const override {
        const SpatialCam own = cam(state.dimensions);
        const auto size = static_cast<Eigen::Index>(3 + active.size());
        if (which == MechanismQuantity::pitch_curvature) {
            const double none = std::numeric_limits<double>::quiet_NaN();
            return {none, Eigen::VectorXd::Constant(size, none), Eigen::MatrixXd::Constant(size, size, none)};
        }
        const SpatialValue value =
            spatial_quantity(own, state.output, station_of(own, station), quantity_of(which));
        Eigen::MatrixXd directions(spatial_variables, size);
        directions.leftCols(3).setIdentity();
        for (std::size_t i = 0; i < active.size(); ++i)
            directions.col(static_cast<Eigen::Index>(3 + i)) = direction_of(own, active[i], station);
        return {value.value, directions.transpose() * value.gradient,
                directions.transpose() * value.hessian * directions};
    }

    /// Barrel cams: beyond 0 <= u <= π continued by the tangents of −ρ sin u, so that it is convex
    /// everywhere.
    [[nodiscard]] MechanismValue pressure_excess(double limit, int sign, const MechanismState& state,
                                                 int station, std::span<const int> active) const override {
        MechanismValue excess = CamMechanism::pressure_excess(limit, sign, state, station, active);
        if (pressure_shape(active) != Curvature::convex) return excess;
        const SpatialCam own = cam(state.dimensions);
        const double side = rotation_ == Rotation::clockwise ? -sign : sign;
        const double u = limit + side * (own.start + state.output.s);
        if (u >= 0.0 && u <= std::numbers::pi) return excess;
        const double rho = own[SpatialDimension::center_distance] - station_of(own, station).height;
        const double tangent = u < 0.0 ? -u : u - std::numbers::pi, slope = u < 0.0 ? -1.0 : 1.0;
        excess.value += rho * (std::sin(u) + tangent);
        excess.gradient(0) += rho * side * (std::cos(u) + slope);
        excess.hessian(0, 0) -= rho * std::sin(u);
        return excess;
    }
    [[nodiscard]] Curvature pressure_shape(const PressureSide&, const MechanismSetting& setting, double,
                                           double) const override {
        return pressure_shape(setting.active);
    }
    [[nodiscard]] std::optional<RangeOver> pressure_over(double limit, int sign,
                                                         const MechanismStateOver& state,
                                                         int station) const override {
        std::vector<int> active;
        for (std::size_t k = 0; k < state.dimensions.size(); ++k)
            if (state.dimensions[k].size() > 0) active.push_back(static_cast<int>(k));
        return spatial_formulas::pressure_over(sort(), state, place_on_roller(station),
                                               {limit, sign, pressure_shape(active) == Curvature::convex});
    }
    [[nodiscard]] std::optional<RangeOver> regularity_over(double margin, const MechanismStateOver& state,
                                                           int station) const override {
        return spatial_formulas::undercut_over(sort(), state, place_on_roller(station), margin);
    }

    [[nodiscard]] std::optional<RangeOver> quantity_over(MechanismQuantity which,
                                                         const MechanismStateOver& state,
                                                         int station) const override {
        if (which == MechanismQuantity::pitch_curvature) return {};
        return spatial_formulas::quantity_over(sort(), state, place_on_roller(station), quantity_of(which));
    }
    [[nodiscard]] std::optional<RangeAlong> quantity_along(MechanismQuantity which,
                                                           const MechanismStateAlong& state,
                                                           int station) const override {
        if (which == MechanismQuantity::pitch_curvature) return {};
        const SpatialCam own = cam(state.dimensions);
        return spatial_formulas::quantity_along(own, state, station_of(own, station), quantity_of(which));
    }
    /// Everything where a barrel cam's is continued.
    [[nodiscard]] std::optional<RangeAlong> pressure_along(double limit, int sign,
                                                           const MechanismStateAlong& state,
                                                           int station) const override {
        const double side = rotation_ == Rotation::clockwise ? -sign : sign;
        const Interval u =
            Interval(limit) + Interval(side) * (Interval(cam(state.dimensions).start) + state.s.value);
        const bool continued = u.lower < 0.0 || u.upper > std::numbers::pi;
        if (follower_ == SpatialFollower::barrel && continued) {
            const Interval all = Interval::everything();
            return RangeAlong(all, all, all);
        }
        return MechanismEnclosures::pressure_along(limit, sign, state, station);
    }

    [[nodiscard]] MechanismPoint point(double theta, const MechanismState& state,
                                       int station) const override {
        const SpatialCam own = cam(state.dimensions);
        const SpatialPoint found = spatial_point(own, theta, state.output, station_of(own, station));
        MechanismPoint point;
        point.theta = theta;
        point.pitch = found.center;
        point.contact = found.contact;
        point.normal = -found.normal;
        point.pressure_angle = found.pressure_angle;
        point.pitch_curvature = point.cam_radius = std::numeric_limits<double>::quiet_NaN();
        point.regularity = found.undercut;
        point.contact_radius = found.contact_radius;
        return point;
    }
    [[nodiscard]] std::optional<CamFlanks> flanks(std::span<const double> dimensions) const override {
        return cam(dimensions);
    }

 private:
    static spatial_formulas::PlaceOnRoller place_on_roller(int station) {
        return {share_of(station), flank_of(station)};
    }
    /// What it is without its numbers.
    [[nodiscard]] SpatialCam sort() const {
        SpatialCam cam;
        cam.follower = follower_;
        cam.rotation = rotation_;
        cam.form = form_;
        return cam;
    }
    static SpatialQuantity quantity_of(MechanismQuantity which) {
        if (which == MechanismQuantity::pressure_numerator) return SpatialQuantity::pressure_numerator;
        if (which == MechanismQuantity::pressure_denominator) return SpatialQuantity::pressure_denominator;
        if (which == MechanismQuantity::normal_lever) return SpatialQuantity::normal_lever;
        if (which == MechanismQuantity::contact_radius) return SpatialQuantity::contact_radius;
        if (which != MechanismQuantity::regularity) refuse_quantity("spatial");
        return SpatialQuantity::undercut;
    }
    [[nodiscard]] SpatialCam cam(std::span<const double> numbers) const {
        return spatial_cam(follower_, rotation_, numbers, form_);
    }

    /// Of a slide it is linear. Of a barrel cam it is, with the index's angle ψ,
    ///   ±r ψ' cos φ − ρ sin u,  u = φ ± ψ,
    /// convex where 0 <= u <= π. A motion that rests at its ends and satisfies the limit on both sides stays
    /// there: its largest and least ψ have ψ' = 0, where the limit says sin u >= 0 for both sides.
    [[nodiscard]] Curvature pressure_shape(std::span<const int> active) const {
        if (follower_ == SpatialFollower::cylindrical_translating) return Curvature::linear;
        if (follower_ != SpatialFollower::barrel) return Curvature::general;
        const bool fixed = std::ranges::none_of(active, [](int number) {
            const auto which = static_cast<SpatialNumber>(number);
            return which != SpatialNumber::roller_radius && which != SpatialNumber::lateral_offset &&
                   which != SpatialNumber::axial_offset;
        });
        return fixed ? Curvature::convex : Curvature::general;
    }

    SpatialFollower follower_;
    Rotation rotation_;
    DrumForm form_;
};

}  // namespace

SpatialCam spatial_cam(SpatialFollower follower, Rotation rotation, std::span<const double> numbers,
                       const DrumForm& form) {
    const auto number = [&](SpatialNumber which) { return numbers[static_cast<std::size_t>(which)]; };
    SpatialCam cam;
    cam.follower = follower;
    cam.rotation = rotation;
    cam.dimensions = {number(SpatialNumber::roller_radius), number(SpatialNumber::arm_length),
                      number(SpatialNumber::center_distance), number(SpatialNumber::lateral_offset)};
    cam.axial_offset = number(SpatialNumber::axial_offset);
    cam.roller_length = number(SpatialNumber::roller_length);
    cam.start = number(SpatialNumber::start);
    cam.form = form;
    return cam;
}

SpatialCam spatial_cam(const CamSpec& spec, std::span<const double> numbers) {
    return spatial_cam(spatial_follower(spec), spec.rotation, numbers, drum_form(spec));
}

CamSpec spatial_spec(SpatialFollower follower) {
    CamSpec spec = blank_spatial_spec(follower);
    spec.make = spatial_mechanism;
    return spec;
}

std::shared_ptr<const CamMechanism> spatial_mechanism(const CamSpec& spec) {
    return std::make_shared<SpatialMechanism>(spatial_follower(spec), spec.rotation, drum_form(spec));
}

}  // namespace camopt
