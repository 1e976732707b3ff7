// SPDX-License-Identifier: MIT
// Private to output/report: the texts of a plane cam's files by kind, in the order of the rows of
// cam_files.cpp.
#pragma once

#include "output/report/cam_files.hpp"

#include <string>
#include <vector>

namespace camopt {

/// Points, the cam to scale, its diagrams.
[[nodiscard]] std::vector<std::string> disk_texts(const Solution& solution, const CamFileOptions& options);

/// Points, cam and linkage to scale, pressure angle, curvature.
[[nodiscard]] std::vector<std::string> linkage_texts(const Solution& solution, const CamFileOptions& options);

/// Points of both walls, the guide to scale, pressure angle.
[[nodiscard]] std::vector<std::string> guide_texts(const Solution& solution, const CamFileOptions& options);

}  // namespace camopt
