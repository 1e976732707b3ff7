// SPDX-License-Identifier: MIT
// Solving and sweeping, with a caller's callbacks around them.
#include "bindings/c/camopt.h"
#include "bindings/c/failure.hpp"
#include "bindings/c/handles.hpp"
#include "core/errors.hpp"
#include "core/units.hpp"
#include "core/version.hpp"
#include "solvers/solver.hpp"
#include "studies/checked/checked_cam.hpp"
#include "studies/solve/solve.hpp"
#include "studies/sweep/sweep_run.hpp"

#include <chrono>
#include <exception>

namespace camopt::c {
namespace {

/// A caller's callbacks around a solve or a sweep. What a callback throws never crosses the frames of
/// solvers: it is kept, the search is stopped, and finish() throws it on as a Failure. Belongs to the thread
/// that solves; must outlive its control().
class CallbackControl {
 public:
    explicit CallbackControl(const camopt_solve_options& options) : options_(options) {}
    CallbackControl(const CallbackControl&) = delete;
    CallbackControl& operator=(const CallbackControl&) = delete;

    [[nodiscard]] SolveControl control() {
        SolveControl control;
        // Also without `cancel`: a callback that threw stops the search.
        if (options_.cancel != nullptr || options_.progress != nullptr)
            control.stop_requested = [this] { return asked_to_stop(); };
        if (options_.progress != nullptr)
            control.progress = [this](const Progress& progress) { report(progress); };
        return control;
    }

    /// Calls `work`, a callback of the caller, unless one has thrown before.
    template <class Work>
    void call(Work&& work) noexcept {
        if (thrown_) return;
        try {
            work();
        } catch (...) {
            thrown_ = std::current_exception();
        }
    }

    /// A callback wanted an end or threw: nothing more is to be begun.
    [[nodiscard]] bool stopped() const { return stopped_ || thrown_; }
    void stop() { stopped_ = true; }

    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
    }

    /// Throws Failure (CALLBACK) where a callback threw.
    void finish() const {
        if (!thrown_) return;
        try {
            std::rethrow_exception(thrown_);
        } catch (const std::exception& error) {
            throw Failure(CAMOPT_ERROR_CALLBACK, std::string("a callback threw: ") + error.what());
        } catch (...) {
            throw Failure(CAMOPT_ERROR_CALLBACK,
                          "a callback threw an exception that is not a std::exception");
        }
    }

 private:
    camopt_solve_options options_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    std::exception_ptr thrown_;
    bool stopped_ = false;

    [[nodiscard]] bool asked_to_stop() {
        // Once said is said: a callback that changes its mind would leave a search half stopped.
        if (!stopped() && options_.cancel != nullptr)
            call([&] { stopped_ = options_.cancel(options_.user) != 0; });
        return stopped();
    }
    void report(const Progress& progress) {
        call([&] {
            const std::string text(progress.message);
            const camopt_progress shown{sizeof(camopt_progress),
                                        text.c_str(),
                                        seconds(),
                                        progress.round.value_or(0),
                                        number_or_absent(progress.incumbent),
                                        number_or_absent(progress.bound),
                                        number_or_absent(progress.violation)};
            options_.progress(&shown, options_.user);
        });
    }
};

std::vector<std::string> station_names(const Solution& solution) {
    std::vector<std::string> names;
    if (solution.cam) {
        const CamMechanism& formulas = *solution.cam->cam.formulas;
        for (int i = 0; i < formulas.stations(); ++i) names.push_back(formulas.station_name(i));
    }
    return names;
}

std::unique_ptr<camopt_solution> solved(const camopt_scene& given, const camopt_solve_options& options) {
    const Scene scene = complete_scene(given);
    CallbackControl callbacks(options);
    auto result = std::make_unique<camopt_solution>();
    result->solution = solve(scene, callbacks.control());
    callbacks.finish();
    if (options.forward_check != 0 && !callbacks.stopped()) add_forward_check(result->solution);
    result->stations = station_names(result->solution);
    result->origin = {given.document.name(), "", given.document.text()};
    return result;
}

/// A row with the lists that its C form points into.
class ShownRow {
 public:
    ShownRow(const SweepRow& row, const SweepColumns& columns, int rows) {
        for (const DimensionIndex which : columns.dimensions)
            if (const std::optional<double>& value = row.dimension(which))
                parameters_.push_back(
                    {sizeof(camopt_parameter), name_of(which), "mm", *value / units::millimetre, 1});
        for (const std::string& key : row.active_limits) limits_.push_back(key.c_str());
        const auto figure = [&](SweepFigure which) { return number_or_absent(row.figure(which)); };
        shown_ = {sizeof(camopt_sweep_row),
                  static_cast<std::size_t>(row.number),
                  static_cast<std::size_t>(rows),
                  row.settings.data(),
                  row.settings.size(),
                  verdict_of(row.verdict),
                  row.reason.c_str(),
                  number_or_absent(row.objective),
                  number_or_absent(row.lower_bound),
                  number_or_absent(row.gap),
                  number_or_absent(row.any_curve_limit),
                  figure(SweepFigure::velocity),
                  figure(SweepFigure::acceleration),
                  figure(SweepFigure::jerk),
                  figure(SweepFigure::torque),
                  figure(SweepFigure::rms_acceleration),
                  figure(SweepFigure::rms_jerk),
                  parameters_.data(),
                  parameters_.size(),
                  limits_.data(),
                  limits_.size(),
                  row.iterations,
                  row.exchange_rounds,
                  row.seconds_total,
                  row.proved_from.value_or(-1)};
    }
    [[nodiscard]] const camopt_sweep_row& shown() const { return shown_; }

