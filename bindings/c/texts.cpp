// SPDX-License-Identifier: MIT
#include "bindings/c/texts.hpp"

#include "bindings/c/handles.hpp"
#include "output/chart/motion_svg.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/json/certificate/certificate_json.hpp"
#include "output/json/result_json.hpp"
#include "output/report/cam_files.hpp"
#include "output/report/report.hpp"
#include "output/words/solution_text.hpp"

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

std::string cam_document(const Solution& solution, CamView view, const char* what) {
    if (!solution.cam || !solution.cam->cam.formulas->is_plane_curve()) refuse_drawing(what);
    return cam_view(solution, view);
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
            return cam_document(solution, CamView::table, "CAMOPT_PROFILE_CSV");
        case CAMOPT_PROFILE_DXF:
            return cam_document(solution, CamView::drawing, "CAMOPT_PROFILE_DXF");
        case CAMOPT_PROFILE_SVG:
            return cam_document(solution, CamView::picture, "CAMOPT_PROFILE_SVG");
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
