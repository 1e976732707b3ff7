// SPDX-License-Identifier: MIT
#include "output/words/tables/segment_table.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {

namespace {

constexpr int peak_digits = 5;
constexpr double nothing = 1e-12;  // in lifts: what is left of a zero

std::string joint_text(const SegmentReport& segment) {
    return segment.continuity < 0 ? std::string("open") : fmt::format("C{}", segment.continuity);
}

std::string place_text(double displacement, double lift) {
    return short_text(std::abs(displacement) < nothing ? 0.0 : lift * displacement);
}

}  // namespace

std::optional<Peaks> segment_peaks(const SegmentReport& segment) {
    if (segment.kind != SegmentKind::law) return segment.peaks;
    Peaks peaks = make_law(segment.law)->peaks();
    for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk, &Peaks::torque}) {
        Extremum& own = peaks.*peak;
        own.at = segment.begin + (segment.end - segment.begin) * own.at;
    }
    return peaks;
}

std::string segment_title(const SegmentReport& segment) {
    return segment.kind == SegmentKind::law ? words_of(segment.law) : std::string(name_of(segment.kind));
}

TextTable segment_table(const Solution& solution) {
    const ShownUnits shown = shown_units(solution.scene);
    const MotionUnit& displacement = shown.motion[0].first;
    const double lift = displacement.per_normalised;
    TextTable table;
    table.columns = {{"segment", true},
                     {"start deg"},
                     {"end deg"},
                     {"angle deg"},
                     {fmt::format("from {}", displacement.name)},
                     {fmt::format("to {}", displacement.name)},
                     {"V"},
                     {"A"},
                     {"J"},
                     {"joint"}};
    for (const SegmentReport& segment : solution.segments) {
        const double begin = shown.degrees_per_x * segment.begin, end = shown.degrees_per_x * segment.end;
        std::vector<std::string> row = {segment_title(segment),
                                        short_text(begin),
                                        short_text(end),
                                        short_text(end - begin),
                                        place_text(segment.from, lift),
                                        place_text(segment.to, lift)};
        const std::optional<Peaks> peaks = segment_peaks(segment);
        for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk})
            row.push_back(peaks ? short_text(((*peaks).*peak).value, peak_digits) : "–");
        row.push_back(joint_text(segment));
        table.rows.push_back(std::move(row));
    }
    return table;
}

const char* segment_table_note() {
    return "V, A, J: by the segment's own angle and displacement. Joint: the highest derivative that is "
           "continuous where the segment begins, 3 at most.";
}

}  // namespace camopt
