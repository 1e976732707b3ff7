// SPDX-License-Identifier: MIT
#include "apps/studio/studio_page.hpp"
#include "core/errors.hpp"
#include "core/text/list_text.hpp"
#include "core/text/text_file.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "report/view/cam_words.hpp"
#include "studies/least/least_value.hpp"

#include <fmt/format.h>

#include <cctype>

namespace camopt::apps {

namespace {

using Json = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) {
            return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
        };
        const unsigned group = byte(0) << 16U | byte(1) << 8U | byte(2);
        for (const unsigned shift : {18U, 12U, 6U, 0U}) text += digits[group >> shift & 63U];
    }
    const std::size_t missing = (3 - bytes.size() % 3) % 3;
    return text.replace(text.size() - missing, missing, missing, '=');
}

/// The comment that begins the file, or follows its title.
std::string comment_of(std::string_view text) {
    std::string words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.starts_with('#')) {
            if (words.empty() && line.starts_with("title")) continue;
            break;
        }
        line.remove_prefix(std::min(line.find_first_not_of("# "), line.size()));
        append_item(words, line, " ");
    }
    return words;
}

std::string kind_of_motion(const MotionSpec& motion) {
    if (motion.valve) return "a valve lobe";
    switch (motion.type) {
        case MotionType::program:
            return fmt::format("a program of {} segments", motion.segments.size());
        case MotionType::drd:
            return "rise between two dwells";
        case MotionType::rr:
            return "rise and return without a dwell at the top";
    }
    throw ModelError("this motion has no name");
}

/// "Rise between two dwells", "Translating roller".
std::string kind_words(const Scene& scene) {
    std::string words = scene.cam ? cam_text(*scene.cam) : kind_of_motion(scene.motion);
    words.erase(std::min(words.find(','), words.size()));
    if (words.ends_with(" flat")) words += " face";
    if (words.ends_with(" knife")) words += " edge";
    return capitalised(scene.drive ? words + ", servo axis" : words);
}

constexpr std::array groups = {"Motions",       "Programs",    "Plane cams",
                               "Cams in space", "Valve lobes", "Servo axes"};

const char* group_of(const Scene& scene) {
    if (scene.motion.valve) return groups[4];
    if (scene.cam) return groups[cam_kind(scene.cam->type)->gives(CamOutput::outline) ? 2 : 3];
    if (scene.drive) return groups[5];
    return groups[scene.motion.type == MotionType::program ? 1 : 0];
}

/// Displacement in percent of its range, at equal steps. Empty without a motion, and of a search that takes
/// long.
Json curve_of(const Scene& given) {
    constexpr int steps = 40;
    constexpr double seconds = 120.0, full = 100.0;
    Scene scene = given;
    scene.solver.starts = 1;
    SolveControl control;
    control.deadline = Deadline::after(seconds);
    const Solution solution = solve_asked(scene, control, nullptr, {.look = true});
    if (!solution.motion || control.deadline.was_felt()) return Json::array();
    const Motion& motion = *solution.motion;
    std::array<double, steps + 1> heights{};
    for (int i = 0; i <= steps; ++i)
        heights[static_cast<std::size_t>(i)] =
            motion.at(motion.begin() + (motion.end() - motion.begin()) * i / steps).derivative[0];
    const auto [low, high] = std::ranges::minmax(heights);
    Json curve = Json::array();
    for (const double height : heights)
        curve.push_back(high > low ? std::lround(full * (height - low) / (high - low)) : 0);
    return curve;
}

Json example_of(const std::filesystem::path& file) {
    const std::string text = read_text_file(file);
    const Scene scene = studio_scene(text, Json::object(), file.filename().string()).scene;
    return {{"name", file.stem().string()},
            {"title", scene.title.empty() ? file.stem().string() : scene.title},
            {"kind", kind_words(scene)},
            {"group", group_of(scene)},
            {"words", comment_of(text)},
            {"curve", curve_of(scene)},
            {"scene", text}};
}

/// drd_cubic_4 before drd_cubic_10.
bool comes_before(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto key = [](const std::filesystem::path& file) {
        const std::string name = file.stem().string();
        const std::size_t digits = name.find_last_not_of("0123456789") + 1;
        return std::tuple(name.substr(0, digits), name.size(), name);
    };
    return key(a) < key(b);
}

/// "…; 0.03 s in all." is of the machine that makes the page.
std::string without_times(std::string answer) {
    constexpr std::string_view words = " s in all.";
    for (std::size_t end = 0; (end = answer.find(words, end)) != std::string::npos;) {
        const std::size_t begin = answer.rfind(';', end);
        answer.replace(begin, end + words.size() - begin, ".");
        end = begin;
    }
    return answer;
}

}  // namespace

std::string make_offline_page(std::string_view engine, std::string_view licenses,
                              const std::filesystem::path& scenes,
                              const std::function<void(const std::string&)>& left_out) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(scenes, error))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    if (files.empty()) throw InputError(fmt::format("{}: found no scenes (*.toml)", scenes.string()));
    std::ranges::sort(files, comes_before);
    std::vector<Json> examples;
    for (const std::filesystem::path& file : files) {
        try {
            examples.push_back(example_of(file));
        } catch (const InputError& fault) {
            left_out(fault.what());
        }
    }
    std::ranges::stable_sort(examples, {}, [](const Json& one) {
        return std::ranges::find(groups, one["group"].get<std::string>()) - groups.begin();
    });
    const StudioStart start = first_scene();
    Json answer = Json::parse(without_times(StudioSession().first(start.scene)));
    answer["seconds"] = 0.0;
    PageHtml html = studio_html(start, answer.dump());
    html.title = "camopt";
    for (const char* const name : {"offline.js", "wasi.js"})
        html.scripts.emplace(html.scripts.begin(), studio_asset(name));
    html.blocks = {{"opening-scene", "null"}, {"examples", Json(examples).dump()}};
    html.licenses = licenses;
    html.engine = base64(engine);
    return page_html(html);
}

}  // namespace camopt::apps
