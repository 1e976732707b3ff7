// SPDX-License-Identifier: MIT
#include "input/dynamics_reader.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt::input {
namespace {

/// Masses and springs of a length, inertias and torsion springs of an angle.
void check_train_unit(const SceneSource& source, const Given& given, bool angle) {
    const std::string_view unit = given.spelling->unit;
    const bool angular = unit == "kg m^2" || unit == "N m/rad" || unit == "N m" || unit == "N m s/rad";
    const bool linear = unit == "kg" || unit == "N/mm" || unit == "N/m" || unit == "N" || unit == "N s/m";
    if ((angular && !angle) || (linear && angle))
        source.fail(given.member->place, "dynamics." + given.member->name,
                    fmt::format("found a quantity in {} where the lift is {}; allowed: {}", unit,
                                angle ? "an angle" : "a length",
                                angle ? "kg m^2, N m/rad and N m" : "kg, N/mm and N"));
}

class DynamicsReader {
 public:
    DynamicsReader(const SceneSource& source, const Node& table, std::string_view path, bool angle)
        : source_(source), table_(table), path_(path), angle_(angle) {}

    [[nodiscard]] std::optional<double> find(std::string_view name) const {
        const std::optional<Given> given = SceneSource::find_in(table_, path_, name);
        if (!given) return std::nullopt;
        check_train_unit(source_, *given, angle_);
        return given->number();
    }
    [[nodiscard]] double mass() const {
        if (const auto mass = find("mass")) return *mass;
        if (const auto inertia = find("inertia")) return *inertia;
        source_.fail(table_.place, path_,
                     fmt::format("missing {}; allowed: a number > 0", angle_ ? "inertia_kg_m2" : "mass_kg"));
    }

 private:
    const SceneSource& source_;
    const Node& table_;
    std::string_view path_;
    bool angle_;
};

TrainStage read_stage(const SceneSource& source, const Node& table, bool angle) {
    const DynamicsReader reader(source, table, "dynamics.stage", angle);
    TrainStage stage;
    stage.mass = reader.mass();
    const std::optional<double> stiffness = reader.find("stiffness");
    if (!stiffness) source.fail(table.place, "dynamics.stage", "missing stiffness; allowed: a number > 0");
    stage.stiffness = *stiffness;
    stage.damping =
        2.0 * reader.find("damping_ratio").value_or(0.0) * std::sqrt(stage.stiffness * stage.mass);
    return stage;
}

}  // namespace

std::optional<DynamicsSpec> read_dynamics(const SceneSource& source, const MotionSpec& motion) {
    const Node* const table = source.table("dynamics");
    if (!table) return std::nullopt;
    const bool angle = motion.lift_is_angle;
    const DynamicsReader reader(source, *table, "dynamics", angle);
    DynamicsSpec spec;
    spec.mass = reader.mass();
    spec.natural_frequency = reader.find("natural_frequency");
    spec.stiffness = reader.find("stiffness");
    spec.damping_ratio = reader.find("damping_ratio");
    spec.damping = reader.find("damping");
    spec.return_stiffness = reader.find("return_spring").value_or(0.0);
    spec.preload = reader.find("preload").value_or(0.0);
    if (const auto range = source.find("dynamics", "speed_range")) {
        const auto& items = range->value().items;
        if (items.size() != 2)
            source.fail(range->value().place, "dynamics.speed_range",
                        fmt::format("found {} numbers; allowed: two speeds, the lower first", items.size()));
        spec.speed_range = {items[0].as_number() * range->spelling->factor,
                            items[1].as_number() * range->spelling->factor};
    }
    if (const auto stages = source.find("dynamics", "stage"))
        for (const Node& stage : stages->value().items)
            spec.stages.push_back(read_stage(source, stage, angle));
    return spec;
}

}  // namespace camopt::input
