// SPDX-License-Identifier: MIT
// camopt list controllers, and the keys of post-processors and of exports.
#include "apps/shop/shop_commands.hpp"
#include "shop/exports/workshop_options.hpp"
#include "shop/nc/post_processor.hpp"

#include <fmt/ranges.h>

namespace camopt::apps {

namespace {

std::string controllers_text() {
    std::string text;
    for (const PlcFormat& format : plc_formats()) {
        text += fmt::format("{:<10} {}\n{:<10}   {}: {}, {}\n", format.key, format.controller, "",
                            fmt::join(format.files(), ", "), format.rule, format.numbers);
        if (format.limit)
            text += fmt::format("{:<10}   {} holds {} {}\n", "", format.limit_words, *format.limit,
                                format.element);
    }
    return text +
           "For camopt export WHAT --out DIR --plc KEY,KEY,…; docs/plc.md says how each is imported.\n";
}

/// Each: key, files, controller, rule, numbers, degree, element, limit (null: none).
Json controllers_json() {
    Json list = Json::array();
    for (const PlcFormat& format : plc_formats())
        list.push_back({{"key", format.key},
                        {"files", format.files()},
                        {"controller", format.controller},
                        {"rule", format.rule},
                        {"numbers", format.numbers},
                        {"degree", format.degree},
                        {"element", format.element},
                        {"limit", format.limit ? Json(*format.limit) : Json(nullptr)}});
    return list;
}

}  // namespace

std::vector<ListTopic> shop_topics() {
    return {{"controllers", controllers_text, controllers_json}};
}

std::vector<DescribedKeys> shop_keys() {
    return {{"post-processor", "KEYS OF A POST-PROCESSOR", post_rows()},
            {"export", "OPTIONS OF EXPORTS", workshop_rows()}};
}

}  // namespace camopt::apps
