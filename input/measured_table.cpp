// SPDX-License-Identifier: MIT
#include "core/text/parsing.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "input/inspected_table.hpp"
#include "input/keys/scene_keys.hpp"
#include "input/scene_parts.hpp"

#include <fmt/format.h>

namespace camopt::input {

namespace {

// A million rows of two numbers are smaller.
constexpr std::uintmax_t most_table_bytes = std::uintmax_t{1} << 26U;

// Of a displacement as written: the two sides of a joint round differently.
constexpr double same_row = 1e-9;

// Around a cell: quotes too.
constexpr std::string_view cell_ends = " \t\r\"";

/// A column's place and unit.
struct Column {
    std::size_t index = 0;
    std::string key;
    Spelling unit;
};

constexpr std::size_t least_inspected = 8;  // rows: twice the parameters of an alignment

constexpr int most_head_lines = 200;  // of other text above the rows

using Cells = std::vector<std::string_view>;

/// Columns have the names of the keys of [measured].
std::optional<Column> column_in(const Cells& names, std::string_view quantity) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const KeyMatch match = match_key("measured", names[i]);
            match.row != nullptr && match.row->name == quantity)
            return Column{i, std::string(names[i]), *match.spelling};
    return std::nullopt;
}

/// Crank angles as camopt writes them.
constexpr std::string_view crank_column = unit_named<"crank deg">.suffix.substr(1);

/// Every name of the column of a quantity.
std::string columns_of(std::string_view quantity) {
    std::vector<KeyNames> names = {find_row("measured", quantity)->names()};
    if (quantity == "theta") names.push_back({crank_column, spellings::plain});
    return keys_text(names, [](const Spelling&) { return true; });
}

/// "theta_deg and s_mm"
std::string two_columns(const char* first, const char* second) {
    return fmt::format("{} and {}", measured_key(first), measured_key(second));
}

std::string inspected_columns() {
    return fmt::format("{} of the follower, or {}, or {} of the cam", two_columns("theta", "s"),
                       two_columns("x", "y"), two_columns("r", "theta"));
}

/// Of a file that does not name its columns.
std::string in_measured() {
    return fmt::format(R"(or columns = ["{}", "{}"] in [measured])", measured_key("theta"),
                       measured_key("s"));
}

/// The angle and the displacement; of points x and y, or the angle and r.
struct Columns {
    std::optional<Column> theta, s;

    Columns() = default;
    Columns(const Cells& names, const TableForm& form)
        : theta(column_in(names, "theta")), s(column_in(names, "s")) {
        for (std::size_t i = 0; i < names.size() && !theta; ++i)
            if (names[i] == crank_column)
                theta = Column{i, fmt::format("theta_{}", crank_column), unit_named<"crank deg">};
        if (!form.points || (s && (theta || form.by_step))) return;
        const std::optional<Column> x = column_in(names, "x");
        std::optional<Column> value = column_in(names, x ? "y" : "r");
        if (!value && !x && theta) value = column_in(names, "z");
        if (!value) return;
        s = value;
        if (x) theta = x;
    }
    [[nodiscard]] bool complete(const TableForm& form) const { return s && (theta || form.by_step); }
};

class TableReader {
 public:
    TableReader(std::string_view text, const std::string& name, const TableForm& form)
        : text_(text), form_(form) {
        table_.file = name;
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
    }

    MeasuredTable read() {
        while (line_ < form_.skipped && !text_.empty()) take_line();
        if (!find_head()) start_at_first_line();
        for (std::optional<std::string_view> line = next_line(); line; line = next_line()) add_line(*line);
        return std::move(table_);
    }

 private:
    std::string_view text_;
    TableForm form_;
    MeasuredTable table_;
    int line_ = 0;
    char separator_ = ',';
    std::size_t columns_ = 0;
    Columns of_;
    double direction_ = 0.0, turns_ = 0.0;                    ///< of the angles
    std::optional<std::pair<int, std::string_view>> no_row_;  ///< below the rows: its number, text

