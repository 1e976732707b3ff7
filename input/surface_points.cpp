// SPDX-License-Identifier: MIT
#include "core/numbers/robust_fit.hpp"
#include "input/scene_parts.hpp"
#include "scene/cam_flanks.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <fmt/format.h>

namespace camopt::input {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double widest_gap = 20.0 * units::degree;          // between points: no curve is known there
constexpr double same_direction = 1e-9;                      // rad
constexpr double rounding_depth = 1e-6, noise_depths = 3.0;  // m, and of the noise: a cut this deep is none
constexpr std::size_t most_compared = 2000;                  // points that the follower must not cut into
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

/// A point of a path: w along it, v across it, and dv/dw.
struct PathPoint {
    double along = 0.0, across = 0.0, slope = 0.0;
};

/// A point of a plane surface and its unit normal, out of the cam: towards the follower.
struct Touch {
    Vector2d point, normal;
};

/// Where the follower is: cam angle and displacement. NaN: nowhere.
struct Held {
    double angle = nowhere, displacement = nowhere;
};

Vector2d at_angle(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

double turned_back(double angle) {
    return angle - units::turn * std::floor(angle / units::turn);
}

}  // namespace

class CamUnderFollower {
 public:
    explicit CamUnderFollower(const PointForm& form) : form_(form) {}
    virtual ~CamUnderFollower() = default;
    CamUnderFollower(const CamUnderFollower&) = delete;
    CamUnderFollower& operator=(const CamUnderFollower&) = delete;

    /// w, rad or like it, and v, m or rad, of a given point.
    [[nodiscard]] virtual PathPoint path_of(const Vector2d& given) const = 0;
    [[nodiscard]] virtual double period() const { return 0.0; }
    [[nodiscard]] virtual bool axial() const { return false; }
    /// The surface there; none: of a three-dimensional cam.
    [[nodiscard]] virtual std::optional<Touch> touch(const PathPoint& /*at*/) const { return {}; }
    /// The follower at a point: with a normal on the surface, without one at its centre or edge.
    [[nodiscard]] virtual Held held(const PathPoint& at, const Vector2d& point,
                                    const std::optional<Vector2d>& normal) const = 0;
    /// The follower from outside: what it must not cut into.
    [[nodiscard]] virtual const FollowerGeometry* outside() const { return nullptr; }
    /// Where a motion of a revolution begins anew.
    [[nodiscard]] virtual bool turns() const { return false; }

    [[nodiscard]] const PointForm& form() const { return form_; }

 private:
    PointForm form_;
};

namespace {

/// Plane cams under a follower that is pushed or swings: in its frame (FollowerGeometry).
class PlaneCam : public CamUnderFollower {
 public:
    PlaneCam(const PointForm& form, FollowerGeometry follower, double roller_radius)
        : CamUnderFollower(form),
          follower_(std::move(follower)),
          roller_(follower_.contact == ContactKind::roller ? roller_radius : 0.0) {}

    [[nodiscard]] const FollowerGeometry* outside() const override {
        return follower_.from_inside ? nullptr : &follower_;
    }
    [[nodiscard]] double roller() const { return roller_; }
    [[nodiscard]] const FollowerGeometry& follower() const { return follower_; }

    [[nodiscard]] Held held(const PathPoint& /*at*/, const Vector2d& point,
                            const std::optional<Vector2d>& normal) const override {
        Vector2d own = point;
        if (normal && !is_flat()) own += roller_ * *normal;
        const auto [angle, position] = placed(own, normal);
        if (follower_.linkage) return {angle, follower_.linkage(follower_.arm_angle(position))};
        return {angle, (follower_.falls ? -1.0 : 1.0) * (position - follower_.rest_position())};
    }

 protected:
    /// The cam angle and the position at which the follower is at this point of the cam, a face with this
    /// normal.
    [[nodiscard]] virtual std::pair<double, double> placed(const Vector2d& own,
                                                           const std::optional<Vector2d>& normal) const = 0;
    [[nodiscard]] bool is_flat() const { return follower_.contact == ContactKind::flat; }

 private:
    FollowerGeometry follower_;
    double roller_;
};

/// A cam that turns: polar coordinates about its centre. Of r(φ) the normal is r e_r − r' e_φ.
class TurningCam final : public PlaneCam {
 public:
    TurningCam(const PointForm& form, FollowerGeometry follower, double roller_radius, double sense)
        : PlaneCam(form, std::move(follower), roller_radius),
          sense_(PlaneCam::follower().mirrored ? -sense : sense) {}

