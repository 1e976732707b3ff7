// SPDX-License-Identifier: MIT
#include "bindings/c/texts.hpp"

#include "bindings/c/handles.hpp"
#include "output/chart/motion_svg.hpp"
#include "output/csv/guide_files.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/drawing/cam_profile.hpp"
#include "output/drawing/mechanism_dxf.hpp"
#include "output/json/certificate_json.hpp"
#include "output/json/result_json.hpp"
#include "output/report/mechanism_files.hpp"
#include "output/report/report.hpp"
#include "output/words/solution_text.hpp"
#include "studies/delivered/mechanism_report.hpp"

#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

namespace camopt::c {
namespace {

[[noreturn]] void refuse_drawing(const char* what) {
    throw Failure(CAMOPT_ERROR_ABSENT, std::string("document: found ") + what +
                                           "; allowed: where the solution has a plane cam that was made");
}

bool has_drawn_mechanism(const Solution& solution) {
    return solution.mechanism && solution.mechanism->mechanism.formulas->planar();
}

std::string profile_table(const Solution& solution) {
    if (solution.cam) return cam_profile(solution).csv;
    if (has_drawn_mechanism(solution)) return mechanism_texts(solution).csv;
    if (has_inverse_cam(solution)) return guide_texts(solution).csv;
    refuse_drawing("CAMOPT_PROFILE_CSV");
}

std::string profile_drawing(const Solution& solution) {
    if (solution.cam) return *cam_profile(solution, {.dxf = true}).dxf;
    if (has_plane_mechanism(solution)) return mechanism_dxf(solution).text;
    refuse_drawing("CAMOPT_PROFILE_DXF");
}

std::string profile_picture(const Solution& solution) {
    if (solution.cam) return cam_profile(solution).svg;
    if (has_drawn_mechanism(solution)) return mechanism_texts(solution).svg;
    if (has_inverse_cam(solution)) return guide_texts(solution).svg;
    refuse_drawing("CAMOPT_PROFILE_SVG");
}

std::string document_of(const camopt_solution& result, camopt_document document) {
    const Solution& solution = result.solution;
    switch (document) {
        case CAMOPT_SUMMARY_TEXT:
            return summary_text(solution, {});
        case CAMOPT_REPORT_MARKDOWN:
            return report_markdown(solution, result.origin);
        case CAMOPT_RESULT_JSON:
            return result_json(solution, result.origin);
        case CAMOPT_CERTIFICATE_JSON:
            return certificate_json(solution.certificate);
        case CAMOPT_MOTION_CSV:
            return motion_csv(motion_of(&result), solution.motion_peaks, solution.scene.motion);
        case CAMOPT_MOTION_SVG:
            (void)motion_of(&result);
            return motion_svg(solution);
        case CAMOPT_PROFILE_CSV:
            return profile_table(solution);
        case CAMOPT_PROFILE_DXF:
            return profile_drawing(solution);
        case CAMOPT_PROFILE_SVG:
            return profile_picture(solution);
    }
    throw Failure(CAMOPT_ERROR_ARGUMENT, "document: found " + std::to_string(static_cast<int>(document)) +
                                             "; allowed: one of camopt_document, " +
                                             std::to_string(CAMOPT_SUMMARY_TEXT) + " to " +
                                             std::to_string(CAMOPT_PROFILE_SVG));
}

}  // namespace

void hand_out_text(std::string_view text, camopt_text* target, const char* name) {
    require(target, name);
    auto* const data = static_cast<char*>(std::malloc(text.size() + 1));
    if (data == nullptr) throw std::bad_alloc();
    if (!text.empty()) std::memcpy(data, text.data(), text.size());
    data[text.size()] = '\0';
    *target = {data, text.size()};
}

}  // namespace camopt::c

using namespace camopt::c;

extern "C" {

void camopt_text_free(camopt_text* text) {
    if (text == nullptr) return;
    std::free(text->data);
    *text = {nullptr, 0};
}

camopt_error camopt_solution_text(const camopt_solution* solution, camopt_document document,
                                  camopt_text* text) {
    return guarded([&] {
        require(solution, "solution");
        require(text, "text");
        hand_out_text(document_of(*solution, document), text, "text");
    });
}
}
