// SPDX-License-Identifier: MIT
#include "input/machine/machine_reader.hpp"

#include "input/document/document.hpp"
#include "input/keys/scene_keys.hpp"
#include "input/scene_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>

namespace camopt::input {

namespace {

struct Key {
    std::string_view name;
    std::span<const Spelling> units = spellings::plain;
    bool required = false;
};
using Keys = std::span<const Key>;

constexpr std::array root_keys = {Key{"title"}, Key{"machine", spellings::plain, true},
                                  Key{"axis", spellings::plain, true}, Key{"clearance"}};
constexpr std::array machine_keys = {Key{"speed", spellings::speed}};
constexpr std::array range_keys = {Key{"min", spellings::plain, true}, Key{"max", spellings::plain, true}};
constexpr std::array axis_keys = {Key{"name", spellings::plain, true}, Key{"scene", spellings::plain, true},
                                  Key{"phase", spellings::angle}};
constexpr std::array clearance_keys = {Key{"between", spellings::plain, true}, Key{"factors"},
                                       Key{"at_least", spellings::lift}, Key{"from", spellings::angle},
                                       Key{"to", spellings::angle}};

std::vector<std::string> written_names(Keys keys) {
    std::vector<std::string> names;
    for (const Key& key : keys)
        for (const Spelling& unit : key.units) names.push_back(fmt::format("{}{}", key.name, unit.suffix));
    return names;
}

std::string joined(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

class MachineReader {
 public:
    MachineReader(const std::filesystem::path& file, std::span<const std::string> settings)
        : file_(file), name_(file.string()), root_(parse_document(scene_file_text(file), name_)) {
        std::vector<std::string> own;
        for (const std::string& setting : settings) {
            const std::string name = setting.substr(0, setting.find_first_of(".="));
            if (is_axis(name) && setting[name.size()] == '.')
                of_axes_.emplace_back(name, setting.substr(name.size() + 1));
            else
                own.push_back(setting);
        }
        apply_overrides(root_, own);
    }

    MachineSpec read(const AxisLoader& load) const {
        check(root_, root_keys, "");
        MachineSpec machine;
        if (const Member* title = root_.find("title")) machine.title = text(*title, "title");
        read_speed(machine);
        each("axis", axis_keys,
             [&](const Node& node, const std::string& path) { machine.axes.push_back(axis(node, path)); });
        if (const std::optional<SceneFault> fault = find_name_fault(machine)) fail(machine, *fault);
        each("clearance", clearance_keys, [&](const Node& node, const std::string& path) {
            machine.clearances.push_back(clearance(node, path, machine));
        });
        for (AxisSpec& axis : machine.axes) {
            for (const auto& [name, setting] : of_axes_)
                if (name == axis.name) axis.settings.push_back(setting);
            axis.scene = load(axis.file, all_settings(axis, machine));
        }
        if (const std::optional<SceneFault> fault = find_fault(machine)) fail(machine, *fault);
        check_units(machine);
        return machine;
    }

    /// A member of an axis's scene is reported in its file.
    [[noreturn]] void fail(const MachineSpec& machine, const SceneFault& fault) const {
        const std::string what = words_of(fault), &member = fault.member;
        const std::size_t scene = member.find("].scene.");
        if (member.starts_with("axis[") && scene != std::string::npos) {
            std::size_t index = 0;
            std::from_chars(member.data() + 5, member.data() + scene, index);
            const AxisSpec& axis = machine.axes.at(index);
            const std::vector<std::string> settings = all_settings(axis, machine);
            const std::string toml = scene_file_text(axis.file);
            fail_in_scene({toml, axis.file, settings}, std::string_view(member).substr(scene + 8), what);
        }
        const Node* node = &root_;
        Place place;
        for (std::string_view rest = member; node && !rest.empty();) {
            const std::size_t dot = rest.find('.'), bracket = rest.substr(0, dot).find('[');
            const std::string_view name = rest.substr(0, std::min(dot, bracket));
            const auto found = std::ranges::find_if(node->members, [&](const Member& one) {
                return one.name == name || (one.name.starts_with(name) && one.name[name.size()] == '_');
            });
            if (found == node->members.end()) break;
            node = &found->value;
            if (bracket != std::string_view::npos) {
                std::size_t index = 0;
                std::from_chars(rest.data() + bracket + 1, rest.data() + rest.size(), index);
                if (index < node->items.size()) node = &node->items[index];
            }
            place = node->place;
            rest = dot == std::string_view::npos ? std::string_view() : rest.substr(dot + 1);
        }
        fail(place, member, what);
    }

 private:
    const std::filesystem::path& file_;
    std::string name_;
    Node root_;
    std::vector<std::pair<std::string, std::string>> of_axes_;  ///< axis, setting of its scene

    [[nodiscard]] bool is_axis(const std::string& name) const {
        const Member* const axes = root_.find("axis");
        return axes != nullptr && std::ranges::find(root_keys, name, &Key::name) == root_keys.end() &&
               std::ranges::any_of(axes->value.items, [&](const Node& axis) {
                   const Member* const own = axis.kind == NodeKind::table ? axis.find("name") : nullptr;
                   return own != nullptr && own->value.kind == NodeKind::text && own->value.text == name;
               });
    }
    [[nodiscard]] static std::vector<std::string> all_settings(const AxisSpec& axis,
                                                               const MachineSpec& machine) {
        std::vector<std::string> all = axis.settings;
        all.push_back(speed_setting(machine.least_speed));
        return all;
    }

    [[noreturn]] void fail(const Place& place, std::string_view key, std::string_view what) const {
        throw PlacedError(place, error_prefix(name_, place, key) + std::string(what));
    }
    [[noreturn]] void refuse(const Node& node, const std::string& key, std::string_view allowed) const {
        fail(node.place, key, fmt::format("found {}; allowed: {}", node.shown(), allowed));
    }

    /// Unknown and missing keys, and two spellings of a quantity.
    void check(const Node& node, Keys keys, const std::string& path) const {
        const std::vector<std::string> allowed = written_names(keys);
        for (const Member& member : node.members)
            if (std::ranges::find(allowed, member.name) == allowed.end())
                fail(member.place, joined(path, member.name),
                     fmt::format("found an unknown key; allowed: {}{}", fmt::join(allowed, ", "),
                                 spelling_hint(member.name, allowed)));
        for (const Key& key : keys) {
            std::vector<const Member*> written;
            for (const Member& member : node.members)
                if (find(member, key)) written.push_back(&member);
            if (written.size() > 1)
                fail(written[1]->place, joined(path, written[1]->name),
                     fmt::format("found together with {}, which means the same; allowed: only one of the two",
                                 joined(path, written[0]->name)));
            if (key.required && written.empty())
                fail(node.place, joined(path, key.name), "missing; allowed: a value");
        }
    }

    template <typename Visit>
    void each(const char* name, Keys keys, const Visit& visit) const {
        const Member* const list = root_.find(name);
        if (!list) return;
        const std::string allowed = fmt::format("tables [[{}]]", name);
        if (list->value.kind != NodeKind::array) refuse(list->value, name, allowed);
        for (std::size_t i = 0; i < list->value.items.size(); ++i) {
            const std::string path = fmt::format("{}[{}]", name, i);
            const Node& item = list->value.items[i];
            if (item.kind != NodeKind::table) refuse(item, path, allowed);
            check(item, keys, path);
            visit(item, path);
        }
    }

    [[nodiscard]] std::string text(const Member& member, const std::string& key) const {
        if (member.value.kind != NodeKind::text) refuse(member.value, key, "a text");
        return member.value.text;
    }
    [[nodiscard]] double number(const Node& node, const std::string& key) const {
        if (!node.is_number()) refuse(node, key, "a number");
        return node.as_number();
    }

    /// A quantity in one of its spellings.
    struct Written {
        const Member* member;
        const Spelling* spelling;
    };
    static std::optional<Written> find(const Member& member, const Key& key) {
        for (const Spelling& unit : key.units)
            if (member.name == fmt::format("{}{}", key.name, unit.suffix)) return Written{&member, &unit};
        return {};
    }
    static std::optional<Written> find(const Node& table, const Key& key) {
        for (const Member& member : table.members)
            if (const auto found = find(member, key)) return found;
        return {};
    }
    void read_angle(const Node& table, const std::string& path, const char* quantity, double& target) const {
        if (const auto found = find(table, {quantity, spellings::angle}))
            target =
                number(found->member->value, joined(path, found->member->name)) * found->spelling->factor;
    }

    void read_speed(MachineSpec& machine) const {
        const Node& table = root_.find("machine")->value;
        if (table.kind != NodeKind::table) refuse(table, "machine", "a table [machine]");
        check(table, machine_keys, "machine");
        const auto speed = find(table, machine_keys.front());
        if (!speed) fail(table.place, "machine.speed_rpm", "missing; allowed: a number > 0, or { min, max }");
        const Node& value = speed->member->value;
        const std::string key = joined("machine", speed->member->name);
        const double unit = speed->spelling->factor;
        if (value.kind == NodeKind::table) {
            check(value, range_keys, key);
            machine.least_speed = number(value.find("min")->value, key + ".min") * unit;
            machine.most_speed = number(value.find("max")->value, key + ".max") * unit;
            if (machine.least_speed >= machine.most_speed) refuse(value, key, "min < max");
        } else {
            machine.least_speed = machine.most_speed = number(value, key) * unit;
        }
        if (!(machine.least_speed > 0.0)) refuse(value, key, "a number > 0, or { min, max } of them");
    }

    [[nodiscard]] AxisSpec axis(const Node& table, const std::string& path) const {
        AxisSpec axis;
        axis.name = text(*table.find("name"), path + ".name");
        axis.file = (file_.parent_path() / text(*table.find("scene"), path + ".scene")).string();
        read_angle(table, path, "phase", axis.phase);
        return axis;
    }

    [[nodiscard]] Clearance clearance(const Node& table, const std::string& path,
                                      const MachineSpec& machine) const {
        Clearance clearance;
        const Node& between = table.find("between")->value;
        if (between.kind != NodeKind::array) refuse(between, path + ".between", "a list of names of axes");
        std::vector<std::string> names(machine.axes.size());
        std::ranges::transform(machine.axes, names.begin(), &AxisSpec::name);
        for (const Node& item : between.items) {
            const auto found = std::ranges::find(names, item.text);
            if (item.kind != NodeKind::text || found == names.end())
                refuse(item, path + ".between",
                       fmt::format("{}{}", fmt::join(names, ", "), spelling_hint(item.text, names)));
            clearance.axes.push_back(static_cast<int>(found - names.begin()));
        }
        if (const Member* factors = table.find("factors")) {
            if (factors->value.kind != NodeKind::array)
                refuse(factors->value, path + ".factors", "a list of numbers");
            for (const Node& item : factors->value.items)
                clearance.factors.push_back(number(item, path + ".factors"));
        } else {
            clearance.factors.assign(clearance.axes.size(), 1.0);
        }
        const auto least = find(table, {"at_least", spellings::lift});
        if (!least)
            fail(table.place, path + ".at_least_mm",
                 "missing; allowed: a number, at_least_deg of axes that swing");
        clearance.key = joined(path, least->member->name);
        clearance.unit = least->spelling->unit;
        clearance.unit_value = least->spelling->factor;
        clearance.at_least = number(least->member->value, clearance.key) * clearance.unit_value;
        read_angle(table, path, "from", clearance.from);
        read_angle(table, path, "to", clearance.to);
        return clearance;
    }

    /// Lengths between axes that translate, angles between axes that swing.
    void check_units(const MachineSpec& machine) const {
        for (std::size_t k = 0; k < machine.clearances.size(); ++k) {
            const Clearance& clearance = machine.clearances[k];
            for (const int index : clearance.axes) {
                const AxisSpec& axis = machine.axes[index];
                const bool swings = axis.scene.motion.lift_is_angle;
                if (swings == is_angle_unit(clearance.unit)) continue;
                const Node& table = root_.find("clearance")->value.items[k];
                fail(table.find(clearance.key.substr(clearance.key.find('.') + 1))->value.place,
                     clearance.key,
                     fmt::format(
                         "found {} with \"{}\", whose displacement is {}; allowed: {}", clearance.unit,
                         axis.name, swings ? "an angle" : "a length",
                         swings ? "at_least_deg or at_least_rad" : "at_least_mm, at_least_in or at_least_m"));
            }
        }
    }
};

}  // namespace

MachineSpec read_machine(const std::filesystem::path& file, const AxisLoader& load,
                         std::span<const std::string> settings) {
    return MachineReader(file, settings).read(load);
}

std::vector<std::string> machine_settings(std::span<const std::string> settings, const MachineSpec& machine) {
    std::vector<std::string> own;
    std::ranges::copy_if(settings, std::back_inserter(own), [&](const std::string& setting) {
        return std::ranges::none_of(machine.axes, [&](const AxisSpec& axis) {
            return setting.starts_with(axis.name + ".") &&
                   std::ranges::find(axis.settings, setting.substr(axis.name.size() + 1)) !=
                       axis.settings.end();
        });
    });
    return own;
}

std::optional<std::string> machine_title(std::string_view toml) {
    try {
        const Node root = parse_document(toml, "");
        if (!root.find("machine")) return {};
        const Member* const title = root.find("title");
        return title != nullptr && title->value.kind == NodeKind::text ? title->value.text : std::string();
    } catch (const InputError&) {
        return {};  // its reader says what is wrong
    }
}

std::string speed_setting(double speed) {
    return fmt::format("motion.speed_rpm={}", as_written(speed / units::revolution_per_minute));
}

void fail_in_machine(const std::filesystem::path& file, std::span<const std::string> settings,
                     const MachineSpec& machine, const SceneFault& fault) {
    MachineReader(file, settings).fail(machine, fault);
}

}  // namespace camopt::input