    [[noreturn]] void fail(const std::string& found, const std::string& allowed) const {
        throw InputError(
            fmt::format("{}:{}: found {}; allowed: {}", table_.file, std::max(line_, 1), found, allowed));
    }

    std::string_view take_line() {
        const std::size_t end = text_.find('\n');
        const std::string_view line = text_.substr(0, end);
        text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
        ++line_;
        return line;
    }

    /// The next line with content.
    std::optional<std::string_view> next_line() {
        while (!text_.empty()) {
            const std::string_view line = take_line();
            const std::string_view said = trimmed(line, cell_ends);
            if (!said.empty() && !said.starts_with('#') && !said.starts_with('!') && !said.starts_with('%') &&
                !said.starts_with("//"))
                return without_comment(line);
        }
        return std::nullopt;
    }

    /// What follows the numbers of a row after # is no cell; in a line of names # may be part of one.
    static std::string_view without_comment(std::string_view line) {
        const std::size_t sign = line.find('#');
        const std::string_view said = trimmed(line, cell_ends);
        const bool row = std::string_view("+-.0123456789").find(said.front()) != std::string_view::npos;
        return row && sign != std::string_view::npos ? trimmed(line.substr(0, sign), cell_ends) : line;
    }

    /// Between blanks if the separator is one.
    [[nodiscard]] Cells cells_of(std::string_view line) const {
        Cells cells = split_text(line, separator_, cell_ends);
        if (separator_ == ' ') std::erase(cells, std::string_view());
        while (cells.size() > std::max<std::size_t>(columns_, 1) && cells.back().empty()) cells.pop_back();
        return cells;
    }

    /// The line that names the columns, or with measured.columns what precedes the first row, below lines of
    /// other text. False, at the beginning of the text: there is none.
    bool find_head() {
        const std::string_view text = text_;
        const int line_before = line_;
        if (!form_.columns.empty()) take_columns(Cells(form_.columns.begin(), form_.columns.end()));
        for (int tried = 0; tried < most_head_lines; ++tried) {
            const auto before = std::pair(text_, line_);
            const std::optional<std::string_view> line = next_line();
            if (!line) break;
            for (const char separator : {',', ';', '\t', ' '}) {
                if (separator == form_.decimal) continue;
                separator_ = separator;
                const Cells cells = cells_of(*line);
                if (form_.columns.empty() ? !Columns(cells, form_).complete(form_) : !is_row(cells)) continue;
                if (form_.any_decimal && separator != ',' && text_.find(',') != std::string_view::npos)
                    form_.decimal = ',';
                if (form_.columns.empty())
                    take_columns(cells);
                else
                    std::tie(text_, line_) = before;
                return true;
            }
        }
        text_ = text;
        line_ = line_before;
        return false;
    }

    /// As many cells as columns, and a number where one is read.
    [[nodiscard]] bool is_row(const Cells& cells) const {
        return cells.size() == columns_ &&
               (value(cells[of_.s->index]) || (of_.theta && value(cells[of_.theta->index])));
    }

    /// What the first line has in place of the names is refused; of measured.columns the rows follow.
    void start_at_first_line() {
        const auto before = std::pair(text_, line_);
        const std::optional<std::string_view> first = next_line();
        if (!first)
            fail("no line at all", fmt::format("a line that names the columns, {}, and rows of numbers",
                                               two_columns("theta", "s")));
        separator_ = form_.decimal == ',' ? ';' : ',';
        for (const char other : {';', '\t'})
            if (first->find(separator_) == std::string_view::npos &&
                first->find(other) != std::string_view::npos)
                separator_ = other;
        const Cells cells = cells_of(*first);
        const bool named = std::ranges::none_of(cells, [&](auto cell) { return value(cell).has_value(); });
        if (form_.columns.empty() && !named && !form_.any_decimal)
            fail("numbers where the columns are named",
                 fmt::format("a line such as {},{}, {}", measured_key("theta"), measured_key("s"),
                             in_measured()));
        if (form_.columns.empty()) take_columns(cells);
        if (!named) std::tie(text_, line_) = before;
    }

