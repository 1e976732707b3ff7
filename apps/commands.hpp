// SPDX-License-Identifier: MIT
// The commands of camopt, one file each (<name>_command.cpp). They return the exit code, print results to
// stdout, and throw InputError for what the user got wrong.
#pragma once

#include "solvers/certificate/certificate.hpp"

namespace camopt::apps {

// The exit codes of camopt, the same for every command. 130 is what a shell says of Ctrl-C.
enum ExitCode : int { success = 0, failure = 1, wrong_input = 2, proved_infeasible = 3, interrupted = 130 };

[[nodiscard]] inline ExitCode exit_code_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::optimal:
        case Verdict::local:
        case Verdict::feasible:
            return success;
        case Verdict::infeasible:
            return proved_infeasible;
        case Verdict::failed:
            break;
    }
    return failure;
}

struct SolveRequest {
    std::string scene;                  ///< file
    std::string out;                    ///< folder; empty: nothing is written
    std::string solver;                 ///< replaces solver.name; empty: the scene's
    std::vector<std::string> settings;  ///< KEY=VALUE
    std::optional<int> points;          ///< of profile.csv; none: by chord tolerance
    bool dxf = false;                   ///< write profile.dxf too
    bool json = false;
    std::string units;    ///< "mm", "in": of lengths for people; empty: as the scene is written
    std::string command;  ///< the whole command line, for the record
};
[[nodiscard]] ExitCode solve_command(const SolveRequest& request);

struct StudioRequest {
    std::string scene;                  ///< file; empty: one to begin with
    std::vector<std::string> settings;  ///< KEY=VALUE
    int port = 0;                       ///< 0: any free one
    bool offline = false;               ///< no server: a page that holds the solver, opened as a file
};
/// Returns after Ctrl-C, SIGTERM or the end of the terminal.
[[nodiscard]] ExitCode studio_command(const StudioRequest& request);

struct CompareRequest {
    std::string scene;                  ///< file
    std::string out;                    ///< folder; empty: nothing is written
    std::string solver;                 ///< replaces solver.name; empty: the scene's
    std::vector<std::string> settings;  ///< KEY=VALUE
    bool json = false;
    std::string units;    ///< as of solve
    std::string command;  ///< the whole command line, for the record
};
[[nodiscard]] ExitCode compare_command(const CompareRequest& request);

struct DynamicsRequest {
    std::string scene;                  ///< file
    std::string out;                    ///< folder; empty: nothing is written
    std::string solver;                 ///< replaces solver.name; empty: the scene's
    std::vector<std::string> settings;  ///< KEY=VALUE
    std::string speeds;                 ///< "FROM:TO:COUNT" in rpm; empty: about the scene's range
    bool json = false;
    std::string command;  ///< the whole command line, for the record
};
[[nodiscard]] ExitCode dynamics_command(const DynamicsRequest& request);

struct InspectRequest {
    std::string scene;                  ///< the nominal cam: file, or a result folder: then nothing is solved
    std::string table, out;             ///< file of the measured cam; folder, empty: nothing is written
    std::string columns;                ///< names between commas; empty: the first line of the table has them
    std::vector<double> scale, offset;  ///< of each column; empty: as written
    std::vector<std::string> settings;  ///< KEY=VALUE
    std::optional<double> tolerance_um;  ///< none: no verdict
    double probe_radius_mm = 0.0;
    bool json = false;
    std::string command;  ///< the whole command line, for the record
};
/// failure: out of tolerance.
[[nodiscard]] ExitCode inspect_command(const InspectRequest& request);

struct ValvesRequest {
    std::string intake, exhaust;   ///< valve lobes: files, or result folders: then nothing is solved
    std::string units;             ///< as of solve
    std::string out;               ///< folder; empty: nothing is written
    std::optional<double> gap_mm;  ///< between the nearest edges of the shut valves; none: no clearance
    double included_deg = 0.0;     ///< between the valves' axes
    bool json = false;
    std::string command;  ///< the whole command line, for the record
};
/// failure: the valves touch.
[[nodiscard]] ExitCode valves_command(const ValvesRequest& request);

