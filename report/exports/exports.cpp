// SPDX-License-Identifier: MIT
#include "report/exports/exports.hpp"

#include "core/errors.hpp"
#include "report/cam/cam_files.hpp"
#include "report/chart/curve_chart.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/exports/workshop.hpp"
#include "report/json/certificate_json.hpp"
#include "report/page/result_page.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

/// The files of a solution and how each is made.
class Exports {
 public:
    Exports(const Solution& solution, const ExportOptions& options) : solution_(solution), options_(options) {
        add_reports();
        if (solution.motion) add_motion();
        if (workshop() == nullptr) return;
        for (ExportFile& file : workshop()->files(solution, options)) files_.push_back(std::move(file));
    }

    Exports(const Exports&) = delete;  // files refer to it
    Exports& operator=(const Exports&) = delete;
    Exports(Exports&&) = delete;
    Exports& operator=(Exports&&) = delete;
    ~Exports() = default;

    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const ExportFile& file : files_) all.push_back(file.name);
        return all;
    }

    [[nodiscard]] std::string bytes(std::string_view name) const {
        const auto file = std::ranges::find(files_, name, &ExportFile::name);
        if (file == files_.end())
            throw InputError(fmt::format("file: found \"{}\"; allowed for this solution: {}", name,
                                         fmt::join(names(), ", ")));
        return file->make().bytes;
    }

 private:
    void add(std::string name, std::function<MadeFile()> make) {
        files_.push_back({std::move(name), std::move(make)});
    }
    void add_reports() {
        add("report.html", [this] { return report_html(solution_, options_.origin); });
        add("report.md", [this] { return report_markdown(solution_, options_.origin); });
        add("result.json", [this] { return result_json(solution_, options_.origin); });
        add("certificate.json", [this] { return certificate_json(solution_.certificate); });
    }
    void add_motion() {
        add("motion.csv", [this] { return motion_csv(solution_); });
        add("motion.svg", [this] { return motion_svg(solution_); });
        for (const CamFile& file : cam_file_list(solution_))
            add(file.name, [this, name = file.name] {
                const std::vector<CamFile> files = cam_files(solution_);
                return std::ranges::find(files, name, &CamFile::name)->text;
            });
    }

    const Solution& solution_;
    const ExportOptions& options_;
    std::vector<ExportFile> files_;
};

}  // namespace

std::vector<std::string> export_names(const Solution& solution) {
    return Exports(solution, {}).names();
}

std::string exported_file(const Solution& solution, std::string_view name, const ExportOptions& options) {
    return Exports(solution, options).bytes(name);
}

std::string step_name(const Solution& solution, const std::string& solid) {
    constexpr const char* flanks = "flanks.step";
    const std::vector<std::string> names = export_names(solution);
    return std::ranges::find(names, flanks) == names.end() ? solid : flanks;
}

std::vector<std::filesystem::path> write_exports(const std::filesystem::path& folder,
                                                 const Solution& solution, std::span<const std::string> names,
                                                 const ExportOptions& options) {
    const Exports exports(solution, options);
    std::vector<FolderFile> files;
    for (const std::string& name : names) files.push_back({name, exports.bytes(name)});
    FolderUpdate update(folder);
    for (const FolderFile& file : files) update.write(file.name, file.text);
    return update.finish();
}

}  // namespace camopt
