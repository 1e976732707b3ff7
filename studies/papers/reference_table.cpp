// SPDX-License-Identifier: MIT
#include "studies/papers/reference_table.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "splines/design_vector.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// The paper's printed ordinate y3 of n = 10 and what it must be for y''(0) = 0 (and y7 = 1 − y3).
constexpr int misprinted_segments = 10;
constexpr int misprinted_ordinate = 3;
constexpr double corrected_value = 0.1748;

double weighted(double velocity, double acceleration, double jerk, const std::array<double, 3>& weights) {
    return weights[0] * velocity / paper::velocity_reference +
           weights[1] * acceleration / paper::acceleration_reference +
           weights[2] * jerk / paper::jerk_reference;
}

PeakFigures figures_of(const Peaks& peaks, const std::array<double, 3>& weights = paper::weights) {
    return {peaks.velocity.value, peaks.acceleration.value, peaks.jerk.value,
            weighted(peaks.velocity.value, peaks.acceleration.value, peaks.jerk.value, weights)};
}

/// The C2 cubic through all ordinates with y' = 0 at both ends: the paper's equation (4).
SplineCurve spline_through(const std::vector<double>& ordinates) {
    const int segments = static_cast<int>(ordinates.size()) - 1;
    const DesignVector design = DesignVector::make(
        {SplineSpace::uniform(3, 2, segments, 1.0), DesignKind::ordinates, {}, {1.0, 0.0, 0.0}, {}, {}});
    return design.curve(Eigen::Map<const Eigen::VectorXd>(ordinates.data() + 1, segments - 1));
}

std::vector<double> ordinates_of(const SplineCurve& curve) {
    std::vector<double> ordinates;
    for (const double x : curve.breakpoints()) ordinates.push_back(curve.at(x, Side::left).derivative[0]);
    return ordinates;
}

void add_printed_points(ConvergenceRow& row) {
    for (const paper::OptimumPoints& points : paper::optimum_points()) {
        if (points.segments != row.segments) continue;
        row.printed_points = points.ordinates;
        const SplineCurve curve = spline_through(points.ordinates);
        row.points_exact = figures_of(peaks_of(curve));
        row.points_end_acceleration = curve.at(0.0).derivative[2];
        if (row.segments != misprinted_segments) continue;
        std::vector<double> corrected = points.ordinates;
        corrected[misprinted_ordinate] = corrected_value;
        corrected[misprinted_segments - misprinted_ordinate] = 1.0 - corrected_value;
        row.corrected_exact = figures_of(peaks_of(spline_through(corrected)));
    }
}

std::string note_of(const ConvergenceRow& row) {
    if (!row.printed) return "beyond the paper";
    if (row.segments == misprinted_segments)
        return fmt::format(
            "y3 = 0.1740 is a misprint: it breaks y''(0) = 0 (found {:.4f}); with 0.1748 the printed "
            "peaks follow",
            row.points_end_acceleration.value_or(0.0));
    const double loss = row.printed->objective - row.optimum.certificate.objective;
    if (loss < 5e-5) return "the printed figure is the optimum, rounded";
    return fmt::format("the paper's search in steps of 0.0001 stops {:.4f} above the optimum", loss);
}

ConvergenceRow convergence_row(int segments, const SolveControl& control) {
    ConvergenceRow row;
    row.segments = segments;
    for (const paper::Convergence& printed : paper::convergence()) {
        if (printed.segments != segments) continue;
        row.printed = PeakFigures{printed.velocity, printed.acceleration, printed.jerk, printed.objective};
    }
    add_printed_points(row);
    row.optimum =
        solve(paper_scene(segments, paper::weights[0], paper::weights[1], paper::weights[2]), control);
    if (row.optimum.curve) row.optimum_points = ordinates_of(*row.optimum.curve);
    row.note = note_of(row);
    return row;
}

std::vector<LawComparisonRow> law_rows(double optimum) {
    std::vector<LawComparisonRow> rows;
    const auto loss = [&](const LawComparisonRow& row) -> std::optional<double> {
        if (!row.exact || !std::isfinite(row.exact->objective)) return {};
        return 100.0 * (row.exact->objective / optimum - 1.0);
    };
    for (const paper::LawPeaks& printed : paper::law_peaks()) {
        LawComparisonRow row{std::string(printed.name), std::string(printed.key), {}, {}, {}};
        row.printed =
            PeakFigures{printed.velocity, printed.acceleration, printed.jerk.value_or(infinity), 0.0};
        if (!row.key.empty()) row.exact = figures_of(make_law(row.key)->peaks());
        row.loss_percent = loss(row);
        rows.push_back(std::move(row));
    }
    for (const LawInfo& law : law_catalogue()) {
        const bool listed = std::ranges::any_of(rows, [&](const auto& row) { return row.key == law.key; });
        if (listed || law.top != TopEnd::dwell || !law.rests) continue;
        LawComparisonRow row{law.title, law.key, {}, figures_of(make_law(law.key)->peaks()), {}};
        row.loss_percent = loss(row);
        rows.push_back(std::move(row));
    }
    return rows;
}

WeightEffectRow weight_row(const paper::WeightEffect& printed, const PeakFigures& printed_optimum,
                           const SolveControl& control) {
    WeightEffectRow row;
    row.velocity = printed.velocity;
    row.acceleration = printed.acceleration;
    row.jerk = printed.jerk;
    row.printed_fourth_ordinate = printed.fourth_ordinate;
    row.printed_objective =
        weighted(printed_optimum.velocity, printed_optimum.acceleration, printed_optimum.jerk,
                 {printed.velocity, printed.acceleration, printed.jerk});
    row.optimum = solve(
        paper_scene(misprinted_segments, printed.velocity, printed.acceleration, printed.jerk), control);
    if (row.optimum.curve) row.fourth_ordinate = ordinates_of(*row.optimum.curve)[4];
    if (row.optimum.any_curve_limit) row.limit = *row.optimum.any_curve_limit;
    return row;
}

