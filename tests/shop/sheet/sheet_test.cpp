// SPDX-License-Identifier: MIT
// Sheets: scales of ISO 5455, what dimensions measure and say, where a dimension's marks stand, DXF and SVG
// of them.
#include "shop/sheet/sheet.hpp"

#include "core/errors.hpp"
#include "shop/dxf/dxf_drawing.hpp"
#include "shop/sheet/dimension_marks.hpp"
#include "shop/sheet/sheet_files.hpp"
#include "shop/sheet/sheet_furniture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt {
namespace sheet_test {

using Eigen::Vector2d;

constexpr double pi = std::numbers::pi;

template <class Element>
std::vector<Element> all(const Drawing& drawing) {
    std::vector<Element> found;
    for (const DrawnElement& element : drawing.elements)
        if (const auto* one = std::get_if<Element>(&element)) found.push_back(*one);
    return found;
}

bool has_words(const Sheet& sheet, std::string_view words) {
    return std::ranges::any_of(all<DrawnText>(sheet.drawing),
                               [&](const DrawnText& text) { return text.words == words; });
}

TEST(Sheet, TakesTheLargestStandardScaleThatFits) {
    const Vector2d room(0.1, 0.1);
    const auto scale = [&](double width, double height) {
        return standard_scale({width, height}, room).words;
    };
    EXPECT_EQ(scale(0.1, 0.05), "1:1");
    EXPECT_EQ(scale(0.1001, 0.05), "1:2");
    EXPECT_EQ(scale(0.02, 0.05), "2:1");
    EXPECT_EQ(scale(0.001, 0.02), "5:1");
    EXPECT_EQ(scale(0.21, 0.01), "1:5");
    EXPECT_EQ(scale(0.0019, 0.0001), "50:1");
    EXPECT_EQ(standard_scale({1.5, 0.1}, room).value, 1.0 / 20.0);
    EXPECT_THROW((void)standard_scale({200.0, 1.0}, room), InputError);
}

TEST(Sheet, DimensionsMeasureTheModelAndSaySo) {
    DrawnDimension dimension;
    dimension.second = {0.03, 0.04};
    EXPECT_DOUBLE_EQ(dimension.measured(), 0.03);
    EXPECT_EQ(words_of(dimension), "30");
    dimension.direction = 0.5 * pi;
    dimension.across = true;
    EXPECT_EQ(words_of(dimension), "⌀40");
    dimension.kind = DrawnDimension::Kind::radius;
    EXPECT_EQ(words_of(dimension), "R50");
    dimension.kind = DrawnDimension::Kind::diameter;
    EXPECT_EQ(words_of(dimension), "⌀100");
    dimension.kind = DrawnDimension::Kind::angle;
    dimension.sweep = -pi / 3.0;
    EXPECT_DOUBLE_EQ(dimension.measured(), pi / 3.0);
    EXPECT_EQ(words_of(dimension), "60°");
    EXPECT_EQ(drawn_length(0.0123456), "12.346");
    EXPECT_EQ(drawn_length(-1e-9), "0");
}

TEST(Sheet, SaysItsLengthsInInchesWhereAsked) {
    DrawnDimension dimension;
    dimension.kind = DrawnDimension::Kind::diameter;
    dimension.second = {0.0127, 0.0};
    dimension.lengths = LengthUnit::inch;
    EXPECT_EQ(words_of(dimension), "⌀1");
    EXPECT_EQ(drawn_length(0.010, LengthUnit::inch), "0.3937");
    Sheet sheet;
    sheet.format = "A4";
    sheet.lengths = LengthUnit::inch;
    add_frame(sheet, {});
    EXPECT_TRUE(has_words(sheet, "A4, in"));
}

TEST(Sheet, TitleBlockWordsFitTheirCells) {
    Sheet sheet;
    sheet.format = "A4";
    sheet.scale_words = "1:2";
    TitleBlock title;
    title.part = "Cam disk of the feeder, rising and returning without a dwell";
    title.number = "4711-0815";
    title.revision = "C";
    title.date = "2026-11-26";
    title.organisation = "Cam Works";
    title.surface_finish = "Ra 0.8";
    title.profile_tolerance = "0.02";
    add_frame(sheet, title, "1.25 kg");
    for (const char* const words : {"4711-0815", "C", "2026-11-26", "Cam Works", "Ra 0.8", "0.02", "1.25 kg",
                                    "1:2", "projection", "mass", "profile tolerance"})
        EXPECT_TRUE(has_words(sheet, words)) << words;
    const double left = sheet.width - sheet_margin - title_block_width;
    for (const DrawnText& text : all<DrawnText>(sheet.drawing)) {
        EXPECT_GE(text.at.x(), left);
        EXPECT_LE(text.at.x() + widest_text(text.words, text.height), sheet.width - sheet_margin);
        EXPECT_GT(text.at.y(), sheet_margin);
        EXPECT_LT(text.at.y() + text.height, sheet_margin + title_block_height);
    }
}

/// ISO 5456-2: the circles stand right of the frustum in first angle, left of it in third angle, and its
/// small end points to the left.
TEST(Sheet, ProjectionSymbolTellsFirstFromThirdAngle) {
    for (const Projection projection : {Projection::first_angle, Projection::third_angle}) {
        Sheet sheet;
        add_frame(sheet, {}, "", projection);
        const std::vector<DrawnCircle> circles = all<DrawnCircle>(sheet.drawing);
        const std::vector<DrawnPath> paths = all<DrawnPath>(sheet.drawing);
        ASSERT_EQ(circles.size(), 2u);
        const auto cone = std::ranges::find_if(paths, [](const DrawnPath& path) {
            return path.closed && path.vertices.size() == 4 &&
                   path.vertices[0].position.y() != path.vertices[1].position.y() &&
                   path.vertices[0].position.x() != path.vertices[1].position.x();
        });
        ASSERT_NE(cone, paths.end());
        const double small = cone->vertices[0].position.x(), large = cone->vertices[1].position.x();
        EXPECT_LT(small, large);
        const double middle = circles[0].center.x();
        EXPECT_EQ(middle > large, projection == Projection::first_angle);
        EXPECT_EQ(middle < small, projection == Projection::third_angle);
    }
}

TEST(Sheet, DimensionCarriesItsFit) {
    DrawnDimension dimension;
    dimension.second = {0.0, 0.025};
    dimension.direction = 0.5 * pi;
    dimension.across = true;
    dimension.tolerance = "H7";
    EXPECT_EQ(words_of(dimension), "⌀25 H7");
}

TEST(Sheet, BulgeArcPassesThroughItsPoints) {
    for (const double bulge : {0.2, -0.7, 1.0, 2.5}) {
        const Vector2d from(1.0, 2.0), to(3.0, -1.0);
        const BulgeArc arc = bulge_arc(from, to, bulge);
        const auto at = [&](double angle) -> Vector2d {
            return arc.center + arc.radius * Vector2d(std::cos(angle), std::sin(angle));
        };
        EXPECT_LT((at(arc.from) - from).norm(), 1e-12);
        EXPECT_LT((at(arc.to) - to).norm(), 1e-12);
        EXPECT_NEAR(arc.to - arc.from, 4.0 * std::atan(bulge), 1e-12);
    }
}

// A short dimension has its arrows outside and its words beside them.
TEST(Sheet, MarksAvoidOverlap) {
    DrawnDimension dimension;
    dimension.place = {0.0, 0.01};
    for (const double length : {0.05, 0.002}) {
        dimension.second = {length, 0.0};
        const Drawing marks = dimension_marks(dimension, 1.0);
        std::vector<DrawnPath> arrows = all<DrawnPath>(marks);
        std::erase_if(arrows, [](const DrawnPath& path) { return path.style != "arrow"; });
        ASSERT_EQ(arrows.size(), 2u);
        const std::vector<ArcVertex>& first = arrows[0].vertices;
        const bool inside = first[1].position.x() > first[0].position.x();  // the back lies inwards
        EXPECT_EQ(inside, length == 0.05);
        EXPECT_EQ(all<DrawnText>(marks).at(0).at.x() > length, length == 0.002);
    }
}

/// Words of a keyway 6 wide and of its angle, and others at one place: none lie over another.
TEST(Sheet, DimensionsMoveApart) {
    Sheet sheet;
    sheet.drawing.text({"datum-words", {-0.004, 0.016}, 2.5e-3, "datum, α = 0", TextSide::end});
    for (const double height : {0.012, 0.012, 0.016}) {
        DrawnDimension dimension;
        dimension.first = {-0.003, 0.005};
        dimension.second = {0.003, 0.005};
        dimension.place = {0.0, height};
        dimension.tolerance = height > 0.015 ? "JS9" : "";
        sheet.dimensions.push_back(dimension);
    }
    separate_dimensions(sheet);
    const std::vector<DrawnText> words = all<DrawnText>(drawing_with_marks(sheet));
    EXPECT_EQ(words.size(), 4u);
    for (std::size_t i = 0; i < words.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const auto box = [](const DrawnText& text) {
                const double width = widest_text(text.words, text.height);
                const double part = share_before(text.anchor);
                return std::pair(text.at.x() - part * width, text.at.x() + (1.0 - part) * width);
            };
            const auto [left, right] = box(words[i]);
            const auto [other_left, other_right] = box(words[k]);
            const bool beside = right <= other_left || other_right <= left;
            const bool above = std::abs(words[i].at.y() - words[k].at.y()) >= 2.5e-3;
            EXPECT_TRUE(beside || above) << words[i].words << " and " << words[k].words;
        }
}

TEST(Sheet, WordsThatDoNotFitAreCut) {
    EXPECT_EQ(fitted_words("short", 2.5e-3, 0.1), "short");
    const std::string cut = fitted_words("Größe der Kurvenscheibe für den Vorschub", 2.5e-3, 0.03);
    EXPECT_TRUE(cut.ends_with("…"));
    EXPECT_LE(widest_text(cut, 2.5e-3), 0.03);
    EXPECT_EQ(fitted_words("ÄÄÄÄ", 2.5e-3, 1e-3), "…");
}

TEST(Sheet, OneDescriptionBecomesSvgAndDxf) {
    Sheet sheet;
    sheet.title = "a <b>";
    sheet.origin = {0.125, 0.125};
    sheet.scale = 0.5;
    sheet.drawing.line("cam", {0.0, 0.0}, {0.02, 0.0});
    sheet.drawing.arc("cam", {0.0, 0.0}, 0.02, 0.0, 1.5 * pi);
    Drawing words;
    words.text({"notes", {0.25, 0.125}, 2e-3, "⌀ 5 °", TextSide::end});
    sheet.add_on_paper(words);
    DrawnDimension dimension;
    dimension.kind = DrawnDimension::Kind::diameter;
    dimension.second = {0.02, 0.0};
    dimension.place = {0.01, -0.01};
    sheet.dimensions.push_back(dimension);
    const std::string svg = sheet_svg(sheet);
    EXPECT_NE(svg.find("width=\"297mm\" height=\"210mm\" viewBox=\"0 0 297 210\""), std::string::npos);
    EXPECT_NE(svg.find("a &lt;b&gt;"), std::string::npos);
    EXPECT_NE(svg.find("M125 85L135 85"), std::string::npos);  // half size, y downwards
    EXPECT_NE(svg.find("A10 10 0 0 0 "), std::string::npos);   // two arcs of 135°
    EXPECT_NE(svg.find(">⌀40<"), std::string::npos);
    const std::string dxf = sheet_dxf(sheet);
    for (const char* words : {"AcDbDiametricDimension", "\n*D1\n", "\nCAMOPT\n", "\\U+2300 5 \\U+00B0"})
        EXPECT_NE(dxf.find(words), std::string::npos) << words;
    EXPECT_NE(dxf.find("\n 42\n40.0\n"), std::string::npos);
    EXPECT_NE(dxf.find("\n 11\n20.0\n 21\n0.0\n"), std::string::npos);   // true size
    EXPECT_NE(dxf.find("\n 11\n250.0\n 21\n0.0\n"), std::string::npos);  // words: paper / scale
    EXPECT_EQ(dxf_text("ü\n€𝄞"), "\\U+00FC \\U+20AC?");
}

}  // namespace sheet_test
}  // namespace camopt