 private:
    std::vector<camopt_parameter> parameters_;
    std::vector<const char*> limits_;
    camopt_sweep_row shown_{};
};

SweepAxis axis_of(const camopt_sweep_axis& given) {
    SweepAxis axis;
    if (given.key_count > 0) require(given.keys, "axes: keys");
    if (given.key_count > 0 && given.point_count > 0) require(given.values, "axes: values");
    for (std::size_t i = 0; i < given.key_count; ++i) {
        require(given.keys[i], "axes: keys: one of them");
        axis.keys.emplace_back(given.keys[i]);
    }
    if (given.point_count > most_sweep_rows)
        throw Failure(CAMOPT_ERROR_ARGUMENT, "axes: point_count: found " + std::to_string(given.point_count) +
                                                 "; allowed: at most " + std::to_string(most_sweep_rows));
    if (given.key_count > 0)
        axis.values.assign(given.values, given.values + given.key_count * given.point_count);
    return axis;
}

SweepPlan plan_of(const camopt_sweep_axis* axes, std::size_t count) {
    require(axes, "axes");
    if (count == 0)
        throw Failure(CAMOPT_ERROR_ARGUMENT, "axis_count: found 0; allowed: at least one axis that varies");
    std::vector<SweepAxis> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = axis_of(axes[i]);
    return sweep_grid(all);
}

struct RowCallback {
    camopt_sweep_callback call;
    void* user;
};

void solve_rows(const camopt_scene& given, const SweepPlan& plan, CallbackControl& callbacks,
                const RowCallback& row_callback) {
    SweepScenes scenes(
        plan, [&](std::span<const std::string> settings) { return complete_scene(given, settings); });
    const SweepColumns columns = check_rows(scenes);
    SolveControl control = callbacks.control();
    control.stop_requested = [asked = std::move(control.stop_requested), &callbacks] {
        return callbacks.stopped() || (asked && asked());
    };
    int told = 0;
    const auto tell = [&](const SweepRow& row) {
        const ShownRow shown(row, columns, plan.rows());
        ++told;
        callbacks.call([&] {
            if (row_callback.call(&shown.shown(), row_callback.user) != 0) callbacks.stop();
        });
    };
    const Chunking chunks{plan.rows(), chunk_size_for(scenes)};
    for (int chunk = 0; chunk < chunks.count() && !callbacks.stopped(); ++chunk)
        (void)solve_chunk(scenes, chunks.range(chunk), control, tell);
    callbacks.finish();
    if (told < plan.rows())
        throw Failure(CAMOPT_ERROR_CANCELLED, "the sweep was stopped by its caller after " +
                                                  std::to_string(told) + " of " +
                                                  std::to_string(plan.rows()) + " rows");
}

}  // namespace
}  // namespace camopt::c

using namespace camopt::c;

extern "C" {

camopt_error camopt_sweep(const camopt_scene* scene, const camopt_sweep_axis* axes, size_t axis_count,
                          const camopt_solve_options* options, camopt_sweep_callback row, void* row_user) {
    return guarded([&] {
        require(scene, "scene");
        if (row == nullptr)
            throw Failure(CAMOPT_ERROR_NULL, "row: found NULL; allowed: the function that takes the rows");
        CallbackControl callbacks(read_options(options, "options"));
        solve_rows(*scene, plan_of(axes, axis_count), callbacks, {row, row_user});
    });
}

int camopt_abi_version() {
    return CAMOPT_ABI_VERSION;
}

const char* camopt_version() {
    return camopt::version().data();
}

const char* camopt_licenses() {
    static const std::string text = camopt::license_text();
    return text.c_str();
}

camopt_error camopt_solve(const camopt_scene* scene, const camopt_solve_options* options,
                          camopt_solution** solution) {
    return guarded([&] {
        require(solution, "solution");
        *solution = nullptr;
        require(scene, "scene");
        *solution = solved(*scene, read_options(options, "options")).release();
    });
}

void camopt_solution_free(camopt_solution* solution) {
    delete solution;
}
}
