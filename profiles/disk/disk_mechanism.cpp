// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_cam.hpp"
#include "scene/scene.hpp"

namespace camopt {
namespace {

constexpr double stem_length = 1.2;  // of a drawn stem, by the larger of base and roller radius

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

class DiskMechanism final : public CamMechanism,
                            public LimitStructure,
                            public MechanismEnclosures,
                            public PlaneMechanism,
                            public DirectCam {
 public:
    DiskMechanism(FollowerType follower, Rotation rotation, const FormSpec& form)
        : follower_(follower), rotation_(rotation), form_(form), which_(dimensions_of(follower)) {}

    /// The numbers of the form, already stored, come after the follower's own dimensions.
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
    [[nodiscard]] std::string station_name(int station) const override {
        return camopt::side_name(form_, station);
    }
    [[nodiscard]] double surface_offset(std::span<const double> dimensions, int station) const override {
        return camopt::surface_offset(cam(dimensions), station);
    }
    /// That of a separate second roller is last among the numbers of the form.
    [[nodiscard]] int roller_radius_at(int station) const override {
        if (station == 1 && form_.is_conjugate() && form_.second_roller_radius)
            return static_cast<int>(which_.size() + form_dimensions(follower_, form_).size()) - 1;
        return has_roller(follower_) ? place_of(DimensionIndex::roller_radius) : -1;
    }
    [[nodiscard]] std::optional<MechanismQuantity> radius_quantity() const override {
        return has_flat_face(follower_) ? MechanismQuantity::cam_radius : MechanismQuantity::pitch_curvature;
    }
    [[nodiscard]] const LimitStructure& limit_structure() const override { return *this; }
    [[nodiscard]] const MechanismEnclosures* enclosures() const override { return this; }
    [[nodiscard]] const PlaneMechanism* plane() const override { return this; }
    [[nodiscard]] const DirectCam* direct() const override { return this; }
    [[nodiscard]] int base_radius_index() const override { return place_of(DimensionIndex::base_radius); }
    [[nodiscard]] std::optional<double> pushed_offset(std::span<const double> dimensions) const override {
        if (swings() || has_flat_face(follower_)) return {};
        return sense_of(rotation_) * cam(dimensions)[DimensionIndex::offset];
    }
    [[nodiscard]] std::vector<std::vector<SignedIndex>> reach() const override {
        std::vector<std::vector<SignedIndex>> all;
        for (const auto& sum : reach_of(follower_)) {
            std::vector<SignedIndex>& own = all.emplace_back();
            own.reserve(sum.size());
            // A dimension that the follower does not have is 0.
            for (const auto& [dimension, sign] : sum)
                if (has_dimension(follower_, dimension)) own.push_back({place_of(dimension), sign});
        }
        return all;
    }
    /// The pivot's distance, or the prime radius.
    [[nodiscard]] double length(std::span<const double> dimensions) const override {
        const DiskCam own = cam(dimensions);
        if (swings()) return own[DimensionIndex::center_distance];
        return own[DimensionIndex::base_radius] + own[DimensionIndex::roller_radius];
    }
    /// Both flanks of a groove have one normal; a pushed face and a knife edge have separate limits.
    [[nodiscard]] bool binds(MechanismQuantity which, int station) const override {
        if (which == MechanismQuantity::regularity) return !has_edge(follower_);
        if (which != MechanismQuantity::pressure_numerator) return true;
        return !has_pushed_face(follower_) && (station == 0 || form_.is_conjugate());
    }
    [[nodiscard]] std::string fault(std::span<const double> dimensions, double least,
                                    double most) const override {
        return geometry_fault(cam(dimensions), least, most);
    }
    [[nodiscard]] std::optional<SceneFault> find_fault(const CamSpec& spec,
                                                       const MotionSpec& motion) const override {
        return disk_fault(disk_of(spec), motion);
    }
    /// Where sign · N cos φm − D sin φm is convex in the motion (and, translating, in the dimensions):
    /// docs/theory/pressure_angle.md. For an oscillating roller it is l(1 + σψ') cos φm − a cos(ψ ∓ φm):
    /// convex where the cosine is concave for the upper side, where it is convex for the lower one. The
    /// second disk is the same in ψ2 = γ − ψ; translating it has +s0 where the first has −s0, which is
    /// concave in the dimensions unless it is linear in them.
    [[nodiscard]] Curvature pressure_shape(const PressureSide& side, const MechanismSetting& setting,
                                           double least, double most) const override {
        constexpr double right_angle = 0.5 * std::numbers::pi;
        const DiskCam own = cam(setting.dimensions);
        const bool second = side.station == 1;
        if (!swings()) {
            // Nothing variable but base and roller, no offset: N = s', D = base + roller + s.
            const bool straight =
                !is_active(setting, DimensionIndex::offset) && own[DimensionIndex::offset] == 0.0;
            if (setting.active.empty() || straight) return Curvature::linear;
            return second ? Curvature::general : Curvature::convex;
        }
        if (!setting.active.empty() || !std::isfinite(least) || !std::isfinite(most))
            return Curvature::general;
        const double start = second ? second_rest_position(own) : rest_position(own);
        const double low = start + (second ? -most : least), high = start + (second ? -least : most);
        const double limit = side.limit;
        const bool convex = has_turning_face(follower_) ? low >= -right_angle && high <= right_angle
                            : side.sign > 0 ? low >= limit - right_angle && high <= limit + right_angle
                                            : low >= right_angle - limit && high <= 3.0 * right_angle - limit;
        return convex ? Curvature::convex : Curvature::general;
    }
    /// sign · N cos φm <= D sin φm bounds the arm's velocity for any angle: σψ' <= a/(l cos φm) − 1 for the
    /// upper side of a roller, >= −a/(l cos φm) − 1 for the lower one; f(1 + σψ') <= a tan φm for a face.
    [[nodiscard]] Interval pressure_slopes(const PressureSide& side,
                                           std::span<const double> dimensions) const override {
        using enum DimensionIndex;
        if (!swings()) return Interval::everything();
        const bool second = side.station == 1;
        const DiskCam own = second ? second_disk(cam(dimensions)) : cam(dimensions);
        const bool roller = has_roller(follower_);
        const double lever = roller ? own[arm_length] : std::abs(own[face_offset]);
        if (lever == 0.0) return Interval::everything();
        const double reach =
            own[center_distance] / lever * (roller ? 1.0 / std::cos(side.limit) : std::tan(side.limit));
        const Interval all = Interval::everything();
        // With the face on the other side of the arm the sides are exchanged.
        const bool upper = (side.sign > 0) == (roller || own[face_offset] > 0.0);
        const Interval turned = upper ? Interval(all.lower, reach - 1.0) : Interval(-reach - 1.0, all.upper);
        const bool as_seen = (sense_of(own.rotation) > 0.0) != second;  // the second disk's ψ' is −ψ'
        return as_seen ? turned : Interval(-turned.upper, -turned.lower);
    }
    /// An arm's rise turns the cam's way clockwise. The mirror of the second disk turns the other way, and it
    /// falls where the follower rises.
    [[nodiscard]] bool upper_side_rises(int station) const override {
        return swings() ? sense_of(rotation_) > 0.0 : station == 0;
    }
    /// The follower's contact may have an offset from its line of travel.
    [[nodiscard]] bool leans_at_rest(int station, const MechanismSetting& setting) const override {
        if (swings()) return true;
        if (station == 1 && form_.second_offset) return *form_.second_offset != 0.0;
        return cam(setting.dimensions)[DimensionIndex::offset] != 0.0 ||
               is_active(setting, DimensionIndex::offset);
    }
    [[nodiscard]] Curvature shape(MechanismQuantity which, const MechanismSetting& setting) const override {
        using enum MechanismQuantity;
        const bool height = which == pressure_denominator && !swings() && setting.active.empty();
        const bool face = which == cam_radius && has_pushed_face(follower_);
        return height || face ? Curvature::linear : Curvature::general;
    }
    [[nodiscard]] double face_turn() const override {
        return has_turning_face(follower_) ? sense_of(rotation_) : 0.0;
    }
    [[nodiscard]] MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int station,
                                          std::span<const int> active) const override {
        const auto size = static_cast<Eigen::Index>(3 + active.size());
        if (which == MechanismQuantity::pitch_curvature && has_flat_face(follower_)) {
            const double none = std::numeric_limits<double>::quiet_NaN();
            return {none, Eigen::VectorXd::Constant(size, none), Eigen::MatrixXd::Constant(size, size, none)};
        }
        const QuantityValue all = camopt::quantity(cam(state.dimensions), state.output, which, station);
        // The form's numbers are not variables of a quantity.
        std::array<int, quantity_variables> columns = {0, 1, 2};
        for (std::size_t k = 0; k < active.size(); ++k) columns[3 + k] = column_of(which_[active[k]]);
        MechanismValue value{all.value, MechanismValue::Gradient(size), MechanismValue::Hessian(size, size)};
        for (Eigen::Index i = 0; i < size; ++i) {
            value.gradient[i] = all.gradient[columns[i]];
            for (Eigen::Index j = 0; j < size; ++j) value.hessian(i, j) = all.hessian(columns[i], columns[j]);
        }
        return value;
    }
    [[nodiscard]] std::optional<RangeOver> quantity_over(MechanismQuantity which,
                                                         const MechanismStateOver& state,
                                                         int station) const override {
        return camopt::quantity(form(), over(state), which, station);
    }
    [[nodiscard]] std::optional<RangeOver> regularity_over(double margin, const MechanismStateOver& state,
                                                           int station) const override {
        if (!has_roller(follower_)) return MechanismEnclosures::regularity_over(margin, state, station);
        const DiskCam own = form();
        const StateOver box = over(state);
        const double wider = form_.is_grooved() ? 0.5 * form_.groove_clearance : 0.0;
        return curvature_excess(own, box, roller_on(own, box, station) + wider, 1.0 - margin, station);
    }
    [[nodiscard]] std::optional<RangeOver> radius_over(const RangeOver& radius,
                                                       const MechanismStateOver& state,
                                                       int station) const override {
        return curvature_excess(form(), over(state), radius, 1.0, station);
    }
    [[nodiscard]] std::optional<RangeAlong> quantity_along(MechanismQuantity which,
                                                           const MechanismStateAlong& state,
                                                           int station) const override {
        return camopt::quantity(cam(state.dimensions), {state.s, state.velocity, state.acceleration}, which,
                                station);
    }
    [[nodiscard]] MechanismPoint point(double theta, const MechanismState& state,
                                       int station) const override {
        return mechanism_point(profile_point(cam(state.dimensions), theta, state.output, station));
    }
    [[nodiscard]] DirectCamDrawing drawing(std::span<const double> dimensions) const override {
        DirectCamDrawing drawing{name_of(follower_), form_.drives_both_ways() ? name_of(form_.type) : "", {}};
        for (std::size_t i = 0; i < which_.size(); ++i)
            drawing.dimensions.push_back({name_of(which_[i]), dimensions[i]});
        for (const auto& dimension : form_dimensions(follower_, form_))
            drawing.dimensions.push_back({dimension.name, dimension.value.low, dimension.is_angle, true});
        if (form_.is_grooved())
            drawing.groove_wall = form_.groove_wall.value_or(cam(dimensions)[DimensionIndex::roller_radius]);
        if (form_.is_conjugate()) drawing.pieces = pieces(cam(dimensions));
        return drawing;
    }
    [[nodiscard]] CamPose pose(const MechanismState& state) const override {
        return {sense_of(rotation_) * state.theta};
    }
    /// A pushed follower is on a stem that is guided above the cam, a swinging one on an arm.
    [[nodiscard]] std::vector<MechanismShape> shapes(const MechanismState& state) const override {
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
    /// The second roller of a conjugate cam runs on its own disk, in a mirror image in which it falls when
    /// the first one rises.
    [[nodiscard]] std::optional<FollowerGeometry> follower(std::span<const double> dimensions,
                                                           int station) const override {
        using enum DimensionIndex;
        const bool second = station == 1 && form_.is_conjugate();
        const DiskCam own = second ? second_disk(cam(dimensions)) : cam(dimensions);
        FollowerGeometry found;
        found.contact = contact();
        found.swings = swings();
        found.roller_radius = own[DimensionIndex::roller_radius];
        found.offset = own[offset];
        found.pivot_distance = own[center_distance];
        found.arm = own[arm_length];
        found.face_offset = own[face_offset];
        found.rest_distance = own[base_radius] + own[DimensionIndex::roller_radius];
        found.mirrored = found.falls = second;
        found.from_inside = station == 1 && form_.is_grooved();
        return found;
    }

 private:
    /// The disks of a conjugate cam, as open cams.
    [[nodiscard]] std::vector<DrivenMechanism> pieces(DiskCam first) const {
        first.form = {};
        DiskCam second = first;
        const auto set = [&second](DimensionIndex which, const std::optional<double>& value) {
            if (value) second.dimensions[static_cast<std::size_t>(which)] = *value;
        };
        set(DimensionIndex::roller_radius, form_.second_roller_radius);
        set(DimensionIndex::offset, form_.second_offset);
        set(DimensionIndex::arm_length, form_.second_arm_length);
        return {disk_mechanism(first), disk_mechanism(second)};
    }
    /// On the slide, or on a separate arm.
    void add_second_roller(std::vector<MechanismShape>& shapes, const DiskCam& own,
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
    /// The cam without its dimensions, for boxes of them.
    [[nodiscard]] DiskCam form() const { return {follower_, rotation_, {}, form_}; }
    [[nodiscard]] StateOver over(const MechanismStateOver& state) const {
        StateOver own{state.s, state.velocity, state.acceleration, {}};
        for (std::size_t i = 0; i < which_.size(); ++i)
            own.dimensions[static_cast<std::size_t>(which_[i])] = state.dimensions[i];
        return own;
    }
    [[nodiscard]] bool is_active(const MechanismSetting& setting, DimensionIndex dimension) const {
        return std::ranges::find(setting.active, place_of(dimension)) != setting.active.end();
    }
    [[nodiscard]] int place_of(DimensionIndex dimension) const {
        return static_cast<int>(std::ranges::find(which_, dimension) - which_.begin());
    }

    FollowerType follower_;
    Rotation rotation_;
    FormSpec form_;
    std::vector<DimensionIndex> which_;
};

}  // namespace

std::shared_ptr<const CamMechanism> disk_formulas(const CamSpec& spec) {
    const DiskSpec disk = disk_of(spec);
    return std::make_shared<DiskMechanism>(disk.follower, disk.rotation, disk.form);
}

CamSpec disk_spec(const DiskSpec& cam) {
    CamSpec spec = blank_disk_spec(cam);
    spec.make = disk_formulas;
    return spec;
}

DrivenMechanism disk_mechanism(const DiskCam& cam) {
    DrivenMechanism mechanism{std::make_shared<DiskMechanism>(cam.follower, cam.rotation, cam.form), {}};
    for (const DimensionIndex which : dimensions_of(cam.follower)) mechanism.dimensions.push_back(cam[which]);
    for (const CamDimension& dimension : form_dimensions(cam.follower, cam.form))
        mechanism.dimensions.push_back(dimension.value.low);
    return mechanism;
}

std::optional<DiskCam> disk_cam(const DrivenMechanism& mechanism) {
    const auto* const disk = dynamic_cast<const DiskMechanism*>(mechanism.formulas.get());
    if (disk == nullptr) return std::nullopt;
    return disk->cam(mechanism.dimensions);
}

}  // namespace camopt
