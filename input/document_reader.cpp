// SPDX-License-Identifier: MIT
#include "input/row_reader.hpp"
#include "input/scene_parts.hpp"

namespace camopt::input {

namespace {

/// Converts a file with validated keys to a Scene; missing keys have the default of scene/scene.hpp.
class SceneReader {
 public:
    SceneReader(const SceneSource& source, const KnownNames& known) : source_(source), known_(known) {}

    Scene read() const {
        Scene scene;
        scene.spline.by_stroke = true;  // without a number of segments
        read_rows(source_, scene, &scene.written);
        scene.length_unit = written_length_unit();
        read_motion(source_, known_, scene);
        check_breakpoints(scene.spline);
        if (!source_.table("objective") && !scene.motion.prescribed() && !uses("nearest") && !uses("given"))
            source_.fail({}, "objective", "missing; allowed: a [objective] table");
        check_reference();
        read_cam(source_, known_, scene);
        check_forces(source_, scene);
        if (scene.cam && scene.cam->face_radius && scene.forces && scene.forces->contact_width)
            scene.cam->set_round_face(*scene.cam->face_radius, *scene.forces->contact_width);
        read_limits(source_, scene);
        if (scene.dynamics) read_dynamics(source_, scene);
        if (scene.drive) check_drive(source_, scene.motion);
        check_solver();
        const std::optional<MeasuredInput> measured = read_measured(source_, scene, known_);
        if (measured) scene.measured = measured->motion;
        weigh_deviation(scene);
        if (const std::optional<SceneFault> fault = find_fault(scene)) {
            if (measured) fail_in_measured(source_, *measured, *fault);
            source_.fail_member(fault->member, words_of(*fault));
        }
        return scene;
    }

 private:
    const SceneSource& source_;
    const KnownNames& known_;

    /// Of the first length in the order of the documentation: the lift, or the next one if it is an angle.
    LengthUnit written_length_unit() const {
        for (const KeyRow& row : scene_keys())
            if (const auto given = source_.find(row.table, row.name)) {
                if (given->spelling->unit == name_of(LengthUnit::inch)) return LengthUnit::inch;
                if (given->spelling->unit == "mm" || given->spelling->unit == "m")
                    return LengthUnit::millimetre;
            }
        return LengthUnit::millimetre;
    }

    void check_breakpoints(const SplineSpec& spline) const {
        const auto breakpoints = source_.find("spline", "breakpoints");
        if (breakpoints && spline.breakpoints.size() < 2)
            source_.fail(breakpoints->value().place, "spline.breakpoints",
                         "found fewer than 2 breakpoints; allowed: 2 to 65537");
    }

    bool uses(std::string_view word) const {
        const auto use = source_.find("measured", "use");
        return use && use->value().text == word;
    }

    /// measured.use = "nearest" is a weight; one that is given stays.
    void weigh_deviation(Scene& scene) const {
        ObjectiveSpec& objective = scene.objective;
        if (!uses("nearest") || objective.deviation > 0.0 || objective.deviation_rms > 0.0) return;
        (scene.measured_rows->norm == "rms" ? objective.deviation_rms : objective.deviation) = 1.0;
    }

    void check_reference() const {
        const auto given = source_.find("objective", "reference");
        if (!given || given->value().kind != NodeKind::text) return;
        std::vector<std::string> laws = known_.laws;  // a rise without rest has no separate peaks
        for (const std::string& moving : known_.moving_laws) std::erase(laws, moving);
        check_law(source_, *given, "objective.reference", known_, {laws, ", or a table of numbers"});
    }

    void check_solver() const {
        const auto given = source_.find("solver", "name");
        if (!given || given->value().text == "auto") return;
        std::vector<std::string> solvers = {"auto"};
        solvers.insert(solvers.end(), known_.solvers.begin(), known_.solvers.end());
        check_name(source_, *given, "solver.name", {solvers});
    }
};

}  // namespace

Scene read_document(const SceneSource& source, const KnownNames& known) {
    check_keys(source);
    return SceneReader(source, known).read();
}

}  // namespace camopt::input
