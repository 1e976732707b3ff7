// SPDX-License-Identifier: MIT
#include "output/words/comparison_words.hpp"

#include "output/view/shown_units.hpp"
#include "scene/cost_table.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int table_figures = 4;
constexpr int base_decimals = 3, base_decimals_of_inches = 4;  // a micrometre, a ten-thousandth of an inch

std::string with_unit(double value, const std::string& unit) {
    return short_text(value, table_figures) + (unit.empty() ? "" : " " + unit_words(unit));
}

/// By how much of its scale the limit is passed.
double weight_of(const LimitOutcome& outcome) {
    return std::isnan(outcome.excess) ? infinity : outcome.excess / std::max(outcome.scale, 1e-12);
}

}  // namespace

std::string row_title(const ComparisonRow& row) {
    return row.title;
}

std::string loss_words(const ComparisonRow& row) {
    if (!row.loss_percent) return "–";
    if (row.is_optimum()) return "0 %";
    const double rounded = std::round(100.0 * *row.loss_percent) / 100.0;
    if (rounded == 0.0) return "±0.00 %";
    return fmt::format("{}{:.2f} %", rounded > 0.0 ? "+" : "−", std::abs(rounded));
}

std::string broken_words(const LimitOutcome& outcome) {
    const ConstraintReport& reached = outcome.reached;
    const std::string name = words_of(reached.name);
    if (reached.no_contact) return fmt::format("{}: {}", name, no_contact_words);
    if (std::isnan(outcome.excess)) return name + " does not exist: the cam cannot be built";
    if (reached.name == "symmetric")
        return fmt::format("not symmetric, by {}", short_text(outcome.excess, table_figures));
    const std::string found = fmt::format("{} {}", name, with_unit(reached.worst, reached.unit));
    if (std::isinf(outcome.excess))
        return fmt::format("{}, allowed {}", found, short_text(reached.limit, table_figures));
    const bool below = reached.worst < reached.limit;
    return fmt::format("{}, {} {} {}", found,
                       short_text(std::abs(outcome.excess), outcome.exact ? 3 : table_figures),
                       below ? "below" : "above", short_text(reached.limit, table_figures));
}

std::vector<std::string> broken_limits(const ComparisonRow& row) {
    std::vector<std::pair<double, std::string>> broken;
    for (const LimitOutcome& outcome : row.limits) {
        if (!outcome.kept) broken.emplace_back(-weight_of(outcome), broken_words(outcome));
    }
    std::ranges::stable_sort(broken, {}, &std::pair<double, std::string>::first);
    std::vector<std::string> words;
    words.reserve(broken.size());
    for (auto& [weight, text] : broken) words.push_back(std::move(text));
    return words;
}

std::string base_title(const Comparison& comparison) {
    return "base " + shown_units(comparison.optimum.scene).length.name;
}

std::string base_words(const Comparison& comparison, const ComparisonRow& row) {
    if (!row.base) return {};
    if (!row.base->radius) return "none";
    const ShownUnit length = shown_units(comparison.optimum.scene).length;
    return fixed_text(length.of(*row.base->radius), comparison.optimum.scene.length_unit == LengthUnit::inch
                                                        ? base_decimals_of_inches
                                                        : base_decimals);
}

std::vector<PhysicalPeak> physical_peaks(const Comparison& comparison) {
    const ShownUnits shown = shown_units(comparison.optimum.scene);
    if (!shown.in_time) return {};
    std::vector<PhysicalPeak> all;
    const auto add = [&](std::string title, std::function<double(const ComparisonRow&)> value) {
        all.push_back({std::move(title), std::move(value)});
        double largest = 0.0;
        for (const ComparisonRow& row : comparison.rows)
            if (const double one = all.back().value(row); std::isfinite(one))
                largest = std::max(largest, one);
        if (largest > 0.0)
            all.back().decimals =
                std::max(0, table_figures - 1 - static_cast<int>(std::floor(std::log10(largest))));
    };
    std::size_t order = 1;
    for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk}) {
        const MotionUnit& unit = shown.motion[order++].first;
        add(unit.symbol + " " + unit.name, [peak, factor = unit.per_normalised](const ComparisonRow& row) {
            return factor * (row.motion_peaks.*peak).value;
        });
    }
    if (!comparison.optimum.scene.drive) return all;
    const ShownUnit torque = shown.torque;
    add("τ " + torque.name, [torque](const ComparisonRow& row) {
        return row.drive ? torque.of(row.drive->torque.value) : infinity;
    });
    add("rms τ " + torque.name, [torque](const ComparisonRow& row) {
        return row.drive ? torque.of(row.drive->rms_torque) : infinity;
    });
    add("n " + rpm_shown.name,
        [](const ComparisonRow& row) { return row.drive ? rpm_shown.of(row.drive->speed.value) : infinity; });
    return all;
}

bool has_bases(const Comparison& comparison) {
    return std::ranges::any_of(comparison.rows,
                               [](const ComparisonRow& row) { return row.base.has_value(); });
}

const ComparisonRow* best_law(const Comparison& comparison) {
    for (const ComparisonRow& row : comparison.rows) {
        if (!row.is_optimum() && row.feasible && std::isfinite(row.objective)) return &row;
    }
    return nullptr;
}

std::string comparison_sentence(const Comparison& comparison) {
    const ComparisonRow* best = best_law(comparison);
    if (!best) return "No law of the catalogue satisfies every limit with a finite objective.";
    const bool differs = std::ranges::any_of(comparison.rows, [&](const ComparisonRow& row) {
        return row.misfit.empty() && row.objective != best->objective;
    });
    if (!differs && best->base && best->base->radius)
        return fmt::format("The law that satisfies every limit with the smallest base radius: {}, {} {}.",
                           best->title, base_words(comparison, *best),
                           shown_units(comparison.optimum.scene).length.name);
    if (!differs) return "The laws do not differ in the objective.";
    if (!best->loss_percent)
        return fmt::format("The best law that satisfies every limit: {}, objective {}.", best->title,
                           short_text(best->objective));
    const std::string sentence =
        fmt::format("The best law that satisfies every limit: {}, {} compared with the optimum", best->title,
                    loss_words(*best));
    if (*best->loss_percent >= 0.0) return sentence + ".";
    // Of a proved optimum only the spline can be to blame; a search may have missed a better one.
    return sentence + (comparison.optimum.certificate.verdict == Verdict::optimal
                           ? ": the spline is coarse; more segments would improve on that law."
                           : ": the optimum is not proved; more starts or segments may improve on that law.");
}

std::string objective_words(const Comparison& comparison) {
    const ObjectiveSpec& objective = comparison.optimum.scene.objective;
    const Peaks& reference = comparison.optimum.reference_peaks;
    std::string text;
    const auto add = [&](double weight, const std::string& symbol, double divisor) {
        if (weight != 0.0)
            text += fmt::format("{}{} {}/{}", text.empty() ? "" : " + ", short_text(weight), symbol,
                                short_text(divisor, table_figures));
    };
    for (const CostTerm& term : cost_terms())
        add(term.weight_in(objective), term.symbol, term.measured.of(reference));
    for (const OwnTermReport& term : comparison.optimum.own_terms)
        add(term.weight, term.of_scene ? words_of(term.name) : term.name, term.reference);
    if (comparison.optimum.train)
        for (const ResponseTermReport& term : comparison.optimum.train->terms)
            add(term.weight, words_of(term.name), term.reference);
    if (std::ranges::any_of(objective.dimensions, [](double weight) { return weight > 0.0; }))
        text += text.empty() ? "dimensions of the cam" : " + dimensions of the cam";
    return text;
}

}  // namespace camopt
