// SPDX-License-Identifier: MIT
// What a machine of several axes (studies/machine/machine.hpp) is asked for, and what was found.
#pragma once

#include "scene/machine_spec.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

struct MachineOptions {
    double speed_gap = 1e-3;    ///< relative, of the largest speed; > 0
    double more_speed = 0.05;   ///< limited_by says what this much more speed needs
    double max_seconds = 60.0;  ///< wall time; then the best motions so far are delivered
    bool explain = true;        ///< searches what each limit would have to give for `more_speed`
    int scanned_speeds = 25;    ///< where feasible speeds need not be an interval
    void validate() const;      ///< throws InputError
};

/// A limit or a clearance that stops the machine, from the proof.
struct MachineLimit {
    int axis = -1;       ///< −1: a clearance
    int clearance = -1;  ///< −1: a limit of an axis
    std::string key;     ///< "limits.acceleration_m_s2", "clearance[0].at_least_mm"
    double angle = 0.0;  ///< of the master, rad, where it has its largest multiplier
    double share = 0.0;  ///< of the proof's multipliers, in (0, 1]
    std::string unit;
    std::optional<double> given;   ///< in the unit; none: not a number of one key
    std::optional<double> needed;  ///< with this alone motions exist at `more_speed` more
    bool enough_alone = false;     ///< false and no `needed`: no value of it alone is enough, or it is open
    bool asked = false;            ///< whether `needed` was searched
};

/// A search over segment angles that the axes give as ranges.
struct MachineTiming {
    std::optional<double>
        given;      ///< speed (rad/s) or total objective with the angles given; none: no motions
    int tried = 0;  ///< sets of angles
    std::vector<std::vector<bool>> searched = {};  ///< by axis and segment
    bool complete = true;                          ///< false: its time was over, or the user stopped it
};

struct MachineSolution {
    MachineSpec spec;
    Certificate certificate;  ///< of the motions at `speed`: total objective, bound, proof; or infeasible
    double speed = 0.0;       ///< rad/s, of the motions; of an infeasible machine the least one tried
    /// rad/s: here it is proved that there are no motions; none: no such speed in the range.
    std::optional<double> impossible_above;
    std::optional<DualityProof> impossible;  ///< that proof
    bool reached_most = false;               ///< the end of the range, not a limit, stops the speed
    bool at_standstill = false;  ///< no motions at any speed: clearances and strokes contradict each other
    bool scanned = false;        ///< feasible speeds need not be an interval: only those tried are known
    int trials = 0;              ///< speeds tried
    std::optional<MachineTiming> timing;   ///< where angles were searched: then `spec` has those found
    std::vector<MachineLimit> limited_by;  ///< heaviest first; empty without a proof of impossibility
    std::vector<Solution> axes;            ///< in the order of the machine; empty where nothing is delivered
    /// The least value of Σ factor · displacement − at_least of every clearance, SI, and its master angle.
    std::vector<Extremum> clearances;
    std::vector<std::string> notes;
    double seconds_total = 0.0;
};

}  // namespace camopt
