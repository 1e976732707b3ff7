// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_mechanism.hpp"

#include "core/units.hpp"
#include "profiles/disk/disk_kind.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "profiles/disk/quantity_algebra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace camopt {
namespace {

constexpr double stem_length = 1.2;  // of a drawn stem, by the larger of base and roller radius

Quantity quantity_of(MechanismQuantity which) {
    switch (which) {
        case MechanismQuantity::pressure_numerator:
            return Quantity::pressure_numerator;
        case MechanismQuantity::pressure_denominator:
            return Quantity::pressure_denominator;
        case MechanismQuantity::pitch_curvature:
            return Quantity::pitch_curvature;
        case MechanismQuantity::regularity:
            break;
    }
    return Quantity::regularity;
}

class DiskMechanism final : public CamMechanism {
 public:
    DiskMechanism(FollowerType follower, Rotation rotation, FormSpec form)
        : follower_(follower), rotation_(rotation), form_(std::move(form)), which_(dimensions_of(follower)) {}

    /// What follows the follower's own dimensions are the form's numbers, which it has already.
    [[nodiscard]] DiskCam cam(std::span<const double> dimensions) const {
        DiskCam own{follower_, rotation_, {}, form_};
        for (std::size_t i = 0; i < which_.size(); ++i)
            own.dimensions[static_cast<std::size_t>(which_[i])] = dimensions[i];
        return own;
    }

    [[nodiscard]] std::string type() const override { return disk_type; }
    [[nodiscard]] bool swings() const override { return is_oscillating(follower_); }
    [[nodiscard]] Rotation rotation() const override { return rotation_; }
    [[nodiscard]] int stations() const override { return side_count(form_); }
    [[nodiscard]] std::string station_name(int station) const override { return side_name(form_, station); }
    [[nodiscard]] double surface_offset(std::span<const double> dimensions, int station) const override {
        return camopt::surface_offset(cam(dimensions), station);
    }
    [[nodiscard]] int roller_radius() const override {
        return has_roller(follower_) ? place_of(DimensionIndex::roller_radius) : -1;
    }
    [[nodiscard]] bool planar() const override { return true; }
    [[nodiscard]] bool is_direct() const override { return true; }
    [[nodiscard]] bool has_pitch_curve() const override { return !has_flat_face(follower_); }
    [[nodiscard]] std::optional<double> base_radius(std::span<const double> dimensions) const override {
        return cam(dimensions)[DimensionIndex::base_radius];
    }
    /// What a swing is multiplied by to be a length.
    [[nodiscard]] double length(std::span<const double> dimensions) const override {
        return cam(dimensions)[swings() ? DimensionIndex::center_distance : DimensionIndex::base_radius];
    }
    [[nodiscard]] std::string fault(std::span<const double> dimensions, double least,
                                    double most) const override {
        return geometry_fault(cam(dimensions), least, most);
    }
    [[nodiscard]] std::string undercut_words() const override;
    [[nodiscard]] std::string check_words(int points) const override {
        if (form_.is_grooved())
            return fmt::format("a roller run along both flanks, over {} points of each", points);
        if (form_.is_conjugate()) return fmt::format("each roller run over {} points of its disk", points);
        return fmt::format("a follower run over {} points of the cam", points);
    }
    [[nodiscard]] MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int station,
                                          std::span<const int> active) const override;
    [[nodiscard]] MechanismPoint point(double theta, const MechanismState& state,
                                       int station) const override {
        return mechanism_point(profile_point(cam(state.dimensions), theta, state.output, station));
    }
    [[nodiscard]] std::vector<MechanismShape> shapes(const MechanismState& state) const override;
    [[nodiscard]] std::optional<RollerLever> roller_lever(std::span<const double>) const override {
        return std::nullopt;
    }

 private:
    void add_second_roller(std::vector<MechanismShape>& shapes, const DiskCam& own,
                           const FollowerState& output, const Eigen::Vector2d& first) const;
    [[nodiscard]] int place_of(DimensionIndex dimension) const {
        return static_cast<int>(std::ranges::find(which_, dimension) - which_.begin());
    }

