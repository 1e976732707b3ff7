// SPDX-License-Identifier: MIT
// Figures that several studies have, and result.json: their names in files are listed here once.
#pragma once

#include "report/document/document.hpp"

namespace camopt {

/// verdict, reason, objective, and bound: what the objective is proved to be no less than, and how.
[[nodiscard]] std::vector<Figure> verdict_figures(const Certificate& certificate);

/// "good", "fair", "bad".
[[nodiscard]] const char* tone_of(Verdict verdict);

/// What a motion asks of the motor.
[[nodiscard]] std::vector<Figure> drive_figures(const Scene& scene, const DriveFigures& drive);

}  // namespace camopt
