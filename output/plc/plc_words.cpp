// SPDX-License-Identifier: MIT
#include "output/plc/plc_words.hpp"

#include "core/version.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace camopt {

namespace {

using nlohmann::ordered_json;

constexpr std::array<const char*, 4> loss_symbols = {"s", "v", "a", "j"};
constexpr int loss_digits = 3;

/// Of a loss by the degree in the units people read.
struct ShownLoss {
    double value = 0.0;
    std::string unit;
};

ShownLoss shown_loss(const Solution& solution, const MasterCurve& curve, std::size_t order,
                     double per_degree) {
    const MotionUnit unit = shown_units(solution.scene).motion[order].first;
    const double normalised =
        per_degree / curve.lift() * std::pow(curve.degrees_per_x(), static_cast<int>(order));
    return {figure_not_exceeded(std::abs(unit.per_normalised) * normalised), unit.name};
}

/// One line of ASCII, whatever the title holds: an editor of a controller may know no other letters.
std::string plain_line(const std::string& text) {
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view rest = std::string_view(text).substr(i);
        const auto byte = static_cast<unsigned char>(text[i]);
        constexpr unsigned char ascii = 0x80, first_of_letter = 0xC0;
        if (rest.starts_with("²"))
            line += "^2";
        else if (rest.starts_with("³"))
            line += "^3";
        else if (byte < ascii)
            line += byte < ' ' ? ' ' : text[i];
        else if (byte >= first_of_letter)
            line += '?';
    }
    return line;
}

std::string degrees_text(double value) {
    return short_text(value, 6) + " deg";
}

std::string range_words(const MasterCurve& curve) {
    const double ends = curve.at(curve.end(), Side::left)[0];
    std::string text = fmt::format("master 0 to {}, lift {} {}; ", degrees_text(curve.end()),
                                   short_text(curve.lift(), 6), curve.slave_unit());
    if (curve.closes()) return text + "the cam closes";
    return text + fmt::format(
                      "the cam does not close: it ends {} {} from where it began, run it once or with "
                      "relative slave positions",
                      short_text(ends - curve.at(0.0, Side::right)[0], 6), curve.slave_unit());
}

std::string count_words(const PlcResult& result) {
    const PlcFormat& format = *result.format;
    std::string text = fmt::format("{} {}", result.count, format.element);
    if (format.limit) text += fmt::format(" of the {} that {} holds", *format.limit, format.limit_words);
    if (!format.limit_note.empty()) text += fmt::format(" ({})", format.limit_note);
    return text + fmt::format(", {}, {}", format.rule, format.numbers);
}

std::string loss_words(const Solution& solution, const MasterCurve& curve, const PlcResult& result) {
    std::string text = result.lossless ? "lossless" : "lossy";
    for (std::size_t r = 0; r < result.loss.size(); ++r) {
        text += r == 0 ? ": " : ", ";
        if (!result.loss[r]) {
            text += fmt::format("{} undefined", loss_symbols[r]);
            continue;
        }
        const ShownLoss shown = shown_loss(solution, curve, r, result.loss[r]->value);
        text += fmt::format("{} {} {}", loss_symbols[r], short_text(shown.value, loss_digits), shown.unit);
        if (!result.lossless)
            text += fmt::format(" ({} of its peak, at {})", short_text(result.of_peak[r], 2),
                                degrees_text(result.loss[r]->at));
    }
    return text;
}

std::string unit_words(const MasterCurve& curve, const PlcResult& result) {
    return fmt::format("units: master {} deg, slave {} {}", short_text(result.units.master, 6),
                       short_text(result.units.slave, 6), curve.slave_unit());
}

std::string drift_words(const MasterCurve& curve, const PlcResult& result) {
    return fmt::format("the period of the slave is rounded to whole units: {} {} are added each turn",
                       short_text(result.drift_per_turn, loss_digits), curve.slave_unit());
}

bool drifts(const MasterCurve& curve, const PlcResult& result) {
    constexpr double no_drift = 1e-12;  // of the lift
    return std::abs(result.drift_per_turn) > no_drift * curve.lift();
}