    [[nodiscard]] bool turns() const override { return true; }
    [[nodiscard]] double period() const override { return form().closed ? units::turn : 0.0; }
    [[nodiscard]] PathPoint path_of(const Vector2d& given) const override {
        const Vector2d seen = follower().seen(given);
        return {std::atan2(seen.y(), seen.x()), seen.norm()};
    }
    [[nodiscard]] std::optional<Touch> touch(const PathPoint& at) const override {
        const Vector2d along = at_angle(at.along), ahead(-along.y(), along.x());
        const double outwards = follower().from_inside ? -1.0 : 1.0;
        return Touch{at.across * along, outwards * (at.across * along - at.slope * ahead).normalized()};
    }

 protected:
    [[nodiscard]] std::pair<double, double> placed(const Vector2d& own,
                                                   const std::optional<Vector2d>& normal) const override {
        const FollowerGeometry& one = follower();
        const Vector2d seen = is_flat() ? normal.value() : own;
        const double position = one.position_at(is_flat() ? own.dot(seen) : own.norm());
        Vector2d fixed(one.offset, position);  // the roller's centre, or the normal of the face
        if (one.swings && is_flat())
            fixed = {std::sin(position), std::cos(position)};
        else if (one.swings)
            fixed = {one.pivot_distance - one.arm * std::cos(position), one.arm * std::sin(position)};
        else if (is_flat())
            fixed = {0.0, 1.0};
        const double turned = std::atan2(fixed.y(), fixed.x()) - std::atan2(seen.y(), seen.x());
        return {sense_ * turned, position};
    }

 private:
    double sense_;
};

/// A cam that slides by c for every radian: along c and across it. The point that the follower touches at the
/// angle θ has slid by c θ.
class SlidingCam final : public PlaneCam {
 public:
    SlidingCam(const PointForm& form, FollowerGeometry follower, double roller_radius)
        : PlaneCam(form, std::move(follower), roller_radius),
          slide_(*PlaneCam::follower().slide),
          up_(PlaneCam::follower().seen({0.0, 1.0})) {}

    [[nodiscard]] PathPoint path_of(const Vector2d& given) const override {
        const Vector2d seen = follower().seen(given);
        return {-seen.dot(slide_) / slide_.squaredNorm(), seen.dot(up_)};
    }
    [[nodiscard]] std::optional<Touch> touch(const PathPoint& at) const override {
        const Vector2d normal = up_ + at.slope / slide_.squaredNorm() * slide_;
        return Touch{at.across * up_ - at.along * slide_, normal.normalized()};
    }

 protected:
    [[nodiscard]] std::pair<double, double> placed(const Vector2d& own,
                                                   const std::optional<Vector2d>& /*normal*/) const override {
        const FollowerGeometry& one = follower();
        if (!one.swings) {
            const double angle = (one.offset - own.x()) / slide_.x();
            return {angle, own.y() + angle * slide_.y()};
        }
        // |own + θ c − pivot| = arm: the root on this side of the arm, nearest to rest.
        const Vector2d from(own.x() - one.pivot_distance, own.y());
        const double middle = -from.dot(slide_) / slide_.squaredNorm(),
                     square =
                         (one.arm * one.arm - (from + middle * slide_).squaredNorm()) / slide_.squaredNorm();
        std::pair<double, double> best{nowhere, nowhere};
        if (!(square >= 0.0)) return best;
        for (const double side : {-1.0, 1.0}) {
            const double angle = middle + side * std::sqrt(square);
            const Vector2d at = from + angle * slide_;
            const double position = std::atan2(at.y(), -at.x());
            const auto off = [&](double one_position) {
                return std::abs(one_position - one.rest_position());
            };
            if (position < one.most_position && (std::isnan(best.second) || off(position) < off(best.second)))
                best = {angle, position};
        }
        return best;
    }

 private:
    Vector2d slide_, up_;
};

/// A guide in a body that swings about the origin: distance and polar angle. The first side is the left wall,
/// seen outwards.
class GuideCam final : public CamUnderFollower {
 public:
    GuideCam(const PointForm& form, RollerGuide guide, double lift)
        : CamUnderFollower(form),
          guide_(std::move(guide)),
          lift_(lift),
          size_(std::abs(guide_.distance(1.0) - guide_.distance(0.0))) {}

