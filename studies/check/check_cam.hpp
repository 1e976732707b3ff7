// SPDX-License-Identifier: MIT
// The check that the points of a delivered cam move its follower as designed.
#pragma once

#include "studies/check/forward_check_input.hpp"
#include "studies/delivered/delivered.hpp"

namespace camopt {

/// Exports about `points` points of the cam, the motion's breakpoints among them, and runs a follower, or the
/// lever and linkage, over them that knows nothing else (forward_check.hpp). points: default 2000, 6000 where
/// a linkage magnifies. Throws InputError where the solution has no cam, or one that neither a follower nor a
/// lever runs on, and where its points cannot be checked at all.
[[nodiscard]] ForwardCheckReport check_cam(const Solution& solution, std::optional<int> points = {});

/// Puts what `check` finds into the report of the cam; where it cannot run, a note says why. Nothing to do
/// without a cam.
void add_forward_check(Solution& solution,
                       ForwardCheckReport (*check)(const Solution& solution, std::optional<int> points));

// The finished cam that drives both ways, turned under its follower: does either side by itself move it as
// designed, and does the follower fit between the two all round?
//
// Groove: a roller that fills it (its own radius and half the clearance) is put down on the points of the
// inner flank and, from inside, on those of the outer flank; the deviation is the larger. Then the roller
// itself: between the two flanks the follower can be moved to and fro by its play, which the clearance makes;
// negative play: it does not go in. The width of the groove is the least distance from a point of the inner
// flank to the curve through those of the outer.
// Conjugate: each roller on the points of its own disk, the second one from the other side. The first disk
// keeps the follower from going below what it found, the second from going above: the play between them is
// the sum of the gaps at both rollers, negative where they jam.
//
// Knows the points alone, as forward_check.hpp does. m, rad.

/// About `points` points of each side. Throws InputError as forward_check does, and for a cam with one side.
[[nodiscard]] ForwardCheckReport two_sided_check(const DrivenMechanism& mechanism, const Motion& motion,
                                                 const MotionScale& scale, int points = 2000);

/// The least distance from any of the points to the smooth curve through those of `outer`, m.
[[nodiscard]] double least_width(const ForwardCheckInput& inner, const ForwardCheckInput& outer);

}  // namespace camopt
