// SPDX-License-Identifier: MIT
// camopt check: is the scene right, can its problem be built, are its derivatives right? No solve.
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "output/number_text.hpp"
#include "studies/scene_check.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace camopt::apps {

namespace {

const char* meaning_of(Curvature curvature) {
    switch (curvature) {
        case Curvature::linear:
            return "linear";
        case Curvature::convex:
            return "convex";
        case Curvature::general:
            break;
    }
    return "general: an optimum may be a local one";
}

std::string limits_text(const std::vector<LimitShape>& limits) {
    std::string text;
    for (const LimitShape& limit : limits)
        text += fmt::format("  limit: {} is {}\n", limit.key, meaning_of(limit.curvature));
    return text;
}

}  // namespace

ExitCode check_command(const CheckRequest& request) {
    const Scene scene = load_scene(request.scene, request.settings);
    const SceneCheck check = check_scene(scene);
    std::string text = fmt::format("{}: the scene is valid\n", request.scene);
    text += fmt::format("  problem: {} variables, {} rows on the first grid, {}\n", check.variables,
                        check.rows, check.convex ? "convex: an optimum is global" : "not convex");
    text +=
        fmt::format("  solver: {}, design vector: {}\n", check.choice.solver, name_of(check.choice.design));
    if (scene.cam || scene.mechanism) text += limits_text(check.limits);
    for (const DerivativeError& error : check.derivatives)
        text +=
            fmt::format("  {:<9} agrees with differences to {}{}\n", error.kind, short_text(error.error, 2),
                        error.where.empty() ? "" : " (worst at " + error.where + ")");
    for (const std::string& condition : check.redundant)
        text += fmt::format("  note: {} follows from others\n", condition);
    for (const std::string& condition : check.contradictions)
        text += fmt::format("  infeasible: {} contradicts other conditions\n", condition);
    if (!check.derivatives_agree) text += "  the derivatives are wrong\n";
    print(text);
    if (!check.derivatives_agree) return failure;
    return check.contradictions.empty() ? success : proved_infeasible;
}

}  // namespace camopt::apps
