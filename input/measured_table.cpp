// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/text/parsing.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "input/inspected_table.hpp"
#include "input/keys/key_spellings.hpp"
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

constexpr const char* inspected_columns =
    "theta_deg and s_mm of the follower, or x_mm and y_mm, or r_mm and theta_deg of the cam";
constexpr const char *angle_columns = "theta_deg, theta_rad or crank_deg",
                     *lift_columns = "s_mm, s_in, s_m, s_deg or s_rad";

class TableReader {
 public:
    TableReader(std::string_view text, const std::string& name, const TableForm& form)
        : text_(text), form_(form) {
        table_.file = name;
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
    }

    MeasuredTable read() {
        std::optional<std::string_view> first = next_line();
        if (!first)
            fail("no line at all", "a line that names the columns, theta_deg and s_mm, and rows of numbers");
        separator_ = form_.decimal == ',' ? ';' : ',';
        for (const char other : {';', '\t'})
            if (first->find(separator_) == std::string_view::npos &&
                first->find(other) != std::string_view::npos)
                separator_ = other;
        if (form_.points && separator_ != ',' && text_.find(',') != std::string_view::npos)
            form_.decimal = ',';
        const std::vector<std::string_view> cells = split_text(*first, separator_, cell_ends);
        const bool named =
            std::ranges::none_of(cells, [&](std::string_view cell) { return value(cell).has_value(); });
        find_columns(cells, named);
        if (named) first = next_line();
        for (; first; first = next_line()) add_row(*first);
        return std::move(table_);
    }

 private:
    std::string_view text_;
    TableForm form_;
    MeasuredTable table_;
    int line_ = 0;
    char separator_ = ',';
    std::size_t columns_ = 0;
    std::optional<Column> theta_;
    Column s_;
    double direction_ = 0.0;  ///< of the angles

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

    void find_columns(const std::vector<std::string_view>& cells, bool named) {
        std::vector<std::string_view> names = cells;
        if (!form_.columns.empty())
            names.assign(form_.columns.begin(), form_.columns.end());
        else if (!named && !form_.points)
            fail("numbers where the columns are named",
                 "a line such as theta_deg,s_mm, or columns = [\"theta_deg\", \"s_mm\"] in [measured]");
        columns_ = names.size();
        theta_ = column(names, "theta", spellings::cam_angle);
        for (std::size_t i = 0; i < names.size() && !theta_; ++i)
            if (names[i] == "crank_deg") theta_ = Column{i, "theta_crank_deg", spellings::cam_angle[2]};
        if (theta_ && form_.by_step)
            fail(fmt::format("the column {} together with measured.step", theta_->key), "one of the two");
        std::optional<Column> lift = column(names, "s", spellings::lift);
        if (form_.points && !(theta_ && lift)) find_points(names, lift);
        if (!theta_ && !form_.by_step) refuse_columns(names, angle_columns, ", or step_deg in [measured]");
        if (!lift) refuse_columns(names, lift_columns);
        s_ = *lift;
        if (theta_) {
            table_.theta_key = theta_->key;
            table_.theta_unit = theta_->unit;
        }
        table_.s_key = s_.key;
        table_.s_unit = s_.unit;
    }

    /// x in place of the angle and y, or r, in place of the displacement.
    void find_points(const std::vector<std::string_view>& names, std::optional<Column>& value) {
        const std::optional<Column> x = column(names, "x", spellings::length);
        value = column(names, x ? "y" : "r", spellings::length);
        if (x) theta_ = x;
        if (!theta_ || !value) refuse_columns(names, inspected_columns);
    }

    [[nodiscard]] static std::optional<Column> column(const std::vector<std::string_view>& names,
                                                      std::string_view name,
                                                      std::span<const Spelling> units) {
        for (std::size_t i = 0; i < names.size(); ++i)
            for (const Spelling& unit : units)
                if (const std::string key = fmt::format("{}{}", name, unit.suffix); names[i] == key)
                    return Column{i, key, unit};
        return std::nullopt;
    }

    [[noreturn]] void refuse_columns(const std::vector<std::string_view>& names, const char* allowed,
                                     const char* or_else = "") const {
        std::string list;
        for (const std::string_view name : names)
            list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", printable(name));
        fail(fmt::format("the columns {}", list),
             fmt::format("{}{}{}", form_.points ? "" : "one of them named ", allowed, or_else));
    }

