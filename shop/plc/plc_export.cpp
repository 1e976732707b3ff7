// SPDX-License-Identifier: MIT
#include "shop/plc/plc_export.hpp"

#include "core/text/list_text.hpp"
#include "core/version.hpp"
#include "report/json/json_text.hpp"
#include "report/view/shown_units.hpp"
#include "shop/plc/plc_template.hpp"
#include "splines/motion_family.hpp"
#include "studies/delivered/solution_parts.hpp"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <set>

namespace camopt {

namespace {

// What is said of electronic cams: the header of a file, the console, plc.json (plc_export.hpp).

using nlohmann::ordered_json;

constexpr std::array<const char*, 4> loss_symbols = {"s", "v", "a", "j"};
constexpr int loss_digits = 3;

/// Of a loss by the degree in the units people read.
struct ShownLoss {
    double value = 0.0;
    std::string unit;
};

ShownLoss shown_loss(const Solution& solution, const MasterCurve& curve, std::size_t order,
                     double per_degree) {
    const MotionUnit unit = shown_units(solution.scene).motion[order].first;
    const double normalised =
        per_degree / curve.lift() * std::pow(curve.degrees_per_x(), static_cast<int>(order));
    return {figure_not_exceeded(std::abs(unit.per_normalised) * normalised), unit.name};
}

/// One line of ASCII, regardless of the title: an editor of a controller may know no other letters.
std::string plain_line(const std::string& text) {
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view rest = std::string_view(text).substr(i);
        const auto byte = static_cast<unsigned char>(text[i]);
        constexpr unsigned char ascii = 0x80, first_of_letter = 0xC0;
        if (rest.starts_with("²"))
            line += "^2";
        else if (rest.starts_with("³"))
            line += "^3";
        else if (byte < ascii)
            line += byte < ' ' ? ' ' : text[i];
        else if (byte >= first_of_letter)
            line += '?';
    }
    return line;
}

std::string degrees_text(double value) {
    return short_text(value, 6) + " deg";
}

std::string range_words(const MasterCurve& curve) {
    const double ends = curve.at(curve.end(), Side::left)[0];
    const auto [low, high] = curve.displacements();
    const std::string travel =
        low == 0.0 && high == curve.lift()
            ? "lift " + short_text(high, 6)
            : fmt::format("strokes from {} to {}", short_text(low, 6), short_text(high, 6));
    std::string text =
        fmt::format("master 0 to {}, {} {}; ", degrees_text(curve.end()), travel, curve.slave_unit());
    if (curve.phase() != 0.0)
        text += fmt::format("the motion begins at {} of the master; ", degrees_text(curve.phase()));
    if (curve.closes()) return text + "the cam closes";
    return text + fmt::format(
                      "the cam does not close: it ends {} {} from where it began, run it once or with "
                      "relative slave positions",
                      short_text(ends - curve.at(0.0, Side::right)[0], 6), curve.slave_unit());
}

std::string count_words(const PlcResult& result) {
    const PlcFormat& format = *result.format;
    std::string text = fmt::format("{} {}", result.count, format.element);
    if (format.limit) text += fmt::format(" of the {} that {} holds", *format.limit, format.limit_words);
    if (!format.limit_note.empty()) text += fmt::format(" ({})", format.limit_note);
    return text + fmt::format(", {}, {}", format.rule, format.numbers);
}

std::string loss_words(const Solution& solution, const MasterCurve& curve, const PlcResult& result) {
    std::string text = result.lossless ? "lossless" : "lossy";
    for (std::size_t r = 0; r < result.loss.size(); ++r) {
        text += r == 0 ? ": " : ", ";
        if (!result.loss[r]) {
            text += fmt::format("{} undefined", loss_symbols[r]);
            continue;
        }
        const ShownLoss shown = shown_loss(solution, curve, r, result.loss[r]->value);
        text += fmt::format("{} {} {}", loss_symbols[r], short_text(shown.value, loss_digits), shown.unit);
        if (!result.lossless)
            text += fmt::format(" ({} of its peak, at {})", short_text(result.of_peak[r], 2),
                                degrees_text(result.loss[r]->at));
    }
    return text;
}

std::string unit_words(const MasterCurve& curve, const PlcResult& result) {
    return fmt::format("units: master {} deg, slave {} {}", short_text(result.units.master, 6),
                       short_text(result.units.slave, 6), curve.slave_unit());
}

std::string drift_words(const MasterCurve& curve, const PlcResult& result) {
    return fmt::format("the period of the slave is rounded to whole units: {} {} are added per cycle",
                       short_text(result.drift_per_turn, loss_digits), curve.slave_unit());
}

bool drifts(const MasterCurve& curve, const PlcResult& result) {
    constexpr double no_drift = 1e-12;  // of the lift
    return std::abs(result.drift_per_turn) > no_drift * curve.lift();
}

ordered_json loss_json(const Solution& solution, const MasterCurve& curve, const PlcResult& result) {
    ordered_json rows = ordered_json::array();
    for (std::size_t r = 0; r < result.loss.size(); ++r) {
        ordered_json row{
            {"quantity", loss_symbols[r]}, {"per_degree", nullptr}, {"shown", nullptr}, {"unit", nullptr},
            {"at_deg", nullptr},           {"of_peak", nullptr}};
        if (result.loss[r]) {
            const ShownLoss shown = shown_loss(solution, curve, r, result.loss[r]->value);
            row.update({{"per_degree", result.loss[r]->value},
                        {"shown", shown.value},
                        {"unit", shown.unit},
                        {"at_deg", result.loss[r]->at},
                        {"of_peak", result.of_peak[r]}});
        }
        rows.push_back(row);
    }
    return rows;
}

ordered_json format_json(const Solution& solution, const MasterCurve& curve, const PlcResult& result) {
    const PlcFormat& format = *result.format;
    const ordered_json none;
    return {{"format", format.key},
            {"file", format.file},
            {"text_file", format.text_file.empty() ? none : ordered_json(format.text_file)},
            {"controller", format.controller},
            {"rule", format.rule},
            {"numbers", format.numbers},
            {"element", format.element},
            {"count", result.count},
            {"limit", format.limit ? ordered_json(*format.limit) : none},
            {"degree", format.degree},
            {"units", {{"master_deg", result.units.master}, {"slave", result.units.slave}}},
            {"slave_at_start", result.units.start},
            {"verdict", result.lossless ? "lossless" : "lossy"},
            {"drift_per_turn", result.drift_per_turn},
            {"loss", loss_json(solution, curve, result)}};
}

std::string check_json(const Solution& solution, const MasterCurve& curve, const PlcResult& result) {
    ordered_json json{{"camopt", version()}, {"kind", "electronic cam"}};
    json.update(format_json(solution, curve, result));
    return export_check_json(solution, std::move(json));
}

/// Lines without a comment sign.
std::vector<std::string> plc_header(const Solution& solution, const MasterCurve& curve,
                                    const PlcResult& result) {
    std::vector<std::string> lines;
    lines.push_back(fmt::format("camopt {}: {}", version(), result.format->controller));
    if (!solution.scene.title.empty()) lines.push_back(solution.scene.title);
    lines.push_back(range_words(curve));
    lines.push_back(unit_words(curve, result));
    lines.push_back(count_words(result));
    lines.push_back("read back and evaluated over the whole cycle, " + loss_words(solution, curve, result));
    if (result.units.start != 0.0)
        lines.push_back(fmt::format("slave positions count from the start, which is {} {}",
                                    short_text(result.units.start, 9), curve.slave_unit()));
    if (drifts(curve, result)) lines.push_back(drift_words(curve, result));
    for (std::string& line : lines) line = plain_line(line);
    return lines;
}

std::string plc_text(const Solution& solution, const MasterCurve& curve,
                     const std::vector<PlcResult>& results) {
    std::string text = fmt::format("\nElectronic cam: {}\n", range_words(curve));
    for (const PlcResult& result : results) {
        const PlcFormat& format = *result.format;
        text += fmt::format("  {}: {}\n    {}\n", fmt::join(format.files(), ", "), count_words(result),
                            loss_words(solution, curve, result));
        if (drifts(curve, result)) text += fmt::format("    {}\n", drift_words(curve, result));
    }
    return text;
}

std::string plc_json(const Solution& solution, const MasterCurve& curve,
                     const std::vector<PlcResult>& results) {
    ordered_json json{{"camopt", version()},
                      {"scene", solution.scene.title},
                      {"master", {{"unit", "deg"}, {"end", curve.end()}, {"phase", curve.phase()}}},
                      {"slave",
                       {{"unit", curve.slave_unit()},
                        {"lift", curve.lift()},
                        {"travel", curve.travel()},
                        {"closes", curve.closes()}}},
                      {"formats", ordered_json::array()}};
    for (const PlcResult& result : results) json["formats"].push_back(format_json(solution, curve, result));
    return json_text(json);
}

constexpr double lossless_displacement = 4e-12;  // of the lift
constexpr double lossless_derivative = 1e-9;     // of its peak

void check_count(const PlcFormat& format, int count) {
    if (!format.limit || count <= *format.limit) return;
    const int points = format.counted == PlcCount::points ? *format.limit : *format.limit + 1;
    throw InputError(
        fmt::format("--plc {}: {} {}, {} holds {}{}; allowed: --points {} or fewer of camopt export (with "
                    "the loss that is "
                    "stated), fewer segments of the spline, or another format",
                    format.key, count, format.element, format.limit_words, *format.limit,
                    format.limit_note.empty() ? "" : fmt::format(" ({})", format.limit_note), points));
}

std::string formats_that_hold_jumps(int order) {
    std::string keys;
    for (const PlcFormat& format : plc_formats())
        if (format.shared < order && !format.straight_lines) append_item(keys, format.key);
    return keys;
}

void check_jumps(const PlcFormat& format, const std::vector<PolynomialPiece>& pieces,
                 const std::array<CamDifference, 4>& peaks) {
    constexpr double rounding_of_joint = 1e-6;  // of the peak: above what solvers leave of continuity
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        for (int order = 1; order <= format.shared; ++order) {
            const auto r = static_cast<std::size_t>(order);
            const double theta = pieces[i].begin;
            const double jump = value_of(pieces[i], theta, order) - value_of(pieces[i - 1], theta, order);
            if (std::abs(jump) <= rounding_of_joint * peaks[r].value) continue;
            throw InputError(fmt::format(
                "--plc {}: the {} jumps at {:.6g} deg, and a point of this format has one {} for both sides; "
                "allowed: {}{}",
                format.key, derivative_names[r], theta, derivative_names[r], formats_that_hold_jumps(order),
                order == 3 ? ", or spline.degree = 7 with spline.end_jerk = \"zero\"" : ""));
        }
    }
}

