// SPDX-License-Identifier: MIT
// Peaks of parts of a motion brought to one scale and put together.
#pragma once

#include "core/peak_figures.hpp"
#include "objectives/model.hpp"

#include <array>

namespace camopt {

/// Peaks and mean squares of y^{(r)} times size / width^r (torque: size² / width³): of a curve on a stretch
/// `width` times as long, `size` times as high.
[[nodiscard]] Peaks scaled_peaks(Peaks peaks, double size, double width);

/// By the stretch's own angle and displacement.
[[nodiscard]] Peaks normalised_peaks(const Peaks& peaks, const StretchScale& scale);

/// Each peak becomes the larger of the two; mean squares stay.
void raise_peaks(Peaks& peaks, const Peaks& other);

/// Root mean squares of several parts as one: each counts by its width.
class JoinedMeans {
 public:
    void add(const Peaks& part, double width);
    void set(Peaks& whole) const;

 private:
    std::array<double, 3> squares_{};
    double width_ = 0.0;
};

}  // namespace camopt
