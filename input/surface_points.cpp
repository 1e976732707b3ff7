// SPDX-License-Identifier: MIT
#include "core/numbers/robust_fit.hpp"
#include "input/scene_parts.hpp"

#include <fmt/format.h>

namespace camopt::input {

namespace {

using Eigen::Vector2d;

constexpr double widest_gap = 20.0 * units::degree;          // between points: no curve is known there
constexpr double same_direction = 1e-9;                      // rad
constexpr double rounding_depth = 1e-6, noise_depths = 3.0;  // m, and of the noise: a cut this deep is none
constexpr std::size_t most_compared = 2000;                  // points that the follower must not cut into

/// A point of the surface, smoothed, with its outward normal.
struct SurfacePoint {
    std::size_t row = 0;
    double direction = 0.0, radius = 0.0;  ///< as measured, seen from the cam's centre
    Vector2d normal{0.0, 0.0}, smooth{0.0, 0.0};
    [[nodiscard]] Vector2d along() const { return {std::cos(direction), std::sin(direction)}; }
};

class Surface {
 public:
    Surface(std::span<const Vector2d> given, const SurfaceProbe& probe) : probe_(probe) {
        for (std::size_t k = 0; k < given.size(); ++k) {
            const Vector2d seen = probe.follower.seen(given[k]);
            points_.push_back({k, std::atan2(seen.y(), seen.x()), seen.norm()});
        }
        std::ranges::stable_sort(points_, {}, &SurfacePoint::direction);
        const auto again = std::unique(points_.begin(), points_.end(), [](const auto& a, const auto& b) {
            return b.direction - a.direction <= same_direction;
        });
        points_.erase(again, points_.end());
        require_all_around();
        smooth();
    }

    [[nodiscard]] SurfaceMotion motion() const {
        struct Row {
            double angle, displacement;
            std::size_t row;
        };
        std::vector<Row> rows;
        SurfaceMotion motion;
        const double rest = probe_.follower.rest_position(), upwards = probe_.follower.falls ? -1.0 : 1.0;
        for (const SurfacePoint& point : points_) {
            const Vector2d measured = point.radius * point.along() - probe_.radius * point.normal;
            const auto [angle, position] = held(measured, point.normal);
            if (!std::isfinite(angle + position) || cuts(point)) {
                ++motion.untouched;
                continue;
            }
            const double turned = angle - units::turn * std::floor(angle / units::turn);
            rows.push_back({turned, upwards * (position - rest), point.row});
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
    const SurfaceProbe& probe_;
    std::vector<SurfacePoint> points_;
    double noise_ = 0.0;

    void require_all_around() const {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const SurfacePoint& next = points_[(i + 1) % points_.size()];
            const double gap =
                next.direction - points_[i].direction + (i + 1 < points_.size() ? 0.0 : units::turn);
            if (gap > widest_gap)
                throw SceneError({entry_key("measured.theta", points_[i].row),
                                  fmt::format("no point within {:.4g} deg after it", gap / units::degree),
                                  fmt::format("points all around the cam's centre, at most {:.4g} deg apart",
                                              widest_gap / units::degree)});
        }
    }

    /// The radius over the direction: of r(φ) the normal is r e_r − r' e_φ.
    void smooth() {
        std::vector<double> directions, radii, off;
        for (const SurfacePoint& point : points_) {
            directions.push_back(point.direction);
            radii.push_back(point.radius);
        }
        const std::vector<LocalFit> fits = local_fits(directions, radii, units::turn);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            SurfacePoint& point = points_[i];
            const Vector2d along = point.along(), ahead(-along.y(), along.x());
            point.normal = (fits[i].value * along - fits[i].slope * ahead).normalized();
            point.smooth = fits[i].value * along - probe_.radius * point.normal;
            off.push_back(fits[i].off);
        }
        noise_ = spread_of(std::move(off));
    }

    [[nodiscard]] bool is_flat() const { return probe_.follower.contact == ContactKind::flat; }

    /// The cam angle and the position at which the follower touches this point with this normal.
    [[nodiscard]] std::pair<double, double> held(const Vector2d& point, const Vector2d& normal) const {
        const FollowerGeometry& follower = probe_.follower;
        const Vector2d own = is_flat() ? normal : Vector2d(point + probe_.roller_radius * normal);
        const double position = follower.position_at(is_flat() ? point.dot(normal) : own.norm());
        Vector2d fixed(follower.offset, position);  // the roller's centre, or the normal of the face
        if (follower.swings && is_flat())
            fixed = {std::sin(position), std::cos(position)};
        else if (follower.swings)
            fixed = {follower.pivot_distance - follower.arm * std::cos(position),
                     follower.arm * std::sin(position)};
        else if (is_flat())
            fixed = {0.0, 1.0};
        const double turned = std::atan2(fixed.y(), fixed.x()) - std::atan2(own.y(), own.x());
        return {probe_.sense * turned, position};
    }

    /// Whether the follower that touches this point would cut into another one: it never touches this one.
    [[nodiscard]] bool cuts(const SurfacePoint& at) const {
        const double depth = rounding_depth + noise_depths * noise_, roller = probe_.roller_radius;
        if (!is_flat() && roller <= depth) return false;
        const Vector2d center = at.smooth + roller * at.normal;
        const std::size_t stride = 1 + points_.size() / most_compared;
        for (std::size_t k = 0; k < points_.size(); k += stride) {
            const Vector2d away = points_[k].smooth - center;
            if (is_flat() ? away.dot(at.normal) > depth
                          : away.squaredNorm() < (roller - depth) * (roller - depth))
                return true;
        }
        return false;
    }
};

}  // namespace

SurfaceProbe surface_probe(const CamSpec& cam, double probe_radius) {
    const std::shared_ptr<const CamMechanism> formulas = cam.formulas();
    const std::vector<double> dimensions = cam.middle();
    std::optional<FollowerGeometry> follower = formulas->follower(dimensions, 0);
    if (!follower || follower->linkage || follower->slide)
        throw SceneError({"measured", fmt::format("points of a cam of type \"{}\"", cam.type),
                          "points of a \"disk\" cam, or displacements"});
    SurfaceProbe probe{*std::move(follower), probe_radius, 0.0, sense_of(formulas->rotation())};
    if (probe.follower.mirrored) probe.sense = -probe.sense;
    if (probe.follower.contact == ContactKind::roller)
        probe.roller_radius = formulas->surface_offset(dimensions, 0);
    return probe;
}

SurfaceMotion motion_on_surface(std::span<const Vector2d> points, const SurfaceProbe& probe) {
    return Surface(points, probe).motion();
}

}  // namespace camopt::input
