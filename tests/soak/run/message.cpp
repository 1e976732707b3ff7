// SPDX-License-Identifier: MIT
#include "tests/soak/run/message.hpp"

namespace camopt::soak {

std::string message_line(const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        if (k > 0) line += '\t';
        for (const char letter : fields[k]) {
            if (letter == '\\')
                line += "\\\\";
            else if (letter == '\n')
                line += "\\n";
            else if (letter == '\t')
                line += "\\t";
            else
                line += letter;
        }
    }
    return line + '\n';
}

std::vector<std::string> message_fields(const std::string& line) {
    std::vector<std::string> fields(1);
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (line[k] == '\t') {
            fields.emplace_back();
        } else if (line[k] == '\\' && k + 1 < line.size()) {
            ++k;
            fields.back() += line[k] == 'n' ? '\n' : line[k] == 't' ? '\t' : line[k];
        } else {
            fields.back() += line[k];
        }
    }
    return fields;
}

}  // namespace camopt::soak
