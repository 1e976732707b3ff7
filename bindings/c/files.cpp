// SPDX-License-Identifier: MIT
#include "bindings/c/handles.hpp"
#include "core/text/list_text.hpp"
#include "core/units.hpp"
#include "shop/exports/exports.hpp"

#include <fmt/format.h>

namespace camopt::c {
namespace {

using units::millimetre;

std::optional<double> length_of(double mm) {
    if (mm == 0.0) return {};
    return mm * millimetre;
}

ExportOptions options_of(const camopt_solution& solution, const camopt_file_options* given) {
    const camopt_file_options read = read_options(given, "options");
    ExportOptions options;
    options.origin = solution.origin;
    options.plate = {length_of(read.bore_mm), length_of(read.thickness_mm)};
    options.nc.cutter_diameter = length_of(read.cutter_mm);
    if (read.feed_mm_min != 0.0) options.nc.feed = read.feed_mm_min * millimetre / units::minute;
    options.nc.spindle_rpm = read.spindle_rpm;
    if (read.post != nullptr) options.nc.post = read.post;
    if (read.plc_points > 0) options.plc.points = static_cast<int>(read.plc_points);
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
