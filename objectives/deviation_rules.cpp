// SPDX-License-Identifier: MIT
#include "objectives/deviation_rules.hpp"

#include "objectives/rules/energy_rule.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// x: a row beyond the end by less is rounding of an angle.
constexpr double end_slack = 1e-9;
constexpr double default_reference = 1e-3;
// Rows of the first grid; others are added where they are passed.
constexpr std::size_t most_first_rows = 200;

/// Of each run of rows on one side of the motion the farthest. setting: the side, the row.
std::vector<WholeMotionRule::Place> farthest_rows(const std::vector<MeasuredRow>& rows, const Motion& motion,
                                                  double reference) {
    std::vector<WholeMotionRule::Place> all;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double off = (motion.at(rows[k].x).derivative[0] - rows[k].y) / reference;
        const double sign = off < 0.0 ? -1.0 : 1.0;
        const WholeMotionRule::Place place{{std::abs(off), rows[k].x}, {sign, static_cast<double>(k)}};
        if (all.empty() || all.back().setting[0] != sign)
            all.push_back(place);
        else if (place.where.value > all.back().where.value)
            all.back() = place;
    }
    return all;
}

/// ± (y(x_k) − t_k) / reference <= q.
WholeMotionRule deviation_rule(const std::vector<MeasuredRow>& rows, int parameter, double reference) {
    WholeMotionRule::Parts parts;
    parts.maxima = [rows, reference](const Motion& motion, double) {
        return farthest_rows(rows, motion, reference);
    };
    parts.row = [rows, reference](const MotionFamily& family, double, Side,
                                  WholeMotionRule::Setting setting) {
        const MeasuredRow& measured = rows[static_cast<std::size_t>(setting[1])];
        const double factor = setting[0] / reference;
        return combined({-factor * measured.y, {}, {}}, factor, family.functional(measured.x, 0));
    };
    parts.first.clear();
    const std::size_t stride = (rows.size() + most_first_rows - 1) / most_first_rows;
    for (std::size_t k = 0; k < rows.size(); k += stride)
        for (const double sign : {1.0, -1.0})
            parts.first.push_back({{0.0, rows[k].x}, {sign, static_cast<double>(k)}});
    parts.remark = [](WholeMotionRule::Setting setting) {
        return fmt::format("row {} {}", static_cast<int>(setting[1]) + 1, setting[0] > 0.0 ? "+" : "-");
    };
    parts.which = [](WholeMotionRule::Setting setting) {
        return std::map<std::string, double>{{"row", setting[1]}, {"side", setting[0]}};
    };
    return {{"deviation", 0, false, true, {parameter}}, std::move(parts)};
}

Energy energy_of(const std::vector<MeasuredRow>& rows) {
    return {[rows](const Motion& motion) { return deviation_of(rows, motion).rms; },
            [rows](const MotionFamily& family, double level) {
                EnergySum sum(family.size());
                for (const MeasuredRow& measured : rows)
                    sum.add(combined({-measured.y / level, {}, {}}, 1.0 / level,
                                     family.functional(measured.x, 0)),
                            1.0);
                return sum.form(1.0 / static_cast<double>(rows.size()));
            }};
}

}  // namespace

std::vector<MeasuredRow> measured_rows(const Scene& scene, double begin, double end) {
    std::vector<MeasuredRow> rows;
    const double unit = scene.motion.unit_angle();
    const MeasuredMotion& measured = *scene.measured;
    for (std::size_t k = 0; k < measured.angle.size(); ++k) {
        const double x = measured.angle[k] / unit;
        if (x < begin - end_slack || x > end + end_slack) continue;
        rows.push_back({std::clamp(x, begin, end), measured.displacement[k] / scene.motion.lift});
    }
    return rows;
}

Deviation deviation_of(const std::vector<MeasuredRow>& rows, const Motion& motion) {
    Deviation deviation;
    double squares = 0.0;
    for (const MeasuredRow& row : rows) {
        const double off = std::abs(motion.at(row.x).derivative[0] - row.y);
        squares += off * off;
        if (off > deviation.largest.value) deviation.largest = {off, row.x};
    }
    deviation.rms = rows.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(rows.size()));
    return deviation;
}

double deviation_reference(const Scene& scene, const ResponseTerm& term) {
    return (scene.objective.reference.*term.reference).value_or(default_reference);
}

void add_deviation_terms(CamModel& model, const Scene& scene) {
    for (const ResponseTerm& term : response_terms()) {
        const double weight = term.weight_in(scene.objective);
        if (!term.needs_measured() || !(weight > 0.0)) continue;
        std::vector<MeasuredRow> rows = measured_rows(scene, model.design.begin(), model.design.end());
        if (rows.empty()) throw SceneError({"measured", "no row on the motion", "rows all along the motion"});
        const bool peak = term.figure == ResponseFigure::deviation;
        const double reference = deviation_reference(scene, term);
        const int index = static_cast<int>(model.parameters.size());
        Parameter parameter{term.name, peak ? Parameter::Kind::response : Parameter::Kind::energy, 0,
                            reference, weight};
        if (peak) {
            parameter.defined_by =
                std::make_shared<const WholeMotionRule>(deviation_rule(rows, index, reference));
            model.rules.emplace_back(parameter.defined_by);
        } else {
            parameter.defined_by = energy_rule(term.name, energy_of(rows), reference, index);
        }
        model.parameters.push_back(std::move(parameter));
    }
}

}  // namespace camopt
