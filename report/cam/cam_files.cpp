// SPDX-License-Identifier: MIT
#include "report/cam/cam_files.hpp"

#include "report/chart/curve_chart.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/drawing/cam_svg.hpp"
#include "report/view/cam_words.hpp"

namespace camopt {

namespace {

const CamFileRow force_file = {CamView::diagram, "forces.svg", "Force, torque and pressure"};

std::vector<CamFileRow> rows_of(const Solution& solution) {
    if (!solution.cam) return {};
    const DrivenMechanism& cam = solution.cam->cam;
    std::vector<CamFileRow> rows = presentation_of(cam).files;
    std::erase_if(rows, [&](const CamFileRow& row) { return row.station >= cam.formulas->stations(); });
    return rows;
}

std::string table_text(const CamFileRow& row, const View& view, const CamFileOptions& options) {
    ProfileSampling sampling = default_sampling(*view.delivered.cam);
    sampling.chord_tolerance = options.chord_tolerance;
    if (options.points) sampling.count = options.points;
    const auto points = [&](int station) {
        return profile_rows(view.solution, view.delivered, sampling, station);
    };
    if (row.both_walls) return guide_csv(view, points(0), points(1));
    return profile_csv(view, points(row.station));
}

std::string text_of(const CamFileRow& row, const View& view, const CamFileOptions& options) {
    switch (row.view) {
        case CamView::table:
            return table_text(row, view, options);
        case CamView::picture:
            return cam_svg(view);
        case CamView::diagram:
            return cam_diagrams_svg(view, row.curves);
    }
    throw ModelError("cam file: no known view");
}

}  // namespace

std::vector<CamFile> cam_file_list(const Solution& solution) {
    std::vector<CamFile> files;
    for (const CamFileRow& row : rows_of(solution)) files.push_back({row.view, row.name, row.title, ""});
    if (solution.cam && is_loaded(solution.cam->summary))
        files.push_back({force_file.view, force_file.name, force_file.title, ""});
    return files;
}

bool has_cam_table(const Solution& solution) {
    return std::ranges::any_of(rows_of(solution),
                               [](const CamFileRow& row) { return row.view == CamView::table; });
}

std::vector<CamFile> cam_files(const View& view, const CamFileOptions& options) {
    std::vector<CamFile> files = cam_file_list(view.solution);
    const std::vector<CamFileRow> rows = rows_of(view.solution);
    for (std::size_t i = 0; i < rows.size(); ++i) files[i].text = text_of(rows[i], view, options);
    if (files.size() > rows.size()) files.back().text = force_diagrams_svg(view);
    return files;
}

std::string cam_view(const View& view, CamView shown, const CamFileOptions& options) {
    const std::vector<CamFile> files = cam_files(view, options);
    const auto found = std::ranges::find(files, shown, &CamFile::view);
    if (found == files.end())
        throw InputError("a plane profile needs a plane mechanism, and this solution has none");
    return found->text;
}

std::vector<std::string> cam_file_names() {
    std::vector<std::string> names = {drawn_profile, drawn_profile_check, force_file.name};
    for (const CamPresentation& presentation : cam_presentations())
        for (const CamFileRow& row : presentation.files) names.emplace_back(row.name);
    return names;
}

}  // namespace camopt
