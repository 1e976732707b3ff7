// SPDX-License-Identifier: MIT
#include "shop/nc/nc_job.hpp"

#include "shop/nc/requirement.hpp"

#include <charconv>

namespace camopt {

namespace {

constexpr Requirement require_job{"NC job"};

constexpr int most_number = 9999;  // of tools and registers: four digits on every control

std::string without_comments(const std::string& line, const PostProcessor& post) {
    std::string rest;
    bool inside = false;
    for (const char letter : line) {
        if (letter == post.comment_begin[0]) inside = true;
        if (!inside) rest += letter;
        if (letter == ')' && post.comment_begin == "(") inside = false;
    }
    return rest;
}

/// M6, also as M06.
bool has_word(const std::string& line, char letter, int value) {
    for (std::size_t place = line.find(letter); place != std::string::npos;
         place = line.find(letter, place + 1)) {
        int number = -1;
        const char* const begin = line.data() + place + 1;
        const auto end = std::from_chars(begin, line.data() + line.size(), number);
        if (end.ec == std::errc() && number == value) return true;
    }
    return false;
}

}  // namespace

const char* name_of(SpindleSense sense) {
    return sense == SpindleSense::clockwise ? "clockwise" : "counterclockwise";
}

void NcJob::validate() const {
    require_job(std::isfinite(feed) && feed > 0.0, "the feed must be > 0 m/s", feed);
    require_job(std::isfinite(plunge_feed) && plunge_feed > 0.0, "the plunge feed must be > 0 m/s",
                plunge_feed);
    require_job(std::isfinite(rotary_speed) && rotary_speed >= 0.0, "the rotary speed must be >= 0 rad/s",
                rotary_speed);
    blank.validate();
    require_job(std::isfinite(safe_distance) && safe_distance > 0.0,
                "the safe distance of rapids from the blank must be > 0 m", safe_distance);
    if (!(std::isfinite(clearance) && clearance >= safe_distance))
        throw InputError(
            fmt::format("NC job: the clearance plane must lie above the blank by the safe distance of {:g} "
                        "mm or more, found {:g} mm{}",
                        safe_distance / units::millimetre, clearance / units::millimetre,
                        clearance < 0.0 ? ", which is inside the blank" : ""));
    require_job(std::isfinite(spindle_rpm) && spindle_rpm >= 0.0, "the spindle speed must be >= 0 rev/min",
                spindle_rpm);
    require_job(!passes.empty(), "there must be a pass", 0);
    require_job(std::isfinite(cutter_diameter) && cutter_diameter >= 0.0,
                "the cutter's diameter must be >= 0 m", cutter_diameter);
    if (tool_number)
        require_job(*tool_number >= 1 && *tool_number <= most_number, "the tool number must be 1 ... 9999",
                    *tool_number);
    require_job(compensation_register >= 1 && compensation_register <= most_number,
                "the compensation register (D) must be 1 ... 9999", compensation_register);
    for (const NcPass& pass : passes) {
        require_job(!pass.poses.empty(), "each pass must have a pose", 0);
        for (const NcArc& arc : pass.arcs)
            require_job(arc.pose > 0 && arc.pose < pass.poses.size(), "an arc must end at a later pose",
                        static_cast<double>(arc.pose));
        if (pass.compensation != CompensationSide::none)
            require_job(pass.poses.size() >= 3, "a compensated pass must have three poses or more",
                        static_cast<double>(pass.poses.size()));
    }
}

std::vector<std::string> warnings_of(const PostProcessor& post, const NcJob& job) {
    const auto has = [&](char letter, int value) {
        return std::ranges::any_of(post.header, [&](const std::string& line) {
            return has_word(without_comments(line, post), letter, value);
        });
    };
    std::vector<std::string> warnings = job.warnings;
    const bool starts = has('M', 3) || has('M', 4);
    if (!starts && !(job.spindle_rpm > 0.0 && !post.spindle_on.empty()))
        warnings.emplace_back("no spindle speed in this program, the spindle must be running before");
    if (!has('M', 6) && !(job.tool_number && !post.tool_call.empty()))
        warnings.emplace_back("no tool call in this program, the tool must be in the spindle and measured");
    return warnings;
}

}  // namespace camopt
