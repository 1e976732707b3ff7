// SPDX-License-Identifier: MIT
#include "tests/soak/known/scene_files.hpp"

#include <fstream>

namespace camopt::soak {

namespace {

void write_file(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

}  // namespace

std::filesystem::path write_scene(const KnownScene& scene, const std::filesystem::path& folder,
                                  const std::string& name, const std::string& remarks) {
    const std::filesystem::path file =
        scene.axes.empty() ? folder / (name + ".toml") : folder / name / "machine.toml";
    write_file(file, remarks + scene.text);
    for (const AxisFile& axis : scene.axes) write_file(file.parent_path() / axis.name, axis.text);
    return file;
}

}  // namespace camopt::soak
