// SPDX-License-Identifier: MIT
#include "core/text/names.hpp"
#include "scene/faults/scene_faults.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace camopt {
namespace {

/// Common to terms and limits.
template <class Rule>
Fault own_rule_fault(const Rule& rule, const std::string& member, std::set<std::string>& names) {
    if (!is_plain_name(rule.name))
        return SceneFault{member + ".name", fmt::format("\"{}\"", rule.name),
                          "a name of lower case letters, digits and _"};
    if (!names.insert(rule.name).second)
        return SceneFault{member + ".name", fmt::format("\"{}\" twice", rule.name), "each name once"};
    if (!rule.formula) return SceneFault{member + ".formula", "none", "a function"};
    if (rule.highest_order < 0 || rule.highest_order > 3)
        return SceneFault{member + ".highest_order", fmt::to_string(rule.highest_order),
                          "an integer from 0 to 3"};
    return std::nullopt;
}

Fault positive_fault(const std::string& member, double value) {
    if (std::isfinite(value) && value > 0.0) return std::nullopt;
    return SceneFault{member, fmt::format("{}", value), "a number > 0"};
}

}  // namespace

Fault own_rules_fault(const Scene& scene) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < scene.own_terms.size(); ++i) {
        const OwnTerm& term = scene.own_terms[i];
        const std::string member = fmt::format("own_terms[{}]", i);
        if (Fault fault = own_rule_fault(term, member, names)) return fault;
        if (Fault fault = positive_fault(member + ".weight", term.weight)) return fault;
        if (Fault fault = positive_fault(member + ".reference", term.reference)) return fault;
    }
    names.clear();
    for (std::size_t i = 0; i < scene.own_limits.size(); ++i) {
        const OwnLimit& limit = scene.own_limits[i];
        const std::string member = fmt::format("own_limits[{}]", i);
        if (Fault fault = own_rule_fault(limit, member, names)) return fault;
        if (!std::isfinite(limit.limit))
            return SceneFault{member + ".limit", fmt::format("{}", limit.limit), "a finite number"};
        if (!std::isfinite(limit.size) || limit.size < 0.0)
            return SceneFault{member + ".size", fmt::format("{}", limit.size), "a number >= 0"};
    }
    return std::nullopt;
}

}  // namespace camopt
