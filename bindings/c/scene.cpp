// SPDX-License-Identifier: MIT
#include "bindings/c/handles.hpp"
#include "bindings/c/texts.hpp"
#include "dynamics/train_formulas.hpp"
#include "input/loading/load_scene.hpp"
#include "profiles/factory/mechanism_factory.hpp"

#include <memory>
#include <vector>

namespace camopt::c {
namespace {

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

Scene complete_scene(const camopt_scene& scene, std::span<const std::string> settings) {
    Scene read = scene.document.scene(settings);
    complete_mechanism(read);
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
}
