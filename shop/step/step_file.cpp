// SPDX-License-Identifier: MIT
#include "shop/step/step_file.hpp"

#include "core/errors.hpp"
#include "core/platform/parts.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "core/version.hpp"
#include "shop/step/step_part.hpp"
#include "shop/step/step_solid.hpp"

extern "C" const void* camopt_part_step(const char* build);  // step_opencascade.cpp

namespace camopt {

namespace {

constexpr PartInfo step_info = {"step",
                                "STEP files",
                                "Open CASCADE",
                                "camopt-step",
                                "libocct-data-exchange-dev",
                                "CAMOPT_WITH_OPENCASCADE",
                                PartBuild::CAMOPT_PART_STEP};

const StepPart& step_part() {
    return opened_part<StepPart, step_info, camopt_part_step>();
}

StepHeader header_of(const std::string& part, const std::string& author = {},
                     const std::string& organisation = {}) {
    return {ascii_text(part), ascii_text(author), ascii_text(organisation),
            "camopt " + std::string(version())};
}

}  // namespace

bool step_available() {
    return part_available(step_info);
}

void write_step_file(const std::filesystem::path& path, std::span<const BsplineSurface> surfaces,
                     const std::string& part) {
    if (surfaces.empty()) throw InputError("STEP: there is no surface to write");
    write_text_file(path, step_part().surfaces(surfaces, header_of(part)));
}

double write_step_solid(const std::filesystem::path& path, const Plate& plate) {
    const StepSolid solid = step_part().solid(plate, header_of(plate.name, plate.author, plate.organisation));
    write_text_file(path, solid.text);
    return solid.volume;
}

}  // namespace camopt
