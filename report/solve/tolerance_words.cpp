// SPDX-License-Identifier: MIT
#include "report/solve/tolerance_words.hpp"

#include "core/text/list_text.hpp"
#include "core/text/printable.hpp"
#include "core/text/quantity_text.hpp"
#include "report/view/cam_words.hpp"
#include "report/view/key_words.hpp"
#include "report/view/number_text.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double least_named = 5e-6;  // of the objective: less is practically nothing

std::string percent(double part) {
    return fmt::format("{:.3g} %", 100.0 * part);
}

/// "the profile error", "the tolerance of the base radius"
std::string words_of_tolerance(const std::string& key) {
    return "the " + key_words(key).words;
}

std::string price_sentence(const Solution& solution) {
    const double price = *solution.tolerance->price;
    const bool proved = solution.certificate.verdict == Verdict::optimal;
    const std::string doubt =
        proved ? ""
               : " Neither objective is proved to be the best, so that the price is one of two searches.";
    if (price < least_named)
        return fmt::format(
            "The tolerances cost practically nothing: without them the objective would be no "
            "better by more than {}.{}",
            percent(std::max(price, least_named)), doubt);
    return fmt::format(
        "The tolerances cost {} of the objective: without them it would be {:.7g} instead of {:.7g}.{}",
        percent(price), solution.certificate.objective / (1.0 + price), solution.certificate.objective,
        doubt);
}

std::vector<std::string> deciding_sentences(const ToleranceReport& report) {
    std::vector<std::string> all;
    for (const auto& [limit, tolerance] : report.decides) {
        all.push_back(fmt::format("Of the {} {} takes the largest part.", key_words(limit).subject(),
                                  words_of_tolerance(tolerance)));
    }
    return all;
}

/// Which cam, from its name in rows: "the slope error at its upper end and the tolerance of the base radius
/// at its lower end".
std::string words_of_cam(const std::string& cam) {
    constexpr std::pair<const char*, const char*> motions[] = {
        {"s''", "acceleration"}, {"s'", "slope"}, {"s", "profile"}};
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin < cam.size();) {
        const std::size_t end = std::min(cam.find_first_of(" ,", begin), cam.size());
        const std::size_t sign = cam.find_first_of("+-", begin);
        if (sign >= end) break;
        const std::string word = cam.substr(begin, sign - begin), size = cam.substr(sign + 1, end - sign - 1);
        const auto* const motion =
            std::ranges::find(motions, word, [](const auto& one) { return one.first; });
        const std::string name = motion != std::end(motions) ? std::string("the ") + motion->second + " error"
                                                             : words_of_tolerance("tolerance." + word);
        parts.push_back(fmt::format("{} at {}", name,
                                    size.empty() ? (cam[sign] == '+' ? "its upper end" : "its lower end")
                                                 : fmt::format("{}{} of it", cam[sign], size)));
        begin = std::min(cam.find_first_not_of(" ,", end), cam.size());
    }
    return listed(parts, " and ");
}

/// Of each limit the worst made cam: what it reaches, where, and which cam it is.
std::vector<std::string> worst_sentences(const Solution& solution) {
    std::vector<std::string> all;
    for (const ConstraintReport& row : solution.constraints) {
        if (!row.made || row.made_cam.empty()) continue;
        all.push_back(
            fmt::format("Worst case of the {}: {} at {} deg, with {}.", key_words(row.key).subject(),
                        short_text(*row.made) + (row.unit.empty() ? "" : " " + unit_words(row.unit)),
                        degrees_at(solution, row.made_at), words_of_cam(row.made_cam)));
    }
    return all;
}

/// Limits whose worst case between the ends of the tolerances is not enclosed.
std::string at_ends_sentence(const Solution& solution) {
    std::vector<std::string> names;
    if (solution.cam)
        for (const EnclosedLimit& one : solution.cam->limits_along)
            if (const std::string name = key_words(one.key).words;
                one.between && !one.complete && std::ranges::find(names, name) == names.end())
                names.push_back(name);
    if (names.empty()) return {};
    return fmt::format(
        "The limit{} on {} hold{} at the ends of the tolerances: what lies between them is not enclosed.",
        names.size() > 1 ? "s" : "", listed(names, " and "), names.size() > 1 ? "" : "s");
}

std::string halved_sentence(const ToleranceReport& report) {
    std::vector<std::string> parts;
    for (const auto& [tolerance, gain] : report.halved)
        parts.push_back(fmt::format("of {} {}", words_of_tolerance(tolerance),
                                    gain < least_named ? "practically nothing" : percent(gain)));
    if (parts.empty()) return {};
    return fmt::format("Half would bring: {}.", listed(parts, ", "));
}

std::string segments_sentence(const Solution& solution) {
    const int worth = *solution.tolerance->segments_worth, own = segments_of(solution.scene.spline);
    if (worth == own)
        return fmt::format(
            "All {} segments are worth making: with fewer more would be lost than the "
            "tolerances cost.",
            own);
    return fmt::format(
        "{} segments are worth making: up to the {} of this scene more gain less than the "
        "tolerances cost.",
        worth, own);
}

/// Limits that the error of s'' would move, if it were bounded.
std::string left_out_sentence(const Scene& scene) {
    if (scene.tolerance->motion[2]) return {};
    std::vector<std::string> names;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (row.order() == 2 && row.in(scene.limits)) names.emplace_back("acceleration");
    for (const LimitedFigure figure :
         {LimitedFigure::convex_radius, LimitedFigure::concave_radius, LimitedFigure::regularity,
          LimitedFigure::contact_force, LimitedFigure::contact_force_most, LimitedFigure::torque,
          LimitedFigure::hertz_pressure})
        if (const auto& limit = limit_on(scene.limits, figure)) names.push_back(key_words(limit->key).words);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    if (names.empty()) return {};
    return fmt::format(
        "The error of the second derivative is not bounded (tolerance.acceleration): the limit{} on {} "
        "leave{} it out.",
        names.size() > 1 ? "s" : "", listed(names, " and "), names.size() > 1 ? "" : "s");
}

}  // namespace

std::vector<std::string> tolerance_sentences(const Solution& solution) {
    if (!solution.tolerance) return {};
    const ToleranceReport& report = *solution.tolerance;
    std::vector<std::string> all = {
        "Every limit holds for all cams within the tolerances: of each the worst is the one that is given as "
        "made."};
    const auto add = [&](std::string sentence) {
        if (!sentence.empty()) all.push_back(std::move(sentence));
    };
    if (report.price) add(price_sentence(solution));
    for (std::string& one : deciding_sentences(report)) add(std::move(one));
    for (std::string& one : worst_sentences(solution)) add(std::move(one));
    add(halved_sentence(report));
    if (report.segments_worth) add(segments_sentence(solution));
    add(left_out_sentence(solution.scene));
    add(at_ends_sentence(solution));
    if (!report.open.empty())
        add(fmt::format("Not computed in the time there was: {}.", listed(report.open, " and ")));
    return all;
}

}  // namespace camopt
