// SPDX-License-Identifier: MIT
#include "studies/sweep/sweep_plan.hpp"

#include "objectives/scene_model.hpp"
#include "scene/limit_table.hpp"
#include "scene/written_limits.hpp"
#include "solvers/registry.hpp"
#include "studies/least/least_value.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/ranges.h>

#include <bit>
#include <cstdint>
#include <set>

namespace camopt {

namespace {

/// Numbers on which nothing else depends in a scene that was read: weights, and limits on peaks under the key
/// that they were written with. False: it is none.
bool set_number(Scene& scene, std::string_view key, double value) {
    if (const ObjectiveWeight* const weight = weight_of_key(key)) {
        weight->in(scene.objective) = value;
        return true;
    }
    for (const PeakLimitRow& row : peak_limit_rows()) {
        std::optional<PeakLimit>& limit = row.in(scene.limits);
        if (!row.on_peak() || !limit || limit->key != key || !(limit->one_normalised > 0.0)) continue;
        limit->given = value;
        limit->normalised = value / limit->one_normalised;
        return true;
    }
    return false;
}

void check_keys(std::span<const SweepAxis> axes) {
    std::vector<std::string> seen;
    for (const SweepAxis& axis : axes) {
        for (const std::string& key : axis.keys) {
            if (std::ranges::find(seen, key) != seen.end())
                throw InputError(fmt::format("{}: varied twice; allowed: once", key));
            seen.push_back(key);
        }
    }
}

long row_count(std::span<const SweepAxis> axes) {
    long rows = 1;
    for (const SweepAxis& axis : axes) {
        if (axis.points() == 0) throw InputError("found an axis without points; allowed: at least one");
        rows *= axis.points();
        if (rows > most_sweep_rows)
            throw InputError(fmt::format("the grid has more rows than allowed: at most {}", most_sweep_rows));
    }
    return rows;
}

/// Laws and the weights that are > 0 with them: whether a law's peaks will do depends on nothing else.
using CheckedLaws = std::set<std::pair<std::string, std::array<bool, sweep_figure_count>>>;

std::array<bool, sweep_figure_count> weighed_figures(const ObjectiveSpec& objective) {
    std::array<bool, sweep_figure_count> weighs{};
    for (const CostTerm& term : cost_terms())
        weighs[static_cast<std::size_t>(term.figure)] = term.weight_in(objective) > 0.0;
    return weighs;
}

void check_solve(const Scene& scene, CheckedLaws& checked) {
    const Reference& reference = scene.objective.reference;
    if (reference.numeric || checked.emplace(reference.law, weighed_figures(scene.objective)).second)
        (void)reference_peaks(scene);
    if (scene.objective.sought.has_value()) (void)sought_number(with_written_limits(scene));
    if (scene.solver.name == "auto" && scene.solver.options.empty()) return;  // there is always one
    const std::string solver = scene.solver.name == "auto" ? plan(scene).solver : scene.solver.name;
    (void)make_solver(solver);
    check_native_options(solver, scene.solver.options);
}

/// What has been seen in any row.
struct Seen {
    std::array<bool, dimension_count> variable{}, weighed{};
    std::array<bool, sweep_figure_count> figures{};
    bool train = false, drive = false, spring = false, sought = false;
    std::vector<std::string> responses;  ///< weighed ones, by name

