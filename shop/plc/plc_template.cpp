// SPDX-License-Identifier: MIT
#include "shop/plc/plc_template.hpp"

#include "core/text/parsing.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace camopt {

namespace {

constexpr std::string_view header_mark = "{header}";

struct Template {
    std::array<std::vector<std::string_view>, 3> parts;  ///< lines before, in and after what is repeated
    bool points = false;                                 ///< that is of a point, else of a piece
    std::string_view comment;                            ///< "//", where the file has a header

    explicit Template(std::string_view text) {
        std::size_t part = 0;
        if (text.ends_with('\n')) text.remove_suffix(1);
        for (const std::string_view line : split_text(text, '\n', "")) {
            const bool each_point = line == "{each point}";
            if (line.ends_with(header_mark)) {
                const std::string_view sign = line.substr(0, line.size() - header_mark.size() - 1);
                comment = sign.substr(sign.rfind(' ') + 1);
            }
            if (each_point || line == "{each piece}" || line == "{end}")
                ++part;
            else
                parts.at(part).push_back(line);
            points |= each_point;
        }
        if (part != 2) throw ModelError("a template without {each point} or {each piece}, and {end}");
    }

    [[nodiscard]] std::string_view code_of(std::string_view line) const {
        return trimmed(comment.empty() ? line : line.substr(0, line.find(comment)));
    }

    /// Calls act(line, index of the element or −1) for each line of a file.
    template <class Act>
    void each_line(int elements, const Act& act) const {
        for (const std::string_view line : parts[0]) act(line, -1);
        for (int index = 0; index < elements; ++index)
            for (const std::string_view line : parts[1]) act(line, index);
        for (const std::string_view line : parts[2]) act(line, -1);
    }

    /// Lines of more than comments, in a file of so many elements.
    [[nodiscard]] int code_lines(int elements) const {
        int lines = 0;
        each_line(elements, [&](std::string_view line, int) { lines += code_of(line).empty() ? 0 : 1; });
        return lines;
    }
};

/// A placeholder of a number: "to.s:REAL".
struct Placeholder {
    std::string_view place, name, type = "LREAL";  ///< "to", "s", "REAL"
    bool coefficient = false;
    int order = -1;  ///< of a derivative or a coefficient

    explicit Placeholder(std::string_view text) {
        const std::size_t colon = text.find(':');
        if (colon != std::string_view::npos) type = text.substr(colon + 1);
        name = text.substr(0, colon);
        if (const std::size_t dot = name.find('.'); dot != std::string_view::npos) {
            place = name.substr(0, dot);
            name.remove_prefix(dot + 1);
        }
        coefficient = name.size() == 2 && name[0] == 'c' && name[1] >= '0' && name[1] <= '9';
        if (coefficient)
            order = name[1] - '0';
        else if (name.size() == 1)
            order = static_cast<int>(std::string_view("svaj").find(name));
    }

