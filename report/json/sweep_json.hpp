// SPDX-License-Identifier: MIT
// sweep.json: what a folder of a sweep holds, so that a run can be continued and parts can be joined.
#pragma once

#include "studies/surface/trade_off_surface.hpp"
#include "studies/sweep/sweep_plan.hpp"

namespace camopt {

/// Everything that a row's result depends on.
struct SweepIdentity {
    std::string version;                ///< of the camopt that made it
    std::string scene_file;             ///< as given; for people, another path to the same text is the same
    std::string scene_text;             ///< the scene file as it was read
    std::vector<std::string> settings;  ///< KEY=VALUE, the same for all rows
    std::vector<std::string> axes;      ///< "--weights simplex:20", …: for people
    std::string plan;                   ///< fingerprint (studies/sweep/sweep_plan.hpp)
    SweepColumns columns;
    Chunking chunking;
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

/// Throws InputError "NAME: KEY: found …; allowed: …" for what is no such text.
[[nodiscard]] StoredSweep read_sweep_json(std::string_view text, std::string_view name);

// surface.json: what a folder of camopt sweep --surface holds beside its table, so that a run can be
// continued and any weight be looked up.

/// Everything that its rows depend on, and what was asked for.
struct SurfaceIdentity {
    std::string version;     ///< of the camopt that made it
    std::string scene_file;  ///< as given; for people
    std::string scene_text;  ///< as it was read, with the settings worked in
    double error = 0.0;      ///< asked for
};

[[nodiscard]] std::string surface_json(const SurfaceIdentity& identity, const TradeOffSurface& surface);

/// Throws InputError "NAME: KEY: found …; allowed: …" for what is no such text.
[[nodiscard]] SurfaceIdentity read_surface_json(std::string_view text, std::string_view name);

/// Why rows of one are no rows of the other, in words; empty where they are.
[[nodiscard]] std::string difference(const SurfaceIdentity& one, const SurfaceIdentity& other);

}  // namespace camopt
