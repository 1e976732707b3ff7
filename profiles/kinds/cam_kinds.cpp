// SPDX-License-Identifier: MIT
#include "profiles/kinds/cam_kinds.hpp"

#include "core/errors.hpp"
#include "core/open_registry.hpp"
#include "profiles/kinds/kind_rows.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

struct NoMaker {};
using Kinds = OpenRegistry<CamKind, NoMaker>;

Kinds& kinds() {
    static Kinds all(&CamKind::type, {kind_rows::All::kinds(), {}});
    return all;
}

[[noreturn]] void refuse_kind(const CamKind& kind, const std::string& found, const std::string& allowed) {
    throw InputError(fmt::format("add_cam_kind: \"{}\": found {}; allowed: {}", kind.type, found, allowed));
}

}  // namespace

std::span<const CamKind> cam_kinds() {
    return kinds().descriptions();
}

void add_cam_kind(CamKind kind) {
    if (kind.variants.empty()) refuse_kind(kind, "no variant", "at least one");
    for (const CamVariant& variant : kind.variants)
        if (!variant.spec)
            refuse_kind(kind, fmt::format("the variant \"{}\" without a spec", variant.word), "one for each");
    if (!kind.formulas) refuse_kind(kind, "no formulas", "a function that makes a CamMechanism of a spec");
    const std::string type = kind.type;
    const auto refuse_type = [&] {
        throw InputError(
            fmt::format("add_cam_kind: found the type \"{}\"; allowed: one that no other kind has: not {}",
                        type, quoted_choices(cam_types())));
    };
    if (type.empty()) refuse_type();
    kinds().add(std::move(kind), {}, refuse_type);
}

const CamKind* cam_kind(std::string_view type) {
    const auto found = std::ranges::find(cam_kinds(), type, &CamKind::type);
    return found == cam_kinds().end() ? nullptr : &*found;
}

std::vector<std::string_view> cam_types() {
    std::vector<std::string_view> types;
    for (const CamKind& kind : cam_kinds()) types.emplace_back(kind.type);
    return types;
}

}  // namespace camopt
