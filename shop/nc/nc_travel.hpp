// SPDX-License-Identifier: MIT
// The verifier's second half: the cutter along every move of the printed text, rapids too, without a gap.
//
//   rapids   never come nearer to the blank than `least_distance`. A control may run each axis of a rapid at
//            its own speed, so not the straight way is looked at but every value of every axis between
//            the two ends. As long as an axis has no value yet, only what holds for any value counts.
//   feeds    never enter the finished cam by more than `most_depth`; all axes in proportion, arcs round
//            (path/cutter_compensation.hpp). A pass that roughs must leave its stock: there the cutter is
//            taken as larger by it.
// No point of the way is a sample: while the axes move by Δ, a point of the blank moves past the cutter by
//   L = |Δ of X, Y, Z| + reach of the blank · Σ |Δ of rotary axes|
// or less (machine.hpp: rotary axes pass the origin), so what is found in the middle of a piece holds over
// the piece within L / 2. Pieces are halved until that decides. m, rad.
#pragma once

#include "shop/nc/finished_cam.hpp"
#include "shop/nc/nc_reader.hpp"

namespace camopt {

struct NcTravelTask {
    Blank blank;
    double cutter_radius = 0.0;  ///< m, > 0
    FinishedCam* cam = nullptr;
    double least_distance = 0.0;  ///< m, > 0: of rapids from the blank
    double most_depth = 0.0;      ///< m, > 0: of feeds in the finished cam
    /// Rapids stay above the blank however the table stands, beside it too: table and clamps are there.
    bool rapids_above = false;
    /// m, >= 0, one a pass: what it must leave of the cam. Passes are feeds between rapids. Empty: nothing.
    std::vector<double> stocks = {};
    /// No feed may touch it; where rapids stay above (as it stands, too), they keep their distance.
    std::optional<Blank> clamp = {};
    bool rapids_above_as_it_stands = false;  ///< the same of the blank as a table that tilts stands

    void validate() const;  ///< throws InputError
};

struct NcTravelCheck {
    int rapids = 0, feeds = 0;  ///< moves looked at
    double nearest = 0.0;       ///< m: the least distance of rapids from the blank that was met
    double deepest = 0.0;       ///< m: the greatest depth of feeds that was met; below 0: never touched
    int passes = 0;             ///< feeds between rapids
    std::string fault;          ///< the first move that must not be, with its line; empty: none

    [[nodiscard]] bool good() const { return fault.empty(); }
};

/// moves: all of the text (read_nc_travel), compensated (path/cutter_compensation.hpp). Throws InputError for
/// a task that is not valid and a text without moves.
[[nodiscard]] NcTravelCheck check_travel(std::span<const NcMove> moves, const Machine& machine,
                                         const NcTravelTask& task);

}  // namespace camopt