struct ReportRequest {
    std::string folder;  ///< a result folder
};
[[nodiscard]] ExitCode report_command(const ReportRequest& request);

struct CheckRequest {
    std::string scene;
    std::vector<std::string> settings;
    std::string write;  ///< file for the scene as read; empty: none
    std::string units;  ///< as of solve
    bool json = false;
};
[[nodiscard]] ExitCode check_command(const CheckRequest& request);

struct ListRequest {
    std::string what;  ///< one of list_topics()
    bool json = false;
};
[[nodiscard]] ExitCode list_command(const ListRequest& request);
/// "laws", "followers", "solvers", "keys", "columns", "controllers".
[[nodiscard]] std::vector<std::string> list_topics();

/// A front instead of a sweep.
struct ParetoWords {
    std::string goals;              ///< "velocity,acceleration"; empty: no front
    std::optional<int> points;      ///< none: 21, or by the spacing
    std::optional<double> spacing;  ///< of neighbours, in parts of the front's box
    std::optional<double> cut_off;
    bool keep_weights = false;
};

struct SurfaceWords {
    std::optional<double> error;  ///< none: no surface
    std::optional<int> most;      ///< solves; none: SurfaceRequest's
    std::string at;               ///< "0.4,0.4,0.2": look these weights up in a folder; empty: solve
};

struct SweepRequest {
    std::string scene;                  ///< file
    std::vector<std::string> vary;      ///< KEY=a:b:count, …
    std::string weights;                ///< "simplex:N" or a CSV file; empty: those of the scene
    std::string out;                    ///< folder
    std::string solver;                 ///< replaces solver.name; empty: the scene's
    std::vector<std::string> settings;  ///< KEY=VALUE
    std::optional<int> workers;         ///< threads; none: one a core
    std::optional<int> chunk;           ///< rows a chunk; none: chunk_size_for (studies/sweep/sweep_run.hpp)
    ParetoWords pareto;
    SurfaceWords surface;
    std::string units;  ///< as of solve
    std::string shard;  ///< "i/N"; empty: the whole
    bool resume = false;
    bool results = false;  ///< a result folder for every row too
};
[[nodiscard]] ExitCode sweep_command(const SweepRequest& request);

struct MachineRequest {
    std::string scene;                             ///< machine file
    std::string out;                               ///< folder; empty: nothing is written
    std::vector<std::string> settings;             ///< KEY=VALUE of the machine file
    std::vector<std::string> plc;                  ///< formats of electronic cams, for every axis
    std::optional<double> speed_gap, max_seconds;  ///< none: MachineOptions'
    bool json = false;
    std::string command;  ///< the whole command line, for the record
};
[[nodiscard]] ExitCode machine_command(const MachineRequest& request);

struct SweepMergeRequest {
    std::vector<std::string> parts;  ///< folders of shards
    std::string out;                 ///< folder
};
[[nodiscard]] ExitCode sweep_merge_command(const SweepMergeRequest& request);

struct TableRequest {
    std::string what;  ///< "spline-vs-modified-sine"
    std::string out;   ///< folder; empty: nothing is written
    bool json = false;
};
[[nodiscard]] ExitCode table_command(const TableRequest& request);

// Studies whose rows depend on those before. They write the files of a sweep (docs/sweep.md), named "pareto"
// or "surface", and print what was found. After Ctrl-C what is finished is written, and --resume goes on from
// it.

/// camopt sweep SCENE --pareto first,second: a front by limits.
[[nodiscard]] ExitCode pareto_run(const SweepRequest& request);

/// camopt sweep SCENE --surface ERROR: every weight of V, A and J to a proved error.
[[nodiscard]] ExitCode surface_run(const SweepRequest& request);

/// request.scene is a folder of a surface: prints between which two values the objective lies at
/// request.surface.at.
[[nodiscard]] ExitCode surface_look_up(const SweepRequest& request);

}  // namespace camopt::apps
