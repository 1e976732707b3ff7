// SPDX-License-Identifier: MIT
#include "apps/list/list_exports.hpp"

#include "output/csv/uniform_csv.hpp"
#include "output/plc/plc_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace camopt::apps {

namespace {

std::vector<std::string> files_of(const PlcFormat& format) {
    std::vector<std::string> files = {format.file};
    if (!format.text_file.empty()) files.push_back(format.text_file);
    return files;
}

}  // namespace

std::string columns_text() {
    std::string text;
    for (const TableColumn& column : table_columns()) {
        const std::string needs = words_of(column.need);
        text += fmt::format("{:<20} {}{}{}\n", column.key, column.meaning, needs.empty() ? "" : "; ", needs);
    }
    return text + "For camopt export WHAT --out DIR --csv --columns KEY,KEY,…\n";
}

Json columns_json() {
    Json list = Json::array();
    for (const TableColumn& column : table_columns()) {
        const std::string needs = words_of(column.need);
        list.push_back({{"key", column.key},
                        {"meaning", column.meaning},
                        {"needs", needs.empty() ? Json(nullptr) : Json(needs)}});
    }
    return list;
}

std::string controllers_text() {
    std::string text;
    for (const PlcFormat& format : plc_formats()) {
        text += fmt::format("{:<10} {}\n{:<10}   {}: {}, {}\n", format.key, format.controller, "",
                            fmt::join(files_of(format), ", "), format.rule, format.numbers);
        if (format.limit)
            text += fmt::format("{:<10}   {} holds {} {}\n", "", format.limit_words, *format.limit,
                                format.element);
    }
    return text +
           "For camopt export WHAT --out DIR --plc KEY,KEY,…; docs/plc.md says how each is imported.\n";
}

Json controllers_json() {
    Json list = Json::array();
    for (const PlcFormat& format : plc_formats())
        list.push_back({{"key", format.key},
                        {"files", files_of(format)},
                        {"controller", format.controller},
                        {"rule", format.rule},
                        {"numbers", format.numbers},
                        {"degree", format.degree},
                        {"element", format.element},
                        {"limit", format.limit ? Json(*format.limit) : Json(nullptr)}});
    return list;
}

}  // namespace camopt::apps
