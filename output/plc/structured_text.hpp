// SPDX-License-Identifier: MIT
// Structured text (IEC 61131-3) as tables need it: literals, comments, assignments; and back.
//
//   Points[3].dX := 10.0;    an element and one of its fields
//   Cam.nElements := 33;     a field of no element
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// "10.0", "1.5e-07": reads back as the same double; no minus before zero.
[[nodiscard]] std::string lreal_text(double value);
/// The same of a REAL.
[[nodiscard]] std::string real_text(float value);

/// "// line" each.
[[nodiscard]] std::string comment_lines(const std::vector<std::string>& lines);

struct StElements {
    std::map<int, std::map<std::string, std::string>> elements;  ///< index, field, value as written
    std::map<std::string, std::string> fields;                   ///< "Cam.nElements"

    /// Throws InputError where it is missing or no number.
    [[nodiscard]] double number(int index, const std::string& field) const;
    [[nodiscard]] float real(int index, const std::string& field) const;
    [[nodiscard]] double number(const std::string& field) const;
    [[nodiscard]] const std::string& word(int index, const std::string& field) const;
};

/// Every assignment of the text; of arrays the last index. Comments are left out. Throws InputError for an
/// element whose field is assigned twice.
[[nodiscard]] StElements read_assignments(std::string_view text);

/// Throws InputError where the text is no number. The decimal sign is a point, whatever the locale.
[[nodiscard]] double number_of(std::string_view text);
[[nodiscard]] float real_of(std::string_view text);

/// The lines of a text without their ends.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text);

}  // namespace camopt