    /// The distance in parts of what the roller moves in the first radian.
    [[nodiscard]] PathPoint path_of(const Vector2d& given) const override {
        return {given.norm() / size_, std::atan2(given.y(), given.x())};
    }
    [[nodiscard]] std::optional<Touch> touch(const PathPoint& at) const override {
        const Vector2d radial = at_angle(at.across), left(-radial.y(), radial.x());
        const Vector2d tangent = (radial + at.along * at.slope * left).normalized();
        return Touch{size_ * at.along * radial,
                     (form().side == 0 ? 1.0 : -1.0) * Vector2d(tangent.y(), -tangent.x())};
    }
    [[nodiscard]] Held held(const PathPoint& /*at*/, const Vector2d& point,
                            const std::optional<Vector2d>& normal) const override {
        const Vector2d center = normal ? Vector2d(point + guide_.roller_radius * *normal) : point;
        return {guide_.cam_angle(center.norm()), displacement_at(std::atan2(center.y(), center.x()))};
    }
    /// By how much each point is turned about the pivot that lies where the output rests, before the motion
    /// and after it: there the guide is a line from the pivot, its walls lie beside it.
    [[nodiscard]] std::vector<double> turns_at_rest(std::span<const Vector2d> points,
                                                    const MotionSpec& motion) const {
        const double first = guide_.distance(0.0),
                     last = guide_.distance(motion.unit_angle() * motion.length());
        const double beside =
            form().centers ? 0.0
                           : (form().side == 0 ? 1.0 : -1.0) * (guide_.roller_radius - form().probe_radius);
        std::vector<double> turns;
        for (const Vector2d& point : points) {
            const double square = point.squaredNorm() - beside * beside;
            const double distance = square > 0.0 ? std::sqrt(square) : 0.0;
            if (!(distance > 0.0) || (distance > first && distance < last)) continue;
            const double wanted = guide_.angle({distance <= first ? 0.0 : motion.lift, 0.0, 0.0});
            const double turn = std::atan2(point.y(), point.x()) - std::atan2(beside, distance) - wanted;
            turns.push_back(std::remainder(turn, units::turn));
        }
        return turns;
    }

 private:
    RollerGuide guide_;
    double lift_, size_;

    /// The output at which the body is at ψ, by Newton's method.
    [[nodiscard]] double displacement_at(double angle) const {
        constexpr int most_steps = 40;
        constexpr double step = 1e-4, settled = 1e-15;  // of the lift
        double s = 0.5 * lift_;
        for (int i = 0; i < most_steps; ++i) {
            const double here = guide_.angle({s, 0.0, 0.0}),
                         slope = (guide_.angle({s + step * lift_, 0.0, 0.0}) - here) / (step * lift_);
            const double change = (angle - here) / slope;
            s += change;
            if (!(std::abs(change) > settled * lift_)) break;
        }
        return s;
    }
};

/// A three-dimensional cam: angle about its axis and z, on a cylinder about it.
class DrumCam final : public CamUnderFollower {
 public:
    DrumCam(const PointForm& form, CamFlanks flanks, double lift)
        : CamUnderFollower(form), flanks_(std::move(flanks)), lift_(lift) {
        const Vector3d foot = flanks_.axis(0.0, 0.5 * lift_).foot;
        radius_ = form.radius.value_or(std::hypot(foot.x(), foot.y()));
        const FollowerState moving{0.5 * lift_, 1e-3 * lift_, 0.0};
        const FlankPoint point =
            flanks_.point(0.0, moving, {0.5 * flanks_.roller_length, form.side == 0 ? 1 : -1});
        ahead_ = point.normal.dot(flanks_.axis(0.0, moving.s).travel) < 0.0 ? -1.0 : 1.0;
    }

    [[nodiscard]] bool axial() const override { return true; }
    [[nodiscard]] bool turns() const override { return true; }
    [[nodiscard]] double period() const override { return form().closed ? units::turn : 0.0; }
    [[nodiscard]] PathPoint path_of(const Vector2d& given) const override {
        return {form().closed ? turned_back(given.x()) : given.x(), given.y()};
    }
    [[nodiscard]] Held held(const PathPoint& at, const Vector2d& /*point*/,
                            const std::optional<Vector2d>& /*normal*/) const override {
        const Vector2d round = at_angle(at.along);
        const Vector3d point(radius_ * round.x(), radius_ * round.y(), at.across);
        const Vector3d tangent = Vector3d(-radius_ * round.y(), radius_ * round.x(), at.slope).normalized();
        if (!std::isnan(last_.angle)) {
            if (const Held found = settled(point, tangent, last_); !std::isnan(found.angle))
                return last_ = found;
        }
        return last_ = searched(point, tangent);
    }

