// SPDX-License-Identifier: MIT
#include "output/plc/plc_export.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/plc/formats/knots.hpp"
#include "output/plc/plc_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace camopt {

namespace {

constexpr double lossless_displacement = 1e-12;  // of the lift
constexpr double lossless_derivative = 1e-9;     // of its peak

void check_count(const PlcFormat& format, int count) {
    if (!format.limit || count <= *format.limit) return;
    const int points = format.counted == PlcCount::points ? *format.limit : *format.limit + 1;
    throw InputError(fmt::format(
        "--plc {}: {} {}, {} holds {}{}; allowed: --points {} or fewer (with the loss that is stated), fewer "
        "segments of the spline, or another format",
        format.key, count, format.element, format.limit_words, *format.limit,
        format.limit_note.empty() ? "" : fmt::format(" ({})", format.limit_note), points));
}

std::string formats_that_hold_jumps() {
    std::string keys;
    for (const PlcFormat& format : plc_formats())
        if (format.shared == 0 && !format.straight_lines) keys += (keys.empty() ? "" : ", ") + format.key;
    return keys;
}

void check_jumps(const PlcFormat& format, const std::vector<CamPiece>& pieces,
                 const std::array<CamDifference, 4>& peaks) {
    constexpr double rounding_of_joint = 1e-6;  // of the peak: above what solvers leave of continuity
    constexpr std::array<const char*, 4> names = {"displacement", "velocity", "acceleration", "jerk"};
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        for (int order = 1; order <= format.shared; ++order) {
            const auto r = static_cast<std::size_t>(order);
            const double theta = pieces[i].begin;
            const double jump = value_of(pieces[i], theta, order) - value_of(pieces[i - 1], theta, order);
            if (std::abs(jump) <= rounding_of_joint * peaks[r].value) continue;
            throw InputError(fmt::format(
                "--plc {}: the {} jumps at {:.6g} deg, and a point of this format has one {} for both sides; "
                "allowed: {}",
                format.key, names[r], theta, names[r], formats_that_hold_jumps()));
        }
    }
}

std::array<std::optional<CamDifference>, 4> loss_of_pieces(const PlcFormat& format,
                                                           std::vector<CamPiece> pieces,
                                                           double slave_at_start, const MasterCurve& curve) {
    for (CamPiece& piece : pieces) piece.coefficients.front() += slave_at_start;
    const int orders = format.straight_lines ? 2 : 4;
    const std::array<CamDifference, 4> found = cam_loss(curve, pieces, orders);
    std::array<std::optional<CamDifference>, 4> loss;
    for (std::size_t r = 0; r < static_cast<std::size_t>(orders); ++r) loss[r] = found[r];
    return loss;
}

void keep_larger_loss(std::array<std::optional<CamDifference>, 4>& loss,
                      const std::array<std::optional<CamDifference>, 4>& other) {
    for (std::size_t r = 0; r < loss.size(); ++r)
        if (loss[r] && other[r] && other[r]->value > loss[r]->value) loss[r] = other[r];
}

/// What was found in the file, with the motion's peaks.
void judge(PlcResult& result, const MasterCurve& curve, const std::array<CamDifference, 4>& peaks) {
    result.lossless = true;
    for (std::size_t r = 0; r < result.loss.size(); ++r) {
        if (!result.loss[r]) {
            result.lossless = false;
            continue;
        }
        result.loss[r]->value = figure_not_exceeded(result.loss[r]->value);
        const double peak = r == 0 ? curve.lift() : peaks[r].value;
        result.of_peak[r] = peak > 0.0 ? figure_not_exceeded(result.loss[r]->value / peak) : 0.0;
        const double allowed = r == 0 ? lossless_displacement : lossless_derivative;
        if (!(result.of_peak[r] <= allowed)) result.lossless = false;
    }
}

/// One format: written, read back, judged, and written again with what was found in its header.
class PlcWriter {
 public:
    PlcWriter(const Solution& solution, const MasterCurve& curve)
        : solution_(solution), curve_(curve), peaks_(cam_peaks(curve)) {}

    PlcResult write(const PlcFormat& format, const PlcOptions& options, std::vector<PlcFile>& files) const {
        PlcTable table = format.prepare(curve_, options, format);
        PlcResult result;
        result.format = &format;
        result.count = format.count_of(table.pieces);
        check_count(format, result.count);
        check_jumps(format, table.pieces, peaks_);
        if (solution_.scene.motion.speed) table.speed = *solution_.scene.motion.speed / units::degree;
        result.units = table.units;
        result.slave_at_start = table.slave_at_start;
        result.loss = loss_in(format, format.write(table), table);
        if (!format.text_file.empty())
            keep_larger_loss(result.loss,
                             loss_of_pieces(format, format.read_text(format.write_text(table), table.units),
                                            table.slave_at_start, curve_));
        result.drift_per_turn = drift(format, table);
        judge(result, curve_, peaks_);
        table.header = plc_header(solution_, curve_, result);
        files.push_back({format.file, format.write(table)});
        if (!format.text_file.empty()) files.push_back({format.text_file, format.write_text(table)});
        return result;
    }

 private:
    [[nodiscard]] std::array<std::optional<CamDifference>, 4> loss_in(const PlcFormat& format,
                                                                      const std::string& text,
                                                                      const PlcTable& table) const {
        return plc_loss(format, text, table.units, table.slave_at_start, curve_);
    }

    /// Of a format with whole periods: what SlavePeriod is off the travel of a turn.
    [[nodiscard]] double drift(const PlcFormat& format, const PlcTable& table) const {
        if (!format.whole_periods) return 0.0;
        const double unit = table.units.slave;
        return std::round(curve_.travel() / unit) * unit - curve_.travel();
    }

    const Solution& solution_;
    const MasterCurve& curve_;
    std::array<CamDifference, 4> peaks_;
};

}  // namespace

double figure_not_exceeded(double value) {
    if (!(value > 0.0)) return 0.0;
    constexpr double digits = 2.0, rounding = 1e-12;
    const double grain = std::pow(10.0, std::floor(std::log10(value)) - digits);
    return as_written(std::ceil(value / grain * (1.0 - rounding)) * grain);
}

std::array<std::optional<CamDifference>, 4> plc_loss(const PlcFormat& format, const std::string& text,
                                                     const PlcUnits& units, double slave_at_start,
                                                     const MasterCurve& curve) {
    return loss_of_pieces(format, format.read(text, units), slave_at_start, curve);
}

PlcExport plc_export(const Solution& solution, const std::vector<std::string>& formats,
                     const PlcOptions& options) {
    if (!solution.motion)
        throw InputError("--plc: an electronic cam needs a motion, and this solution has none");
    const MasterCurve curve(solution.whole_turn(), solution.scene.motion);
    const PlcWriter writer(solution, curve);
    PlcExport result;
    std::set<std::string> done;
    for (const std::string& key : formats)
        if (done.insert(key).second)
            result.results.push_back(writer.write(plc_format(key), options, result.files));
    result.text = plc_text(solution, curve, result.results);
    result.files.push_back({"plc.json", plc_json(solution, curve, result.results)});
    return result;
}

}  // namespace camopt
