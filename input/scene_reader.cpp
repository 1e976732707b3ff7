// SPDX-License-Identifier: MIT
#include "input/scene_reader.hpp"

#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "input/scene_parts.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "scene/cost_table.hpp"

#include <fmt/format.h>

#include <system_error>

namespace camopt::input {

namespace {

// The [drawing] table. Internal to input/.

std::optional<Keyway> read_keyway(const SceneSource& source) {
    constexpr std::string_view table = "drawing.keyway";
    if (!source.table(table)) return std::nullopt;
    Keyway keyway;
    source.read_number(table, "width", keyway.width);
    source.read_number(table, "depth", keyway.depth);
    source.read_number(table, "at", keyway.at);
    return keyway;
}

std::optional<DrawingSpec> read_drawing(const SceneSource& source) {
    if (!source.table("drawing")) return std::nullopt;
    DrawingSpec drawing;
    drawing.bore = source.number("drawing", "bore");
    drawing.keyway = read_keyway(source);
    drawing.thickness = source.number("drawing", "thickness");
    drawing.groove_depth = source.number("drawing", "groove_depth");
    source.read_number("drawing", "datum", drawing.datum);
    const auto words = [&](std::string_view name, std::string& target) {
        if (const auto given = source.find("drawing.title_block", name)) target = given->value().text;
    };
    TitleBlock& title = drawing.title_block;
    words("part", title.part);
    words("material", title.material);
    words("tolerance", title.tolerance);
    words("drawn_by", title.drawn_by);
    words("organisation", title.organisation);
    words("number", title.number);
    words("revision", title.revision);
    words("date", title.date);
    words("surface_finish", title.surface_finish);
    words("profile_tolerance", title.profile_tolerance);
    words("bore_fit", title.bore_fit);
    words("keyway_tolerance", title.keyway_tolerance);
    drawing.density = source.number("drawing", "density");
    source.read_choice("drawing", "projection", {Projection::first_angle, Projection::third_angle},
                       drawing.projection);
    return drawing;
}

// A scene with a breakpoint in every micrometre of a metre is smaller.
constexpr std::uintmax_t most_scene_bytes = std::uintmax_t{1} << 28U;

/// Converts a file with validated keys to a Scene; missing keys have the default of scene/scene.hpp.
class SceneReader {
 public:
    SceneReader(const SceneSource& source, const KnownNames& known) : source_(source), known_(known) {}

