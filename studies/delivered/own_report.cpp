// SPDX-License-Identifier: MIT
#include "studies/delivered/own_report.hpp"

#include "objectives/rules/own_point_rule.hpp"

namespace camopt {

std::vector<OwnTermReport> own_term_reports(const Scene& scene, const Motion& motion) {
    std::vector<OwnTermReport> reports;
    for (const OwnTerm& term : scene.own_terms) {
        const Extremum largest = largest_of_own(term, motion);
        reports.push_back({term.name, term.weight, term.reference, largest.value, largest.at});
    }
    return reports;
}

std::vector<ConstraintReport> own_constraints(const Scene& scene, const Motion& motion) {
    std::vector<ConstraintReport> reports;
    for (const OwnLimit& limit : scene.own_limits) {
        const Extremum worst = largest_of_own(limit, motion);
        reports.push_back({limit.key(), limit.key(), limit.limit, worst.value, limit.unit, worst.at});
    }
    return reports;
}

}  // namespace camopt
