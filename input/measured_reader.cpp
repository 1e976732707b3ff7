// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/text/parsing.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "input/keys/key_spellings.hpp"
#include "input/scene_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

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

std::vector<double> scaled(std::vector<double> numbers, double factor) {
    for (double& number : numbers) number *= factor;
    return numbers;
}

/// The row of "measured.theta[17]"; nullopt for other members.
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

// A million rows of two numbers are smaller.
constexpr std::uintmax_t most_table_bytes = std::uintmax_t{1} << 26U;

// Around a cell: quotes too.
constexpr std::string_view cell_ends = " \t\r\"";

/// A column's place and unit.
struct Column {
    std::size_t index = 0;
    std::string key;
    Spelling unit;
};

class TableReader {
 public:
    TableReader(std::string_view text, const std::string& name) : text_(text) {
        table_.file = name;
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
    }

    MeasuredTable read() {
        const std::optional<std::string_view> header = next_line();
        if (!header)
            fail("no line at all", "a line that names the columns, theta_deg and s_mm, and rows of numbers");
        separator_ = ',';
        for (const char other : {';', '\t'})
            if (header->find(',') == std::string_view::npos && header->find(other) != std::string_view::npos)
                separator_ = other;
        const std::vector<std::string_view> names = split_text(*header, separator_, cell_ends);
        theta_ = column(names, "theta", spellings::angle, "theta_deg or theta_rad");
        s_ = column(names, "s", spellings::lift, "s_mm, s_in, s_m, s_deg or s_rad");
        columns_ = names.size();
        while (const std::optional<std::string_view> line = next_line()) add_row(*line);
        table_.theta_key = theta_.key;
        table_.s_key = s_.key;
        table_.theta_unit = theta_.unit;
        table_.s_unit = s_.unit;
        return std::move(table_);
    }

 private:
    std::string_view text_;
    MeasuredTable table_;
    int line_ = 0;
    char separator_ = ',';
    std::size_t columns_ = 0;
    Column theta_, s_;

    [[noreturn]] void fail(const std::string& found, const std::string& allowed) const {
        throw InputError(
            fmt::format("{}:{}: found {}; allowed: {}", table_.file, std::max(line_, 1), found, allowed));
    }

    /// The next line with content.
    std::optional<std::string_view> next_line() {
        while (!text_.empty()) {
            const std::size_t end = text_.find('\n');
            const std::string_view line = text_.substr(0, end);
            text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
            ++line_;
            const std::string_view said = trimmed(line, cell_ends);
            if (!said.empty() && !said.starts_with('#')) return line;
        }
        return std::nullopt;
    }

    [[nodiscard]] Column column(const std::vector<std::string_view>& names, std::string_view name,
                                std::span<const Spelling> units, const char* allowed) const {
        std::optional<Column> found;
        for (std::size_t i = 0; i < names.size(); ++i)
            for (const Spelling& unit : units) {
                const std::string key = fmt::format("{}{}", name, unit.suffix);
                if (names[i] != key) continue;
                if (found)
                    fail(fmt::format("two columns, {} and {}", found->key, key),
                         fmt::format("one of {}", allowed));
                found = Column{i, key, unit};
            }
        if (found) return *found;
        std::string list;
        for (const std::string_view other : names)
            list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", printable(other));
        fail(fmt::format("the columns {}", list), fmt::format("one of them named {}", allowed));
    }

    [[nodiscard]] double number(std::string_view cell, const Column& column) const {
        const std::optional<double> value = number_in(cell.starts_with('+') ? cell.substr(1) : cell);
        if (value && std::isfinite(*value)) return *value;
        const bool comma = cell.find(',') != std::string_view::npos;
        fail(fmt::format("\"{}\" in the column {}", printable(cell), column.key),
             fmt::format("a finite number{}", comma ? ", written with a decimal point" : ""));
    }

    void add_row(std::string_view line) {
        const std::vector<std::string_view> cells = split_text(line, separator_, cell_ends);
        if (cells.size() != columns_)
            fail(fmt::format("{} cells", cells.size()),
                 fmt::format("{}, as the first line names columns", columns_));
        const double theta = number(cells[theta_.index], theta_), s = number(cells[s_.index], s_);
        if (!table_.theta.empty() && !(theta > table_.theta.back()))
            fail(fmt::format("{} = {} after {}", theta_.key, theta, table_.theta.back()), "ascending angles");
        table_.theta.push_back(theta);
        table_.s.push_back(s);
        table_.lines.push_back(line_);
    }
};

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
            source.fail(table->value().place, "measured.table",
                        "found a file name in a scene that was not read from a file; allowed: the numbers, "
                        "theta_deg and s_mm, "
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

MeasuredTable measured_table_of(std::string_view text, const std::string& name) {
    return TableReader(text, name).read();
}

MeasuredTable read_measured_table(const std::filesystem::path& file) {
    const FileBytes read = file_bytes(file, most_table_bytes);
    if (!read.fault.empty())
        throw InputError(
            fmt::format("{}: cannot be read: {}; allowed: a CSV file with the columns theta_deg and s_mm",
                        printable(file.string()), read.fault));
    return measured_table_of(read.bytes, printable(file.string()));
}

}  // namespace camopt::input
