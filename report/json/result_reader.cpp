// SPDX-License-Identifier: MIT
#include "report/json/result_reader.hpp"

#include "core/version.hpp"
#include "report/json/result_fields.hpp"

namespace camopt {

namespace {

CamRecord cam_record(const JsonFields& json, const Scene& scene) {
    CamRecord cam;
    for (const auto& [name, value] : json.at("dimensions").members())
        value.get(cam.dimensions.emplace_back(name, 0.0).second);
    const JsonFields check = json.at("forward_check");
    if (!check.is_null()) fields(check, cam.forward_check.emplace(), scene);
    return cam;
}

}  // namespace

ResultRecord read_result(std::string_view json, std::string_view source_name,
                         const SceneOfResult& scene_of_result, RecordedMotion needed) {
    const JsonFields source(json, source_name, "a result");
    std::string written;
    source.words("camopt", written);
    if (written != version())
        source.at("camopt").fail(fmt::format(
            "found a result of camopt {}; allowed: of {}: solve its scene again", written, version()));
    const Scene& scene = scene_of_result();
    ResultRecord record;
    origin_fields(source, record, "");
    source("verdict", record.verdict);
    if (const JsonFields motion = source.at("motion");
        needed == RecordedMotion::required || !motion.is_null()) {
        if (motion.is_null() || record.verdict == Verdict::infeasible)  // a prescribed one is shown, not made
            motion.fail(fmt::format("found none: the verdict is {}; allowed: a result with a motion",
                                    name_of(record.verdict)));
        motion.get(record.motion);
    }
    bound_fields(source.at("bound"), record.any_curve_limit, record.solver);
    if (const JsonFields cam = source.at("cam"); !cam.is_null()) record.cam = cam_record(cam, scene);
    if (record.motion) source("design", record.design);
    run_fields(source, record);
    return record;
}

}  // namespace camopt
