// SPDX-License-Identifier: MIT
#include "report/check/check_document.hpp"

#include "core/text/list_text.hpp"
#include "core/word_of.hpp"
#include "input/scene_text.hpp"
#include "report/view/key_words.hpp"
#include "report/view/number_text.hpp"
#include "report/view/verdict_words.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;

constexpr std::size_t most_characters = 60;  // of a value in a line: longer lists stand in the file

/// "lift 12 mm", of a limit "cam radius >= 5 mm".
std::string key_text(const input::WrittenKey& key, std::string_view name, bool limit) {
    std::string value = key.value;
    const bool one = value.front() != '[' && value.front() != '{';
    if (value.front() == '"') value = value.substr(1, value.size() - 2);
    if (!one && value.size() > most_characters) value = value.substr(0, most_characters) + " …";
    const bool least = name.find("_min") != std::string_view::npos;
    const std::string_view sign = !limit || !one ? "" : least ? ">= " : "<= ";
    return fmt::format("{} {}{}{}{}", key_words(name).words, sign, value, key.unit.empty() ? "" : " ",
                       key.unit);
}

/// A line a table of the scene file: "motion: type RR, lift 12 mm, rise 100 deg".
std::vector<std::string> scene_lines(const std::vector<input::WrittenKey>& keys) {
    std::vector<std::string> lines;
    std::string last, items;
    const auto finish = [&] {
        if (!items.empty()) lines.push_back(last.empty() ? items : last + ": " + items);
        items.clear();
    };
    for (const input::WrittenKey& key : keys) {
        const std::size_t name = key.key.rfind('.') + 1;  // npos + 1 is 0
        const std::string table = key.key.substr(0, name == 0 ? 0 : name - 1);
        if (table != last) finish();
        last = table;
        append_item(items, key_text(key, std::string_view(key.key).substr(name), table == "limits"));
    }
    finish();
    return lines;
}

Section scene_section(const Scene& scene) {
    const std::vector<input::WrittenKey> keys = input::keys_of(scene);
    Section section = listing("scene", "The scene", scene_lines(keys));
    section.say(Kind::remark, "default", {"What is not listed has its default (camopt list keys)."});
    Table table{"keys", "", {{.key = "key"}, {.key = "value"}, {.key = "unit"}}};
    table.where = Where::files;
    for (const input::WrittenKey& key : keys) table.rows.push_back({key.key, key.value, key.unit});
    section.tables.push_back(std::move(table));
    return section;
}

const char* meaning_of(Curvature curvature) {
    return word_of<Curvature::general>(curvature,
                                       {"linear", "convex", "general: an optimum may be a local one"});
}