    /// Of the number in the file, in deg and mm or deg.
    [[nodiscard]] double unit(const PlcUnits& units) const {
        if (name == "x") return units.master;
        double unit = order < 0 ? 1.0 : units.slave;
        for (int r = 0; r < order; ++r) unit /= units.master;
        return unit;
    }
};

using Place = std::pair<const PolynomialPiece&, double>;  // a piece, and where on it: deg

/// Index: of the element; −1 outside of them.
Place place_of(const std::vector<PolynomialPiece>& pieces, int element, std::string_view place) {
    std::size_t index = static_cast<std::size_t>(std::max(0, element));
    if (place == "next") ++index;
    if (place == "first") index = 0;
    if (place == "end" || index >= pieces.size()) return {pieces.back(), pieces.back().end};
    if (place == "to") return {pieces[index], pieces[index].end};
    return {pieces[index], pieces[index].begin};
}

/// In deg and mm or deg.
double number_at(const PlcFormat& format, const PlcTable& table, int index, const Placeholder& what) {
    const auto& [piece, theta] = place_of(table.pieces, index, what.place);
    if (what.name == "x") return theta;
    if (what.coefficient) return what.order <= piece.degree() ? piece.coefficients[what.order] : 0.0;
    if (what.order >= 0) return value_of(piece, theta, what.order);
    if (format.own_number) return format.own_number(table, piece, theta, what.name);
    throw ModelError(fmt::format("a template of {} has {{{}}}, which is no number", format.key, what.name));
}

/// A literal of type REAL or LREAL has digits on both sides of a point, before an exponent too.
std::string literal(double value, const Placeholder& what) {
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    if (what.type == "REAL") value = as_real(value);
    if (value == 0.0) value = 0.0;  // no minus
    if (what.type == "DINT" && !(std::abs(std::round(value)) <= most))
        throw InputError(fmt::format("an electronic cam: found {:.0f} as {{{}}}; allowed: a DINT, up to {}",
                                     value, what.name, most));
    if (what.type == "DINT") return std::to_string(std::lround(value));
    std::string digits =
        what.type == "REAL" ? fmt::format("{}", static_cast<float>(value)) : fmt::format("{}", value);
    if (digits.find('.') == std::string::npos) digits.insert(std::min(digits.find('e'), digits.size()), ".0");
    return digits;
}

std::optional<double> parsed(std::string_view text, std::string_view type) {
    std::optional<double> value = number_in(text);
    if (type == "DINT" && !integer_in(text)) return std::nullopt;
    if (!value || type != "REAL") return value;
    if (std::abs(*value) > static_cast<double>(std::numeric_limits<float>::max())) return std::nullopt;
    return as_real(*value);
}

/// What is said of a place in a line: the statement there.
std::string_view statement_at(std::string_view line, std::size_t place) {
    const std::size_t begin = line.substr(0, place).rfind(';') + 1;  // npos + 1 is 0
    return trimmed(line.substr(begin, line.find(';', place) - begin));
}

/// The line with its placeholders as text_of gives them.
template <class TextOf>
std::string filled(std::string_view line, const TextOf& text_of) {
    std::string text;
    while (true) {
        const std::size_t open = line.find('{'), close = line.find('}', open);
        text += line.substr(0, open);
        if (open == std::string_view::npos) return text;
        text += text_of(line.substr(open + 1, close - open - 1));
        line.remove_prefix(close + 1);
    }
}

class TemplateFile {
 public:
    TemplateFile(const PlcFormat& format, const std::string& file)
        : format_(format), form_(plc_template(file)) {}

    [[nodiscard]] std::string written(const PlcTable& table) const {
        std::string text;
        auto header = table.header.begin();
        const int elements = static_cast<int>(table.pieces.size()) + (form_.points ? 1 : 0);
        form_.each_line(elements, [&](std::string_view line, int index) {
            const bool headed = line.ends_with(header_mark);
            const std::string_view code = headed ? form_.code_of(line) : line;
            const auto next_header = [&] { return fmt::format("{} {}", form_.comment, *header++); };
            if (headed && code.empty()) {  // a line of header alone is repeated
                while (header != table.header.end()) text += next_header() + "\n";
                return;
            }
            text += filled(code, [&](std::string_view name) {
                if (const auto count = counted(name, elements, index)) return std::to_string(*count);
                const Placeholder what(name);
                return literal(number_at(format_, table, index, what) / what.unit(table.units), what);
            });
            text += headed && header != table.header.end() ? " " + next_header() + "\n" : "\n";
        });
        return text;
    }

    [[nodiscard]] PlcReading read(std::string_view text, const PlcUnits& units) const {
        std::vector<Line> lines;
        int number = 0;
        for (const std::string_view line : split_text(text, '\n'))
            if (++number; !form_.code_of(line).empty()) lines.push_back({number, form_.code_of(line)});
        const int fixed = form_.code_lines(0), each = form_.code_lines(1) - fixed;
        const int elements = std::max(0, (static_cast<int>(lines.size()) - fixed) / each);
        lines.push_back({number, "the end"});
        PlcReading reading{std::vector<PlcNumbers>(static_cast<std::size_t>(elements)), {}};
        auto next = lines.begin();
        form_.each_line(elements, [&](std::string_view line, int index) {
            const std::string expected = filled(form_.code_of(line), [&](std::string_view name) {
                const auto count = counted(name, elements, index);
                return count ? std::to_string(*count) : fmt::format("{{{}}}", name);
            });
            PlcNumbers& into = index < 0 ? reading.rest : reading.elements[static_cast<std::size_t>(index)];
            if (!expected.empty()) match(expected, *next++, units, into);
        });
        if (next + 1 != lines.end()) refuse(*next, 0, "the end", 0);
        return reading;
    }

 private:
    struct Line {
        int number = 0;
        std::string_view code;
    };

