// SPDX-License-Identifier: MIT
#include "output/words/mechanism_words.hpp"

#include "core/units.hpp"
#include "output/words/angle_words.hpp"
#include "output/words/key_words.hpp"
#include "output/words/number_text.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/mechanism_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

using units::degree, units::millimetre;

constexpr int mechanism_check_digits = 2;
constexpr double output_moves_as_designed = 1e-4;  // of the lift: what an undercut cam is off is far more

std::string mechanism_undercut_remark(const Solution& solution) {
    const MechanismSummary& summary = solution.mechanism->summary;
    if (!summary.undercut()) return "No undercut: the cam has neither a cusp nor a loop.";
    if (has_inverse_cam(solution))
        return fmt::format(
            "UNDERCUT at {} deg: a wall of the guide crosses itself there and does not lead the roller as "
            "designed. A smaller roller or a longer stroke helps; the limit undercut_margin = 0 rules "
            "undercut "
            "out.",
            degrees_at(solution, summary.regularity.at));
    if (!solution.mechanism->mechanism.formulas->planar())
        return fmt::format(
            "UNDERCUT at {} deg: a flank folds there and is cut away by the roller's own sweep. A smaller or "
            "shorter roller or a larger cam helps; the limit undercut_margin = 0 rules undercut out.",
            degrees_at(solution, summary.regularity.at));
    return fmt::format(
        "UNDERCUT at {} deg: the cam crosses itself there, the part that remains does not lead the roller as "
        "designed. A smaller roller or a cam's centre farther from it helps; the limit {} = 0 "
        "rules undercut out.",
        degrees_at(solution, summary.regularity.at), limit_row(LimitedFigure::convex_radius).first_key());
}

std::string mechanism_limited_remark(const Solution& solution) {
    std::string limits;
    for (const ConstraintReport& row : solution.constraints)
        if (row.active)
            limits += fmt::format("{}the {} at {} deg", limits.empty() ? "" : ", ", key_words(row.key).words,
                                  degrees_at(solution, row.at));
    return limits.empty() ? "No limit shapes it: none is active."
                          : fmt::format("What limits it: {}.", limits);
}

std::string what_was_driven(const Solution& solution, int points) {
    if (has_inverse_cam(solution))
        return fmt::format("the roller pushes the body along {} points of the guide's walls", points);
    if (solution.mechanism->mechanism.formulas->planar())
        return fmt::format("lever and linkage run over {} points of the cam", points);
    return fmt::format("the follower is driven by {} points of each flank at either end of its roller",
                       points);
}

std::string mechanism_check_remark(const Solution& solution, const ForwardCheckReport& check) {
    const bool swings = solution.scene.motion.lift_is_angle;
    const std::string where = degrees_at(solution, check.at);
    if (!std::isfinite(check.deviation))
        return fmt::format("Forward check: at {} deg no place was found where the roller touches the cam.",
                           where);
    return fmt::format("Forward check: {}, and nothing else: the output {} {} {} (at {} deg).",
                       what_was_driven(solution, check.points),
                       check.relative <= output_moves_as_designed ? "moves as designed within"
                                                                  : "DEPARTS from the designed motion by",
                       short_text(check.deviation / (swings ? degree : millimetre), mechanism_check_digits),
                       swings ? "deg" : "mm", where);
}

}  // namespace

std::string mechanism_text(const MechanismSpec& spec) {
    const auto linkage = spec.choices.find("linkage");
    std::string parts = linkage == spec.choices.end() ? std::string{} : words_of(linkage->second);
    std::ranges::replace(parts, ' ', '-');
    const auto follower = spec.choices.find("follower");
    if (follower != spec.choices.end()) parts = "a " + follower->second + " follower";
    return fmt::format("{} cam{}, turning {}", words_of(spec.type), parts.empty() ? "" : " with " + parts,
                       name_of(spec.rotation));
}

std::string mechanism_dimensions_text(const Solution& solution) {
    std::string text;
    const auto& all = solution.scene.mechanism->dimensions;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Dimension& value = all[i].value;
        if (value.key.empty()) continue;  // this linkage has no such dimension
        const double unit = all[i].is_angle ? degree : millimetre;
        std::string number = short_text(value.low / unit);
        if (value.is_variable())
            number = fmt::format("free from {} to {}", number, short_text(value.high / unit));
        if (solution.mechanism) number = short_text(solution.mechanism->mechanism.dimensions[i] / unit);
        text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", words_of(all[i].name), number,
                            all[i].is_angle ? "deg" : "mm");
    }
    return text;
}

std::vector<CamFigure> mechanism_figures(const Solution& solution) {
    const MechanismSummary& summary = solution.mechanism->summary;
    std::vector<CamFigure> figures;
    const auto add = [&](const char* name, const std::optional<CamExtreme>& extreme, double unit,
                         const char* unit_name) {
        if (!extreme) return;
        figures.push_back(
            {name, short_text(extreme->value / unit) + unit_name, degrees_at(solution, extreme->at)});
    };
    add("largest pressure angle", summary.pressure_angle, degree, " deg");
    add("least convex radius of the cam", summary.convex_radius, millimetre, " mm");
    add("least concave radius of the cam", summary.concave_radius, millimetre, " mm");
    add("least regularity (0: undercut)", summary.regularity, 1.0, "");
    return figures;
}

std::vector<std::string> mechanism_remarks(const Solution& solution) {
    std::vector<std::string> all = {mechanism_undercut_remark(solution), mechanism_limited_remark(solution)};
    if (const auto& check = solution.mechanism->forward_check)
        all.push_back(mechanism_check_remark(solution, *check));
    return all;
}

}  // namespace camopt