 private:
    CamFlanks flanks_;
    double lift_, radius_ = 0.0, ahead_ = 1.0;
    mutable Held last_;  ///< of the point before: where the search begins

    /// From the roller's axis to a point, across it.
    [[nodiscard]] Vector3d across(const Held& at, const Vector3d& point) const {
        const RollerAxis axis = flanks_.axis(at.angle, at.displacement);
        const Vector3d from = point - axis.foot;
        return from - from.dot(axis.direction) * axis.direction;
    }
    /// What is 0 where the follower is at the point: its axis through it, or its roller against it along the
    /// tangent.
    [[nodiscard]] Vector3d miss(const Held& at, const Vector3d& point, const Vector3d& tangent) const {
        Vector3d off = across(at, point);
        if (form().centers) return off;
        return {off.norm() - flanks_.roller_radius, off.dot(tangent), 0.0};
    }
    /// Newton's method from a state. NaN: it does not settle.
    [[nodiscard]] Held settled(const Vector3d& point, const Vector3d& tangent, Held at) const {
        constexpr int most_steps = 30;
        constexpr double step = 1e-6, enough = 1e-14;  // rad and lifts; of the cylinder's radius
        for (int i = 0; i < most_steps; ++i) {
            const Vector3d off = miss(at, point, tangent);
            if (off.norm() < enough * radius_) return at;
            Eigen::Matrix<double, 3, 2> slopes;
            slopes.col(0) = (miss({at.angle + step, at.displacement}, point, tangent) - off) / step;
            slopes.col(1) = (miss({at.angle, at.displacement + step * lift_}, point, tangent) - off) / step;
            const Vector2d change = slopes.colPivHouseholderQr().solve(off);
            at.angle -= change[0];
            at.displacement -= lift_ * change[1];
            if (!(std::abs(change[0]) < units::turn && std::abs(change[1]) < 10.0)) return {};
        }
        constexpr double rounded = 1e-10;
        return miss(at, point, tangent).norm() < rounded * radius_ ? at : Held{};
    }
    /// From displacements over the whole lift and beyond: the solution on the side of the flank.
    [[nodiscard]] Held searched(const Vector3d& point, const Vector3d& tangent) const {
        constexpr int starts = 24;
        constexpr double from = -0.3, range = 1.6;  // lifts
        Held best;
        for (int i = 0; i <= starts; ++i) {
            const double s = lift_ * (from + range * i / starts);
            const RollerAxis axis = flanks_.axis(0.0, s);
            const double ahead = std::atan2(axis.foot.y(), axis.foot.x()) - std::atan2(point.y(), point.x());
            Held found = settled(point, tangent, {sense_of(flanks_.rotation) * ahead, s});
            if (std::isnan(found.angle)) continue;
            const double side =
                across(found, point).dot(flanks_.axis(found.angle, found.displacement).travel);
            const bool wrong = !form().centers && side * ahead_ < 0.0;
            const auto beyond = [&](double one) { return std::abs(one - 0.5 * lift_); };
            if (!wrong && (std::isnan(best.angle) || beyond(found.displacement) < beyond(best.displacement)))
                best = found;
        }
        return best;
    }
};

/// Points in the order of their path, smoothed.
class PointsOfCam {
 public:
    PointsOfCam(std::span<const Vector2d> given, const CamUnderFollower& cam) : cam_(cam) {
        for (std::size_t k = 0; k < given.size(); ++k) points_.push_back({k, cam.path_of(given[k])});
        if (cam.turns() && !cam.form().closed) join_around();
        std::ranges::stable_sort(points_, {}, &Point::along);
        const auto again = std::unique(points_.begin(), points_.end(), [](const auto& a, const auto& b) {
            return b.along() - a.along() <= same_direction;
        });
        points_.erase(again, points_.end());
        if (cam.period() > 0.0) require_all_around();
        smooth();
    }

