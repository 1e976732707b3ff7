// SPDX-License-Identifier: MIT
#include "bindings/c/handles.hpp"
#include "core/text/list_text.hpp"
#include "core/text/parsing.hpp"
#include "report/exports/exports.hpp"
#include "report/view/number_text.hpp"

#include <fmt/format.h>

namespace camopt::c {
namespace {

/// "KEY=VALUE", one a line.
void add_settings(ExportOptions& options, std::string_view lines) {
    for (const std::string_view line : split_text(lines, '\n', "")) {
        if (line.empty()) continue;
        const std::size_t sign = line.find('=');
        if (sign == std::string_view::npos)
            throw InputError(fmt::format("options.settings: found {}; allowed: KEY=VALUE", in_quotes(line)));
        options.settings.emplace_back(line.substr(0, sign), line.substr(sign + 1));
    }
}

ExportOptions options_of(const camopt_solution& solution, const camopt_file_options* given) {
    const camopt_file_options read = read_options(given, "options");
    ExportOptions options{.origin = solution.origin, .settings = {}};
    const std::pair<const char*, double> numbers[] = {{"bore_mm", read.bore_mm},
                                                      {"thickness_mm", read.thickness_mm},
                                                      {"cutter_mm", read.cutter_mm},
                                                      {"feed_mm_min", read.feed_mm_min},
                                                      {"spindle_rpm", read.spindle_rpm}};
    for (const auto& [key, number] : numbers)
        if (number != 0.0) options.settings.emplace_back(key, round_trip_text(number));
    if (read.plc_points > 0) options.settings.emplace_back("points", fmt::to_string(read.plc_points));
    if (read.post != nullptr) options.settings.emplace_back("post", read.post);
    if (read.settings != nullptr) add_settings(options, read.settings);
    return options;
}

/// Throws Failure for a file that the solution does not have.
void check_name(const camopt_solution& solution, const std::string& name) {
    const std::vector<std::string> names = export_names(solution.solution);
    if (std::ranges::find(names, name) != names.end()) return;
    throw Failure(CAMOPT_ERROR_ABSENT, fmt::format("file: found {}; allowed for this solution: {}",
                                                   in_quotes(name), fmt::join(names, ", ")));
}

}  // namespace
}  // namespace camopt::c

using namespace camopt::c;

extern "C" {

camopt_error camopt_file_names(const camopt_solution* solution, camopt_text* names) {
    return guarded([&] {
        require(solution, "solution");
        std::string lines;
        for (const std::string& name : camopt::export_names(solution->solution)) lines += name + "\n";
        hand_out_text(lines, names, "names");
    });
}

camopt_error camopt_file(const camopt_solution* solution, const char* name,
                         const camopt_file_options* options, camopt_text* bytes) {
    return guarded([&] {
        require(solution, "solution");
        require(name, "name");
        require(bytes, "bytes");
        check_name(*solution, name);
        hand_out_text(camopt::exported_file(solution->solution, name, options_of(*solution, options)), bytes,
                      "bytes");
    });
}

camopt_error camopt_write_files(const camopt_solution* solution, const char* folder, const char* const* names,
                                size_t count, const camopt_file_options* options) {
    return guarded([&] {
        require(solution, "solution");
        require(folder, "folder");
        if (count > 0) require(names, "names");
        std::vector<std::string> wanted;
        for (std::size_t i = 0; i < count; ++i) {
            require(names[i], "names");
            wanted.emplace_back(names[i]);
            check_name(*solution, wanted.back());
        }
        (void)camopt::write_exports(folder, solution->solution, wanted, options_of(*solution, options));
    });
}
}