    void add(const Scene& scene) {
        train = train || scene.dynamics.has_value();
        drive = drive || scene.drive.has_value();
        spring = spring || (scene.forces && scene.forces->is_chosen());
        sought = sought || scene.objective.sought.has_value();
        for (const ResponseTerm& term : response_terms())
            if ((term.needs_dynamics() || term.needs_drive()) && term.weight_in(scene.objective) > 0.0 &&
                std::ranges::find(responses, term.name) == responses.end())
                responses.emplace_back(term.name);
        const ObjectiveSpec& objective = scene.objective;
        const auto weighs = weighed_figures(objective);
        for (std::size_t i = 0; i < weighs.size(); ++i) figures[i] = figures[i] || weighs[i];
        for (std::size_t i = 0; i < variable.size(); ++i) {
            const Dimension* const own =
                scene.cam ? scene.cam->find(static_cast<DimensionIndex>(i)) : nullptr;
            if (own == nullptr || !own->is_variable()) continue;
            variable[i] = true;
            weighed[i] = weighed[i] || objective.dimensions[i] > 0.0;
        }
    }
    [[nodiscard]] SweepColumns columns(std::vector<std::string> keys, LengthUnit unit) const {
        SweepColumns columns;
        columns.keys = std::move(keys);
        columns.length_unit = unit;
        columns.train = train;
        columns.drive = drive;
        columns.spring = spring;
        columns.sought = sought;
        for (int i = 0; i < sweep_figure_count; ++i)
            if (figures[i]) columns.criteria.emplace_back(name_of(static_cast<SweepFigure>(i)));
        columns.criteria.insert(columns.criteria.end(), responses.begin(), responses.end());
        for (int i = 0; i < dimension_count; ++i) {
            const auto index = static_cast<DimensionIndex>(i);
            if (variable[i]) columns.dimensions.push_back(index);
            if (weighed[i]) columns.criteria.emplace_back(name_of(index));
        }
        return columns;
    }
};

std::optional<double> finite(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? value : std::nullopt;
}

void set_figures(SweepRow& row, const Peaks& peaks) {
    for (const CostTerm& term : cost_terms())
        row.figures[static_cast<std::size_t>(term.figure)] = finite(term.measured.of(peaks));
}

void set_train(SweepRow& row, const TrainReport& train) {
    if (train.residual) row.train.residual = finite(train.residual->value);
    if (train.acceleration) row.train.dynamic_acceleration = finite(train.acceleration->value);
    if (train.least_force) row.train.contact_force = finite(train.least_force->value);
}

void set_drive(SweepRow& row, const DriveFigures& drive) {
    row.drive = {finite(drive.torque.value), finite(drive.rms_torque), finite(drive.speed.value)};
}

void set_spring(SweepRow& row, const ForceSpec& forces) {
    if (forces.preload_range) row.spring.preload = finite(forces.preload);
    if (forces.spring_rate_range) row.spring.spring_rate = finite(forces.spring_rate);
}

void set_cam(SweepRow& row, const CamSummary& cam) {
    row.cam.pressure_angle = finite(cam.pressure_angle.value);
    if (cam.convex_radius) row.cam.convex_radius = finite(cam.convex_radius->value);
    if (cam.concave_radius) row.cam.concave_radius = finite(cam.concave_radius->value);
}

void set_dimensions(SweepRow& row, const Solution& solution) {
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        const Dimension* const own = solution.scene.cam->find(index);
        if (own != nullptr && own->is_variable())
            row.dimensions[static_cast<std::size_t>(i)] =
                finite(delivered_dimension(solution, index).value());
    }
}

}  // namespace

SweepPlan sweep_grid(std::span<const SweepAxis> axes) {
    if (axes.empty()) throw InputError("found nothing that varies; allowed: --weights, --vary, or both");
    check_keys(axes);
    const long rows = row_count(axes);
    SweepPlan plan;
    for (const SweepAxis& axis : axes) plan.keys.insert(plan.keys.end(), axis.keys.begin(), axis.keys.end());
    plan.values.reserve(static_cast<std::size_t>(rows) * plan.keys.size());
    for (long row = 0; row < rows; ++row) {
        long block = rows;
        for (const SweepAxis& axis : axes) {
            const long pass = row / block;  // how often the axis has been run through
            const int points = std::max(axis.points(), 1);
            block = std::max(block / points, 1L);
            const int along = static_cast<int>(row / block % points);
            const auto point = axis.point(pass % 2 == 0 ? along : points - 1 - along);
            plan.values.insert(plan.values.end(), point.begin(), point.end());
        }
    }
    return plan;
}

std::string fingerprint(const SweepPlan& plan) {
    // FNV-1a, 64 bits: to tell plans apart, not to withstand an attack.
    std::uint64_t hash = 14695981039346656037ULL;
    const auto add = [&](std::uint64_t bits) {
        for (int byte = 0; byte < 8; ++byte) {
            hash ^= bits >> (8 * byte) & 0xFFU;
            hash *= 1099511628211ULL;
        }
    };
    for (const std::string& key : plan.keys) {
        for (const char letter : key) add(static_cast<unsigned char>(letter));
        add(0);
    }
    for (const double value : plan.values) add(std::bit_cast<std::uint64_t>(value));
    return fmt::format("{:016x}", hash);
}

std::string setting_text(const std::string& key, double value) {
    constexpr double exact_integers = 1e15;
    if (value == std::round(value) && std::abs(value) < exact_integers)
        return fmt::format("{}={}", key, static_cast<long long>(value));
    return fmt::format("{}={}", key, value);
}

std::vector<std::string> settings_of(std::span<const std::string> keys, std::span<const double> values) {
    std::vector<std::string> settings;
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (!std::isnan(values[i])) settings.push_back(setting_text(keys[i], values[i]));
    return settings;
}

std::string row_text(const SweepPlan& plan, int row) {
    return fmt::format("row {} ({})", row, fmt::join(settings_of(plan.keys, plan.row(row)), ", "));
}

bool SweepScenes::set_numbers(int row) {
    const std::span<const double> now = plan_->row(row), before = plan_->row(*row_);
    for (std::size_t i = 0; i < plan_->keys.size(); ++i)
        if (now[i] != before[i] && !set_number(scene_, plan_->keys[i], now[i])) return false;
    return !find_fault(scene_);
}