std::string counted(int count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string searched_line(const SolvePlan& plan) {
    std::vector<std::string> parts;
    if (!plan.prescribed) parts.emplace_back("the motion");
    if (plan.displacements > 0) parts.push_back(counted(plan.displacements, "free displacement"));
    if (plan.dimensions > 0) parts.push_back(counted(plan.dimensions, "dimension") + " of the cam");
    if (plan.breakpoints > 0) parts.push_back(counted(plan.breakpoints, "breakpoint"));
    if (plan.angles > 0) parts.push_back("the angles of " + counted(plan.angles, "segment"));
    if (parts.empty()) return "Searched: nothing, the motion is prescribed";
    return fmt::format("Searched: {}", fmt::join(parts, ", "));
}

std::string starts_sentence(const SolvePlan& plan) {
    if (plan.breakpoints > 0)
        return fmt::format(
            "first on the given breakpoints, then the structured solver moves them from at most {}: the "
            "given ones, then random ones (seed {})",
            counted(plan.starts, "start"), plan.seed);
    return fmt::format(
        "a convex relaxation first ({}), then the best of at most {}: {}its optimum, the smoothest motion, "
        "random ones (seed {})",
        plan.relaxations.size() > 1
            ? "without the limits that are not convex, then with those that are for sensible displacements"
            : "without the limits that are not convex",
        counted(plan.starts, "start"), plan.from_measured ? "the measured motion, " : "", plan.seed);
}

std::string verdict_sentence(const SolvePlan& plan) {
    if (plan.contradiction) return "its conditions contradict each other: infeasible, proved";
    if (plan.breakpoints > 0)
        return fmt::format(
            "{}local or feasible; infeasibility is not proved",
            plan.proof == ProofKind::none ? "" : "optimal if the limit of any curve is reached, else ");
    if (plan.angles > 0)
        return fmt::format(
            "{}{}",
            plan.proof == ProofKind::boxes ? "optimal or infeasible if the boxes prove it, else " : "",
            plan.angles == 2 ? "local or feasible" : "feasible");
    if (plan.proof == ProofKind::boxes)
        return "optimal or infeasible if the relaxation or a bound over boxes proves it, else local or "
               "feasible with a bound";
    if (plan.proof == ProofKind::none) return "local or feasible, without a bound";
    return plan.reason.empty() && plan.solver != "structured"
               ? fmt::format("optimal or infeasible, both with a proof; if {} fails, feasible", plan.solver)
               : "optimal or infeasible, both with a proof";
}

/// One line each; what the plan does not contain is left out.
std::vector<std::string> plan_lines(const SolvePlan& plan) {
    std::vector<std::string> lines = {searched_line(plan)};
    if (plan.prescribed && plan.dimensions == 0)
        lines.push_back("Solved: by no solver, " +
                        no_solver_words(plan.reason.empty() ? plan.solver : "auto"));
    else
        lines.push_back(fmt::format("Solved: {}by {} ({}), design vector: {}, at most {} s",
                                    plan.relaxations.empty() || plan.solver == "structured"
                                        ? ""
                                        : "by structured where the convex relaxation decides, else ",
                                    plan.solver, plan.reason.empty() ? "named in the scene" : "chosen",
                                    name_of(plan.design), short_text(plan.seconds)));
    if (!plan.reason.empty()) lines.push_back("Reason: " + plan.reason);
    if (plan.angles > 0)
        lines.push_back(
            fmt::format("Angles: each set of angles that is tried is solved by its own plan; boxes of angles "
                        "are {}bounded",
                        plan.proof == ProofKind::boxes ? "" : "not "));
    if (!plan.relaxations.empty() || plan.breakpoints > 0) lines.push_back("Steps: " + starts_sentence(plan));
    if (plan.strokes_first_free)
        lines.emplace_back(
            "Strokes: rules of motion.within_lift and motion.monotone are added if the motion leaves a "
            "range");
    if (!plan.next_solver.empty())
        lines.push_back(fmt::format("Without a {}: {} is tried next",
                                    plan.relaxations.empty() ? "proof" : "motion", plan.next_solver));
    if (plan.cost_scale != 1.0)
        lines.push_back(fmt::format("Scale: the objective is divided by {} while it is solved",
                                    short_text(plan.cost_scale)));
    if (plan.tie_break) lines.emplace_back("Ties: of equal optima the smoothest motion");
    lines.push_back("Expected verdict: " + verdict_sentence(plan));
    if (plan.explain_seconds > 0.0)
        lines.push_back(fmt::format("Without a motion: changes that help are searched for at most {} s",
                                    short_text(plan.explain_seconds)));
    return lines;
}

Table limit_table(const std::vector<LimitShape>& limits) {
    Table table{"limits",
                "Limits",
                {{.key = "key", .title = "limit", .left = true, .code = true},
                 {.key = "curvature", .title = "in the design vector", .left = true}}};
    for (const LimitShape& limit : limits) table.rows.push_back({limit.key, meaning_of(limit.curvature)});
    return table;
}

/// Against differences.
Table derivative_table(const std::vector<DerivativeError>& errors) {
    Table table{"derivatives",
                "Derivatives against differences",
                {{.key = "derivative", .left = true},
                 {.key = "entries"},
                 {.key = "wrong"},
                 {.key = "error", .title = "largest error"},
                 {.key = "beyond", .title = "times what differences may err"},
                 {.key = "where", .left = true}}};
    for (const DerivativeError& one : errors)
        table.rows.push_back({one.kind, Cell(static_cast<double>(one.entries)),
                              Cell(static_cast<double>(one.wrong)), Cell(one.error, 2),
                              one.wrong > 0 ? Cell(one.beyond, 2) : Cell(), one.where});
    return table;
}

/// Conditions of the motion that are not independent.
void say_conditions(Section& section, const SceneCheck& check) {
    for (const std::string& condition : check.redundant)
        section.say(Kind::note, "redundant", {condition + " follows from others"});
    for (const std::string& condition : check.contradictions)
        section.say(Kind::warning, "contradiction",
                    {fmt::format("infeasible: {} contradicts other conditions", condition)});
    if (!check.derivatives_agree) section.say(Kind::warning, "derivatives", {"the derivatives are wrong"});
}

Figure count_of(const char* key, const char* title, int count) {
    return {{.key = key, .title = title}, Cell(static_cast<double>(count))};
}

}  // namespace

Document check_document(const Scene& scene, const SceneCheck& check, const std::string& name) {
    Document document{name + ": the scene is valid"};
    Section problem;
    say_conditions(problem, check);
    document.sections = {std::move(problem), scene_section(scene),
                         listing("plan", "The solve", plan_lines(check.plan))};
    Section& plan = document.sections.back();
    plan.figures = {count_of("variables", "variables", check.variables),
                    count_of("rows", "rows on the first grid", check.rows)};
    plan.figures.push_back(
        {{.key = "convex", .title = "problem"},
         flag(check.plan.convex)
             .in_words(check.plan.convex ? "convex: an optimum is global" : "not convex")});
    if (scene.cam) plan.tables.push_back(limit_table(check.limits));
    plan.tables.push_back(derivative_table(check.derivatives));
    return document;
}

}  // namespace camopt
