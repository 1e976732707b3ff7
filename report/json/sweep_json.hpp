// SPDX-License-Identifier: MIT
// sweep.json, pareto.json, surface.json: what the folder of a study of many solves holds, so that a run can
// be continued, parts can be joined and any weight of a surface be looked up.
#pragma once

#include "studies/pareto/pareto_front.hpp"
#include "studies/surface/trade_off_surface.hpp"
#include "studies/sweep/sweep_plan.hpp"

namespace camopt {

/// Everything that a row's result depends on.
struct SweepIdentity {
    std::string version;                ///< of the camopt that made it
    std::string scene_file;             ///< as given; for people, another path to the same text is the same
    std::string scene_text;             ///< the scene file as it was read
    std::vector<std::string> settings;  ///< KEY=VALUE, the same for all rows
    std::vector<std::string> axes;      ///< "--weights simplex:20", …: for people; of a front its goals
    std::string plan;                   ///< fingerprint (studies/sweep/sweep_plan.hpp)
    SweepColumns columns;
    Chunking chunking;
    /// The name of its files: "sweep", whose rows are known before they are solved; or "pareto", "surface",
    /// each of whose rows depends on those before, which have neither plan, columns nor chunks here.
    std::string study = "sweep";
    std::optional<double> error =
        {};  ///< of a surface: asked for; a run with another one goes on all the same

    [[nodiscard]] bool is_grid() const { return study == "sweep"; }
};

/// What makes two sweeps different ones, in words ("another scene file"); empty where nothing does.
[[nodiscard]] std::string difference(const SweepIdentity& one, const SweepIdentity& other);

/// Every count-th chunk, the index-th of every round, from 1. 1 of 1: the whole.
struct SweepShard {
    int index = 1, count = 1;

    [[nodiscard]] bool is_whole() const { return count == 1; }
    [[nodiscard]] bool holds(int chunk) const { return chunk % count == index - 1; }
};

struct StoredSweep {
    SweepIdentity identity;
    SweepShard shard;
};

[[nodiscard]] std::string sweep_json(const StoredSweep& sweep);
/// The same with what was found: reference, proved error and triangles of a surface (docs/sweep.md); goals
/// and spacing of a front.
[[nodiscard]] std::string sweep_json(const StoredSweep& sweep, const TradeOffSurface& surface);
[[nodiscard]] std::string sweep_json(const StoredSweep& sweep, const ParetoFront& front);

/// study: of which it is the description. Throws InputError "NAME: KEY: found …; allowed: …" for what is
/// none.
[[nodiscard]] StoredSweep read_sweep_json(std::string_view text, std::string_view name,
                                          const std::string& study = "sweep");

}  // namespace camopt