void SweepScenes::read(int row) {
    try {
        scene_ = read_(settings_of(plan_->keys, plan_->row(row)));
    } catch (const UnavailableError& error) {
        throw UnavailableError(fmt::format("{}: {}", row_text(*plan_, row), error.what()));
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", row_text(*plan_, row), error.what()));
    }
}

const Scene& SweepScenes::scene(int row) {
    if (row_ == row) return scene_;
    const bool set = row_ && set_numbers(row);
    row_.reset();  // until it is there: whatever throws below leaves no half-made scene
    if (!set) read(row);
    row_ = row;
    return scene_;
}

bool is_safe_in_threads(const Scene& scene) {
    const SolvePlan how = plan(scene);  // how.next_solver is rare: it waits for its turn
    return std::ranges::all_of(solver_entries(), [&](const SolverEntry& entry) {
        return entry.safe_in_threads || entry.name != how.solver;
    });
}

SweepColumns check_rows(SweepScenes& scenes) {
    const SweepPlan& plan = scenes.plan();
    Seen seen;
    CheckedLaws checked;
    for (int row = 0; row < plan.rows(); ++row) {
        const Scene& scene = scenes.scene(row);
        try {
            check_solve(scene, checked);
        } catch (const UnavailableError& error) {
            throw UnavailableError(fmt::format("{}: {}", row_text(plan, row), error.what()));
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", row_text(plan, row), error.what()));
        }
        seen.add(scene);
    }
    return seen.columns(plan.keys, plan.rows() > 0 ? scenes.scene(0).length_unit : LengthUnit::millimetre);
}

SweepColumns columns_of(std::vector<std::string> keys, std::span<const Scene> scenes) {
    Seen seen;
    for (const Scene& scene : scenes) seen.add(scene);
    return seen.columns(std::move(keys), scenes.front().length_unit);
}

SweepRow certified_row(int number, std::span<const double> settings, const Certificate& certificate) {
    SweepRow row = failed_row(number, settings, name_of(certificate.reason));
    row.verdict = certificate.verdict;
    row.lower_bound = finite(certificate.lower_bound);
    row.gap = finite(certificate.gap);
    return row;
}

SweepRow sweep_row(int number, std::span<const double> settings, const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    SweepRow row = certified_row(number, settings, certificate);
    if (solution.any_curve_limit) row.any_curve_limit = finite(solution.any_curve_limit->objective);
    if (solution.motion && row.is_feasible()) {
        row.objective = finite(certificate.objective);
        set_figures(row, solution.peaks);
        if (solution.cam) {
            set_dimensions(row, solution);
            set_cam(row, solution.cam->summary);
        }
        if (solution.train) set_train(row, *solution.train);
        if (solution.drive) set_drive(row, *solution.drive);
        if (solution.scene.forces) set_spring(row, *solution.scene.forces);
        if (solution.least) row.sought = {solution.least->value, solution.least->impossible};
        for (const ConstraintReport& limit : solution.constraints)
            if (limit.active) row.active_limits.push_back(limit.key);
    }
    row.proved_from = solution.solver.proved_from;
    row.iterations = solution.solver.iterations;
    row.exchange_rounds = solution.solver.exchange_rounds;
    row.evaluations = solution.evaluations;
    row.seconds_solve = solution.seconds_solve;
    row.seconds_total = solution.seconds_total;
    return row;
}

SweepRow failed_row(int number, std::span<const double> settings, std::string_view reason) {
    SweepRow row;
    row.number = number;
    row.settings.assign(settings.begin(), settings.end());
    row.reason = reason;
    return row;
}

namespace {

/// The key that moves fastest is one whose rows may be proved from one another (proved_optima.hpp).
bool may_prove_neighbours(SweepScenes& scenes) {
    const std::string& key = scenes.plan().keys.back();
    if (is_weight_key(key)) return true;
    const Scene& first = scenes.scene(0);
    return differ_in_peak_limits_only(first, first) &&
           std::ranges::any_of(peak_limit_rows(), [&](const PeakLimitRow& row) {
               const std::optional<PeakLimit>& limit = row.in(first.limits);
               return row.on_peak() && limit && limit->key == key;
           });
}

}  // namespace

int chunk_size_for(SweepScenes& scenes) {
    constexpr int segments_of_a_chunk = 16'000;
    const SweepPlan& plan = scenes.plan();
    int most = default_chunk_size;
    if (plan.rows() > least_chunks * most && may_prove_neighbours(scenes)) {
        const Scene& first = scenes.scene(0);
        const int segments = std::max(1, segments_of(first.spline));
        if (camopt::plan(first).convex)
            most = std::clamp(segments_of_a_chunk / segments, default_chunk_size, weight_chunk_size);
    }
    return std::clamp((plan.rows() + least_chunks - 1) / least_chunks, 1, most);
}

}  // namespace camopt
