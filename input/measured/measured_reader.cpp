// SPDX-License-Identifier: MIT
#include "input/measured/measured_reader.hpp"

#include "core/text/number_parsing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt::input {
namespace {

/// As written in the scene.
std::vector<double> numbers_of(const Given& given) {
    std::vector<double> numbers;
    for (const Node& item : given.value().items) numbers.push_back(item.as_number() * given.spelling->factor);
    return numbers;
}

void require_unit_of_lift(const SceneSource& source, const Place& place, const std::string& key,
                          const Spelling& unit, const MotionSpec& motion) {
    if (is_angle_unit(unit.unit) == motion.lift_is_angle) return;
    source.fail(place, key,
                fmt::format("found displacements in {} where the lift is {}; allowed: {}", unit.unit,
                            motion.lift_is_angle ? "an angle" : "a length",
                            motion.lift_is_angle ? "s_deg or s_rad" : "s_mm, s_in or s_m"));
}

std::vector<double> scaled(const std::vector<double>& numbers, double factor) {
    std::vector<double> all;
    for (const double number : numbers) all.push_back(number * factor);
    return all;
}

/// The row of "measured.theta[17]"; none of anything else.
std::optional<std::size_t> row_of(std::string_view member) {
    const std::size_t open = member.find('[');
    if (open == std::string_view::npos || !member.ends_with(']')) return std::nullopt;
    const auto row = integer_in(member.substr(open + 1, member.size() - open - 2));
    return row ? std::optional(static_cast<std::size_t>(*row)) : std::nullopt;
}

Node array_of(const std::vector<double>& numbers, const Place& place) {
    Node array;
    array.kind = NodeKind::array;
    array.place = place;
    for (const double number : numbers) {
        Node item;
        item.kind = NodeKind::number;
        item.number = number;
        item.place = place;
        array.items.push_back(std::move(item));
    }
    return array;
}

}  // namespace

std::optional<MeasuredInput> read_measured(const SceneSource& source, const MotionSpec& motion,
                                           const KnownNames& known) {
    const Node* const node = source.table("measured");
    if (!node) return std::nullopt;
    MeasuredInput input;
    if (const auto use = source.find("measured", "use")) input.motion.start = use->value().text == "start";
    const auto table = source.find("measured", "table");
    const auto theta = source.find("measured", "theta"), s = source.find("measured", "s");
    if (table) {
        if (!known.folder)
            source.fail(
                table->value().place, "measured.table",
                "found a file in a scene that is none itself; allowed: the numbers, theta_deg and s_mm, "
                "or a scene file that names its table");
        input.table = read_measured_table(*known.folder / table->value().text);
        require_unit_of_lift(source, table->value().place, "measured.table", input.table->s_unit, motion);
        input.motion.angle = scaled(input.table->theta, input.table->theta_unit.factor);
        input.motion.displacement = scaled(input.table->s, input.table->s_unit.factor);
        input.motion.name = std::filesystem::path(table->value().text).filename().string();
    } else {
        if (!theta || !s)
            source.fail(node->place,
                        theta ? "measured.s_mm"
                        : s   ? "measured.theta_deg"
                              : "measured.table",
                        "missing; allowed: table, or both theta_deg and s_mm");
        require_unit_of_lift(source, s->member->place, joined_key("measured", s->member->name), *s->spelling,
                             motion);
        input.motion.angle = numbers_of(*theta);
        input.motion.displacement = numbers_of(*s);
    }
    if (const auto name = source.find("measured", "name")) input.motion.name = name->value().text;
    return input;
}

void fail_in_table(const SceneSource& source, const MeasuredInput& measured, const SceneFault& fault) {
    if (!measured.table || !fault.member.starts_with("measured.")) return;
    const MeasuredTable& table = *measured.table;
    const std::optional<std::size_t> row = row_of(fault.member);
    const bool theta = fault.member.starts_with("measured.theta");
    const std::string line =
        row && *row < table.lines.size() ? fmt::format(":{}", table.lines[*row]) : std::string();
    const auto place = source.find("measured", "table");
    throw PlacedError(place->value().place,
                      fmt::format("{}{}: {}: found {}; allowed: {}", table.file, line,
                                  theta ? table.theta_key : table.s_key, fault.found, fault.allowed));
}

void write_out_tables(Node& root, const std::filesystem::path& folder) {
    Member* const measured = root.find("measured");
    if (!measured || measured->value.kind != NodeKind::table) return;
    std::vector<Member>& members = measured->value.members;
    const auto written =
        std::ranges::find_if(members, [](const Member& member) { return member.name == "table"; });
    if (written == members.end() || written->value.kind != NodeKind::text) return;
    const std::string file = written->value.text;
    const Place place = written->place;
    const MeasuredTable table = read_measured_table(folder / file);
    members.erase(written);
    if (!measured->value.find("name")) {
        Node name;
        name.kind = NodeKind::text;
        name.place = place;
        name.text = std::filesystem::path(file).filename().string();
        members.push_back({"name", place, std::move(name)});
    }
    members.push_back({table.theta_key, place, array_of(table.theta, place)});
    members.push_back({table.s_key, place, array_of(table.s, place)});
}

}  // namespace camopt::input
