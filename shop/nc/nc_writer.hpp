// SPDX-License-Identifier: MIT
// Private to shop/nc/: G-code line by line.
#pragma once

#include "shop/nc/nc_job.hpp"

namespace camopt {

struct NcStep {
    ToolPose pose;
    Eigen::VectorXd values;
};

/// Z of the machine, m.
struct WayHeights {
    double plane = 0.0;  ///< the clearance plane
    double safe = 0.0;   ///< over the blank, as the table stands; below the plane or on it
};

class NcWriter {
 public:
    NcWriter(const Machine& machine, const PostProcessor& post);

    /// Header, what the numbers mean, blank and clearance plane, units and modes.
    void begin(const NcJob& job, double plane);
    /// Rapid: up, over the first pose with the rotary axes turned, down to the safe height.
    void approach(std::string_view name, const NcStep& first, const WayHeights& heights);
    void plunge(const NcStep& first, double feed) { along_the_tool(first.values(2), feed); }
    /// seconds: of the block; feed: m/s, where F is not a time. arc: none is a line.
    void cut(const NcStep& step, double seconds, double feed, const NcArc* arc = nullptr);
    /// Words before the next block: G41 or G42 with D, or G40.
    void compensate(CompensationSide side, int offset_register);
    void end_compensation() { before_block_ = "G40 "; }
    /// Out of the blank at `feed`, then rapid.
    void retract(const WayHeights& heights, double feed);
    /// The text, with the footer.
    [[nodiscard]] std::string finish();

 private:
    void line(const std::string& words);
    void comment(std::string_view words);
    void warn(const NcJob& job);
    [[nodiscard]] std::string arc_words(const NcArc& arc) const;
    [[nodiscard]] bool mirrored() const {
        return post_axis(post_, machine_.axes()[0]).sign * post_axis(post_, machine_.axes()[1]).sign < 0;
    }
    void describe_blank(const NcJob& job, double plane);
    void along_the_tool(double height, double feed);
    void mode(std::string_view word);
    [[nodiscard]] std::string placed(const std::string& text) const;
    [[nodiscard]] std::string axis_word(std::size_t axis, double value, bool always);
    [[nodiscard]] std::string axis_words(const Eigen::VectorXd& values);
    [[nodiscard]] std::string axis_formula(const MachineAxis& axis) const;
    [[nodiscard]] std::string number(double value, int decimals) const;

    const Machine& machine_;
    const PostProcessor& post_;
    std::map<std::string, std::string> placeholders_;
    std::vector<std::string> last_words_;
    Eigen::VectorXd last_values_;
    std::string before_block_;
    std::string text_, feed_mode_;
    int block_ = 0;
};

}  // namespace camopt