/// How far the modified sine is ahead of the best cubic where the paper says it.
std::vector<std::string> displacement_note(const ConvergenceRow& row) {
    constexpr double x = 0.25, lift = 10e-3, printed = 46e-6;
    if (!row.optimum.curve) return {};
    const double ahead =
        make_law("modified_sine")->at(x).derivative[0] - row.optimum.curve->at(x).derivative[0];
    return {fmt::format(
        "Fig. 5: at x = {} of a lift of {:.0f} mm the modified sine is {:.1f} µm ahead of the best cubic "
        "of {} segments; the paper says {:.0f} µm.",
        x, 1e3 * lift, 1e6 * ahead * lift, row.segments, 1e6 * printed)};
}

std::vector<std::string> explanations() {
    return {
        "The paper divides by the modified sine's peaks rounded to 1.76, 5.53 and 69 (exact: 1.7596, 5.5280 "
        "and 69.466); so does this table.",
        "Table 1, n = 10: y3 = 0.1740 (and y7 = 0.8260) is a misprint. It breaks y''(0) = 0 and evaluates "
        "to A = 5.867, J = 57.53; with 0.1748 (0.8252) the printed peaks 1.688, 5.520, 55.20 follow.",
        "Table 3: the text does not define its modified cycloidal law. SCCA with a sine, a constant, a "
        "cosine and "
        "a coast of 67.5, 33.3, 49.5 and 29.7 of 180 has the printed peaks; whether it is the paper's law "
        "cannot "
        "be known.",
        "The paper searches the ordinates in steps of 0.0001, so its figures lie up to 0.002 above the "
        "optimum. The problem is a linear program; the optimum here is proved by weak duality.",
        "Table 4: all five weightings have the same optimal peaks at n = 10, V = 5/3, A = 50/9, J = 500/9, "
        "with y4 = 1/3. The paper's two values of y4, 0.331733 and 0.333633, come from its search grid, not "
        "from the weights.",
        "More segments are not always better: uniform breakpoints may miss the switching points of the best "
        "curve (n = "
        "16 is worse than n = 10). The limit is what no curve can pass; 7 free segments reach it.",
    };
}

}  // namespace

Scene paper_scene(int segments, double velocity_weight, double acceleration_weight, double jerk_weight) {
    Scene scene;
    scene.title = fmt::format("Spline against modified sine, {} segments", segments);
    scene.motion.symmetric = true;
    scene.spline.segments = segments;
    scene.objective.velocity = velocity_weight;
    scene.objective.acceleration = acceleration_weight;
    scene.objective.jerk = jerk_weight;
    Reference& reference = scene.objective.reference;
    reference.numeric = true;
    reference.velocity = paper::velocity_reference;
    reference.acceleration = paper::acceleration_reference;
    reference.jerk = paper::jerk_reference;
    return scene;
}

ReferenceTable spline_versus_modified_sine(const SolveControl& control,
                                           const std::function<void(const std::string&)>& finished) {
    const auto tell = [&](const std::string& what) {
        if (finished) finished(what);
    };
    ReferenceTable table;
    for (const int segments : {4, 6, 8, 10, 12, 14, 16, 24, 32, 64}) {
        if (control.stopped()) return table;
        table.convergence.push_back(convergence_row(segments, control));
        tell(fmt::format("{} segments", segments));
    }
    const auto row_of = [&](int segments) -> const ConvergenceRow& {
        return *std::ranges::find(table.convergence, segments, &ConvergenceRow::segments);
    };
    if (row_of(12).optimum.any_curve_limit) table.limit = *row_of(12).optimum.any_curve_limit;
    table.modified_sine_exact = figures_of(make_law("modified_sine")->peaks());
    table.laws = law_rows(row_of(12).optimum.certificate.objective);
    for (const paper::WeightEffect& printed : paper::weight_effects()) {
        if (control.stopped()) return table;
        table.weights.push_back(weight_row(printed, *row_of(10).corrected_exact, control));
        tell(fmt::format("weights {:.3g}, {:.3g}, {:.3g}", printed.velocity, printed.acceleration,
                         printed.jerk));
    }
    table.notes = explanations();
    for (std::string& note : displacement_note(row_of(12))) table.notes.push_back(std::move(note));
    return table;
}

std::vector<std::string> unproved_rows(const ReferenceTable& table) {
    std::vector<std::string> rows;
    const auto look = [&](const std::string& name, const Certificate& certificate) {
        if (certificate.verdict == Verdict::optimal) return;
        const std::string reason =
            certificate.reason == Reason::none ? "" : fmt::format(": {}", name_of(certificate.reason));
        rows.push_back(fmt::format("{} ({}{})", name, name_of(certificate.verdict), reason));
    };
    for (const ConvergenceRow& row : table.convergence)
        look(fmt::format("n = {}", row.segments), row.optimum.certificate);
    for (const WeightEffectRow& row : table.weights)
        look(fmt::format("weights {:.3g}, {:.3g}, {:.3g}", row.velocity, row.acceleration, row.jerk),
             row.optimum.certificate);
    return rows;
}

}  // namespace camopt
