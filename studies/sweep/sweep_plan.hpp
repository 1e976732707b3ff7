// SPDX-License-Identifier: MIT
// The rows of a sweep: which keys of the scene vary, and the value of each in every row.
//
// Rows are numbered from 0. The plan is the full grid of its axes in boustrophedon order (a reflected Gray
// code: from one row to the next a single axis moves, by one point), so neighbours in number are neighbours
// in value. The first axis moves slowest.
#pragma once

#include "scene/scene.hpp"
#include "studies/sweep/sweep_axis.hpp"
#include "studies/sweep/sweep_row.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

/// Of one row, as --set takes them.
[[nodiscard]] std::vector<std::string> settings_of(const SweepPlan& plan, int row);

/// "row 17 (objective.velocity=0.3, objective.jerk=0.7)"
[[nodiscard]] std::string row_text(const SweepPlan& plan, int row);

/// Reads the scene of the sweep with some settings "KEY=VALUE" on top; throws InputError.
using SceneReading = std::function<Scene(std::span<const std::string> settings)>;

/// The scene of every row. A row that differs from the one asked for before in weights only costs no reading:
/// the weights are set in place.
class SweepScenes {
 public:
    /// The plan must outlive it.
    SweepScenes(const SweepPlan& plan, SceneReading read) : plan_(&plan), read_(std::move(read)) {}

    /// Throws InputError "row 17 (objective.velocity=0.3, …): " with the reader's message.
    [[nodiscard]] const Scene& scene(int row);
    [[nodiscard]] const SweepPlan& plan() const { return *plan_; }

 private:
    [[nodiscard]] bool only_weights_differ(int row) const;
    [[nodiscard]] bool set_weights(int row);
    void read(int row);

    const SweepPlan* plan_;
    SceneReading read_;
    std::optional<int> row_;  ///< whose scene it is
    Scene scene_;
};

// Every row of a sweep looked at before anything is solved.

/// Makes the scene of every row and checks what solve() would refuse. Throws InputError naming the first row
/// that is wrong, its values and why; UnavailableError for a backend this build leaves out. Returns what the
/// rows have in common.
[[nodiscard]] SweepColumns check_rows(SweepScenes& scenes);

}  // namespace camopt
