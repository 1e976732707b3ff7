// SPDX-License-Identifier: MIT
#include "input/scene_reader.hpp"

#include "core/errors.hpp"
#include "core/range.hpp"
#include "core/units.hpp"
#include "input/key_check.hpp"
#include "input/overrides.hpp"
#include "input/peak_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

namespace camopt::input {
namespace {

/// Turns a file whose keys have been checked into a Scene; what is absent keeps the default of
/// core/scene.hpp.
class SceneReader {
 public:
    SceneReader(const SceneSource& source, const KnownNames& known) : source_(source), known_(known) {}

    Scene read() const {
        Scene scene;
        read_text("", "title", scene.title);
        scene.motion = read_motion();
        scene.spline = read_spline();
        scene.objective = read_objective();
        scene.limits = read_limits(source_, scene.motion);
        scene.solver = read_solver();
        if (const std::optional<SceneFault> fault = find_fault(scene))
            source_.fail_member(fault->member,
                                fmt::format("found {}; allowed: {}", fault->found, fault->allowed));
        return scene;
    }

 private:
    const SceneSource& source_;
    const KnownNames& known_;

    void read_text(std::string_view table, std::string_view name, std::string& target) const {
        if (const auto given = source_.find(table, name)) target = given->value().text;
    }

    void read_number(std::string_view table, std::string_view name, double& target) const {
        target = source_.number(table, name).value_or(target);
    }

    template <typename Integer>
    void read_integer(std::string_view table, std::string_view name, Integer& target) const {
        if (const auto given = source_.find(table, name))
            target = static_cast<Integer>(given->value().integer);
    }

    /// The value of `values` whose name_of is the text.
    template <typename Choice>
    void read_choice(std::string_view table, std::string_view name, std::initializer_list<Choice> values,
                     Choice& target) const {
        const auto given = source_.find(table, name);
        if (!given) return;
        for (const Choice value : values)
            if (given->value().text == name_of(value)) target = value;
    }

    MotionSpec read_motion() const {
        MotionSpec motion;
        read_choice("motion", "type", {MotionType::drd, MotionType::rr}, motion.type);
        if (const auto lift = source_.find("motion", "lift")) {
            motion.lift = lift->number();
            motion.lift_is_angle = lift->spelling->unit == "deg" || lift->spelling->unit == "rad";
        }
        read_number("motion", "rise", motion.rise);
        motion.return_angle = source_.number("motion", "return");
        motion.speed = source_.number("motion", "speed");
        if (const auto symmetric = source_.find("motion", "symmetric"))
            motion.symmetric = symmetric->value().boolean;
        if (const auto via = source_.find("motion", "via"))
            for (const Node& point : via->value().items) motion.via.push_back(read_point(point));
        check_turn(motion);
        return motion;
    }

    static SetPoint read_point(const Node& table) {
        const auto number = [&](std::string_view name) {
            const auto given = SceneSource::find_in(table, "motion.via", name);
            return given ? std::optional(given->number()) : std::nullopt;
        };
        return {.at = number("at").value_or(0.0),
                .displacement = number("displacement"),
                .velocity = number("velocity"),
                .acceleration = number("acceleration")};
    }

    /// core/ checks this too, but in radians.
    void check_turn(const MotionSpec& motion) const {
        if (motion.type != MotionType::rr) return;
        auto given = source_.find("motion", "return");
        if (!given) given = source_.find("motion", "rise");
        if (!given) return;
        const double factor = given->spelling->factor;
        const double total = (motion.rise + motion.return_angle.value_or(motion.rise)) / factor;
        const Range allowed = Range::above_up_to(0.0, 360.0).scaled(units::degree / factor);
        if (!allowed.contains(total))
            source_.fail(
                given->value().place, joined_key("motion", given->member->name),
                fmt::format("found {0}, together {1:.10g} {2} of rise and return; allowed: a whole turn, "
                            "{3:.10g} {2}, at most",
                            given->value().shown(), total, given->spelling->unit, allowed.high));
    }