ordered_json loss_json(const Solution& solution, const MasterCurve& curve, const PlcResult& result) {
    ordered_json rows = ordered_json::array();
    for (std::size_t r = 0; r < result.loss.size(); ++r) {
        ordered_json row{{"quantity", loss_symbols[r]}};
        if (result.loss[r]) {
            const ShownLoss shown = shown_loss(solution, curve, r, result.loss[r]->value);
            row.update({{"per_degree", result.loss[r]->value},
                        {"shown", shown.value},
                        {"unit", shown.unit},
                        {"at_deg", result.loss[r]->at},
                        {"of_peak", result.of_peak[r]}});
        } else {
            row.update({{"per_degree", nullptr},
                        {"shown", nullptr},
                        {"unit", nullptr},
                        {"at_deg", nullptr},
                        {"of_peak", nullptr}});
        }
        rows.push_back(row);
    }
    return rows;
}

ordered_json format_json(const Solution& solution, const MasterCurve& curve, const PlcResult& result) {
    const PlcFormat& format = *result.format;
    ordered_json json{{"format", format.key},
                      {"file", format.file},
                      {"text_file", nullptr},
                      {"controller", format.controller},
                      {"rule", format.rule},
                      {"numbers", format.numbers},
                      {"element", format.element},
                      {"count", result.count},
                      {"limit", nullptr},
                      {"degree", format.degree},
                      {"units", {{"master_deg", result.units.master}, {"slave", result.units.slave}}},
                      {"slave_at_start", result.slave_at_start},
                      {"verdict", result.lossless ? "lossless" : "lossy"},
                      {"drift_per_turn", result.drift_per_turn},
                      {"loss", loss_json(solution, curve, result)}};
    if (!format.text_file.empty()) json["text_file"] = format.text_file;
    if (format.limit) json["limit"] = *format.limit;
    return json;
}

}  // namespace

std::vector<std::string> plc_header(const Solution& solution, const MasterCurve& curve,
                                    const PlcResult& result) {
    std::vector<std::string> lines;
    lines.push_back(fmt::format("camopt {}: {}", version(), result.format->controller));
    if (!solution.scene.title.empty()) lines.push_back(solution.scene.title);
    lines.push_back(range_words(curve));
    lines.push_back(unit_words(curve, result));
    lines.push_back(count_words(result));
    lines.push_back("read back and evaluated so, the whole turn, " + loss_words(solution, curve, result));
    if (result.slave_at_start != 0.0)
        lines.push_back(fmt::format("slave positions count from the start, which is {} {}",
                                    short_text(result.slave_at_start, 9), curve.slave_unit()));
    if (drifts(curve, result)) lines.push_back(drift_words(curve, result));
    for (std::string& line : lines) line = plain_line(line);
    return lines;
}

std::string plc_text(const Solution& solution, const MasterCurve& curve,
                     const std::vector<PlcResult>& results) {
    std::string text = fmt::format("\nElectronic cam: {}\n", range_words(curve));
    for (const PlcResult& result : results) {
        const PlcFormat& format = *result.format;
        text += fmt::format("  {}{}{}: {}\n    {}\n", format.file, format.text_file.empty() ? "" : ", ",
                            format.text_file, count_words(result), loss_words(solution, curve, result));
        if (drifts(curve, result)) text += fmt::format("    {}\n", drift_words(curve, result));
    }
    return text;
}

std::string plc_json(const Solution& solution, const MasterCurve& curve,
                     const std::vector<PlcResult>& results) {
    ordered_json json{{"camopt", version()},
                      {"scene", solution.scene.title},
                      {"master", {{"unit", "deg"}, {"end", curve.end()}}},
                      {"slave",
                       {{"unit", curve.slave_unit()},
                        {"lift", curve.lift()},
                        {"travel", curve.travel()},
                        {"closes", curve.closes()}}},
                      {"formats", ordered_json::array()}};
    for (const PlcResult& result : results) json["formats"].push_back(format_json(solution, curve, result));
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace camopt
