// SPDX-License-Identifier: MIT
#include "shop/dxf/dxf_drawing.hpp"

#include "core/text/printable.hpp"
#include "report/view/shown_units.hpp"

#include <fmt/ranges.h>

namespace camopt {

// A tag is a group code and a value, a line each. Every object has a handle, in hexadecimal, and names its
// owner (330). Lenient readers take less; AutoCAD refuses a file without the classes of its objects, a
// layer's plot style (390), the subclass marker of the dimension styles' table, the group dictionary or the
// layouts.

namespace {

constexpr int dxf_model_space = 0x17;    // handle of the block record that owns the entities
constexpr int dxf_first_layer = 0x80;    // handles of the layers begin here
constexpr int dxf_first_entity = 0x100;  // handles of the entities begin here
constexpr const char* dxf_dimension_style = "CAMOPT";
/// mm of the drawing, times the scale of its dimensions.
constexpr double dimension_text = 2.5, dimension_arrow = 2.5;

struct DxfScaffold {
    std::span<const DxfLayer> layers;
    Eigen::Vector2d least, most;  ///< extent of the drawing, mm
    int next_handle = 0;          ///< none in use is as large
    std::span<const DxfBlock> blocks;
    double dimension_scale = 1.0;
};

void append_tag(std::string& text, int code, std::string_view value) {
    text += fmt::format("{:>3}\n{}\n", code, value);
}

std::string dxf_handle(int handle) {
    return fmt::format("{:X}", handle);
}

std::string dxf_real(double value) {
    const std::string text = round_trip_text(value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

// Handles, hexadecimal: tables 1 … 9, root dictionary A, its children C … F, *Model_Space 17 with block 18,
// 19 and layout 1A, *Paper_Space 1B with 1C, 1D, 1E, table entries 20 … 2F.

/// "5 8|330 0": tags with bars between them, code and value with a space.
std::string tags(std::string_view list) {
    std::string text;
    while (!list.empty()) {
        const std::size_t bar = std::min(list.find('|'), list.size());
        const std::string_view tag = list.substr(0, bar);
        const std::size_t space = tag.find(' ');
        text += fmt::format("{:>3}\n{}\n", tag.substr(0, space), tag.substr(space + 1));
        list.remove_prefix(std::min(bar + 1, list.size()));
    }
    return text;
}

/// "12 x|22 y".
std::string point(int code, const Eigen::Vector2d& place) {
    return fmt::format("{} {}|{} {}", code, dxf_real(place.x()), code + 10, dxf_real(place.y()));
}

/// What is absent has its default value: linear units, angles in degrees from x, the model in view.
std::string header(const DxfScaffold& scaffold) {
    return tags(
        fmt::format("0 SECTION|2 HEADER|9 $ACADVER|1 AC1015|9 $DWGCODEPAGE|3 ANSI_1252|9 $EXTMIN|{0}|30 0.0|"
                    "9 $EXTMAX|{1}|30 0.0|9 $LIMMIN|{0}|9 $LIMMAX|{1}|9 $LUPREC|70 6|9 $HANDSEED|5 {2}|"
                    "9 $MEASUREMENT|70 1|9 $INSUNITS|70 4|9 $PSTYLEMODE|290 1|0 ENDSEC",
                    point(10, scaffold.least), point(10, scaffold.most), dxf_handle(scaffold.next_handle)));
}

std::string classes() {
    std::string text = "0 SECTION|2 CLASSES";
    for (const char* names : {"1 ACDBDICTIONARYWDFLT|2 AcDbDictionaryWithDefault",
                              "1 ACDBPLACEHOLDER|2 AcDbPlaceHolder", "1 LAYOUT|2 AcDbLayout"})
        text += fmt::format("|0 CLASS|{}|3 ObjectDBX Classes|90 0|280 0|281 0", names);
    return tags(text + "|0 ENDSEC");
}

std::string table(std::string_view name, std::string_view handle, const std::vector<std::string>& records,
                  std::string_view more = "") {
    return tags(fmt::format("0 TABLE|2 {}|5 {}|330 0|100 AcDbSymbolTable|70 {}{}", name, handle,
                            records.size(), more)) +
           fmt::format("{}", fmt::join(records, "")) + tags("0 ENDTAB");
}

/// `handle`: with its group code. `subclass`: of "AcDb…TableRecord".
std::string record(std::string_view type, std::string_view subclass, std::string_view handle,
                   std::string_view owner, std::string_view name, std::string_view rest) {
    return tags(fmt::format("0 {}|{}|330 {}|100 AcDbSymbolTableRecord|100 AcDb{}TableRecord|2 {}|{}", type,
                            handle, owner, subclass, name, rest));
}

std::string view(const DxfScaffold& scaffold) {
    const Eigen::Vector2d middle = 0.5 * (scaffold.least + scaffold.most),
                          size = scaffold.most - scaffold.least;
    const double height = 1.1 * std::max({size.x(), size.y(), 1.0});
    return record(
        "VPORT", "Viewport", "5 20", "8", "*Active",
        fmt::format("70 0|10 0.0|20 0.0|11 1.0|21 1.0|{}|13 0.0|23 0.0|14 10.0|24 10.0|15 10.0|25 "
                    "10.0|16 0.0|26 0.0|36 1.0|17 0.0|27 0.0|37 0.0|40 {}|41 1.5|42 50.0|43 0.0|44 "
                    "0.0|50 0.0|51 0.0|71 0|72 1000|73 1|74 3|75 0|76 0|77 0|78 0|281 0|65 0|146 0.0",
                    point(12, middle), dxf_real(height)));
}

std::string line_type(const char* handle, const char* name, const char* pattern) {
    return record("LTYPE", "Linetype", handle, "2", name, fmt::format("70 0|3 {}", pattern));
}

std::string layer(int handle, const DxfLayer& layer) {
    const char* const line = layer.line == DxfLine::dashed   ? "DASHED"
                             : layer.line == DxfLine::center ? "CENTER"
                                                             : "Continuous";
    return record("LAYER", "Layer", "5 " + dxf_handle(handle), "1", layer.name,
                  fmt::format("70 0|62 {}|6 {}|370 -3|390 F", layer.color, line));
}

/// Group codes of the variables: 41 arrow, 42 and 44 extension lines, 77 words above the line, 78 no zeros at
/// the end, 140 words, 271 decimals, 40 the scale of all of them.
std::string dimension_style(double scale) {
    return record("DIMSTYLE", "DimStyle", "105 2B", "4", dxf_dimension_style,
                  fmt::format("70 0|40 {}|41 {}|42 0.6|44 1.2|77 1|78 8|140 {}|147 0.8|271 3|179 2|340 27",
                              dxf_real(scale), dxf_real(dimension_arrow), dxf_real(dimension_text)));
}

std::string tables(const DxfScaffold& scaffold) {
    constexpr const char* solid = "|72 65|73 0|40 0.0";
    std::vector<std::string> layers = {layer(0x26, {"0", 7, DxfLine::continuous})}, blocks;
    for (const DxfLayer& one : scaffold.layers)
        layers.push_back(layer(dxf_first_layer + static_cast<int>(layers.size()) - 1, one));
    std::vector<std::string> styles = {record("DIMSTYLE", "DimStyle", "105 29", "4", "Standard", "70 0")};
    if (!scaffold.blocks.empty()) styles.push_back(dimension_style(scaffold.dimension_scale));
    const auto add_block = [&](const std::string& handle, std::string_view name, const char* layout) {
        blocks.push_back(record("BLOCK_RECORD", "Block", "5 " + handle, "9", name, layout));
    };
    for (const DxfBlock& block : scaffold.blocks) add_block(dxf_handle(block.record), block.name, "340 0");
    add_block("17", "*Model_Space", "340 1A");
    add_block("1B", "*Paper_Space", "340 1E");
    return tags("0 SECTION|2 TABLES") + table("VPORT", "8", {view(scaffold)}) +
           table("LTYPE", "2",
                 {line_type("5 21", "ByBlock", solid), line_type("5 22", "ByLayer", solid),
                  line_type("5 23", "Continuous", solid),
                  line_type("5 24", "DASHED", "__ __ __|72 65|73 2|40 3.0|49 2.0|74 0|49 -1.0|74 0"),
                  line_type("5 25", "CENTER",
                            "____ _ ____|72 65|73 4|40 9.0|49 6.0|74 0|49 -1.0|74 0|49 1.0|74 0|49 -1.0|74 "
                            "0")}) +
           table("LAYER", "1", layers) +
           table("STYLE", "5",
                 {record("STYLE", "TextStyle", "5 27", "5", "Standard",
                         "70 0|40 0.0|41 1.0|50 0.0|71 0|42 2.5|3 txt|4 ")}) +
           table("VIEW", "7", {}) + table("UCS", "6", {}) +
           table("APPID", "3", {record("APPID", "RegApp", "5 28", "3", "ACAD", "70 0")}) +
           table("DIMSTYLE", "4", styles, "|100 AcDbDimStyleTable|71 0") +
           table("BLOCK_RECORD", "9", blocks) + tags("0 ENDSEC");
}

/// The handles of its begin and its end follow that of its record.
std::string block(const DxfBlock& block, int flags) {
    const std::string owner = dxf_handle(block.record);
    return tags(fmt::format("0 BLOCK|5 {}|330 {}|100 AcDbEntity|8 0|100 AcDbBlockBegin|2 {}|70 {}|10 0.0|20 "
                            "0.0|30 0.0|3 {}|1 ",
                            dxf_handle(block.record + 1), owner, block.name, flags, block.name)) +
           block.entities +
           tags(fmt::format("0 ENDBLK|5 {}|330 {}|100 AcDbEntity|8 0|100 AcDbBlockEnd",
                            dxf_handle(block.record + 2), owner));
}

std::string layout(const char* name, const char* handle, bool is_model) {
    return tags(fmt::format(
        "0 LAYOUT|5 {}|330 D|100 AcDbPlotSettings|1 |2 none_device|4 A4|6 |40 7.5|41 20.0|42 7.5|43 20.0|"
        "44 210.0|45 297.0|46 0.0|47 0.0|48 0.0|49 0.0|140 0.0|141 0.0|142 1.0|143 1.0|70 {}|72 1|73 0|74 5|"
        "7 |75 16|147 1.0|148 0.0|149 0.0|100 AcDbLayout|1 {}|70 1|71 {}|10 0.0|20 0.0|11 210.0|21 297.0|"
        "12 0.0|22 0.0|32 0.0|14 0.0|24 0.0|34 0.0|15 0.0|25 0.0|35 0.0|146 0.0|13 0.0|23 0.0|33 0.0|16 1.0|"
        "26 0.0|36 0.0|17 0.0|27 1.0|37 0.0|76 0|330 {}",
        handle, is_model ? 1024 : 0, name, is_model ? 0 : 1, is_model ? "17" : "1B"));
}

std::string dxf_before_entities(const DxfScaffold& scaffold) {
    std::string blocks =
        block({"*Model_Space", dxf_model_space, ""}, 0) + block({"*Paper_Space", 0x1b, ""}, 0);
    for (const DxfBlock& one : scaffold.blocks) blocks += block(one, 1);
    return header(scaffold) + classes() + tables(scaffold) + tags("0 SECTION|2 BLOCKS") + blocks +
           tags("0 ENDSEC|0 SECTION|2 ENTITIES");
}

std::string dxf_after_entities() {
    return tags(
               "0 ENDSEC|0 SECTION|2 OBJECTS|0 DICTIONARY|5 A|330 0|100 AcDbDictionary|281 1|3 "
               "ACAD_GROUP|350 C|3 ACAD_LAYOUT|350 D|3 ACAD_PLOTSTYLENAME|350 E|0 DICTIONARY|5 C|330 A|100 "
               "AcDbDictionary|281 1|0 DICTIONARY|5 D|330 A|100 AcDbDictionary|281 1|3 Model|350 1A|3 "
               "Layout1|350 1E|0 ACDBDICTIONARYWDFLT|5 E|330 A|100 AcDbDictionary|281 1|3 Normal|350 F|100 "
               "AcDbDictionaryWithDefault|340 F|0 ACDBPLACEHOLDER|5 F|330 E") +
           layout("Model", "1A", true) + layout("Layout1", "1E", false) + tags("0 ENDSEC|0 EOF");
}

}  // namespace

std::string dxf_text(std::string_view words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto byte = static_cast<unsigned char>(words[i]);
        if (byte < 0x80U) {
            text += byte < 0x20U ? ' ' : words[i];
            continue;
        }
        const int more = byte >= 0xf0U ? 3 : byte >= 0xe0U ? 2 : 1;
        unsigned code = byte & (0x3fU >> more);
        for (int k = 0; k < more && i + 1 < words.size(); ++k)
            code = (code << 6U) | (static_cast<unsigned char>(words[++i]) & 0x3fU);
        text += code > 0xffffU ? std::string("?") : fmt::format("\\U+{:04X}", code);
    }
    return text;
}

std::vector<DxfLayer> layers_of(const Drawing& drawing, std::span<const DxfStyle> styles) {
    std::vector<DxfLayer> layers;
    for (const DxfStyle& style : styles)
        if (drawing.has(style.style) &&
            std::ranges::find(layers, style.layer, &DxfLayer::name) == layers.end())
            layers.push_back({style.layer, style.color, style.line});
    return layers;
}

std::string dxf_of(const Drawing& drawing, std::span<const DxfStyle> styles) {
    DxfDrawing dxf(layers_of(drawing, styles));
    dxf.draw(drawing, styles);
    return dxf.finish();
}

void DxfDrawing::draw(const Drawing& drawing, std::span<const DxfStyle> styles) {
    for (const DrawnElement& element : drawing.elements) {
        const auto style = std::ranges::find(styles, style_of(element), &DxfStyle::style);
        if (style == styles.end()) continue;
        if (const auto* words = std::get_if<DrawnText>(&element)) text(style->layer, *words);
        if (const auto* round = std::get_if<DrawnCircle>(&element))
            circle(style->layer, round->center, round->radius);
        const auto* path = std::get_if<DrawnPath>(&element);
        if (path == nullptr) continue;
        const std::vector<ArcVertex>& corners = path->vertices;
        if (style->filled && corners.size() == 3)
            triangle(style->layer, {corners[0].position, corners[1].position, corners[2].position});
        else if (corners.size() == 2 && corners.front().bulge == 0.0)
            line(style->layer, corners.front().position, corners.back().position);
        else
            polyline(style->layer, corners, path->closed);
    }
}

void DxfDrawing::begin_entity(const char* type, std::string_view layer, const char* subclass) {
    append_tag(entities_, 0, type);
    append_tag(entities_, 5, dxf_handle(dxf_first_entity + entity_count_++));
    append_tag(entities_, 330, dxf_handle(owner_ == 0 ? dxf_model_space : owner_));
    append_tag(entities_, 100, "AcDbEntity");
    append_tag(entities_, 8, layer);
    append_tag(entities_, 100, subclass);
}

void DxfDrawing::point(int code, const Eigen::Vector2d& place) {
    append_tag(entities_, code, dxf_real(millimetres_shown.of(place.x())));
    append_tag(entities_, code + 10, dxf_real(millimetres_shown.of(place.y())));
}

void DxfDrawing::widen(const Eigen::Vector2d& place, double reach) {
    if (!place.allFinite() || !std::isfinite(reach))
        throw InputError("a DXF drawing takes finite points only, and one is not");
    const Eigen::Vector2d middle = place / millimetres_shown.size;
    const Eigen::Vector2d size = Eigen::Vector2d::Constant(millimetres_shown.of(reach));
    const bool first = entity_count_ == 0;
    least_ = first ? Eigen::Vector2d(middle - size) : Eigen::Vector2d(least_.cwiseMin(middle - size));
    most_ = first ? Eigen::Vector2d(middle + size) : Eigen::Vector2d(most_.cwiseMax(middle + size));
}

void DxfDrawing::polyline(std::string_view layer, std::span<const ArcVertex> vertices, bool closed) {
    for (const ArcVertex& vertex : vertices) widen(vertex.position);
    begin_entity("LWPOLYLINE", layer, "AcDbPolyline");
    append_tag(entities_, 90, std::to_string(vertices.size()));
    append_tag(entities_, 70, closed ? "1" : "0");
    append_tag(entities_, 43, dxf_real(0.0));
    for (const ArcVertex& vertex : vertices) {
        point(10, vertex.position);
        append_tag(entities_, 42, dxf_real(vertex.bulge));
    }
}

void DxfDrawing::circle(std::string_view layer, const Eigen::Vector2d& center, double radius) {
    widen(center, radius);
    begin_entity("CIRCLE", layer, "AcDbCircle");
    point(10, center);
    append_tag(entities_, 30, dxf_real(0.0));
    append_tag(entities_, 40, dxf_real(millimetres_shown.of(radius)));
}

void DxfDrawing::line(std::string_view layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    widen(from);
    widen(to);
    begin_entity("LINE", layer, "AcDbLine");
    point(10, from);
    append_tag(entities_, 30, dxf_real(0.0));
    point(11, to);
    append_tag(entities_, 31, dxf_real(0.0));
}

void DxfDrawing::text(std::string_view layer, const DrawnText& words) {
    widen(words.at);
    begin_entity("TEXT", layer, "AcDbText");
    point(10, words.at);
    append_tag(entities_, 30, dxf_real(0.0));
    append_tag(entities_, 40, dxf_real(millimetres_shown.of(words.height)));
    append_tag(entities_, 1, dxf_text(words.words));
    append_tag(entities_, 50, dxf_real(degrees_shown.of(words.turn)));
    if (words.anchor != TextSide::start) {
        append_tag(entities_, 72, words.anchor == TextSide::middle ? "1" : "2");
        point(11, words.at);
        append_tag(entities_, 31, dxf_real(0.0));
    }
    append_tag(entities_, 100, "AcDbText");
}

void DxfDrawing::triangle(std::string_view layer, const std::array<Eigen::Vector2d, 3>& corners) {
    for (const Eigen::Vector2d& corner : corners) widen(corner);
    begin_entity("SOLID", layer, "AcDbTrace");
    for (int i = 0; i < 4; ++i) {
        point(10 + i, corners[static_cast<std::size_t>(std::min(i, 2))]);
        append_tag(entities_, 30 + i, dxf_real(0.0));
    }
}

void DxfDrawing::dimension(std::string_view layer, const DrawnDimension& dimension,
                           const Eigen::Vector2d& text, const std::function<void()>& draw_marks) {
    using Kind = DrawnDimension::Kind;
    const auto ray = [](double angle) { return Eigen::Vector2d(std::cos(angle), std::sin(angle)); };
    DxfBlock block;
    block.name = fmt::format("*D{}", blocks_.size() + 1);
    block.record = dxf_first_entity + entity_count_;
    entity_count_ += 3;
    std::swap(entities_, block.entities);
    owner_ = block.record;
    draw_marks();
    owner_ = 0;
    std::swap(entities_, block.entities);

    const auto place = [&](int code, const Eigen::Vector2d& at) {
        point(code, at);
        append_tag(entities_, code + 20, dxf_real(0.0));
    };
    begin_entity("DIMENSION", layer, "AcDbDimension");
    append_tag(entities_, 2, block.name);
    const double reach = (dimension.place - dimension.first).norm();
    const Eigen::Vector2d across = ray(dimension.direction + 0.5 * std::numbers::pi);
    switch (dimension.kind) {
        case Kind::linear:  // the line passes at the second point's foot
            place(10, dimension.second + across * across.dot(dimension.place - dimension.second));
            break;
        case Kind::diameter:
            place(10, 2.0 * dimension.first - dimension.second);
            break;
        case Kind::radius:
            place(10, dimension.first);
            break;
        case Kind::angle:
            place(10, dimension.first + reach * ray(dimension.direction + 0.5 * dimension.sweep));
            break;
    }
    place(11, text);
    constexpr int own_block = 32,
                  own_place = 128;  // no other dimension has the block; words stand where we put them
    const int kind = dimension.kind == Kind::linear     ? 0
                     : dimension.kind == Kind::diameter ? 3
                     : dimension.kind == Kind::radius   ? 4
                                                        : 5;
    append_tag(entities_, 70, std::to_string(kind + own_block + own_place));
    append_tag(entities_, 71, "8");  // their foot's middle
    const bool angle = dimension.kind == Kind::angle;
    append_tag(entities_, 42,
               dxf_real(angle ? dimension.measured() : millimetres_shown.of(dimension.measured())));
    const std::string tolerance =
        dimension.tolerance.empty() ? "" : " " + dxf_text(printable(dimension.tolerance));
    append_tag(entities_, 1, (dimension.across ? "%%c<>" : "<>") + tolerance);
    append_tag(entities_, 3, dxf_dimension_style);
    switch (dimension.kind) {
        case Kind::linear:
            append_tag(entities_, 100, "AcDbAlignedDimension");
            place(13, dimension.first);
            place(14, dimension.second);
            append_tag(entities_, 50, dxf_real(degrees_shown.of(dimension.direction)));
            append_tag(entities_, 100, "AcDbRotatedDimension");
            break;
        case Kind::diameter:
        case Kind::radius:
            append_tag(entities_, 100,
                       dimension.kind == Kind::radius ? "AcDbRadialDimension" : "AcDbDiametricDimension");
            place(15, dimension.second);
            append_tag(entities_, 40, dxf_real(0.0));
            break;
        case Kind::angle:
            append_tag(entities_, 100, "AcDb3PointAngularDimension");
            // Counterclockwise from the first to the second.
            place(13, dimension.first + reach * ray(dimension.direction + std::min(dimension.sweep, 0.0)));
            place(14, dimension.first + reach * ray(dimension.direction + std::max(dimension.sweep, 0.0)));
            place(15, dimension.first);
            break;
    }
    blocks_.push_back(std::move(block));
}

std::string DxfDrawing::finish() const {
    return dxf_before_entities(
               {layers_, least_, most_, dxf_first_entity + entity_count_, blocks_, dimension_scale_}) +
           entities_ + dxf_after_entities();
}

}  // namespace camopt
