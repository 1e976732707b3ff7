// SPDX-License-Identifier: MIT
// Where the classical laws lie above the trade-off, as lines of the picture.
#include "output/chart/placed_texts.hpp"
#include "output/chart/sweep/sweep_panels.hpp"
#include "output/words/number_text.hpp"
#include "output/words/tables/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

constexpr double line_height = 21, head_height = 54;
constexpr double bar_left = 582, bar_width = 120, bar_number = 60;

/// "−29.6 %": what the best motion saves of the law's peak.
std::string saving_words(const LawLoss& law, std::size_t peak) {
    if (!law.least[peak]) return "–";
    return change_text(*law.least[peak], law.peaks[peak]);
}

std::string percent_words(const std::optional<double>& percent) {
    return percent ? change_text(100.0 + *percent, 100.0) : "–";
}

/// Before the column of V; long names are set smaller.
void draw_name(SvgCanvas& canvas, double left, double y, const LawLoss& law) {
    constexpr double room = 232.0, size = 12.0;
    const std::string name = law.title + (law.feasible ? "" : " *");
    canvas.text(left, y, name,
                fmt::format("value{}{}", law.feasible ? "" : " faint",
                            text_width(name, size) > room ? " tight" : ""));
}

void draw_heads(SvgCanvas& canvas, double left, double top, bool all_feasible) {
    canvas.text(left, top, "Laws above the trade-off", "panel-title");
    const double y = top + 36;
    canvas.text(left + 26, y, all_feasible ? "law" : "law (* breaks a limit)", "head left");
    for (const auto& [x, words] : {std::pair{304.0, "V"}, {364.0, "A"}, {430.0, "J"}})
        canvas.text(left + x, y, words, "head");
    canvas.text(left + 552, y - 15, "loss at the", "head");
    canvas.text(left + 552, y, "scene’s weights", "head");
    canvas.text(left + bar_left, y - 15, "least loss", "head left");
    canvas.text(left + bar_left, y, "over all weights", "head left");
    canvas.text(left + 895, y - 15, "at the weights", "head");
    canvas.text(left + 895, y, "V / A / J", "head");
    canvas.text(left + 1130, y - 15, "one peak alone can fall by", "head");
    for (const auto& [x, words] : {std::pair{990.0, "V"}, {1060.0, "A"}, {1130.0, "J"}})
        canvas.text(left + x, y, words, "head");
}

void draw_least_loss(SvgCanvas& canvas, double left, double y, const LawLoss& law, double longest) {
    if (!law.closest) {
        canvas.text(left + bar_left + bar_number, y, "–", "value right");
        return;
    }
    const double loss = law.closest->loss_percent;
    canvas.text(left + bar_left + bar_number, y, percent_words(loss), "value right");
    const double width = longest > 0.0 ? bar_width * std::max(loss, 0.0) / longest : 0.0;
    canvas.rectangle(left + bar_left + bar_number + 8, y - 10, width, 12, "law-bar");
    const PeakTriple& w = law.closest->weights;
    canvas.text(left + 895, y, fmt::format("{:.2f} / {:.2f} / {:.2f}", w[0], w[1], w[2]), "value right");
}

}  // namespace

double law_table_height(const LawLosses& losses) {
    return head_height + line_height * static_cast<double>(losses.laws.size());
}

double draw_law_table(SvgCanvas& canvas, double left, double top, const LawLosses& losses) {
    draw_heads(canvas, left, top, std::ranges::all_of(losses.laws, &LawLoss::feasible));
    double longest = 0.0;
    for (const LawLoss& law : losses.laws)
        if (law.closest) longest = std::max(longest, law.closest->loss_percent);
    double y = top + head_height + 6;
    for (std::size_t i = 0; i < losses.laws.size(); ++i) {
        const LawLoss& law = losses.laws[i];
        canvas.text(left, y, std::to_string(i + 1), "value");
        draw_name(canvas, left + 26, y, law);
        canvas.text(left + 304, y, fixed_text(law.peaks[0], 3), "value right");
        canvas.text(left + 364, y, fixed_text(law.peaks[1], 3), "value right");
        canvas.text(left + 430, y, fixed_text(law.peaks[2], 2), "value right");
        canvas.text(left + 552, y, percent_words(law.loss_percent), "value right");
        draw_least_loss(canvas, left, y, law, longest);
        for (std::size_t peak = 0; peak < 3; ++peak)
            canvas.text(left + 990 + 70.0 * static_cast<double>(peak), y, saving_words(law, peak),
                        "value right");
        y += line_height;
    }
    return law_table_height(losses);
}

}  // namespace camopt
