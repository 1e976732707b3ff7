// SPDX-License-Identifier: MIT
#include "input/scene_reader.hpp"

#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "input/scene_parts.hpp"
#include "profiles/kinds/cam_kinds.hpp"

#include <fmt/format.h>

#include <system_error>

namespace camopt::input {

namespace {

// A scene with a breakpoint in every micrometre of a metre is smaller.
constexpr std::uintmax_t most_scene_bytes = std::uintmax_t{1} << 28U;

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
