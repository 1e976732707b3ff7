// SPDX-License-Identifier: MIT
#include "output/spatial/indexing_body.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "core/whole_turn.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

using Section = std::vector<Eigen::Vector3d>;

constexpr double same_end = 1e-9;  // rad
constexpr int roller_corners = 40, hub_corners = 96;
// Choices of drawing, as parts of the least radius of the flanks.
constexpr double hub_part = 0.985, thread_part = 0.975, bore_part = 0.35;

class Builder {
 public:
    Builder(const SpatialCam& cam, const FollowerMotion& motion, const IndexingBodyOptions& options)
        : cam_(cam), motion_(motion), options_(options) {
        pitch_ = motion.state(motion.end()).s - motion.state(motion.begin()).s;
    }

    [[nodiscard]] IndexingBody build() {
        std::vector<Section> sections;
        // The thread between the rollers −1 and 0 comes in, stays, and goes on as that between 0 and 1.
        for (const int left : {-1, 0})
            for (int k = left < 0 ? 0 : 1; k <= options_.angles; ++k) {
                const double theta = motion_.begin() + units::turn * k / options_.angles;
                if (within_reach(theta, left)) sections.push_back(flanks_at(theta, left));
            }
        if (sections.size() < 2) throw InputError("indexing cam: the thread is not within reach");
        measure(sections);
        for (Section& section : sections) sink(section);
        return {swept_solid(sections, false), hub(), rollers()};
    }

 private:
    [[nodiscard]] SpatialCam roller(int index) const {
        SpatialCam shifted = cam_;
        shifted.start += index * pitch_;
        return shifted;
    }
    [[nodiscard]] bool within_reach(double theta, int left) const {
        // From the middle of the dwell's two rollers, in pitches.
        const double first = motion_.state(theta).s / pitch_ + left - 0.5;
        const double limit = 0.5 + options_.reach;
        return first >= -limit && first + 1.0 <= limit;
    }
    [[nodiscard]] double height(int i) const { return cam_.roller_length * i / (options_.heights - 1); }
    /// The contact of a roller on the side where s grows (+1) or falls (−1).
    [[nodiscard]] Eigen::Vector3d side(int index, double theta, double h, int direction) const {
        const SpatialCam cam = roller(index);
        const FollowerState state = motion_.state(theta);
        const Eigen::Vector3d travel = roller_axis(cam, theta, state.s).travel;
        const SpatialPoint point = spatial_point(cam, theta, state, {h, 1});
        const bool along = point.normal.dot(travel) * direction > 0.0;
        return along ? point.contact : spatial_point(cam, theta, state, {h, -1}).contact;
    }
    [[nodiscard]] Section flanks_at(double theta, int left) const {
        Section section;
        for (int i = 0; i < options_.heights; ++i) section.push_back(side(left, theta, height(i), 1));
        for (int i = options_.heights; i-- > 0;) section.push_back(side(left + 1, theta, height(i), -1));
        return section;
    }
    void measure(const std::vector<Section>& sections) {
        least_radius_ = HUGE_VAL;
        lower_ = HUGE_VAL;
        upper_ = -HUGE_VAL;
        for (const Section& section : sections)
            for (const Eigen::Vector3d& point : section) {
                least_radius_ = std::min(least_radius_, std::hypot(point.x(), point.y()));
                lower_ = std::min(lower_, point.z());
                upper_ = std::max(upper_, point.z());
            }
    }
    /// The foot of the section, inside the hub.
    void sink(Section& section) const {
        const auto foot = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
            const double part = (options_.foot_on_hub ? hub_part : thread_part) * least_radius_ /
                                std::hypot(point.x(), point.y());
            return {part * point.x(), part * point.y(), point.z()};
        };
        const auto middle = section.begin() + options_.heights;
        const Eigen::Vector3d left = foot(*(middle - 1)), right = foot(*middle);
        section.insert(middle, {left, right});
    }
    [[nodiscard]] TriangleMesh hub() const {
        std::vector<Section> sections;
        for (int k = 0; k < hub_corners; ++k) {
            const double angle = units::turn * k / hub_corners, c = std::cos(angle), s = std::sin(angle);
            const auto rim = [&](double part, double z) {
                return Eigen::Vector3d(part * least_radius_ * c, part * least_radius_ * s, z);
            };
            // Many short facets: painted one by one, large ones would hide what stands on them.
            Section section{rim(bore_part, upper_), rim(bore_part, lower_)};
            const int rings = 32;
            for (int i = 0; i <= rings; ++i)
                section.push_back(rim(hub_part, lower_ + (upper_ - lower_) * i / rings));
            sections.push_back(section);
        }
        return swept_solid(sections, true);
    }
    [[nodiscard]] TriangleMesh rollers() const {
        TriangleMesh all;
        for (const int index : {0, 1}) {
            const double theta = motion_.begin();
            const RollerAxis axis = roller_axis(roller(index), theta, motion_.state(theta).s);
            const Eigen::Vector3d across = axis.direction.cross(axis.travel);
            std::vector<Section> sections;
            for (const double h : {-0.35, 0.0, 0.5, 1.0}) {
                Section circle;
                for (int i = 0; i < roller_corners; ++i) {
                    const double angle = units::turn * i / roller_corners;
                    circle.push_back(axis.foot + h * cam_.roller_length * axis.direction +
                                     cam_[SpatialDimension::roller_radius] *
                                         (std::cos(angle) * axis.travel + std::sin(angle) * across));
                }
                sections.push_back(circle);
            }
            append(all, swept_solid(sections, false));
        }
        return all;
    }

    const SpatialCam& cam_;
    const FollowerMotion& motion_;
    const IndexingBodyOptions& options_;
    double pitch_ = 0.0, least_radius_ = 0.0, lower_ = 0.0, upper_ = 0.0;
};

}  // namespace

void IndexingBodyOptions::validate() const {
    if (angles < 16) throw InputError(fmt::format("indexing body: angles must be >= 16, found {}", angles));
    if (heights < 2) throw InputError(fmt::format("indexing body: heights must be >= 2, found {}", heights));
    if (!(reach >= 0.0 && reach <= 0.9))
        throw InputError(fmt::format("indexing body: reach must be 0 … 0.9, found {:g}", reach));
}

IndexingBody indexing_body(const SpatialCam& cam, const FollowerMotion& motion,
                           const IndexingBodyOptions& options) {
    options.validate();
    if (!is_whole_turn(motion.end() - motion.begin()))
        throw InputError(fmt::format("indexing cam: the motion must take one turn, it takes {:g} deg",
                                     (motion.end() - motion.begin()) / units::degree));
    if (!(std::abs(motion.state(motion.end()).s - motion.state(motion.begin()).s) > same_end))
        throw InputError("indexing cam: the motion must end one pitch from where it begins");
    return Builder(cam, motion, options).build();
}

std::vector<PaintedMesh> painted(const IndexingBody& body) {
    return {{body.hub, {150, 160, 172}, MeshPlace::revolved},
            {body.thread, {226, 164, 84}, MeshPlace::around_revolved},
            {body.rollers, {96, 142, 198}, MeshPlace::around_revolved}};
}

}  // namespace camopt
