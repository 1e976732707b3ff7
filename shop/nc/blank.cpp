// SPDX-License-Identifier: MIT
#include "shop/nc/blank.hpp"

#include "core/units.hpp"
#include "shop/nc/requirement.hpp"

namespace camopt {

namespace {

constexpr int most_projections = 60;    // between two convex bodies; any direction found is a valid bound
constexpr double settled_step = 1e-10;  // m: the points no longer move
constexpr double least_gap = 1e-12;     // m: below, the direction between two points is rounding

/// The cutter as a set of points: a cylinder of `radius` from its tip up, without an end.
struct Cutter {
    Eigen::Vector3d tip, up;
    double radius;

    [[nodiscard]] Eigen::Vector3d nearest(const Eigen::Vector3d& point) const {
        const Eigen::Vector3d from_tip = point - tip;
        const double along = from_tip.dot(up);
        Eigen::Vector3d across = from_tip - along * up;
        if (const double length = across.norm(); length > radius) across *= radius / length;
        return tip + std::max(along, 0.0) * up + across;
    }
    /// The least d · p over the cutter for d that does not fall along it.
    [[nodiscard]] double least_along(const Eigen::Vector3d& d) const {
        return tip.dot(d) - radius * (d - d.dot(up) * up).norm();
    }
};

/// How far the plane across `direction` keeps the two apart. The cutter has no upper end, so a direction that
/// falls along it separates nothing: its falling part, rounding as a rule, is taken out.
double separation(const Blank& blank, const Cutter& cutter, Eigen::Vector3d direction) {
    const double along = direction.dot(cutter.up);
    if (along < 0.0) direction -= along * cutter.up;
    const double length = direction.norm();
    if (!(length > least_gap)) return -HUGE_VAL;
    direction /= length;
    return cutter.least_along(direction) - blank.support(direction);
}

constexpr Requirement require_blank{"blank", " mm", units::millimetre};

}  // namespace

void Blank::validate() const {
    if (block)
        require_blank(!block->isEmpty() && block->sizes().minCoeff() > 0.0, "its sides must be > 0 mm",
                      block->isEmpty() ? 0.0 : block->sizes().minCoeff());
    else
        require_blank(std::isfinite(radius) && radius > 0.0, "its radius must be given and > 0 mm", radius);
    require_blank(std::isfinite(lower), "its lower end must be a finite height", lower);
    require_blank(std::isfinite(upper) && upper > lower, "its upper end must lie above its lower end", upper);
}

double Blank::support(const Eigen::Vector3d& direction) const {
    const double across =
        block ? std::max(direction.x() * block->min().x(), direction.x() * block->max().x()) +
                    std::max(direction.y() * block->min().y(), direction.y() * block->max().y())
              : radius * std::hypot(direction.x(), direction.y());
    return across + std::max(direction.z() * lower, direction.z() * upper);
}

double Blank::farthest_from_axis() const {
    return block ? block->min().cwiseAbs().cwiseMax(block->max().cwiseAbs()).norm() : radius;
}

Eigen::Vector3d Blank::nearest(const Eigen::Vector3d& point) const {
    Eigen::Vector2d across = point.head<2>();
    if (block)
        across = across.cwiseMax(block->min()).cwiseMin(block->max());
    else if (across.norm() > radius)
        across *= radius / across.norm();
    return {across.x(), across.y(), std::clamp(point.z(), lower, upper)};
}

void BlankChoice::validate() const {
    require_blank(std::isfinite(allowance) && allowance >= 0.0, "the allowance must be >= 0 mm", allowance);
}

Blank chosen_blank(const Blank& with_allowance, const BlankChoice& choice) {
    choice.validate();
    Blank blank{choice.radius.value_or(with_allowance.radius), choice.lower.value_or(with_allowance.lower),
                choice.upper.value_or(with_allowance.upper)};
    blank.validate();
    return blank;
}

double greatest_height(const Blank& blank, const Machine& machine) {
    // Up is −O: height(u) = radius sqrt(1 − u²) + max(u lower, u upper), concave on either side of u = 0.
    const AxisRange range = machine.tool_along_cam_axis();
    double greatest = -HUGE_VAL;
    const auto take = [&](double u) {
        u = std::clamp(u, -range.most, -range.least);
        const double across = std::sqrt(std::max(1.0 - u * u, 0.0)) * blank.farthest_from_axis();
        greatest = std::max(greatest, across + std::max(u * blank.lower, u * blank.upper));
    };
    for (const double end : {blank.lower, blank.upper})
        take(end / std::hypot(blank.farthest_from_axis(), end));
    for (const double u : {-1.0, 0.0, 1.0}) take(u);
    return greatest;
}

double distance_to_blank(const Blank& blank, const ToolPose& pose, double cutter_radius) {
    const Cutter cutter{pose.tip, -pose.axis, cutter_radius};
    double best = separation(blank, cutter, cutter.up);
    best = std::max(best, separation(blank, cutter, {pose.tip.x(), pose.tip.y(), 0.0}));
    Eigen::Vector3d ours = blank.nearest(pose.tip);
    for (int i = 0; i < most_projections; ++i) {
        const Eigen::Vector3d theirs = cutter.nearest(ours), next = blank.nearest(theirs);
        if (!((theirs - next).norm() > least_gap)) return best;
        const double moved = (next - ours).norm();
        ours = next;
        if (moved > settled_step) continue;
        return std::max(best, separation(blank, cutter, theirs - ours));
    }
    return std::max(best, separation(blank, cutter, cutter.nearest(ours) - ours));
}

std::string words_of(const Blank& blank) {
    if (blank.block)
        return fmt::format(
            "block, x from {:.3f} to {:.3f} mm, y from {:.3f} to {:.3f} mm, z from {:.3f} to {:.3f} mm",
            blank.block->min().x() / units::millimetre, blank.block->max().x() / units::millimetre,
            blank.block->min().y() / units::millimetre, blank.block->max().y() / units::millimetre,
            blank.lower / units::millimetre, blank.upper / units::millimetre);
    return fmt::format(
        "cylinder about the axis of the cam, diameter {:.3f} mm, from {:.3f} to {:.3f} mm along it",
        2.0 * blank.radius / units::millimetre, blank.lower / units::millimetre,
        blank.upper / units::millimetre);
}

std::string clamp_words(const Blank& clamp) {
    if (clamp.block)
        return fmt::format("below y = {:g} mm along the plate", clamp.block->max().y() / units::millimetre);
    return fmt::format("within diameter {:g} mm about the cam's axis",
                       2.0 * clamp.radius / units::millimetre);
}

}  // namespace camopt
