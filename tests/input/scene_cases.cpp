// SPDX-License-Identifier: MIT
#include "tests/input/scene_cases.hpp"

#include "core/text/parsing.hpp"
#include "core/text/text_file.hpp"
#include "input/keys/scene_keys.hpp"
#include "tests/support/source_folder.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <stdexcept>

namespace camopt::input {
namespace scene_cases {

using Words = std::map<std::string, std::string>;

struct Line {
    std::string place, text;
};

struct Base {
    std::vector<std::string> lines;
    std::string table;
};

struct Section {
    std::vector<Base> scenes;
    std::vector<Line> lines;
};

[[noreturn]] void refuse(const Line& line, const std::string& why) {
    throw std::runtime_error(line.place + ": " + why + ": " + line.text);
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find(separator, from), text.size());
        parts.push_back(text.substr(from, to - from));
        from = to + separator.size();
    }
    return parts;
}

/// The text behind a word that the line holds; the line keeps what is before it.
std::string cut(std::string& line, const std::string& word) {
    const std::size_t at = line.find(word);
    if (at == std::string::npos) return {};
    const std::string rest = line.substr(at + word.size());
    line.resize(at);
    return rest;
}

std::string key_of(const std::string& line) {
    return line.substr(0, line.find(" = "));
}

std::vector<Line> lines_of(const std::filesystem::path& file) {
    std::vector<Line> lines;
    for (const std::string& text : split(read_text_file(file), "\n"))
        lines.push_back({file.filename().string() + ":" + std::to_string(lines.size() + 1), text});
    return lines;
}

std::vector<Section> sections_of(const std::filesystem::path& file) {
    std::map<std::string, Base> scenes = {{"nothing", {}}};
    const auto find = [&](const Line& line, const std::string& name) {
        const auto found = scenes.find(name);
        if (found == scenes.end()) refuse(line, "no scene '" + name + "'");
        return found->second;
    };
    std::vector<Section> sections;
    Base* open = nullptr;
    for (const Line& line : lines_of(file)) {
        std::string head = line.text;
        std::string own = head;
        if (head.empty()) {
            open = nullptr;
        } else if (head.starts_with("scene ")) {
            own = cut(head, ": ");
            const std::string table = cut(head, " for ");
            const std::string parent = cut(head, " from ");
            Base scene = parent.empty() ? Base{} : find(line, parent);
            if (!table.empty()) scene.table = table + ".";
            open = &(scenes[head.substr(6)] = scene);
        } else if (head.starts_with("on ")) {
            const std::string without = cut(head, " without ");
            Section& section = sections.emplace_back();
            for (const std::string& name : split(head.substr(3), ", ")) {
                Base scene = find(line, name);
                if (!without.empty())
                    for (const std::string& key : split(without, ", "))
                        if (std::erase_if(scene.lines, [&](const auto& one) { return key_of(one) == key; }) !=
                            1)
                            refuse(line, "not one '" + key + "' in the scene");
                section.scenes.push_back(scene);
            }
            continue;
        } else if (open == nullptr && !sections.empty()) {
            sections.back().lines.push_back(line);
        } else if (open == nullptr && !head.starts_with('#')) {
            refuse(line, "neither a scene nor a case");
        }
        if (open != nullptr && !own.empty())
            for (const std::string& one : split(std::string(trimmed(own)), " | ")) open->lines.push_back(one);
    }
    return sections;
}

const Words& words() {
    static const Words all = [] {
        Words found;
        std::string* open = nullptr;
        for (const Line& line : lines_of(source_folder() + "/tests/input/broken/words.txt")) {
            if (line.text.starts_with("words "))
                open = &found[line.text.substr(6)];
            else if (open != nullptr && !line.text.empty())
                *open += (open->empty() ? "" : " ") + line.text;
        }
        return found;
    }();
    return all;
}

/// The whole message: "s.toml:3:11: …".
std::string message_of(const Line& line, std::string error, int last_line, const std::string& setting) {
    for (const auto& [name, text] : words()) {
        const std::string mark = "<" + name + ">";
        for (std::size_t at = error.find(mark); at != std::string::npos; at = error.find(mark, at))
            error.replace(at, mark.size(), text);
    }
    static const std::regex place(R"(^ (?:(\d+):)?(\d+): )");
    std::smatch found;
    if (std::regex_search(error, found, place)) {
        const std::string in = found[1].matched ? found[1].str() : std::to_string(last_line);
        return "s.toml:" + in + ":" + found[2].str() + ": " + found.suffix().str();
    }
    if (error.starts_with(" --set ")) return error.substr(1);
    if (!error.starts_with(": ") || setting.empty()) refuse(line, "no place of the error");
    return "--set " + setting + error;
}

}  // namespace scene_cases