    FollowerType follower_;
    Rotation rotation_;
    FormSpec form_;
    std::vector<DimensionIndex> which_;
};

std::string DiskMechanism::undercut_words() const {
    if (has_edge(follower_)) return {};
    return fmt::format(
        "the cam crosses itself there, the part that remains does not lead the follower as designed. A "
        "larger "
        "base radius{} {}",
        has_roller(follower_) ? " or a smaller roller" : "",
        is_oscillating(follower_) ? "may help" : "helps");
}

/// On the slide, or on an arm of its own.
void DiskMechanism::add_second_roller(std::vector<MechanismShape>& shapes, const DiskCam& own,
                                      const FollowerState& output, const Eigen::Vector2d& first) const {
    using Kind = MechanismShape::Kind;
    const Eigen::Vector2d center = profile_point(own, 0.0, output, 1).center;
    if (is_oscillating(follower_)) {
        const Eigen::Vector2d pivot(own[DimensionIndex::center_distance], 0.0);
        shapes.push_back({Kind::link, "second_arm", {center, pivot}});
    } else {
        shapes.push_back({Kind::link, "yoke", {first, center}});
    }
    shapes.push_back({Kind::circle, "second_roller", {center}, roller_radius_of(own, 1)});
}

/// A pushed follower hangs on a stem that is guided above the cam, a swinging one on an arm.
std::vector<MechanismShape> DiskMechanism::shapes(const MechanismState& state) const {
    using Kind = MechanismShape::Kind;
    using Eigen::Vector2d;
    const DiskCam own = cam(state.dimensions);
    const double rest = rest_position(own), now = rest + state.output.s;
    const double roller = has_roller(follower_) ? own[DimensionIndex::roller_radius] : 0.0;
    std::vector<MechanismShape> shapes = {{Kind::pivot, "cam_center", {Vector2d::Zero()}}};
    Vector2d tip;
    if (is_oscillating(follower_)) {
        const Vector2d pivot(own[DimensionIndex::center_distance], 0.0);
        const Vector2d along(-std::cos(now), std::sin(now)), down(-std::sin(now), -std::cos(now));
        if (has_flat_face(follower_)) {
            tip = pivot + own[DimensionIndex::face_offset] * down;
            shapes.push_back({Kind::face, "face", {tip, tip + along}});
        } else {
            tip = pivot + own[DimensionIndex::arm_length] * along;
        }
        shapes.push_back({Kind::link, "arm", {tip, pivot}});
        shapes.push_back({Kind::pivot, "arm_pivot", {pivot}});
    } else {
        const bool flat = has_flat_face(follower_);
        const Vector2d up(0.0, stem_length * std::max(own[DimensionIndex::base_radius], roller));
        tip = {flat ? 0.0 : own[DimensionIndex::offset], now};
        if (flat) shapes.push_back({Kind::face, "face", {tip, tip + Vector2d::UnitX()}});
        shapes.push_back({Kind::link, "stem", {tip, tip + up}});
        shapes.push_back({Kind::guide, "guide", {Vector2d(tip.x(), rest + up.y()), tip + up}});
    }
    if (has_roller(follower_)) shapes.push_back({Kind::circle, "roller", {tip}, roller});
    if (form_.is_conjugate()) add_second_roller(shapes, own, state.output, tip);
    return shapes;
}

MechanismValue DiskMechanism::quantity(MechanismQuantity which, const MechanismState& state, int station,
                                       std::span<const int> active) const {
    const auto size = static_cast<Eigen::Index>(3 + active.size());
    if (which == MechanismQuantity::pitch_curvature && !has_pitch_curve()) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        return {none, Eigen::VectorXd::Constant(size, none), Eigen::MatrixXd::Constant(size, size, none)};
    }
    const QuantityValue all =
        camopt::quantity(cam(state.dimensions), state.output, quantity_of(which), station);
    std::vector<int> columns = {0, 1, 2};
    for (const int dimension : active)
        columns.push_back(column_of(which_[static_cast<std::size_t>(dimension)]));
    return {all.value, all.gradient(columns), all.hessian(columns, columns)};
}

}  // namespace