    [[nodiscard]] SurfaceMotion motion() const {
        SurfaceMotion motion;
        std::vector<Row> rows;
        for (const Point& point : points_) {
            const Held at = held(point);
            if (!std::isfinite(at.angle + at.displacement) || cuts(point)) {
                ++motion.untouched;
                continue;
            }
            rows.push_back({cam_.turns() ? turned_back(at.angle) : at.angle, at.displacement, point.row});
        }
        std::ranges::stable_sort(rows, {}, &Row::angle);
        for (const Row& row : rows) {
            if (!motion.angle.empty() && row.angle - motion.angle.back() <= same_direction) continue;
            motion.angle.push_back(row.angle);
            motion.displacement.push_back(row.displacement);
            motion.rows.push_back(row.row);
        }
        return motion;
    }

 private:
    struct Point {
        std::size_t row = 0;
        PathPoint path;  ///< as measured; the slope is that of the smooth path
        std::optional<Touch> smooth = {};
        [[nodiscard]] double along() const { return path.along; }
    };
    struct Row {
        double angle, displacement;
        std::size_t row;
    };

    const CamUnderFollower& cam_;
    std::vector<Point> points_;
    double noise_ = 0.0;

    /// Of a part of a revolution: without a jump inside.
    void join_around() {
        std::vector<double> all;
        for (const Point& point : points_) all.push_back(turned_back(point.along()));
        std::ranges::sort(all);
        double widest = all.front() + units::turn - all.back(), begin = all.front();
        for (std::size_t i = 1; i < all.size(); ++i)
            if (all[i] - all[i - 1] > widest) widest = all[i] - all[i - 1], begin = all[i];
        for (Point& point : points_) point.path.along = begin + turned_back(point.along() - begin);
    }

    void require_all_around() const {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const Point& next = points_[(i + 1) % points_.size()];
            const double gap =
                next.along() - points_[i].along() + (i + 1 < points_.size() ? 0.0 : units::turn);
            if (gap > widest_gap)
                throw SceneError({entry_key("measured.theta", points_[i].row),
                                  fmt::format("no point within {:.4g} deg after it", gap / units::degree),
                                  fmt::format("points all around the cam's centre, at most {:.4g} deg apart",
                                              widest_gap / units::degree)});
        }
    }

    void smooth() {
        std::vector<double> along, across, off;
        for (const Point& point : points_) {
            along.push_back(point.path.along);
            across.push_back(point.path.across);
        }
        const std::vector<LocalFit> fits = closest_local_fits(along, across, cam_.period());
        for (std::size_t i = 0; i < points_.size() && i < fits.size(); ++i) {
            Point& point = points_[i];
            point.path.slope = fits[i].slope;
            off.push_back(fits[i].off);
            if (cam_.form().centers) continue;
            point.smooth = cam_.touch({point.path.along, fits[i].value, fits[i].slope});
            if (point.smooth) point.smooth->point -= cam_.form().probe_radius * point.smooth->normal;
        }
        noise_ = spread_of(std::move(off));
    }

    [[nodiscard]] Held held(const Point& point) const {
        const std::optional<Touch> own = cam_.touch(point.path);
        if (!own) return cam_.held(point.path, {}, {});
        if (!point.smooth) return cam_.held(point.path, own->point, {});
        const Vector2d& normal = point.smooth->normal;
        return cam_.held(point.path, own->point - cam_.form().probe_radius * normal, normal);
    }

    /// Whether the follower that touches this point would cut into another one: it never touches this one.
    [[nodiscard]] bool cuts(const Point& at) const {
        const auto* const plane = dynamic_cast<const PlaneCam*>(&cam_);
        if (plane == nullptr || plane->outside() == nullptr || !at.smooth) return false;
        const bool flat = plane->follower().contact == ContactKind::flat;
        const double depth = rounding_depth + noise_depths * noise_, roller = plane->roller();
        if (!flat && roller <= depth) return false;
        const Vector2d center = at.smooth->point + roller * at.smooth->normal;
        const std::size_t stride = 1 + points_.size() / most_compared;
        for (std::size_t k = 0; k < points_.size(); k += stride) {
            const Vector2d away = points_[k].smooth->point - center;
            if (flat ? away.dot(at.smooth->normal) > depth
                     : away.squaredNorm() < (roller - depth) * (roller - depth))
                return true;
        }
        return false;
    }
};

[[noreturn]] void refuse_points(const std::string& found, const std::string& allowed) {
    throw SceneError({"measured", found, allowed});
}

}  // namespace