    void take_columns(const Cells& names) {
        columns_ = names.size();
        of_ = Columns(names, form_);
        for (const auto& [name, numbers] : {std::pair{"scale", &form_.scale}, {"offset", &form_.offset}})
            if (!numbers->empty() && numbers->size() != columns_)
                fail(fmt::format("{} columns with {} numbers in {}{}", columns_, numbers->size(),
                                 form_.any_decimal ? "--" : "measured.", name),
                     "one number for each column");
        if (of_.theta && form_.by_step)
            fail(fmt::format("the column {} together with measured.step", of_.theta->key), "one of the two");
        if (form_.any_decimal && !of_.complete(form_)) refuse_columns(names, inspected_columns());
        if (!of_.theta && !form_.by_step)
            refuse_columns(
                names, fmt::format("one of them named {}, or {} in [measured], {}, in the order of the file",
                                   columns_of("theta"), measured_key("step"), in_measured()));
        if (!of_.s)
            refuse_columns(
                names, fmt::format("one of them named {}{}, {}, in the order of the file", columns_of("s"),
                                   form_.points ? fmt::format(", or {}, or {} or {}, of the cam",
                                                              two_columns("x", "y"), measured_key("r"),
                                                              measured_key("z"))
                                                : "",
                                   in_measured()));
        if (of_.theta) {
            table_.theta_key = of_.theta->key;
            table_.theta_unit = of_.theta->unit;
        }
        table_.s_key = of_.s->key;
        table_.s_unit = of_.s->unit;
    }

    /// Of a file that may be no table at all no text is repeated: a scene of others can name any file.
    [[noreturn]] void refuse_columns(const Cells& names, const std::string& allowed) const {
        std::string known;
        for (const auto* const column : {&of_.theta, &of_.s})
            if (*column) known += fmt::format(", of these only {}", (*column)->key);
        fail(fmt::format("{} columns{}", names.size(), known.empty() ? ", none of these" : known), allowed);
    }

    /// A letter before the number names its axis: X12.5.
    [[nodiscard]] std::optional<double> value(std::string_view cell) const {
        const bool letter =
            cell.size() > 1 && ((cell[0] >= 'A' && cell[0] <= 'Z') || (cell[0] >= 'a' && cell[0] <= 'z'));
        if (letter) cell.remove_prefix(1);
        if (form_.decimal != ',') return number_in(cell);
        if (cell.find('.') != std::string_view::npos) return std::nullopt;
        std::string pointed(cell);
        std::ranges::replace(pointed, ',', '.');
        return number_in(pointed);
    }

    [[nodiscard]] double number(std::string_view cell, const Column& column) const {
        if (const std::optional<double> found = value(cell))
            return (form_.offset.empty() ? 0.0 : form_.offset[column.index]) +
                   (form_.scale.empty() ? 1.0 : form_.scale[column.index]) * *found;
        const bool other = cell.find(form_.decimal == ',' ? '.' : ',') != std::string_view::npos;
        // Columns that the scene names, and no row yet: it may be no table (refuse_columns).
        const bool is_table = form_.columns.empty() || !table_.s.empty() ||
                              cell.find_first_not_of("0123456789.,+-") == std::string_view::npos;
        fail(fmt::format("{} in the column {}",
                         is_table ? fmt::format("\"{}\"", printable(cell)) : std::string("no number"),
                         column.key),
             !other                 ? "a finite number, or # before the line"
             : form_.decimal == ',' ? "a finite number, written with a decimal comma"
                                    : "a finite number, written with a decimal point; with a comma where "
                                      "[measured] has decimal = \",\"");
    }

    /// Lines without any number: units below the names, and what follows the last row.
    void add_line(std::string_view line) {
        const Cells cells = cells_of(line);
        if (std::ranges::none_of(cells, [&](std::string_view cell) { return value(cell).has_value(); })) {
            if (!table_.s.empty() && !no_row_) no_row_ = {line_, line};
            if (!table_.s.empty() || form_.columns.empty()) return;
        }
        if (no_row_) {
            line_ = no_row_->first;
            add_row(cells_of(no_row_->second));
        }
        add_row(cells);
    }

