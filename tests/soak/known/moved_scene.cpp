// SPDX-License-Identifier: MIT
#include "tests/soak/known/moved_scene.hpp"

#include "tests/soak/scenes/scene_text.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace camopt::soak {

namespace {

bool is_of_number(char letter) {
    return std::isdigit(static_cast<unsigned char>(letter)) != 0 || letter == '.' || letter == 'e' ||
           letter == '-' || letter == '+';
}

/// Numbers that must add up, or end where the motion ends.
bool stays(const SceneTable& table, const std::string& key, bool own_breakpoints) {
    if (table.name == "motion.segments") return key == "angle_deg";
    if (table.name == "spline") return key == "breakpoints";
    return own_breakpoints && (key == "rise_deg" || key == "return_deg");
}

std::string moved_text(Draw& draw, const std::string& toml, double by) {
    SceneText text = SceneText::parse(toml);
    const bool own_breakpoints =
        !text.list("spline", "breakpoints").empty() || text.word("motion", "symmetric", "") == "true";
    for (SceneTable& table : text.tables())
        for (auto& [key, value] : table.members)
            if (!stays(table, key, own_breakpoints)) value = moved_numbers(draw, value, by);
    return text.text();
}

void move_numbers(Draw& draw, KnownScene& scene, double by) {
    scene.text = moved_text(draw, scene.text, by);
    for (AxisFile& axis : scene.axes) axis.text = moved_text(draw, axis.text, by);
}

std::string with_zero_weights(const std::string& toml) {
    SceneText text = SceneText::parse(toml);
    SceneTable& objective = text.at("objective");
    for (const char* key : {"velocity", "acceleration", "jerk", "area", "rms_acceleration", "rms_jerk"})
        if (!objective.find(key)) objective.set(key, "0");
    return text.text();
}

void write_zero_weights(KnownScene& scene) {
    if (scene.axes.empty()) scene.text = with_zero_weights(scene.text);
    for (AxisFile& axis : scene.axes) axis.text = with_zero_weights(axis.text);
    scene.change = "weights of 0";
}

}  // namespace

std::string moved_numbers(Draw& draw, const std::string& value, double by) {
    if (value.starts_with('"')) return value;
    std::string moved;
    for (std::size_t k = 0; k < value.size();) {
        const bool begins =
            (std::isdigit(static_cast<unsigned char>(value[k])) != 0 || value[k] == '-') &&
            (k == 0 || (std::isalnum(static_cast<unsigned char>(value[k - 1])) == 0 && value[k - 1] != '_'));
        if (!begins) {
            moved += value[k++];
            continue;
        }
        std::size_t end = k;
        while (end < value.size() && is_of_number(value[end])) ++end;
        const std::string word = value.substr(k, end - k);
        k = end;
        const double number = std::strtod(word.c_str(), nullptr);
        if (number == 0.0 || word.find_first_of(".e") == std::string::npos) {  // a beginning, or a count
            moved += word;
            continue;
        }
        const double sign = draw.chance(0.5) ? 1.0 : -1.0;
        moved +=
            number_text(by > 0.0 ? number * (1.0 + sign * by)
                                 : std::nextafter(number, sign * std::numeric_limits<double>::infinity()));
    }
    return moved;
}

void move_scene(Draw& draw, KnownScene& scene) {
    if (draw.chance(0.15)) return write_zero_weights(scene);
    // A narrow corridor may have no width once it is moved, nor set points a distance.
    if (scene.change == "narrow corridors" || scene.change == "set points close together") return;
    if (!scene.change.empty() && draw.chance(0.5)) return;
    // 0: one unit in the last place.
    static const std::vector<double> moves = {0.0,   1e-15, 1e-14, 1e-13, 1e-12, 1e-11,
                                              1e-10, 1e-9,  1e-8,  1e-7,  1e-6};
    double by = draw.one_of(moves);
    // Beyond that the answer is not known to first order.
    KnownAnswer& answer = scene.answer;
    while (by * answer.condition > 1e-4) by *= 0.1;
    move_numbers(draw, scene, by);
    const double most = std::max(by, 3e-16);
    constexpr double margin = 10.0;  // several numbers of a row, each to the power of its order
    answer.below += margin * most * answer.condition * answer.objective;
    const bool known = answer.growth >= 0.0 && most * answer.growth < 1e-3 * answer.objective;
    answer.above =
        known ? answer.above + margin * most * answer.growth : std::numeric_limits<double>::infinity();
    scene.change += scene.change.empty() ? "" : ", ";
    scene.change += by > 0.0 ? fmt::format("numbers moved by {:.0e}", by) : "numbers moved by 1 ulp";
}

}  // namespace camopt::soak
