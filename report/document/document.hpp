// SPDX-License-Identifier: MIT
// What a study has to say, as a value: sections of sentences, figures, tables and curves, in the order of
// importance and in the units of the user. A filler of the study makes it once; the renderers
// (document_text.hpp, report/page/document_page.hpp) print it and know no study.
//
// Numbers are SI and carry their units: the one behind the number for people, and the one of a column or
// figure, which ends its key in files ("least_mm"). A key is spelled as in JSON: "peak_to_valley"; with
// points, "peaks.velocity.at", it is that of an object in an object, which is null where it has no value.
#pragma once

#include "report/chart/chart.hpp"
#include "report/view/view.hpp"

namespace camopt {

/// Who is shown a part of a document, bit by bit. Files for programs have all of it.
struct Where {
    static constexpr unsigned files = 0, console = 1, markdown = 2, page = 4, texts = 3, reports = 6,
                              everywhere = 7;
};

/// "at least 12 mm", "at most 12 mm".
enum class Bound : unsigned char { exact, at_least, at_most };

struct Figure;

/// Words, a number, or both: then words are shown in the place of a number that files have.
struct Cell {
    std::string words = {};
    std::string key = {};                ///< of words, in files: "radial_offset_um"
    std::optional<double> value = {};    ///< SI
    std::optional<ShownUnit> unit = {};  ///< shown behind the number; none: the column's title has it
    int digits = 6;                      ///< significant
    Bound bound = Bound::exact;
    std::optional<bool> holds = {};  ///< true or false instead
    /// In JSON in the place of the words: an object, a list of objects, a list of numbers.
    std::shared_ptr<const std::vector<Figure>> object = {};
    std::shared_ptr<const std::vector<std::vector<Figure>>> list = {};
    std::vector<double> numbers = {};

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
/// A normalised derivative of a motion.
[[nodiscard]] inline Cell motion_cell(const MotionUnit& unit, double normalised, int digits = 6) {
    return {unit.si(normalised), static_cast<const ShownUnit&>(unit), digits};
}
[[nodiscard]] inline Cell flag(std::optional<bool> holds) {
    Cell cell;
    cell.holds = holds;
    return cell;
}
/// The same, 1 or 0 in CSV.
[[nodiscard]] inline Cell counted_flag(bool holds) {
    Cell cell(holds ? 1.0 : 0.0);
    cell.holds = holds;
    return cell;
}

/// Names a number of files: key and unit together ("least_mm").
struct Field {
    std::string key;
    std::string title = {};            ///< empty: the key and the unit in words
    ShownUnit unit = {};               ///< of the numbers in files, and of cells without a unit of their own
    bool left = false;                 ///< words stand left, numbers right
    std::optional<int> decimals = {};  ///< of its numbers, as people read them
    unsigned where = Where::everywhere;
    bool code = false;  ///< in Markdown words are code

    [[nodiscard]] std::string file_key() const;  ///< "least_mm"
    [[nodiscard]] std::string shown_title() const;
};

/// What a row stands for where rows are motions: the page sorts them, draws any column over any other, and
/// hands out the scene of each.
struct RowMotion {
    std::string name;
    std::string tone = {};   ///< "good", "bad"
    int number = 0;          ///< the class "rN" of its marks in pictures
    bool only_page = false;  ///< texts leave the row out
    /// KEY=VALUE, which make its scene of that of the document; none: the page has no scene of it.
    std::optional<std::vector<std::string>> settings = {};
};

/// Motions of all rows over one angle, drawn into one chart.
struct Overlay {
    std::string title, symbol;
    ShownUnit unit;
    std::vector<std::vector<double>> lines = {};  ///< by row, in `unit`; empty: none
};

/// Tables of one key are one list in JSON.
struct Table {
    std::string key = {}, title = {};
    std::vector<Field> columns = {};
    std::vector<std::vector<Cell>> rows = {};
    std::string note = {};
    unsigned where = Where::everywhere, note_where = Where::everywhere;
    std::vector<std::string> folders = {};  ///< result folders of the rows, to which their first cells lead
    /// Only in this CSV file, as it is: rows by the hundred. Empty: shown everywhere.
    std::string file = {};
    bool in_json = false;                  ///< of such a file: in JSON too
    std::vector<RowMotion> motions = {};   ///< a row each, or none
    std::array<std::string, 2> axes = {};  ///< keys of the columns that are drawn first, to the right and up
    std::vector<double> overlay_angles = {};  ///< deg
    std::vector<Overlay> overlays = {};
    /// Where no row has a scene: what a click says, and the command that solves a scene but for the settings
    /// in the name of the row ("row 7: KEY=VALUE, KEY=VALUE").
    std::string without_scenes = {}, scene_command = {};

