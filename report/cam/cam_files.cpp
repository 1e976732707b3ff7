// SPDX-License-Identifier: MIT
#include "report/cam/cam_files.hpp"

#include "report/chart/curve_chart.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/drawing/cam_svg.hpp"
#include "report/view/cam_words.hpp"

namespace camopt {

namespace {

const CamFile force_file = {CamView::diagram, "forces.svg", "Force, torque and pressure", ""};

/// The files of a kind and what makes them.
struct KindFiles {
    bool (*is_it)(const CamMechanism&);
    std::vector<CamFile> files;
    std::vector<std::string> (*texts)(const View&, const CamFileOptions&);
};

/// The first that fits.
const std::array<KindFiles, 4>& kinds() {
    using enum CamView;
    static const std::array<KindFiles, 4> all = {{
        {[](const CamMechanism& cam) { return cam.is_direct() && cam.stations() > 1; },
         {{table, "profile.csv", "", ""},
          {picture, "profile.svg", "The cam to scale", ""},
          {diagram, "profile_diagrams.svg", "Pressure angle and curvature", ""},
          {table, "second_profile.csv", "", ""}},
         disk_texts},
        {[](const CamMechanism& cam) { return cam.is_direct(); },
         {{table, "profile.csv", "", ""},
          {picture, "profile.svg", "The cam to scale", ""},
          {diagram, "profile_diagrams.svg", "Pressure angle and curvature", ""}},
         disk_texts},
        {[](const CamMechanism& cam) { return cam.has_guide(); },
         {{table, "guide.csv", "", ""},
          {picture, "guide.svg", "The guide to scale", ""},
          {diagram, "pressure_angle.svg", "Pressure angle", ""}},
         guide_texts},
        {[](const CamMechanism& cam) { return cam.planar(); },
         {{table, "profile.csv", "", ""},
          {picture, "mechanism.svg", "Cam and linkage to scale", ""},
          {diagram, "pressure_angle.svg", "Pressure angle", ""},
          {diagram, "curvature.svg", "Curvature", ""}},
         linkage_texts},
    }};
    return all;
}

/// Null where there are none.
const KindFiles* kind_of(const Solution& solution) {
    if (!solution.cam) return nullptr;
    const std::span all(kinds());
    const auto found = std::ranges::find_if(
        all, [&](const KindFiles& kind) { return kind.is_it(*solution.cam->cam.formulas); });
    return found == all.end() ? nullptr : &*found;
}

constexpr int left_wall = 0, right_wall = 1;  // stations of the mechanism

std::vector<DeliveredRow> counted_rows(const View& view, const CamFileOptions& options, int station) {
    ProfileSampling sampling = default_sampling(*view.delivered.cam);
    if (options.points) sampling.count = options.points;
    return profile_rows(view.solution, view.delivered, sampling, station);
}

}  // namespace

std::vector<CamFile> cam_file_list(const Solution& solution) {
    const KindFiles* const kind = kind_of(solution);
    if (kind == nullptr) return {};
    std::vector<CamFile> files = kind->files;
    if (is_loaded(solution.cam->summary)) files.push_back(force_file);
    return files;
}

std::vector<CamFile> cam_files(const View& view, const CamFileOptions& options) {
    const Solution& solution = view.solution;
    std::vector<CamFile> files = cam_file_list(solution);
    if (files.empty()) return files;
    std::vector<std::string> texts = kind_of(solution)->texts(view, options);
    if (is_loaded(solution.cam->summary)) texts.push_back(force_diagrams_svg(view));
    for (std::size_t i = 0; i < files.size(); ++i) files[i].text = std::move(texts[i]);
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
    for (const KindFiles& kind : kinds())
        for (const CamFile& file : kind.files) names.push_back(file.name);
    return names;
}

std::vector<std::string> disk_texts(const View& view, const CamFileOptions& options) {
    const ProfileSampling sampling{options.points, options.chord_tolerance};
    const auto table = [&](int side) {
        return profile_csv(view, profile_rows(view.solution, view.delivered, sampling, side));
    };
    std::vector<std::string> texts = {table(0), cam_svg(view), cam_diagrams_svg(view)};
    if (view.delivered.cam->cam().formulas->stations() > 1) texts.push_back(table(1));
    return texts;
}

std::vector<std::string> guide_texts(const View& view, const CamFileOptions& options) {
    const auto left = counted_rows(view, options, left_wall), right = counted_rows(view, options, right_wall);
    return {guide_csv(view, left, right), cam_svg(view), cam_diagrams_svg(view, "pressure_angle")};
}

std::vector<std::string> linkage_texts(const View& view, const CamFileOptions& options) {
    return {profile_csv(view, counted_rows(view, options, 0)), cam_svg(view),
            cam_diagrams_svg(view, "pressure_angle"), cam_diagrams_svg(view, "curvature")};
}

}  // namespace camopt