    [[nodiscard]] std::optional<double> value(std::string_view cell) const {
        if (form_.decimal != ',') return number_in(cell);
        if (cell.find('.') != std::string_view::npos) return std::nullopt;
        std::string pointed(cell);
        std::ranges::replace(pointed, ',', '.');
        return number_in(pointed);
    }

    [[nodiscard]] double number(std::string_view cell, const Column& column) const {
        if (const std::optional<double> found = value(cell)) return *found;
        const bool other = cell.find(form_.decimal == ',' ? '.' : ',') != std::string_view::npos;
        fail(fmt::format("\"{}\" in the column {}", printable(cell), column.key),
             !other                 ? "a finite number"
             : form_.decimal == ',' ? "a finite number, written with a decimal comma"
                                    : "a finite number, written with a decimal point; with a comma where "
                                      "[measured] has decimal = \",\"");
    }

    void add_row(std::string_view line) {
        const std::vector<std::string_view> cells = split_text(line, separator_, cell_ends);
        if (cells.size() != columns_)
            fail(fmt::format("{} cells", cells.size()),
                 fmt::format("{}, as {} columns", columns_,
                             form_.columns.empty() ? "the first line names" : "measured.columns names"));
        const double s = number(cells[s_.index], s_);
        if (theta_ && !add_angle(number(cells[theta_->index], *theta_), s)) return;
        table_.s.push_back(s);
        table_.lines.push_back(line_);
    }

    /// False for a row that repeats the one before.
    [[nodiscard]] bool add_angle(double theta, double s) {
        if (!table_.theta.empty() && !theta_->key.starts_with('x')) {
            const double step = theta - table_.theta.back();
            const double change = std::abs(s - table_.s.back());
            if (step == 0.0 && change <= same_row * std::max(1.0, std::abs(s))) return false;
            if (direction_ == 0.0) direction_ = step;
            if (!(step * direction_ > 0.0))
                fail(fmt::format("{} = {} after {}", theta_->key, theta, table_.theta.back()),
                     "angles that ascend, or descend, all along the table");
        }
        table_.theta.push_back(theta);
        return true;
    }
};

}  // namespace

MeasuredTable measured_table_of(std::string_view text, const std::string& name, const TableForm& form) {
    return TableReader(text, name, form).read();
}

MeasuredTable read_measured_table(const std::filesystem::path& file, const TableForm& form) {
    const FileBytes read = file_bytes(file, most_table_bytes);
    if (!read.fault.empty())
        throw InputError(
            fmt::format("{}: cannot be read: {}; allowed: a CSV file with the columns theta_deg and s_mm",
                        printable(file.string()), read.fault));
    return measured_table_of(read.bytes, printable(file.string()), form);
}

InspectedTable inspected_table_of(std::string_view text, const std::string& name) {
    TableForm form;
    form.points = true;
    const MeasuredTable read = measured_table_of(text, name, form);
    if (read.s.size() < least_inspected)
        throw InputError(
            fmt::format("{}: found {} rows; allowed: at least {}", name, read.s.size(), least_inspected));
    const bool plane = read.theta_key.starts_with('x'), polar = read.s_key.starts_with('r');
    InspectedTable table{name, plane || polar, is_angle_unit(read.s_unit.unit), {}, read.lines};
    for (std::size_t i = 0; i < read.s.size(); ++i) {
        const double first = read.theta_unit.factor * read.theta[i], second = read.s_unit.factor * read.s[i];
        table.rows.emplace_back(polar ? second * std::cos(first) : first,
                                polar ? second * std::sin(first) : second);
    }
    return table;
}

InspectedTable read_inspected_table(const std::filesystem::path& file) {
    const std::string name = printable(file.string());
    const FileBytes read = file_bytes(file, most_table_bytes);
    if (read.fault.empty()) return inspected_table_of(read.bytes, name);
    throw InputError(fmt::format("{}: cannot be read: {}; allowed: a CSV file with the columns {}", name,
                                 read.fault, inspected_columns));
}

}  // namespace camopt::input
