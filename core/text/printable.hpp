// SPDX-License-Identifier: MIT
// Text of others (titles, keys, values, file names of a scene) as it may be shown: what a terminal or another
// reader would obey instead of showing is written out.
//
// Written out as \u001b (as JSON does): control characters (U+0000 … 1F, 7F … 9F), the separators of lines
// and paragraphs (U+2028, 2029), the marks that turn the direction of writing (U+200E, 200F, 202A … 202E,
// 2066 … 2069). A byte that is no UTF-8 becomes \x and two digits. Everything else stays as it is.
// For readers that know ASCII alone (NC controls) letters and signs are transliterated.
#pragma once

#include <string>
#include <string_view>

namespace camopt {

/// One line, whatever the text holds.
[[nodiscard]] std::string printable(std::string_view text);

/// Line feeds and tabs stay: for texts of camopt's own lines. In JSON nothing changes but the spelling.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// `printable` for XML and HTML, in elements and in attributes: & < > " are escaped.
[[nodiscard]] std::string xml_text(std::string_view text);

/// In printable ASCII: ä as ae, é as e, µ as u, ° as " deg", – as -; a control character as a blank, anything
/// else, and a byte that is no UTF-8, as '?'.
[[nodiscard]] std::string ascii_text(std::string_view text);

}  // namespace camopt