    void add_row(const Cells& cells) {
        if (cells.size() != columns_)
            fail(fmt::format("{} cells", cells.size()),
                 fmt::format("{}, as {} columns, or # before a line that is no row", columns_,
                             form_.columns.empty() ? "the first line names" : "measured.columns names"));
        const double s = number(cells[of_.s->index], *of_.s);
        if (of_.theta && !add_angle(number(cells[of_.theta->index], *of_.theta), s)) return;
        table_.s.push_back(s);
        table_.lines.push_back(line_);
    }

    /// False for a row that repeats the one before. From the end of the revolution to its begin once.
    [[nodiscard]] bool add_angle(double theta, double s) {
        const std::string& key = of_.theta->key;
        if (!table_.theta.empty() && !key.starts_with('x')) {
            const double turn = units::turn / (of_.theta->unit.factor * (form_.crank ? 0.5 : 1.0));
            theta += turns_ * turn;
            double step = theta - table_.theta.back();
            const double change = std::abs(s - table_.s.back());
            if (step == 0.0 && change <= same_row * std::max(1.0, std::abs(s))) return false;
            if (turns_ == 0.0 && step * direction_ < 0.0 && std::abs(step) > 0.5 * turn) {
                turns_ = direction_ > 0.0 ? 1.0 : -1.0;
                theta += turns_ * turn;
                step += turns_ * turn;
            }
            if (direction_ == 0.0) direction_ = step;
            if (!(step * direction_ > 0.0))
                fail(fmt::format("{} = {} after {}", key, theta, table_.theta.back()),
                     "angles that ascend, or descend, all along the table");
        }
        table_.theta.push_back(theta);
        return true;
    }
};

}  // namespace

std::string measured_key(std::string_view name) {
    return find_row("measured", name)->first_key();
}

MeasuredTable measured_table_of(std::string_view text, const std::string& name, const TableForm& form) {
    return TableReader(text, name, form).read();
}

MeasuredTable read_measured_table(const std::filesystem::path& file, const TableForm& form) {
    const FileBytes read = file_bytes(file, most_table_bytes);
    if (!read.fault.empty())
        throw InputError(fmt::format("{}: cannot be read: {}; allowed: a CSV file with the columns {}",
                                     printable(file.string()), read.fault, two_columns("theta", "s")));
    return measured_table_of(read.bytes, printable(file.string()), form);
}

std::vector<Eigen::Vector2d> points_of(const MeasuredTable& table) {
    const bool polar = table.is_polar();
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i < table.s.size(); ++i) {
        const double first = table.theta_unit.factor * table.theta[i],
                     second = table.s_unit.factor * table.s[i];
        points.emplace_back(polar ? second * std::cos(first) : first,
                            polar ? second * std::sin(first) : second);
    }
    return points;
}

InspectedTable inspected_table_of(std::string_view text, const std::string& name,
                                  const InspectedForm& given) {
    TableForm form;
    form.columns = given.columns;
    form.scale = given.scale;
    form.offset = given.offset;
    form.points = form.any_decimal = true;
    const MeasuredTable read = measured_table_of(text, name, form);
    if (read.s.size() < least_inspected)
        throw InputError(
            fmt::format("{}: found {} rows; allowed: at least {}", name, read.s.size(), least_inspected));
    return {name, read.is_points(), is_angle_unit(read.s_unit.unit), points_of(read), read.lines};
}

InspectedTable read_inspected_table(const std::filesystem::path& file, const InspectedForm& form) {
    const std::string name = printable(file.string());
    const FileBytes read = file_bytes(file, most_table_bytes);
    if (read.fault.empty()) return inspected_table_of(read.bytes, name, form);
    throw InputError(fmt::format("{}: cannot be read: {}; allowed: a CSV file with the columns {}", name,
                                 read.fault, inspected_columns()));
}

}  // namespace camopt::input
