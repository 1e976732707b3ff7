// SPDX-License-Identifier: MIT
#include "studies/rest_conflict.hpp"

#include "core/units.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

struct Broken {
    std::string key;
    KnownPoint where;
    double value = 0.0, scale = 1.0;
};

bool speaks_of_rest(const PlacedRule& rule) {
    return rule->limit() && rule->parameters().empty() && rule->highest_order() <= 1 && rule.stretch == -1 &&
           rule->curvature(-infinity, infinity) == Curvature::general;
}

}  // namespace

bool report_rest_conflict(Solution& solution, const CamModel& model) {
    std::optional<Broken> worst;
    for (const PlacedRule& rule : model.rules) {
        if (!speaks_of_rest(rule)) continue;
        for (const KnownPoint& known : model.known_points) {
            if (!known.at_rest) continue;
            const double value = rule->evaluate({known.x, {known.y, 0.0, 0.0, 0.0}}, {}).value;
            const bool broken = value > solution.scene.solver.tolerance * rule->scale();
            if (broken && (!worst || value / rule->scale() > worst->value / worst->scale))
                worst = Broken{rule->name(), known, value, rule->scale()};
        }
    }
    if (!worst) return false;
    solution.certificate.verdict = Verdict::infeasible;
    solution.certificate.reason = "limit_broken_at_rest";
    solution.conflict = {{worst->key, worst->where.x, 1.0}};
    solution.notes.push_back(fmt::format(
        "every motion of this scene rests at {:.6g} deg at displacement {:.6g} (in lifts), and {} is "
        "broken there whatever it does elsewhere",
        worst->where.x * solution.scene.motion.unit_angle() / units::degree, worst->where.y, worst->key));
    return true;
}

}  // namespace camopt
