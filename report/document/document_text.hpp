// SPDX-License-Identifier: MIT
// A document as text: for a terminal, as Markdown, as JSON and as CSV. The page is
// report/page/document_page.hpp.
#pragma once

#include "report/document/document.hpp"
#include "report/document/run_origin.hpp"

namespace camopt {

/// Title, sentences, figures, tables; notes and effort last.
[[nodiscard]] std::string console_text(const Document& document);

/// report.md. The picture of the curves is a file beside it.
[[nodiscard]] std::string document_markdown(const Document& document, const RunOrigin& origin);

/// {camopt, title, every figure by its key, sentences [{kind, key, text}], every table by its key as a list
/// of rows}. A number is in the unit that its key names; one with a unit of its own is {value, unit}. null
/// where there is none. Numbers read back as the same double.
[[nodiscard]] std::string document_json(const Document& document);

/// Every cell of figures and tables on a line: table, row (a figure: its key), column, value, unit; without
/// the tables of a section that has `code`.
[[nodiscard]] std::string cells_csv(const Document& document);

/// One table: a line a row, keys in the first line.
[[nodiscard]] std::string table_csv(const Table& table);

/// The picture of the curves as SVG.
[[nodiscard]] std::string curves_svg(const Document& document, const Curves& curves);

/// The picture, the CSV files and the Markdown of a document: what its folder has beside page and JSON. A
/// table without rows has no file.
[[nodiscard]] std::vector<FolderFile> text_files(const Document& document, const RunOrigin& origin);

}  // namespace camopt