std::vector<DimensionIndex> dimensions_of(FollowerType follower) {
    std::vector<DimensionIndex> all;
    for (int d = 0; d < dimension_count; ++d)
        if (has_dimension(follower, static_cast<DimensionIndex>(d)))
            all.push_back(static_cast<DimensionIndex>(d));
    return all;
}

std::vector<MechanismDimension> form_dimensions(FollowerType follower, const FormSpec& form) {
    std::vector<MechanismDimension> all;
    const auto add = [&](const char* name, double value, bool is_angle) {
        MechanismDimension dimension{name, Dimension(value), is_angle};
        dimension.value.key = fmt::format("cam.{}_{}", name, is_angle ? "deg" : "mm");
        dimension.value.unit = is_angle ? units::degree : units::millimetre;
        all.push_back(std::move(dimension));
    };
    const auto add_given = [&](const char* name, const std::optional<double>& value) {
        if (value) add(name, *value, false);
    };
    if (form.is_grooved()) {
        add("groove_clearance", form.groove_clearance, false);
        add_given("groove_wall", form.groove_wall);
    }
    if (!form.is_conjugate()) return all;
    if (is_oscillating(follower)) {
        add("arm_angle", form.arm_angle, true);
        add_given("second_arm_length", form.second_arm_length);
    } else {
        add("roller_distance", form.roller_distance, false);
        add_given("second_offset", form.second_offset);
    }
    add_given("second_roller_radius", form.second_roller_radius);
    return all;
}

MechanismPoint mechanism_point(const ProfilePoint& found) {
    MechanismPoint point;
    point.theta = found.theta;
    point.pitch << found.pitch, 0.0;
    point.contact << found.contact, 0.0;
    point.normal << found.normal, 0.0;
    point.pressure_angle = found.pressure_angle;
    point.pitch_curvature = found.pitch_curvature;
    point.cam_radius = found.cam_radius;
    point.regularity = found.regularity;
    point.contact_offset = found.contact_offset;
    return point;
}

MechanismSpec disk_spec(const CamSpec& cam) {
    MechanismSpec spec;
    spec.type = disk_type;
    spec.rotation = cam.rotation;
    spec.choices["follower"] = name_of(cam.follower);
    spec.choices["form"] = name_of(cam.form.type);
    for (const DimensionIndex which : dimensions_of(cam.follower)) {
        MechanismDimension dimension{name_of(which), cam[which], false};
        if (dimension.value.key.empty()) {
            dimension.value.key = fmt::format("cam.{}_mm", dimension.name);
            dimension.value.unit = units::millimetre;
        }
        spec.dimensions.push_back(std::move(dimension));
    }
    for (MechanismDimension& dimension : form_dimensions(cam.follower, cam.form))
        spec.dimensions.push_back(std::move(dimension));
    spec.formulas = std::make_shared<DiskMechanism>(cam.follower, cam.rotation, cam.form);
    return spec;
}

DrivenMechanism disk_mechanism(const DiskCam& cam) {
    DrivenMechanism mechanism{std::make_shared<DiskMechanism>(cam.follower, cam.rotation, cam.form), {}};
    for (const DimensionIndex which : dimensions_of(cam.follower)) mechanism.dimensions.push_back(cam[which]);
    for (const MechanismDimension& dimension : form_dimensions(cam.follower, cam.form))
        mechanism.dimensions.push_back(dimension.value.low);
    return mechanism;
}

std::optional<DiskCam> disk_cam(const DrivenMechanism& mechanism) {
    const auto* const disk = dynamic_cast<const DiskMechanism*>(mechanism.formulas.get());
    if (disk == nullptr) return std::nullopt;
    return disk->cam(mechanism.dimensions);
}

}  // namespace camopt