    [[nodiscard]] bool in_texts(std::size_t row) const { return motions.empty() || !motions[row].only_page; }
    /// One more column: `cell_of` every item of the rows.
    template <class Rows, class CellOf>
    void add_column(Field field, const Rows& items, const CellOf& cell_of) {
        columns.push_back(std::move(field));
        rows.resize(items.size());
        std::size_t row = 0;
        for (const auto& item : items) rows[row++].push_back(Cell(cell_of(item)));
    }
};

/// A number that stands alone. Without a title a sentence says it, and only files have it.
struct Figure {
    Field field;
    Cell cell = {};
    std::optional<double> at = {};  ///< where it is, in `place`, SI
    ShownUnit place = degrees_shown;
    std::string at_words = {};  ///< in the place of that number
};

struct Sentence {
    enum class Kind : unsigned char { headline, verdict, remark, warning, note, effort };

    Kind kind = Kind::remark;
    std::string key;  ///< says what it is about: "tolerance"
    std::string text;
    unsigned where = Where::everywhere;
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

/// A chart of its own: KEY.svg.
struct Picture {
    std::string key, caption;
    std::optional<Chart> chart =
        {};  ///< none: the folder has the file from elsewhere, the page draws it otherwise
    unsigned where = Where::everywhere;
};

/// What is said where it has no title is the verdict. The sentences of a titled section are a list; on the
/// page those of the key "reference" stand beside the verdict.
struct Section {
    std::string key = {}, title = {};
    std::vector<Sentence> sentences = {};
    std::vector<Figure> figures = {};
    std::optional<Curves> curves = {};
    std::vector<Picture> pictures = {};
    std::vector<Table> tables = {};  ///< those without rows are left out
    std::string code = {};           ///< TOML, as it is, in Markdown
    unsigned where = Where::everywhere;

    void say(Sentence::Kind kind, const std::string& about, std::vector<std::string> texts,
             unsigned to = Where::everywhere);
    /// Sentences of these kinds, for any of these readers.
    [[nodiscard]] std::vector<std::string> said(std::initializer_list<Sentence::Kind> kinds,
                                                unsigned to = Where::everywhere) const;
    [[nodiscard]] std::vector<const Table*> shown_tables(unsigned to) const;
};

/// Remarks under a title; without any nothing is shown.
[[nodiscard]] Section listing(std::string key, std::string title, std::vector<std::string> remarks,
                              unsigned where = Where::everywhere);

struct Document {
    std::string title;
    std::string tone = "good";  ///< "good", "fair", "bad"
    std::vector<Section> sections = {};
    std::string kind = "Report";  ///< above the title of the page
    std::string foot = {};        ///< of printed pages; empty: the title
    std::string verdict = {};     ///< of a solve, a key: "optimal"

    /// Of all sections, in their order.
    [[nodiscard]] std::vector<std::string> sentences(std::initializer_list<Sentence::Kind> kinds,
                                                     unsigned to = Where::everywhere) const;
    [[nodiscard]] std::vector<const Picture*> pictures() const;
    [[nodiscard]] const Curves* curves() const;  ///< the first; null: none
};

/// The cell as people read it: words, else the number with its bound and unit.
[[nodiscard]] std::string shown_text(const Cell& cell, const Field& field);
/// The place of a figure: "12 deg"; empty: none.
[[nodiscard]] std::string place_text(const Figure& figure);

bool has_own_unit(const Cell& cell, const Field& field);
/// In the unit that the key of the field names, or else in that of the cell.
[[nodiscard]] std::optional<double> file_number(const Cell& cell, const Field& field);
[[nodiscard]] const std::string& file_words(const Cell& cell);
/// Where a figure is, as a figure of files: it has `at`.
[[nodiscard]] Figure place_figure(const Figure& figure);

/// The table as these people read it, without columns that say nothing in any row.
[[nodiscard]] TextTable text_table(const Table& table, unsigned to = Where::everywhere);

}  // namespace camopt