void keep_larger_loss(std::array<std::optional<CamDifference>, 4>& loss,
                      const std::array<std::optional<CamDifference>, 4>& other) {
    for (std::size_t r = 0; r < loss.size(); ++r)
        if (other[r] && (!loss[r] || other[r]->value > loss[r]->value)) loss[r] = other[r];
}

/// What was found in the file, with the motion's peaks.
void judge(PlcResult& result, const MasterCurve& curve, const std::array<CamDifference, 4>& peaks) {
    result.lossless = true;
    for (std::size_t r = 0; r < result.loss.size(); ++r) {
        if (!result.loss[r]) {
            result.lossless = false;
            continue;
        }
        // Doubles know the difference of two polynomials of this size to some units of their last place.
        constexpr double unknown = 32.0 * std::numeric_limits<double>::epsilon();
        const double peak = r == 0 ? curve.lift() : peaks[r].value;
        if (double& value = result.loss[r]->value; value > 0.0)
            value = figure_not_exceeded(value + unknown * peak);
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

    PlcResult write(const PlcFormat& format, const PlcOptions& options,
                    std::vector<FolderFile>& files) const {
        PlcTable table = prepared_table(curve_, options, format);
        PlcResult result;
        result.format = &format;
        result.count = format.count_of(table.pieces);
        check_count(format, result.count);
        check_jumps(format, table.pieces, peaks_);
        if (solution_.scene.motion.speed) table.speed = degrees_shown.of(*solution_.scene.motion.speed);
        result.units = table.units;
        for (const std::string& file : format.files()) {
            const std::string text = written_file(format, file, table);
            keep_larger_loss(result.loss,
                             plc_loss(format, read_file(format, file, text, table.units), curve_));
        }
        result.drift_per_turn = drift(format, table);
        judge(result, curve_, peaks_);
        table.header = plc_header(solution_, curve_, result);
        for (const std::string& file : format.files())
            files.push_back({file, written_file(format, file, table)});
        files.push_back({plc_check_name(format), check_json(solution_, curve_, result)});
        return result;
    }

 private:
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

std::string plc_check_name(const PlcFormat& format) {
    return format.file.substr(0, format.file.rfind('.')) + ".check.json";
}

double figure_not_exceeded(double value) {
    if (!(value > 0.0)) return 0.0;
    constexpr double digits = 2.0, rounding = 1e-12;
    const double grain = std::pow(10.0, std::floor(std::log10(value)) - digits);
    return as_written(std::ceil(value / grain * (1.0 - rounding)) * grain);
}

std::array<std::optional<CamDifference>, 4> plc_loss(const PlcFormat& format,
                                                     const std::vector<PolynomialPiece>& pieces,
                                                     const MasterCurve& curve) {
    const std::size_t orders = format.straight_lines ? 2 : 4;
    const std::array<CamDifference, 4> found = cam_loss(curve, pieces, static_cast<int>(orders));
    std::array<std::optional<CamDifference>, 4> loss;
    std::copy_n(found.begin(), orders, loss.begin());
    return loss;
}

void refuse_too_few_elements(const Scene& scene, const std::vector<std::string>& formats) {
    if (formats.empty()) return;
    Solution unsolved;
    unsolved.scene = scene;
    const int pieces = static_cast<int>(family_of(unsolved)->pieces().size());
    for (const std::string& key : formats) {
        const PlcFormat& format = plc_format(key);
        check_count(format, pieces + (format.counted == PlcCount::points ? 1 : 0));
    }
}

PlcExport plc_export(const Solution& solution, const std::vector<std::string>& formats,
                     const PlcOptions& options) {
    if (!solution.motion)
        throw InputError("--plc: an electronic cam needs a motion, and this solution has none");
    const MasterCurve curve(solution.master_turn(), solution.scene.motion);
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

std::vector<std::vector<FolderFile>> plc_files(std::span<const Solution> solutions,
                                               const std::vector<std::string>& formats) {
    std::vector<std::vector<FolderFile>> all;
    for (const Solution& solution : solutions)
        if (!formats.empty()) all.push_back(plc_export(solution, formats, {}).files);
    return all;
}

}  // namespace camopt
