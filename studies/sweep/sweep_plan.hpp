// SPDX-License-Identifier: MIT
// The rows of a sweep: which keys of the scene vary, and the value of each in every row.
//
// Rows are numbered from 0. The plan is the full grid of its axes in boustrophedon order (a reflected Gray
// code: from one row to the next a single axis moves, by one point), so neighbours in number are neighbours
// in value. The first axis moves slowest.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/sweep/sweep_axis.hpp"
#include "studies/sweep/sweep_row.hpp"

namespace camopt {

struct SweepPlan {
    std::vector<std::string> keys;  ///< those of the axes, one after another
    std::vector<double> values;     ///< row after row, one value a key

    [[nodiscard]] int rows() const {
        return keys.empty() ? 0 : static_cast<int>(values.size() / keys.size());
    }
    [[nodiscard]] std::span<const double> row(int number) const {
        return std::span(values).subspan(static_cast<std::size_t>(number) * keys.size(), keys.size());
    }
};

/// Throws InputError where a key stands in two axes, there is no axis, or there are too many rows.
[[nodiscard]] SweepPlan sweep_grid(std::span<const SweepAxis> axes);

/// 16 hexadecimal digits that change with any key, value or their order.
[[nodiscard]] std::string fingerprint(const SweepPlan& plan);

/// "objective.velocity=0.3": integers without a point, everything else as it reads back.
[[nodiscard]] std::string setting_text(const std::string& key, double value);

/// Of one row, as --set takes them; a key without a value (NaN) has none.
[[nodiscard]] std::vector<std::string> settings_of(std::span<const std::string> keys,
                                                   std::span<const double> values);

/// "row 17 (objective.velocity=0.3, objective.jerk=0.7)"
[[nodiscard]] std::string row_text(const SweepPlan& plan, int row);

/// Reads the scene of the sweep with some settings "KEY=VALUE" on top; throws InputError.
using SceneReading = std::function<Scene(std::span<const std::string> settings)>;

/// The scene of every row. A row that differs from the one asked for before in weights and limits on peaks
/// only costs no reading: they are set in place.
class SweepScenes {
 public:
    /// The plan must outlive it.
    SweepScenes(const SweepPlan& plan, SceneReading read) : plan_(&plan), read_(std::move(read)) {}

    /// Throws InputError "row 17 (objective.velocity=0.3, …): " with the reader's message.
    [[nodiscard]] const Scene& scene(int row);
    [[nodiscard]] const SweepPlan& plan() const { return *plan_; }

 private:
    [[nodiscard]] bool set_numbers(int row);
    void read(int row);

    const SweepPlan* plan_;
    SceneReading read_;
    std::optional<int> row_;  ///< whose scene it is
    Scene scene_;
};

// Every row of a sweep looked at before anything is solved.

/// Whether the solver that the scene's plan takes first runs in several threads at once.
[[nodiscard]] bool is_safe_in_threads(const Scene& scene);

/// Makes the scene of every row and checks what solve() would refuse. Throws InputError naming the first row
/// that is wrong, its values and why; UnavailableError for a backend this build leaves out. Returns what the
/// rows have in common.
[[nodiscard]] SweepColumns check_rows(SweepScenes& scenes);

/// What rows of such scenes have in common; at least one.
[[nodiscard]] SweepColumns columns_of(std::vector<std::string> keys, std::span<const Scene> scenes);

// How the rows of a sweep are cut into chunks (studies/sweep/sweep_run.hpp solves them).

/// Long enough for warm starts to pay, short enough to lose little where a run is stopped.
inline constexpr int default_chunk_size = 25;
/// Where the weights of a convex scene or limits on its peaks move fastest, most rows need no solve, and the
/// more of them the longer a chunk: up to this, or fewer where splines have so many segments that a solve
/// takes long.
inline constexpr int weight_chunk_size = 500;
/// The chunks a small sweep is cut into at least, so that several workers find something to do.
inline constexpr int least_chunks = 16;

/// Rows begin … end − 1.
struct RowRange {
    int begin = 0, end = 0;
    [[nodiscard]] int size() const { return end - begin; }
};

/// How rows are cut into chunks; the last one may be shorter.
struct Chunking {
    int rows = 0;
    int size = default_chunk_size;

    [[nodiscard]] int count() const { return (rows + size - 1) / size; }
    [[nodiscard]] RowRange range(int chunk) const {
        return {chunk * size, chunk == count() - 1 ? rows : (chunk + 1) * size};
    }
};

/// By the number of rows, what moves fastest, and the scene of the first row: one of the sizes above, or less
/// where that makes fewer than least_chunks chunks. Throws InputError where that row is wrong.
[[nodiscard]] int chunk_size_for(SweepScenes& scenes);

/// What a certificate says of a row: verdict, reason, bound.
[[nodiscard]] SweepRow certified_row(int number, std::span<const double> settings,
                                     const Certificate& certificate);

/// What a solution says, as a row.
[[nodiscard]] SweepRow sweep_row(int number, std::span<const double> settings, const Solution& solution);

/// A row without a solution.
[[nodiscard]] SweepRow failed_row(int number, std::span<const double> settings, std::string_view reason);

/// Hears of a solution before its row: settings as --set takes them, those of the row alone.
using FoundSolution =
    std::function<void(int row, std::span<const std::string> settings, const Solution& solution)>;

/// How rows are solved that depend on one another (a front, a surface): what ends them, and who hears.
struct RowRun {
    SolveControl control = {};
    /// Rows of an earlier run of the same study, in their order: not solved again as long as they are those
    /// asked for.
    std::vector<SweepRow> known = {};
    /// After every row, also a known one. error: what a surface has proved so far.
    std::function<void(const SweepTable& so_far, std::optional<double> error)> row_done = {};
    FoundSolution found = {};  ///< after every solve
};

}  // namespace camopt
