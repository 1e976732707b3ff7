// SPDX-License-Identifier: MIT
#include "tests/support/scene_kit.hpp"

#include "core/errors.hpp"
#include "input/loading/load_scene.hpp"
#include "tests/support/source_folder.hpp"

#include <filesystem>

namespace camopt::testing_support {

Scene TestScene::read() const {
    if (name_.empty()) return scene_of_toml(toml_, settings_);
    for (const char* folder : {"/scenes/", "/tests/support/cases/", "/tests/cases/"}) {
        const std::string file = source_folder() + folder + name_ + ".toml";
        if (std::filesystem::exists(file)) return load_scene(file, settings_);
    }
    throw InputError("no scene of the tests has the name " + name_);
}

TestScene scene_named(std::string name) {
    TestScene scene("");
    scene.name_ = std::move(name);
    return scene;
}

TestScene pressure_angle_scene(double prime_radius_mm, int segments) {
    return scene_named("cam_smallest")
        .with("objective.base_radius = 0")
        .set("cam.base_radius_mm", prime_radius_mm - 10.0)
        .set("spline.segments", segments);
}

TestScene flat_scene(double base_mm) {
    return scene_named("rr_cubic_24")
        .with("motion.lift_mm = 14", "motion.rise_deg = 70", "cam.type = disk",
              "cam.follower = translating_flat")
        .set("cam.base_radius_mm", base_mm);
}

}  // namespace camopt::testing_support