    Scene read() const {
        Scene scene;
        read_text("", "title", scene.title);
        scene.length_unit = written_length_unit();
        scene.written = written_spellings();
        scene.motion = read_motion(source_, known_);
        scene.spline = read_spline();
        if (!source_.table("objective") && !scene.motion.prescribed() && !is_nearest())
            source_.fail({}, "objective", "missing; allowed: a [objective] table");
        scene.objective = read_objective();
        scene.cam = read_cam(source_, scene.motion, known_);
        scene.forces = read_forces(source_, scene);
        if (scene.cam && scene.cam->face_radius && scene.forces && scene.forces->contact_width)
            scene.cam->set_round_face(*scene.cam->face_radius, *scene.forces->contact_width);
        scene.limits = read_peak_limits(source_, scene.motion);
        read_cam_limits(source_, scene, scene.limits);
        scene.drawing = read_drawing(source_);
        scene.dynamics = read_dynamics(source_, scene.motion);
        scene.drive = read_drive(source_, scene.motion);
        scene.solver = read_solver();
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

    void read_text(std::string_view table, std::string_view name, std::string& target) const {
        if (const auto given = source_.find(table, name)) target = given->value().text;
    }

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

    /// Scene::written.
    std::map<std::string, Spelling> written_spellings() const {
        std::map<std::string, Spelling> all;
        for (const KeyRow& row : scene_keys())
            if (const auto given = source_.find(row.table, row.name))
                all[joined_key(row.table, row.name)] = *given->spelling;
        if (const auto segments = source_.find("motion", "segments"))
            for (std::size_t i = 0; i < segments->value().items.size(); ++i)
                if (const auto angle =
                        SceneSource::find_in(segments->value().items[i], "motion.segments", "angle"))
                    all[fmt::format("motion.segments[{}].angle", i)] = *angle->spelling;
        return all;
    }

    SplineSpec read_spline() const {
        SplineSpec spline;
        source_.read_integer("spline", "degree", spline.degree);
        source_.read_integer("spline", "segments", spline.segments);
        if (const auto breakpoints = source_.find("spline", "breakpoints")) {
            for (const Node& item : breakpoints->value().items)
                spline.breakpoints.push_back(item.as_number());
            if (spline.breakpoints.size() < 2)
                source_.fail(breakpoints->value().place, "spline.breakpoints",
                             "found fewer than 2 breakpoints; allowed: 2 to 65537");
        } else {
            spline.by_stroke = !source_.find("spline", "segments");
        }
        if (const auto continuity = source_.find("spline", "continuity"))
            spline.continuity = static_cast<int>(continuity->value().integer);
        if (const auto knots = source_.find("spline", "knots"))
            spline.free_knots = knots->value().text == "free";
        source_.read_choice("spline", "end_jerk", {EndJerk::free, EndJerk::zero}, spline.end_jerk);
        source_.read_choice(
            "spline", "design",
            {DesignKind::automatic, DesignKind::ordinates, DesignKind::coefficients, DesignKind::states},
            spline.design);
        return spline;
    }

    bool is_nearest() const {
        const auto use = source_.find("measured", "use");
        return use && use->value().text == "nearest";
    }

    /// measured.use = "nearest" is a weight; one that is given stays.
    void weigh_deviation(Scene& scene) const {
        const auto norm = source_.find("measured", "norm");
        ObjectiveSpec& objective = scene.objective;
        if (!is_nearest() || objective.deviation > 0.0 || objective.deviation_rms > 0.0) return;
        (norm && norm->value().text == "rms" ? objective.deviation_rms : objective.deviation) = 1.0;
    }

    ObjectiveSpec read_objective() const {
        ObjectiveSpec objective;
        for (const CostTerm& term : cost_terms())
            source_.read_number("objective", term.name(), objective.*term.weight);
        for (const ResponseTerm& term : response_terms())
            source_.read_number("objective", term.name, objective.*term.weight);
        for (int i = 0; i < dimension_count; ++i)
            source_.read_number("objective", name_of(static_cast<DimensionIndex>(i)),
                                objective.dimensions[i]);
        objective.reference = read_reference();
        source_.read_choice("objective", "tie_break", std::span<const TieBreak>(tie_breaks),
                            objective.tie_break);
        return objective;
    }

    Reference read_reference() const {
        Reference reference;
        const auto given = source_.find("objective", "reference");
        if (!given) return reference;
        if (given->value().kind == NodeKind::text) {
            std::vector<std::string> laws = known_.laws;  // a rise without rest has no separate peaks
            for (const std::string& moving : known_.moving_laws) std::erase(laws, moving);
            check_name(source_, *given, "objective.reference",
                       {laws, "a law of the catalogue: ", ", or a table of numbers"});
            reference.law = given->value().text;
            return reference;
        }
        constexpr std::string_view table = "objective.reference";
        reference.numeric = true;
        for (const CostTerm& term : cost_terms())
            reference.*term.reference = source_.number(table, term.name());
        for (const ResponseTerm& term : response_terms())
            reference.*term.reference = source_.number(table, term.name);
        return reference;
    }

    SolverSpec read_solver() const {
        SolverSpec solver;
        if (const auto given = source_.find("solver", "name"); given && given->value().text != "auto") {
            std::vector<std::string> solvers = {"auto"};
            solvers.insert(solvers.end(), known_.solvers.begin(), known_.solvers.end());
            check_name(source_, *given, "solver.name", {solvers});
            solver.name = given->value().text;
        }
        source_.read_number("solver", "tolerance", solver.tolerance);
        if (source_.find("solver", "gap")) {
            solver.gap = 0.0;
            source_.read_number("solver", "gap", *solver.gap);
        }
        source_.read_number("solver", "max_seconds", solver.max_seconds);
        source_.read_number("solver", "explain_seconds", solver.explain_seconds);
        source_.read_integer("solver", "explain_changes", solver.explain_changes);
        if (const auto starts = source_.find("solver", "starts"))
            solver.starts = static_cast<int>(starts->value().integer);
        source_.read_integer("solver", "seed", solver.seed);
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
};

/// No effect for a number without a key, or for a duplicate.
void add_key(FollowerKind& kind, const CamNumber& number) {
    const KeyRow* const row = number.owned ? find_row(number.table, number.key) : nullptr;
    if (!row) return;
    const std::string key = row->key(row->spellings.front());
    const std::string written = row->table == "cam" ? key : fmt::format("{}.{}", row->table, key);
    if (std::ranges::find(kind.keys, written) == kind.keys.end()) kind.keys.push_back(written);
}

SceneSource source_of(std::string_view toml, std::string_view name, std::span<const std::string> overrides) {
    SceneSource source{.name = std::string(name), .root = parse_document(toml, name)};
    apply_overrides(source.root, overrides);
    return source;
}

}  // namespace

Scene read_document(const SceneSource& source, const KnownNames& known) {
    check_keys(source);
    return SceneReader(source, known).read();
}

Scene read_scene(std::string_view toml, std::string_view source_name, const KnownNames& known,
                 std::span<const std::string> overrides) {
    return read_document(source_of(toml, source_name, overrides), known);
}

void fail_in_scene(const SceneOrigin& origin, std::string_view member, std::string_view what) {
    source_of(origin.toml, origin.name, origin.overrides).fail_member(member, what);
}

std::string scene_with_overrides(std::string_view toml, std::string_view source_name,
                                 std::span<const std::string> overrides,
                                 const std::optional<std::filesystem::path>& folder) {
    // A text without the word names no table, and need not be parsed.
    const bool names_table = folder && toml.find("measured") != std::string_view::npos;
    if (overrides.empty() && !names_table && printable_lines(toml) == toml) return std::string(toml);
    Node root = parse_document(toml, source_name);
    apply_overrides(root, overrides);
    if (folder) {
        const Node before = root;
        write_out_tables(root, *folder);
        const bool same = document_text(before) == document_text(root);
        if (same && overrides.empty() && printable_lines(toml) == toml) return std::string(toml);
    }
    std::string origin = printable(source_name);
    for (const std::string& text : overrides) origin += " --set " + printable(text);
    return fmt::format("# {}\n{}", origin, document_text(root));
}

std::string scene_file_text(const std::filesystem::path& path) {
    const std::string name = path.string();
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw InputError(name + ": found a directory; allowed: a scene file in TOML");
    FileBytes file = file_bytes(path, most_scene_bytes);
    if (!file.fault.empty())
        throw InputError(
            fmt::format("{}: cannot be read: {}; allowed: a scene file in TOML", name, file.fault));
    return std::move(file.bytes);
}

std::string whole_scene_text(const std::filesystem::path& path) {
    return scene_with_overrides(scene_file_text(path), path.string(), {}, path.parent_path());
}

Scene read_scene_file(const std::filesystem::path& path, const KnownNames& known,
                      std::span<const std::string> overrides) {
    KnownNames with_folder = known;
    with_folder.folder = path.parent_path();
    return read_scene(scene_file_text(path), path.string(), with_folder, overrides);
}

std::vector<FollowerKind> follower_kinds() {
    std::vector<FollowerKind> all;
    for (const CamKind& cam : cam_kinds())
        for (const CamVariant& variant : cam.variants) {
            FollowerKind kind{cam.type, {}, variant.word, variant.swings, variant.touches_with, {}};
            if (!cam.choosing_key.empty())
                kind.chosen_by = fmt::format("{}.{}", cam.choosing_table, cam.choosing_key);
            for (const CamNumber& number : variant.numbers) add_key(kind, number);
            all.push_back(std::move(kind));
        }
    return all;
}

}  // namespace camopt::input
