// SPDX-License-Identifier: MIT
// A cam profile from a law, without a solver. Links camopt::profiles and camopt::motions.
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"

#include <cstdio>

int main() {
    const auto law = camopt::make_law("modified_sine");
    const camopt::DiskCam cam{camopt::FollowerType::translating_roller,
                              camopt::Rotation::counterclockwise,
                              {0.04, 0.01, 0.0, 0.0, 0.0, 0.0}};
    constexpr double lift = 0.02, rise = 1.0471975511965976;
    const auto half = law->at(0.5).derivative;
    const camopt::ProfilePoint point = camopt::profile_point(
        cam, rise / 2, {lift * half[0], lift / rise * half[1], lift / (rise * rise) * half[2]});
    std::printf("%.6f\n", point.cam_radius);
}
