// SPDX-License-Identifier: MIT
#include "objectives/rules/cam_variables.hpp"

#include "core/errors.hpp"
#include "profiles/disk/disk_mechanism.hpp"

#include <algorithm>
#include <optional>

namespace camopt {

std::vector<double> CamVariables::dimensions_at(const Eigen::VectorXd& parameters) const {
    std::vector<double> own = cam.dimensions;
    for (const Variable& variable : variables)
        own[static_cast<std::size_t>(variable.dimension)] =
            variable.reference * parameters[variable.parameter];
    return own;
}

DiskVariables::DiskVariables(const CamVariables& all) : scale(all.scale), profile_points(all.profile_points) {
    const std::optional<DiskCam> disk = disk_cam(all.cam);
    if (!disk) throw ModelError("rules of a disk cam for a cam of another kind");
    cam = *disk;
    const std::vector<DimensionIndex> which = dimensions_of(cam.follower);
    for (const CamVariables::Variable& variable : all.variables)
        variables.push_back(
            {which[static_cast<std::size_t>(variable.dimension)], variable.parameter, variable.reference});
}

bool DiskVariables::is_variable(DimensionIndex dimension) const {
    return std::ranges::find(variables, dimension, &Variable::dimension) != variables.end();
}

}  // namespace camopt
