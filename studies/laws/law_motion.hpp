// SPDX-License-Identifier: MIT
// The motion of a scene in which a law of the catalogue takes the place of the spline, with exact peaks.
//
//   DRD      the law
//   RR       the law, then its mirror image stretched to the return's angle: y(1 + ratio·t) = law(1 − t)
//   program  the law on every spline segment, from the displacement at its begin to that at its end; on
//            every law where the program has no spline
//   "polynomial" takes the velocities and accelerations that the scene gives at both ends of a stroke; all
//            other laws rest there
//
// A law that turns back at its top (TopEnd::turning_point) fits a stroke only where the opposite stroke
// follows (or, mirrored, precedes) at once. An impulse of the jerk counts where y'' jumps, the joints with
// what stands beside the law included: so the simple harmonic has none in an eccentric, where no dwell
// interrupts it. Displacements in lifts, angles in x.
#pragma once

#include "motions/laws/law.hpp"
#include "objectives/laws/segment_law.hpp"
#include "objectives/rules/model.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// One stretch of a scene: where it lies, and from where to where it moves.
struct LawStroke {
    SegmentKind kind = SegmentKind::spline;  ///< spline: where the law goes
    std::shared_ptr<const Law> law = {};     ///< kind law: the scene's
    double begin = 0.0, end = 1.0;           ///< x
    std::optional<double> from, to;          ///< none: free, and nobody has chosen it
    StretchScale scale = {};                 ///< what its peaks are normalised by
    bool mirrored = false;                   ///< runs through the law from its end to its begin
    std::array<JointState, 2> ends = {};     ///< that the scene gives, in lifts and units of x
};

/// model: of the scene. optimum: gives the displacements the scene leaves free; may be null.
[[nodiscard]] std::vector<LawStroke> strokes_of(const Scene& scene, const CamModel& model,
                                                const Motion* optimum);

/// A stroke begins or ends in motion, as only "polynomial" does.
[[nodiscard]] bool any_moves_on(std::span<const LawStroke> strokes);

/// Of a DRD or an RR motion.
[[nodiscard]] std::vector<LawStroke> strokes_of(const MotionSpec& motion);

struct LawMotion {
    std::shared_ptr<const MotionChain> motion;  ///< none: the law does not fit
    std::string misfit;                         ///< then why
    Peaks peaks;         ///< over the spline's strokes, normalised as the scene's; infinite where they are
    Peaks motion_peaks;  ///< of the whole motion in lifts and units of x; no mean squares
};

/// closed: the end of the last stroke joins the begin of the first; else rest lies beyond both.
[[nodiscard]] LawMotion law_motion(std::span<const LawStroke> strokes, bool closed,
                                   const std::shared_ptr<const Law>& law);

/// Peaks of a law on its stroke of a motion, in lifts and units of x. Its jerk is infinite only where y''
/// jumps in that motion: inside of the stroke, or where it joins what stands beside it.
[[nodiscard]] Peaks law_peaks(const LawStroke& stroke, const Law& law, const MotionChain& motion,
                              bool closed);

// Peaks of parts of a motion brought to one scale and put together.

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
