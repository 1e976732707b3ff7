// SPDX-License-Identifier: MIT
#include "input/machine/machine_reader.hpp"

#include "input/document/scene_source.hpp"
#include "input/row_reader.hpp"
#include "input/scene_reader.hpp"

#include <fmt/format.h>

#include <charconv>

namespace camopt::input {

namespace {

class MachineReader {
 public:
    MachineReader(const std::filesystem::path& file, std::span<const std::string> settings)
        : file_(file),
          source_{.name = file.string(),
                  .root = parse_document(scene_file_text(file), file.string()),
                  .rows = machine_rows()} {
        for (const std::string& setting : settings) {
            const std::size_t end = setting.find_first_of(".=[");
            const bool is_own = end == std::string::npos || setting[end] != '.' ||
                                match_key("", setting.substr(0, end), source_.rows).row != nullptr;
            if (is_own)
                apply_overrides(source_.root, {&setting, 1}, source_.rows);
            else
                of_axes_.push_back({setting.substr(0, end), setting.substr(end + 1), setting});
        }
    }

    MachineSpec read(const AxisLoader& load) {
        check_keys(source_);
        MachineSpec machine;
        read_rows(source_, machine);
        for (const AxisSetting& setting : of_axes_) give(machine, setting);
        for (AxisSpec& axis : machine.axes) {
            axis.file = (file_.parent_path() / axis.file).string();
            axis.scene = load(axis.file, all_settings(axis, machine));
        }
        if (const std::optional<SceneFault> fault = find_fault(machine)) fail(machine, *fault);
        return machine;
    }

    /// A member of an axis's scene is reported in its file.
    [[noreturn]] void fail(const MachineSpec& machine, const SceneFault& fault) const {
        const std::string what = words_of(fault), &member = fault.member;
        const std::size_t scene = member.find("].scene.");
        if (!member.starts_with("axis[") || scene == std::string::npos) source_.fail_member(member, what);
        std::size_t index = 0;
        std::from_chars(member.data() + 5, member.data() + scene, index);
        const AxisSpec& axis = machine.axes.at(index);
        const std::vector<std::string> settings = all_settings(axis, machine);
        const std::string toml = scene_file_text(axis.file);
        fail_in_scene({toml, axis.file, settings}, std::string_view(member).substr(scene + 8), what);
    }

 private:
    struct AxisSetting {
        std::string axis, of_scene, written;  ///< "pusher", "motion.lift_mm=60", "pusher.motion.lift_mm=60"
    };

    const std::filesystem::path& file_;
    SceneSource source_;
    std::vector<AxisSetting> of_axes_;

    /// Throws for a setting of no axis: its key is unknown.
    void give(MachineSpec& machine, const AxisSetting& setting) {
        const auto axis = std::ranges::find(machine.axes, setting.axis, &AxisSpec::name);
        if (axis != machine.axes.end()) return axis->settings.push_back(setting.of_scene);
        apply_overrides(source_.root, {&setting.written, 1}, source_.rows);
        check_keys(source_);
    }
    [[nodiscard]] static std::vector<std::string> all_settings(const AxisSpec& axis,
                                                               const MachineSpec& machine) {
        std::vector<std::string> all = axis.settings;
        all.push_back(speed_setting(machine.least_speed));
        return all;
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

std::string setting_of(std::string_view path, std::string_view table, std::string_view name, double si) {
    const KeyRow& row = *find_row(table, name);
    return fmt::format("{}={}", joined_key(path, row.first_key()),
                       as_written(si / row.spellings.front().factor));
}

std::string speed_setting(double speed) {
    return setting_of("motion", "motion", "speed", speed);
}

void fail_in_machine(const std::filesystem::path& file, std::span<const std::string> settings,
                     const MachineSpec& machine, const SceneFault& fault) {
    MachineReader(file, settings).fail(machine, fault);
}

}  // namespace camopt::input
