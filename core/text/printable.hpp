// SPDX-License-Identifier: MIT
// Escapes text of users (titles, keys, values, file names of a scene) so that a terminal or another reader
// does not interpret it.
//
// Escaped as \u001b (as in JSON): control characters (U+0000 … 1F, 7F … 9F), the separators of lines and
// paragraphs (U+2028, 2029), the marks that change the direction of writing (U+200E, 200F, 202A … 202E, 2066
// … 2069). A byte that is not UTF-8 becomes \x and two digits. Everything else is unchanged. For ASCII
// readers (NC controls) letters and signs are transliterated.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

/// On one line.
[[nodiscard]] std::string printable(std::string_view text);

/// Line feeds and tabs remain: for camopt's own lines. In JSON only the spelling changes.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// `printable` for XML and HTML, in elements and in attributes: & < > " are escaped.
[[nodiscard]] std::string xml_text(std::string_view text);

/// In printable ASCII: ä as ae, é as e, µ as u, ° as " deg", – as -; a control character as a blank; anything
/// else, including a byte that is not UTF-8, as '?'.
[[nodiscard]] std::string ascii_text(std::string_view text);

/// A unit as it is read: "mm/s^2" becomes "mm/s²", "um" "µm".
[[nodiscard]] std::string unit_words(std::string_view unit);

}  // namespace camopt