std::shared_ptr<const CamUnderFollower> cam_under_follower(const CamSpec& cam, const PointForm& form,
                                                           double lift) {
    const std::shared_ptr<const CamMechanism> formulas = cam.formulas();
    const std::vector<double> dimensions = cam.middle();
    const int side = form.side;
    if (std::optional<CamFlanks> flanks = formulas->flanks(dimensions)) {
        if (form.probe_radius > 0.0)
            throw SceneError({"measured.probe_radius", "centres of a probe on a three-dimensional cam",
                              "points of the flank itself"});
        return std::make_shared<DrumCam>(form, *std::move(flanks), lift);
    }
    if (side >= std::max(1, formulas->stations()))
        throw SceneError({"measured.side", fmt::format("{}", side + 1),
                          fmt::format("1: a cam of type \"{}\" with this follower has one side", cam.type)});
    if (std::optional<RollerGuide> guide = formulas->guide(dimensions))
        return std::make_shared<GuideCam>(form, *std::move(guide), lift);
    std::optional<FollowerGeometry> follower = formulas->follower(dimensions, side);
    if (!follower)
        throw SceneError({"measured", fmt::format("points of a cam of type \"{}\"", cam.type),
                          "displacements of its follower"});
    if (form.centers && follower->contact == ContactKind::flat)
        throw SceneError({"measured.of", "\"center\" with a flat face", "\"surface\""});
    const double roller = formulas->surface_offset(dimensions, side);
    if (follower->slide) return std::make_shared<SlidingCam>(form, *std::move(follower), roller);
    return std::make_shared<TurningCam>(form, *std::move(follower), roller, sense_of(formulas->rotation()));
}

SurfaceMotion motion_on_points(std::span<const Vector2d> points, bool axial, const CamUnderFollower& cam) {
    if (axial != cam.axial())
        refuse_points(
            axial ? "points (theta, z) of a plane cam" : "points in a plane of a three-dimensional cam",
            cam.axial() ? "theta and z on a cylinder about its axis" : "x and y, or r and theta");
    return PointsOfCam(points, cam).motion();
}

bool is_turning(const CamUnderFollower& cam) {
    return cam.turns();
}

bool is_guide(const CamUnderFollower& cam) {
    return dynamic_cast<const GuideCam*>(&cam) != nullptr;
}

MeasuredPlace register_guide(const MotionSpec& motion, RegisterRequest request, std::vector<Vector2d>& points,
                             const CamUnderFollower& cam) {
    constexpr std::size_t least_rows = 3;
    if (request.radius)
        throw SceneError({"measured.register", "\"radius\" of a guide",
                          "\"angle\": a guide is turned about its pivot, whose distance is known"});
    const std::vector<double> turns = dynamic_cast<const GuideCam&>(cam).turns_at_rest(points, motion);
    if (turns.size() < least_rows)
        throw SceneError({"measured.register", "points of a guide none of which lie where its feeder rests",
                          "points before its rise begins or after its end"});
    const auto count = static_cast<double>(turns.size());
    double sum = 0.0, squares = 0.0;
    for (const double turn : turns) sum += turn;
    const double angle = sum / count;
    for (const double turn : turns) squares += (turn - angle) * (turn - angle);
    for (Vector2d& point : points) point = Eigen::Rotation2Dd(-angle) * point;
    MeasuredPlace place;
    place.points = true;
    place.angle = {angle, std::sqrt(squares / (count - 1.0) / count)};
    return place;
}

std::optional<double> base_radius_for(const CamUnderFollower& cam, double zero) {
    const auto* const turning = dynamic_cast<const TurningCam*>(&cam);
    if (turning == nullptr || turning->follower().linkage) return {};
    const FollowerGeometry& follower = turning->follower();
    const double up = follower.falls ? -1.0 : 1.0;
    return follower.distance_at(follower.rest_position() + up * zero) - follower.roller_radius;
}

namespace {

constexpr int points_of_piece = 240;
constexpr double same_joint = 1e-6;                   // of the cam's size: coordinates in micrometres
constexpr double largest_kink = 0.5 * units::degree;  // of pieces whose coordinates were rounded

[[noreturn]] void refuse_piece(std::size_t index, const std::string& found, const std::string& allowed) {
    throw SceneError({entry_key("cam.piece", index), found, allowed});
}

/// A line or an arc.
struct Piece {
    Vector2d begin, end;
    std::optional<Vector2d> center;
    double sweep = 0.0;  ///< of an arc, rad

