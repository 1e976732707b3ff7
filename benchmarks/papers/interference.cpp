// SPDX-License-Identifier: MIT
#include "benchmarks/papers/spatial_methods.hpp"
#include "core/errors.hpp"
#include "core/numbers/extremum.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace camopt {
namespace {

using Eigen::Vector3d;

// Only maxima between samples within this distance are refined; between two samples (1/2 degree) a cutter
// moves less.
constexpr double near_share = 0.2;
constexpr int refining_sections = 60;

struct Cutter {
    double radius = 0.0;
    HeightRange length;

    /// Depth of the point inside, > 0; outside: a negative number.
    [[nodiscard]] double depth(const RollerAxis& axis, const Vector3d& point) const {
        const Vector3d from_foot = point - axis.foot;
        const double along = from_foot.dot(axis.direction);
        const double distance = (from_foot - along * axis.direction).norm();
        return std::min({radius - distance, along - length.from, length.to - along});
    }
};

/// The cutter at each sampled angle of the whole motion.
class Sweep {
 public:
    Sweep(const SpatialCam& cam, const FollowerMotion& motion, const Cutter& cutter, int count)
        : cam_(cam), motion_(motion), cutter_(cutter), angles_(even_angles(motion, count)) {
        for (const double theta : angles_) axes_.push_back(axis_at(theta));
    }

    /// The largest depth of one point, starting from its own cutter (depth 0, to round-off).
    void search(const Vector3d& point, Interference& worst, bool& deeper) const {
        std::vector<double> depths;
        depths.reserve(axes_.size());
        for (const RollerAxis& axis : axes_) depths.push_back(cutter_.depth(axis, point));
        for (std::size_t k = 0; k < depths.size(); ++k) {
            const std::size_t before = k > 0 ? k - 1 : 0, after = std::min(k + 1, depths.size() - 1);
            if (depths[k] < depths[before] || depths[k] < depths[after]) continue;
            if (depths[k] < -near_share * cutter_.radius) continue;
            const double place =
                golden_maximum([&](double theta) { return cutter_.depth(axis_at(theta), point); },
                               angles_[before], angles_[after], refining_sections)
                    .place();
            const double depth = std::max(depths[k], cutter_.depth(axis_at(place), point));
            if (depth <= worst.depth) continue;
            worst.depth = depth;
            worst.cutter_theta = place;
            deeper = true;
        }
    }

 private:
    [[nodiscard]] RollerAxis axis_at(double theta) const {
        return roller_axis(cam_, theta, motion_.state(theta).s);
    }

    const SpatialCam& cam_;
    const FollowerMotion& motion_;
    Cutter cutter_;
    std::vector<double> angles_;
    std::vector<RollerAxis> axes_;
};

HeightRange or_roller(const HeightRange& range, const SpatialCam& cam) {
    return range.to == 0.0 ? HeightRange{0.0, cam.roller_length} : range;
}

}  // namespace

void InterferenceOptions::validate() const {
    const auto at_least = [](const char* name, int found, int least) {
        if (found < least)
            throw InputError(fmt::format("{}: found {}; allowed: at least {}", name, found, least));
    };
    at_least("sections", sections, 1);
    at_least("angles", angles, 2);
    at_least("cutter_angles", cutter_angles, 3);
    for (const HeightRange& range : {cutter, flank})
        if (range.to != 0.0 && !(range.to > range.from))
            throw InputError(
                fmt::format("a stretch from {} to {} m; allowed: to > from", range.from, range.to));
}

Interference interference(const SpatialCam& cam, const FollowerMotion& motion,
                          const InterferenceOptions& options) {
    options.validate();
    const HeightRange flank = or_roller(options.flank, cam);
    std::vector<double> heights{flank.to};
    for (int i = options.sections - 2; i >= 0; --i)
        heights.insert(heights.begin(), flank.from + (flank.to - flank.from) * i / (options.sections - 1));
    return interference(cam, motion, options,
                        flank_grid(cam, motion, heights, even_angles(motion, options.angles)));
}

Interference interference(const SpatialCam& cam, const FollowerMotion& motion,
                          const InterferenceOptions& options, const FlankGrid& grid) {
    options.validate();
    const Cutter cutter{cam[SpatialDimension::roller_radius], or_roller(options.cutter, cam)};
    const Sweep sweep(cam, motion, cutter, options.cutter_angles);
    Interference worst;
    for (const FlankSurface& flank : grid.flanks)
        for (std::size_t i = 0; i < grid.heights.size(); ++i)
            for (std::size_t j = 0; j < grid.angles.size(); ++j) {
                bool deeper = false;
                sweep.search(flank.points[grid.index(i, j)], worst, deeper);
                ++worst.points;
                if (!deeper) continue;
                worst.theta = grid.angles[j];
                worst.height = grid.heights[i];
                worst.flank = flank.flank;
            }
    return worst;
}

}  // namespace camopt