    [[nodiscard]] std::optional<int> counted(std::string_view name, int elements, int index) const {
        const int pieces = elements - (form_.points ? 1 : 0);
        const int count = pieces + (format_.counted == PlcCount::points ? 1 : 0);
        if (name == "count") return count;
        if (name == "last") return count - 1;
        if (name == "index") return index;
        if (name == "number") return index + 1;
        if (name == "step") return index + 1 < elements ? 1 : 0;
        return std::nullopt;
    }

    [[noreturn]] void refuse(const Line& line, std::size_t found, std::string_view expected,
                             std::size_t allowed) const {
        throw InputError(fmt::format("an electronic cam: line {} of {}: found \"{}\"; allowed: {}",
                                     line.number, format_.key, statement_at(line.code, found),
                                     statement_at(expected, allowed)));
    }

    /// The line must have the expected text; its numbers are taken.
    void match(std::string_view expected, const Line& line, const PlcUnits& units,
               PlcNumbers& numbers) const {
        const std::string_view code = line.code;
        std::size_t place = 0, found = 0;
        while (true) {
            const std::size_t open = std::min(expected.find('{', place), expected.size());
            for (; place < open; ++place, ++found)
                if (found == code.size() || code[found] != expected[place])
                    refuse(line, found, expected, place);
            if (open == expected.size()) break;
            const std::size_t close = expected.find('}', open);
            const char after = close + 1 < expected.size() ? expected[close + 1] : '\n';
            const std::size_t end = std::min(code.find(after, found), code.size());
            const std::string_view name = expected.substr(open + 1, close - open - 1);
            const Placeholder what(name);
            const auto value = parsed(code.substr(found, end - found), what.type);
            if (!value) refuse(line, found, expected, open);
            numbers.all.emplace_back(name, *value * what.unit(units));
            place = close + 1;
            found = end;
        }
        if (found < code.size()) refuse(line, found, "the end of the line", 0);
    }

    const PlcFormat& format_;
    Template form_;
};

/// A controller takes some numbers, others repeat them: a jerk, an end, a slave position beside its
/// polynomial.
void check_agreement(const PlcFormat& format, const PlcTable& table, const PlcNumbers& numbers, int index) {
    constexpr double same = 1e-9, same_real = 1e-6;
    constexpr double same_jerk = 1e-4;  // a quintic magnifies the jump of a joint, 1e-6 at most (plc_export)
    double size = 0.0;
    for (const PolynomialPiece& one : table.pieces)
        size = std::max({size, std::abs(value_of(one, one.begin)), std::abs(value_of(one, one.end))});
    for (const auto& [name, found] : numbers.all) {
        const Placeholder what(name);
        const double meant = number_at(format, table, index, what);
        const PolynomialPiece& piece = place_of(table.pieces, index, what.place).first;
        double allowed = what.name == "j" ? same_jerk : what.type == "REAL" ? same_real : same;
        if (what.order >= 0) allowed *= size / std::pow(piece.end - piece.begin, what.order);
        if (what.type == "DINT") allowed = std::nextafter(what.unit(table.units), 0.0);  // as drives allow it
        if (!(std::abs(found - meant) <= allowed))
            throw InputError(fmt::format(
                "an electronic cam: {}: found {} as {{{}}}{}; allowed: {}, which follows from the other "
                "numbers",
                format.key, found, name, index < 0 ? "" : fmt::format(" of element {}", index), meant));
    }
}

}  // namespace

std::string written_file(const PlcFormat& format, const std::string& file, const PlcTable& table) {
    return TemplateFile(format, file).written(table);
}

std::vector<PolynomialPiece> read_file(const PlcFormat& format, const std::string& file,
                                       std::string_view text, const PlcUnits& units) {
    const PlcReading reading = TemplateFile(format, file).read(text, units);
    PlcTable table;
    table.pieces = format.evaluate(reading);
    table.units = units;
    const double first = table.pieces.front().coefficients.front();
    if (format.relative && first != 0.0)
        throw InputError(fmt::format(
            "an electronic cam: {}: found {} as the first slave position; allowed: 0", format.key, first));
    int index = 0;
    if (!format.straight_lines)  // of which every number is taken
        for (const PlcNumbers& element : reading.elements) check_agreement(format, table, element, index++);
    if (!format.straight_lines) check_agreement(format, table, reading.rest, -1);
    for (PolynomialPiece& piece : table.pieces) piece.coefficients.front() += units.start;
    return table.pieces;
}

}  // namespace camopt