std::vector<std::filesystem::path> case_files(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".txt" && entry.path().stem() != "words")
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::vector<BrokenScene> broken_scenes(const std::filesystem::path& file) {
    using namespace scene_cases;
    static const std::regex line_feed(R"(\\n)");
    std::vector<BrokenScene> all;
    for (const Section& section : sections_of(file)) {
        const std::vector<std::string>& base = section.scenes.at(0).lines;
        std::vector<std::string> lines = base, settings;
        for (std::size_t k = 0; k < section.lines.size(); ++k) {
            std::string text = section.lines[k].text;
            const std::size_t at = text.find("# error");
            const std::string own(trimmed(text.substr(0, at)));
            for (const std::string& one : split(own, " | "))
                if (one.starts_with("--set "))
                    settings.push_back(std::regex_replace(one.substr(6), line_feed, "\n"));
                else if (!one.empty())
                    lines.push_back(one);
            if (at == std::string::npos) continue;
            std::string error = text.substr(at + 7);
            const Line& line = section.lines[k];
            while (k + 1 < section.lines.size() && section.lines[k + 1].text.starts_with("#   "))
                error += " " + section.lines[++k].text.substr(4);
            BrokenScene scene = {line.place, {}, settings, {}};
            for (const std::string& one : lines) scene.toml += (scene.toml.empty() ? "" : "\n") + one;
            scene.message = message_of(line, error, static_cast<int>(lines.size()),
                                       settings.empty() ? std::string() : settings.back());
            all.push_back(scene);
            lines = base;
            settings.clear();
        }
        if (lines.size() != base.size()) refuse(section.lines.back(), "a case without an error");
    }
    return all;
}

std::vector<AcceptedScene> accepted_scenes(const std::filesystem::path& file) {
    using namespace scene_cases;
    const auto match = [](const std::string& key) {
        const std::size_t dot = key.rfind('.');
        return dot == std::string::npos ? match_key("", key)
                                        : match_key(key.substr(0, dot), key.substr(dot + 1));
    };
    static const std::regex form(R"(^(?:([a-z0-9_]+): )?(.+) -> (?:([a-z_. ]+) = )?(.+)$)");
    std::vector<AcceptedScene> all;
    for (const Section& section : sections_of(file))
        for (const Base& base : section.scenes)
            for (const Line& line : section.lines) {
                std::string quantity = line.text;
                for (const std::string& one : split(cut(quantity, "  "), " | ")) {
                    std::smatch part;
                    if (!std::regex_match(one, part, form)) refuse(line, "no value and what it becomes");
                    const std::string key = quantity + (part[1].matched ? "_" + part[1].str() : "");
                    const std::string own = key + " = " + part[2].str();
                    AcceptedScene scene = {
                        line.place, base.table + key, {}, base.table + quantity, part[4].str()};
                    if (part[3].matched) scene.field = part[3].str();
                    const KeyRow* const row = match(scene.key).row;
                    if (row == nullptr) refuse(line, "no key '" + scene.key + "'");
                    bool marked = false;
                    for (std::string text : base.lines) {
                        if (const std::size_t mark = text.find('*'); mark != std::string::npos) {
                            text.replace(mark, 1, own);
                            marked = true;
                        } else if (match(key_of(text)).row == row) {
                            continue;
                        }
                        scene.toml += text + "\n";
                    }
                    if (!marked) scene.toml += own + "\n";
                    all.push_back(scene);
                }
            }
    return all;
}

const std::vector<AcceptedScene>& all_accepted_scenes() {
    static const std::vector<AcceptedScene> all = [] {
        std::vector<AcceptedScene> found;
        for (const auto& file : case_files(source_folder() + "/tests/input/accepted"))
            for (const AcceptedScene& one : accepted_scenes(file)) found.push_back(one);
        return found;
    }();
    return all;
}

}  // namespace camopt::input
