// SPDX-License-Identifier: MIT
#include "bindings/c/handles.hpp"
#include "dynamics/train_formulas.hpp"
#include "input/loading/load_scene.hpp"
#include "report/cam/cam_files.hpp"
#include "report/chart/curve_chart.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/exports/exports.hpp"
#include "report/folders/result_folder.hpp"
#include "report/json/certificate_json.hpp"
#include "report/json/result_json.hpp"
#include "report/solve/solution_document.hpp"

#include <cstdlib>
#include <cstring>
#include <new>

namespace camopt::c {
namespace {

[[noreturn]] void refuse_drawing(const char* what) {
    throw Failure(CAMOPT_ERROR_ABSENT, std::string("document: found ") + what +
                                           "; allowed: where the solution has a plane cam that was made");
}

std::string cam_document(const Solution& solution, CamView view, const char* what) {
    if (!has_cam_table(solution)) refuse_drawing(what);
    return cam_view(solution, view);
}

std::string document_of(const camopt_solution& result, camopt_document document) {
    const Solution& solution = result.solution;
    switch (document) {
        case CAMOPT_SUMMARY_TEXT:
            return summary_text(solution);
        case CAMOPT_REPORT_MARKDOWN:
            return report_markdown(solution, result.origin);
        case CAMOPT_RESULT_JSON:
            return result_json(solution, result.origin);
        case CAMOPT_CERTIFICATE_JSON:
            return certificate_json(solution.certificate);
        case CAMOPT_MOTION_CSV:
            (void)motion_of(&result);
            return motion_csv(solution);
        case CAMOPT_MOTION_SVG:
            (void)motion_of(&result);
            return motion_svg(solution);
        case CAMOPT_PROFILE_CSV:
            return cam_document(solution, CamView::table, "CAMOPT_PROFILE_CSV");
        case CAMOPT_PROFILE_DXF:
            if (!has_cam_table(solution)) refuse_drawing("CAMOPT_PROFILE_DXF");
            return exported_file(solution, drawn_profile);
        case CAMOPT_PROFILE_SVG:
            return cam_document(solution, CamView::picture, "CAMOPT_PROFILE_SVG");
    }
    throw Failure(CAMOPT_ERROR_ARGUMENT, "document: found " + std::to_string(static_cast<int>(document)) +
                                             "; allowed: one of camopt_document, " +
                                             std::to_string(CAMOPT_SUMMARY_TEXT) + " to " +
                                             std::to_string(CAMOPT_PROFILE_SVG));
}

/// A scene that is right as a whole.
std::unique_ptr<camopt_scene> scene_of(std::string_view toml, std::string_view name) {
    auto made = std::make_unique<camopt_scene>(camopt_scene{input::SceneDocument(toml, name, known_names())});
    (void)complete_scene(*made);
    return made;
}

camopt_error set_value(camopt_scene* scene, const char* key, const input::SceneValue& value) {
    return guarded([&] {
        require(scene, "scene");
        require(key, "key");
        scene->document.set(key, value);
    });
}

/// value: a text of the caller.
template <class Value>
camopt_error set_words(camopt_scene* scene, const char* key, const char* value) {
    return guarded([&] {
        require(scene, "scene");
        require(key, "key");
        require(value, "value");
        scene->document.set(key, Value{value});
    });
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

Scene complete_scene(const camopt_scene& scene, std::span<const std::string> settings) {
    Scene read = scene.document.scene(settings);
    complete_dynamics(read);
    return read;
}

}  // namespace camopt::c

using namespace camopt::c;

extern "C" {

camopt_error camopt_scene_new(camopt_scene** scene) {
    return guarded([&] {
        require(scene, "scene");
        *scene = nullptr;
        *scene = new camopt_scene{camopt::input::SceneDocument("", "scene", camopt::known_names())};
    });
}

camopt_error camopt_scene_from_toml(const char* toml, const char* name, camopt_scene** scene) {
    return guarded([&] {
        require(scene, "scene");
        *scene = nullptr;
        require(toml, "toml");
        *scene = scene_of(toml, name == nullptr ? "scene" : name).release();
    });
}

camopt_error camopt_scene_from_file(const char* path, camopt_scene** scene) {
    return guarded([&] {
        require(scene, "scene");
        *scene = nullptr;
        require(path, "path");
        *scene = scene_of(camopt::input::whole_scene_text(path), path).release();
    });
}

camopt_error camopt_scene_copy(const camopt_scene* scene, camopt_scene** copy) {
    return guarded([&] {
        require(copy, "copy");
        *copy = nullptr;
        require(scene, "scene");
        *copy = new camopt_scene(*scene);
    });
}

void camopt_scene_free(camopt_scene* scene) {
    delete scene;
}

camopt_error camopt_set_number(camopt_scene* scene, const char* key, double value) {
    return set_value(scene, key, value);
}

camopt_error camopt_set_text(camopt_scene* scene, const char* key, const char* value) {
    return set_words<std::string>(scene, key, value);
}

camopt_error camopt_set_bool(camopt_scene* scene, const char* key, int value) {
    return set_value(scene, key, value != 0);
}

camopt_error camopt_set_numbers(camopt_scene* scene, const char* key, const double* values, size_t count) {
    return guarded([&] {
        require(scene, "scene");
        require(key, "key");
        if (count > 0) require(values, "values");
        scene->document.set(key, std::vector<double>(values, values + count));
    });
}

camopt_error camopt_set_toml(camopt_scene* scene, const char* key, const char* value) {
    return set_words<camopt::input::TomlValue>(scene, key, value);
}

camopt_error camopt_unset(camopt_scene* scene, const char* key) {
    return guarded([&] {
        require(scene, "scene");
        require(key, "key");
        scene->document.unset(key);
    });
}

camopt_error camopt_scene_check(const camopt_scene* scene) {
    return guarded([&] {
        require(scene, "scene");
        (void)complete_scene(*scene);
    });
}

camopt_error camopt_scene_to_toml(const camopt_scene* scene, camopt_text* toml) {
    return guarded([&] {
        require(scene, "scene");
        hand_out_text(scene->document.text(), toml, "toml");
    });
}

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