    SplineSpec read_spline() const {
        SplineSpec spline;
        read_integer("spline", "degree", spline.degree);
        read_integer("spline", "segments", spline.segments);
        if (const auto breakpoints = source_.find("spline", "breakpoints")) {
            for (const Node& item : breakpoints->value().items)
                spline.breakpoints.push_back(item.as_number());
            if (spline.breakpoints.size() < 2)
                source_.fail(breakpoints->value().place, "spline.breakpoints",
                             "found fewer than 2 breakpoints; allowed: 2 to 65537");
        }
        if (const auto continuity = source_.find("spline", "continuity"))
            spline.continuity = static_cast<int>(continuity->value().integer);
        read_choice("spline", "end_jerk", {EndJerk::free, EndJerk::zero}, spline.end_jerk);
        read_choice(
            "spline", "design",
            {DesignKind::automatic, DesignKind::ordinates, DesignKind::coefficients, DesignKind::states},
            spline.design);
        return spline;
    }

    ObjectiveSpec read_objective() const {
        ObjectiveSpec objective;
        read_number("objective", "velocity", objective.velocity);
        read_number("objective", "acceleration", objective.acceleration);
        read_number("objective", "jerk", objective.jerk);
        read_number("objective", "rms_acceleration", objective.rms_acceleration);
        read_number("objective", "rms_jerk", objective.rms_jerk);
        objective.reference = read_reference();
        read_choice("objective", "tie_break", {TieBreak::none, TieBreak::rms_jerk}, objective.tie_break);
        return objective;
    }

    Reference read_reference() const {
        Reference reference;
        const auto given = source_.find("objective", "reference");
        if (!given) return reference;
        if (given->value().kind == NodeKind::text) {
            check_name(*given, known_.laws, "a law of the catalogue: ", ", or a table of numbers");
            reference.law = given->value().text;
            return reference;
        }
        constexpr std::string_view table = "objective.reference";
        reference.numeric = true;
        reference.velocity = source_.number(table, "velocity");
        reference.acceleration = source_.number(table, "acceleration");
        reference.jerk = source_.number(table, "jerk");
        reference.rms_acceleration = source_.number(table, "rms_acceleration");
        reference.rms_jerk = source_.number(table, "rms_jerk");
        return reference;
    }

    SolverSpec read_solver() const {
        SolverSpec solver;
        if (const auto given = source_.find("solver", "name"); given && given->value().text != "auto") {
            std::vector<std::string> solvers = {"auto"};
            solvers.insert(solvers.end(), known_.solvers.begin(), known_.solvers.end());
            check_name(*given, solvers, "", "");
            solver.name = given->value().text;
        }
        read_number("solver", "tolerance", solver.tolerance);
        read_number("solver", "gap", solver.gap);
        read_number("solver", "max_seconds", solver.max_seconds);
        if (const auto starts = source_.find("solver", "starts"))
            solver.starts = static_cast<int>(starts->value().integer);
        read_integer("solver", "seed", solver.seed);
        if (const auto options = source_.find("solver", "options"))
            for (const Member& option : options->value().members)
                solver.options.emplace(option.name, option_value(option.value));
        return solver;
    }

    static OptionValue option_value(const Node& node) {
        if (node.kind == NodeKind::boolean) return node.boolean;
        if (node.kind == NodeKind::integer) return node.integer;
        if (node.kind == NodeKind::number) return node.number;
        return node.text;
    }

    void check_name(const Given& given, const std::vector<std::string>& names, std::string_view before,
                    std::string_view after) const {
        const std::string& text = given.value().text;
        if (std::ranges::find(names, text) != names.end()) return;
        std::string list;
        for (const std::string& name : names) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
        source_.fail(given.value().place, joined_key(given.row->table, given.member->name),
                     fmt::format("found {}; allowed: {}{}{}{}", given.value().shown(), before, list, after,
                                 spelling_hint(text, names)));
    }
};

}  // namespace

Scene read_scene(std::string_view toml, std::string_view source_name, const KnownNames& known,
                 std::span<const std::string> overrides) {
    SceneSource source{.name = std::string(source_name), .root = parse_document(toml, source_name)};
    apply_overrides(source.root, overrides);
    check_keys(source);
    return SceneReader(source, known).read();
}

Scene read_scene_file(const std::filesystem::path& path, const KnownNames& known,
                      std::span<const std::string> overrides) {
    const std::string name = path.string();
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw InputError(name + ": found a directory; allowed: a scene file in TOML");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw InputError(fmt::format("{}: cannot be read: {}; allowed: a scene file in TOML", name,
                                     std::generic_category().message(errno)));
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) throw InputError(name + ": reading stopped with an error; allowed: a scene file in TOML");
    return read_scene(text, name, known, overrides);
}

}  // namespace camopt::input
