// SPDX-License-Identifier: MIT
#include "studies/spatial/spatial_forward_check.hpp"

#include "core/deadline.hpp"
#include "core/errors.hpp"
#include "studies/spatial/flank_contact.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace camopt {

namespace {

void check_section(const SpatialForwardCheckInput& input, std::size_t index,
                   SpatialForwardCheckResult& result) {
    FlankContact contact(input.follower, input.sections[index], input.breaks, input.designed(input.begin));
    bool first = true;
    double begin_s = 0.0;
    for (int i = 0; i < input.angles; ++i) {
        const double theta = input.begin + (input.end - input.begin) * (i + 0.5) / input.angles;
        const FlankContact::Stand stand = contact.at(theta);
        if (stand.at_end) {
            ++result.beyond;
            continue;
        }
        ++result.angles;
        const double found = std::abs(stand.s - input.designed(theta));
        const double deviation = std::isfinite(found) ? found : std::numeric_limits<double>::infinity();
        if (deviation > result.deviation) {
            result.deviation = deviation;
            result.theta = theta;
            result.section = static_cast<int>(index);
        }
        if (index > 0) continue;
        if (first) begin_s = stand.s;
        first = false;
        result.travel = stand.s - begin_s;
    }
}

}  // namespace

void SpatialForwardCheckInput::validate() const {
    if (!designed) throw InputError("a forward check needs the designed motion");
    if (sections.empty()) throw InputError("a forward check needs at least one section of a flank");
    if (angles < 2) throw InputError(fmt::format("a forward check of {} angles: at least 2", angles));
    if (!(end > begin)) throw InputError(fmt::format("a forward check from {} to {} rad", begin, end));
    for (const auto& section : sections)
        for (const Eigen::Vector3d& point : section)
            if (!point.allFinite())
                throw InputError("a forward check takes finite points only, and one is not");
}

std::vector<std::vector<Eigen::Vector3d>> sections_of(const FlankGrid& grid) {
    std::vector<std::vector<Eigen::Vector3d>> sections;
    const auto width = static_cast<std::ptrdiff_t>(grid.angles.size());
    for (const FlankSurface& flank : grid.flanks)
        for (std::size_t i = 0; i < grid.heights.size(); ++i) {
            const auto first = flank.points.begin() + static_cast<std::ptrdiff_t>(grid.index(i, 0));
            sections.emplace_back(first, first + width);
        }
    return sections;
}

SpatialForwardCheckResult spatial_forward_check(const SpatialForwardCheckInput& input) {
    const Stopwatch watch;
    input.validate();
    SpatialForwardCheckResult result;
    result.points = static_cast<int>(input.sections.front().size());
    for (std::size_t i = 0; i < input.sections.size(); ++i) check_section(input, i, result);
    if (result.angles == 0) result.deviation = std::numeric_limits<double>::infinity();
    result.seconds = watch.seconds();
    return result;
}

SpatialForwardCheckRow spatial_forward_check_row(const SpatialCam& cam, const FollowerMotion& motion,
                                                 int count) {
    const Stopwatch watch;
    const FlankGrid grid = flank_grid(cam, motion, FlankSampling{.sections = 2, .angles = count});
    const auto sections = sections_of(grid);
    const std::size_t half = sections.size() / 2;
    SpatialForwardCheckRow row;
    for (const bool positive : {true, false}) {
        SpatialForwardCheckInput input;
        const auto first = sections.begin() + static_cast<std::ptrdiff_t>(positive ? 0 : half);
        input.sections.assign(first, first + static_cast<std::ptrdiff_t>(half));
        input.breaks = grid.breaks;
        input.follower = cam;
        input.designed = [&motion](double theta) { return motion.state(theta).s; };
        input.begin = motion.begin();
        input.end = motion.end();
        const SpatialForwardCheckResult result = spatial_forward_check(input);
        (positive ? row.deviation_positive : row.deviation_negative) = result.deviation;
        row.points = result.points;
        if (positive) row.travel = result.travel;
    }
    row.seconds = watch.seconds();
    return row;
}

}  // namespace camopt