    [[nodiscard]] Vector2d at(double part) const {
        if (!center) return begin + part * (end - begin);
        return *center + Eigen::Rotation2Dd(part * sweep) * (begin - *center);
    }
    [[nodiscard]] Vector2d tangent(bool at_end) const {
        if (!center) return (end - begin).normalized();
        const Vector2d from = (at_end ? end : begin) - *center;
        return (sweep > 0.0 ? 1.0 : -1.0) * Vector2d(-from.y(), from.x()).normalized();
    }
};

Vector2d two_of(const std::vector<double>& numbers, std::size_t index) {
    if (numbers.size() != 2) refuse_piece(index, fmt::format("{} numbers", numbers.size()), "x and y");
    return {numbers[0], numbers[1]};
}

std::vector<Piece> pieces_of(const std::vector<CamPiece>& given) {
    std::vector<Piece> pieces;
    const CamPiece& first = given.front();
    Vector2d last = first.from.empty() ? two_of(given.back().to, given.size() - 1) : two_of(first.from, 0);
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (i > 0 && !given[i].from.empty())
            refuse_piece(i, "from", "only in the first piece: others begin where the one before ends");
        Piece piece{last, two_of(given[i].to, i), {}};
        const double size = std::max(piece.begin.norm(), piece.end.norm());
        if (!((piece.end - piece.begin).norm() > same_joint * size))
            refuse_piece(i, "a piece of no length", "another end; a full circle takes two arcs");
        if (!given[i].center.empty()) {
            piece.center = two_of(given[i].center, i);
            const Vector2d from = piece.begin - *piece.center, to = piece.end - *piece.center;
            if (!(std::abs(from.norm() - to.norm()) <= same_joint * std::max(size, from.norm())))
                refuse_piece(
                    i,
                    fmt::format("an arc whose end is {:.9g} times as far from its centre as its begin",
                                to.norm() / from.norm()),
                    "a centre at the same distance from both ends");
            piece.sweep = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
        }
        if (!pieces.empty()) {
            const Vector2d before = pieces.back().tangent(true), now = piece.tangent(false);
            const double kink =
                std::abs(std::atan2(before.x() * now.y() - before.y() * now.x(), before.dot(now)));
            if (kink > largest_kink)
                refuse_piece(i, fmt::format("a kink of {:.4g} deg", kink / units::degree),
                             fmt::format("tangents that follow one another, to {:.4g} deg",
                                         largest_kink / units::degree));
        }
        last = piece.end;
        pieces.push_back(piece);
    }
    return pieces;
}

}  // namespace

SurfaceMotion motion_on_pieces(const std::vector<CamPiece>& given, const CamUnderFollower& cam) {
    if (cam.axial()) refuse_piece(0, "pieces of a three-dimensional cam", "points (theta, z)");
    SurfaceMotion motion;
    struct Row {
        double angle, displacement;
    };
    std::vector<Row> rows;
    bool ended = false;
    double direction = 0.0, before = nowhere;
    const std::vector<Piece> pieces = pieces_of(given);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (int k = i == 0 ? 0 : 1; k <= points_of_piece; ++k) {
            const PathPoint path = cam.path_of(pieces[i].at(static_cast<double>(k) / points_of_piece));
            const Held at = cam.held(path, cam.touch(path)->point, {});
            const bool reached = std::isfinite(at.angle + at.displacement);
            ended = ended || (!reached && !rows.empty());
            if (reached && ended)
                refuse_piece(i, "a place that the follower does not reach in pieces before",
                             "pieces out of its reach at both ends only");
            if (!reached) continue;
            const double step =
                cam.turns() ? std::remainder(at.angle - before, units::turn) : at.angle - before;
            if (direction == 0.0 && step != 0.0 && !std::isnan(step)) direction = step;
            if (step * direction <= 0.0)
                refuse_piece(i, "a piece along which the cam angle turns back", "one roller, one place");
            before = std::isnan(step) ? at.angle : before + step;
            rows.push_back({before, at.displacement});
            if (k == points_of_piece) motion.breaks.push_back(before);
        }
    if (direction < 0.0) std::ranges::reverse(rows);
    for (const Row& row : rows) {
        motion.angle.push_back(row.angle);
        motion.displacement.push_back(row.displacement);
    }
    std::ranges::sort(motion.breaks);
    return motion;
}

}  // namespace camopt::input
