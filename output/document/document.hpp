// SPDX-License-Identifier: MIT
// What a study has to say, as a value: sections of sentences, figures, tables and curves, in the order of
// importance and in the units of the user. A filler of the study makes it once; the renderers
// (document_text.hpp, output/page/document_page.hpp) print it and know no study.
//
// Numbers are SI and carry their units: the one behind the number for people, and the one of a column or
// figure, which ends its key in files ("least_mm"). A key is spelled as in JSON: "peak_to_valley".
#pragma once

#include "output/view/view.hpp"

namespace camopt {

/// "at least 12 mm", "at most 12 mm".
enum class Bound : unsigned char { exact, at_least, at_most };

/// Words, a number, or both: then words are shown in the place of a number that files have.
struct Cell {
    std::string words = {};
    std::string key = {};                ///< of words, in files: "radial_offset_um"
    std::optional<double> value = {};    ///< SI
    std::optional<ShownUnit> unit = {};  ///< shown behind the number; none: the column's title has it
    int digits = 6;                      ///< significant
    Bound bound = Bound::exact;
    std::optional<bool> holds = {};  ///< true or false instead

    Cell() = default;
    explicit(false) Cell(std::string text) : words(std::move(text)) {}
    explicit(false) Cell(const char* text) : words(text) {}
    explicit(false) Cell(std::optional<double> number, int shown_digits = 6)
        : value(number), digits(shown_digits) {}
    Cell(std::optional<double> number, ShownUnit shown, int shown_digits = 6)
        : value(number), unit(std::move(shown)), digits(shown_digits) {}

    [[nodiscard]] Cell in_words(std::string text) && {
        words = std::move(text);
        return std::move(*this);
    }
};
[[nodiscard]] inline Cell flag(std::optional<bool> holds) {
    Cell cell;
    cell.holds = holds;
    return cell;
}

/// Names a number of files: key and unit together ("least_mm").
struct Field {
    std::string key;
    std::string title = {};  ///< empty: the key and the unit in words
    ShownUnit unit = {};     ///< of the numbers in files, and of cells without a unit of their own
    bool left = false;       ///< words stand left, numbers right

    [[nodiscard]] std::string file_key() const;  ///< "least_mm"
    [[nodiscard]] std::string shown_title() const;
};

struct Table {
    std::string key, title;
    std::vector<Field> columns;
    std::vector<std::vector<Cell>> rows = {};
    std::string note = {};
    std::vector<std::string> folders = {};  ///< result folders of the rows, to which their first cells lead
    /// Only in this CSV file, as it is: rows by the hundred. Empty: shown everywhere.
    std::string file = {};
};

/// A number that stands alone. Without a title a sentence says it, and only files have it.
struct Figure {
    Field field;
    Cell cell;
    std::optional<double> at = {};  ///< where it is, in `place`, SI
    ShownUnit place = degrees_shown;
    std::string at_words = {};  ///< in the place of that number
};

struct Sentence {
    enum class Kind : unsigned char { headline, verdict, remark, warning, note, effort };

    Kind kind = Kind::remark;
    std::string key;  ///< says what it is about: "tolerance"
    std::string text;
};

/// Curves over one angle: charts of the page with one cursor, and a picture. `group` of a curve is the
/// heading above it.
struct Curves : CurveSet {
    std::string key = {};                          ///< the picture is KEY.svg, its numbers are KEY.csv
    std::string caption = {};                      ///< of the picture
    std::string angle_key = {}, angle_title = {};  ///< "master", "angle of the master"
    ShownUnit angle_unit = degrees_shown;
    std::string line_title = {};  ///< in the legend of the picture
    bool table = true;            ///< KEY.csv is written; false: a table of the study has the rows
};

struct Section {
    std::string key, title;  ///< the first one has none
    std::vector<Sentence> sentences = {};
    std::vector<Figure> figures = {};
    std::optional<Curves> curves = {};
    std::vector<Table> tables = {};  ///< those without rows are left out
};

struct Document {
    std::string title;
    std::string tone = "good";  ///< "good", "fair", "bad"
    std::vector<Section> sections = {};

    /// Of all sections, in their order.
    [[nodiscard]] std::vector<std::string> sentences(std::initializer_list<Sentence::Kind> kinds) const;
    [[nodiscard]] std::vector<const Table*> shown_tables() const;
    [[nodiscard]] const Curves* curves() const;  ///< the first; null: none
};

/// The cell as people read it: words, else the number with its bound and unit.
[[nodiscard]] std::string shown_text(const Cell& cell, const Field& field);
/// The place of a figure: "12 deg"; empty: none.
[[nodiscard]] std::string place_text(const Figure& figure);
/// The table as people read it, without columns that say nothing in any row.
[[nodiscard]] TextTable text_table(const Table& table);

}  // namespace camopt
