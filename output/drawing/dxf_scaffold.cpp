// SPDX-License-Identifier: MIT
// Lenient readers take less; AutoCAD refuses a file without the classes of its objects, a layer's plot style
// (390), the subclass marker of the dimension styles' table, the group dictionary or the layouts.
#include "output/drawing/dxf_scaffold.hpp"

#include "output/words/number_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Handles, hexadecimal: tables 1 … 9, root dictionary A, its children B … F, *Model_Space 17 with block 18,
// 19 and layout 1A, *Paper_Space 1B with 1C, 1D, 1E, table entries 20 … 2F.

/// "5 8|330 0": tags with bars between them, code and value with a space.
void append_tags(std::string& text, std::string_view tags) {
    while (!tags.empty()) {
        const std::size_t bar = std::min(tags.find('|'), tags.size());
        const std::string_view tag = tags.substr(0, bar);
        const std::size_t space = tag.find(' ');
        text += fmt::format("{:>3}\n{}\n", tag.substr(0, space), tag.substr(space + 1));
        tags.remove_prefix(std::min(bar + 1, tags.size()));
    }
}

void append_point(std::string& text, const Eigen::Vector2d& place, bool with_height) {
    append_tag(text, 10, dxf_real(place.x()));
    append_tag(text, 20, dxf_real(place.y()));
    if (with_height) append_tag(text, 30, dxf_real(0.0));
}

void append_header(std::string& text, const DxfScaffold& scaffold) {
    append_tags(text,
                "0 SECTION|2 HEADER|9 $ACADVER|1 AC1015|9 $DWGCODEPAGE|3 ANSI_1252|"
                "9 $INSBASE|10 0.0|20 0.0|30 0.0|9 $EXTMIN");
    append_point(text, scaffold.least, true);
    append_tags(text, "9 $EXTMAX");
    append_point(text, scaffold.most, true);
    append_tags(text, "9 $LIMMIN");
    append_point(text, scaffold.least, false);
    append_tags(text, "9 $LIMMAX");
    append_point(text, scaffold.most, false);
    append_tags(
        text,
        "9 $LTSCALE|40 1.0|9 $TEXTSTYLE|7 Standard|9 $CLAYER|8 0|9 $CELTYPE|6 ByLayer|9 $CECOLOR|62 256|"
        "9 $DIMSTYLE|2 Standard|9 $LUNITS|70 2|9 $LUPREC|70 6|9 $AUNITS|70 0|9 $ANGBASE|50 0.0|9 $ANGDIR|70 "
        "0|9 $HANDSEED");
    append_tag(text, 5, dxf_handle(scaffold.next_handle));
    append_tags(text,
                "9 $TILEMODE|70 1|9 $CMLSTYLE|2 Standard|9 $MEASUREMENT|70 1|9 $INSUNITS|70 4|"
                "9 $PSTYLEMODE|290 1|0 ENDSEC");
}

void append_classes(std::string& text) {
    append_tags(text, "0 SECTION|2 CLASSES");
    for (const char* names : {"1 ACDBDICTIONARYWDFLT|2 AcDbDictionaryWithDefault",
                              "1 ACDBPLACEHOLDER|2 AcDbPlaceHolder", "1 LAYOUT|2 AcDbLayout"})
        append_tags(text, fmt::format("0 CLASS|{}|3 ObjectDBX Classes|90 0|280 0|281 0", names));
    append_tags(text, "0 ENDSEC");
}

void begin_table(std::string& text, const char* name, const char* handle, std::size_t entries) {
    append_tags(text,
                fmt::format("0 TABLE|2 {}|5 {}|330 0|100 AcDbSymbolTable|70 {}", name, handle, entries));
}

void append_view(std::string& text, const DxfScaffold& scaffold) {
    const Eigen::Vector2d middle = 0.5 * (scaffold.least + scaffold.most),
                          size = scaffold.most - scaffold.least;
    const double height = 1.1 * std::max({size.x(), size.y(), 1.0});
    begin_table(text, "VPORT", "8", 1);
    append_tags(text,
                "0 VPORT|5 20|330 8|100 AcDbSymbolTableRecord|100 AcDbViewportTableRecord|2 *Active|70 0|10 "
                "0.0|20 0.0|"
                "11 1.0|21 1.0");
    append_tag(text, 12, dxf_real(middle.x()));
    append_tag(text, 22, dxf_real(middle.y()));
    append_tags(text,
                "13 0.0|23 0.0|14 10.0|24 10.0|15 10.0|25 10.0|16 0.0|26 0.0|36 1.0|17 0.0|27 0.0|37 0.0");
    append_tag(text, 40, dxf_real(height));
    append_tags(
        text,
        "41 1.5|42 50.0|43 0.0|44 0.0|50 0.0|51 0.0|71 0|72 1000|73 1|74 3|75 0|76 0|77 0|78 0|281 0|65 0|"
        "146 0.0|0 ENDTAB");
}

void append_line_types(std::string& text) {
    begin_table(text, "LTYPE", "2", 5);
    const auto entry = [&](const char* handle, const char* name, const char* pattern) {
        append_tags(text,
                    fmt::format("0 LTYPE|5 {}|330 2|100 AcDbSymbolTableRecord|100 AcDbLinetypeTableRecord|"
                                "2 {}|70 0|{}",
                                handle, name, pattern));
    };
    entry("21", "ByBlock", "3 |72 65|73 0|40 0.0");
    entry("22", "ByLayer", "3 |72 65|73 0|40 0.0");
    entry("23", "Continuous", "3 |72 65|73 0|40 0.0");
    entry("24", "DASHED", "3 __ __ __|72 65|73 2|40 3.0|49 2.0|74 0|49 -1.0|74 0");
    entry("25", "CENTER",
          "3 ____ _ ____|72 65|73 4|40 9.0|49 6.0|74 0|49 -1.0|74 0|49 1.0|74 0|49 -1.0|74 0");
    append_tags(text, "0 ENDTAB");
}

const char* name_of(DxfLine line) {
    if (line == DxfLine::dashed) return "DASHED";
    return line == DxfLine::center ? "CENTER" : "Continuous";
}

void append_layers(std::string& text, std::span<const DxfLayer> layers) {
    begin_table(text, "LAYER", "1", layers.size() + 1);
    const auto entry = [&](int handle, const DxfLayer& layer) {
        append_tags(text, fmt::format("0 LAYER|5 {}|330 1|100 AcDbSymbolTableRecord|100 AcDbLayerTableRecord|"
                                      "2 {}|70 0|62 {}|6 {}|370 -3|390 F",
                                      dxf_handle(handle), layer.name, layer.color, name_of(layer.line)));
    };
    entry(0x26, {"0", 7, DxfLine::continuous});
    int handle = dxf_first_layer;
    for (const DxfLayer& layer : layers) entry(handle++, layer);
    append_tags(text, "0 ENDTAB");
}

/// Group codes of the variables: 41 arrow, 42 and 44 extension lines, 77 words above the line, 78 no zeros at
/// the end, 140 words, 271 decimals, 40 the scale of all of them.
void append_dimension_style(std::string& text, const DxfDimensionStyle& style) {
    append_tags(text,
                fmt::format("0 DIMSTYLE|105 2B|330 4|100 AcDbSymbolTableRecord|100 AcDbDimStyleTableRecord|"
                            "2 {}|70 0|40 {}|41 {}|42 0.6|44 1.2|77 1|78 8|140 {}|147 0.8|271 3|179 2|340 27",
                            dxf_dimension_style, dxf_real(style.scale), dxf_real(style.arrow),
                            dxf_real(style.text_height)));
}

void append_other_tables(std::string& text, const DxfScaffold& scaffold) {
    begin_table(text, "STYLE", "5", 1);
    append_tags(
        text,
        "0 STYLE|5 27|330 5|100 AcDbSymbolTableRecord|100 AcDbTextStyleTableRecord|2 Standard|70 0|40 0.0|"
        "41 1.0|50 0.0|71 0|42 2.5|3 txt|4 |0 ENDTAB");
    begin_table(text, "VIEW", "7", 0);
    append_tags(text, "0 ENDTAB");
    begin_table(text, "UCS", "6", 0);
    append_tags(text, "0 ENDTAB");
    begin_table(text, "APPID", "3", 1);
    append_tags(
        text, "0 APPID|5 28|330 3|100 AcDbSymbolTableRecord|100 AcDbRegAppTableRecord|2 ACAD|70 0|0 ENDTAB");
    begin_table(text, "DIMSTYLE", "4", scaffold.dimensions == nullptr ? 1 : 2);
    append_tags(text,
                "100 AcDbDimStyleTable|71 0|0 DIMSTYLE|105 29|330 4|100 AcDbSymbolTableRecord|"
                "100 AcDbDimStyleTableRecord|2 Standard|70 0");
    if (scaffold.dimensions != nullptr) append_dimension_style(text, *scaffold.dimensions);
    append_tags(text, "0 ENDTAB");
    begin_table(text, "BLOCK_RECORD", "9", 2 + scaffold.blocks.size());
    for (const DxfBlock& block : scaffold.blocks)
        append_tags(text, fmt::format("0 BLOCK_RECORD|5 {}|330 9|100 AcDbSymbolTableRecord|"
                                      "100 AcDbBlockTableRecord|2 {}|340 0",
                                      dxf_handle(block.record), block.name));
    append_tags(
        text,
        "0 BLOCK_RECORD|5 17|330 9|100 AcDbSymbolTableRecord|100 AcDbBlockTableRecord|2 *Model_Space|340 1A|"
        "0 BLOCK_RECORD|5 1B|330 9|100 AcDbSymbolTableRecord|100 AcDbBlockTableRecord|2 *Paper_Space|340 1E|"
        "0 ENDTAB");
}

void append_dimension_blocks(std::string& text, std::span<const DxfBlock> blocks) {
    for (const DxfBlock& block : blocks) {
        const std::string record = dxf_handle(block.record);
        append_tags(
            text, fmt::format("0 BLOCK|5 {0}|330 {1}|100 AcDbEntity|8 0|100 AcDbBlockBegin|2 {2}|70 1|10 0.0|"
                              "20 0.0|30 0.0|3 {2}|1 ",
                              dxf_handle(block.record + 1), record, block.name));
        text += block.entities;
        append_tags(text, fmt::format("0 ENDBLK|5 {}|330 {}|100 AcDbEntity|8 0|100 AcDbBlockEnd",
                                      dxf_handle(block.record + 2), record));
    }
}

void append_blocks(std::string& text, std::span<const DxfBlock> blocks) {
    const auto block = [&](const char* name, const char* record, const char* begin, const char* end) {
        append_tags(text,
                    fmt::format("0 BLOCK|5 {2}|330 {1}|100 AcDbEntity|8 0|100 AcDbBlockBegin|2 {0}|70 0|"
                                "10 0.0|20 0.0|30 0.0|3 {0}|1 |"
                                "0 ENDBLK|5 {3}|330 {1}|100 AcDbEntity|8 0|100 AcDbBlockEnd",
                                name, record, begin, end));
    };
    append_tags(text, "0 SECTION|2 BLOCKS");
    block("*Model_Space", "17", "18", "19");
    block("*Paper_Space", "1B", "1C", "1D");
    append_dimension_blocks(text, blocks);
    append_tags(text, "0 ENDSEC");
}

void append_layout(std::string& text, const char* name, const char* handle, bool is_model) {
    append_tags(
        text, fmt::format("0 LAYOUT|5 {}|330 D|100 AcDbPlotSettings|1 |2 none_device|4 A4|6 |40 7.5|41 20.0|"
                          "42 7.5|43 20.0|44 210.0|45 297.0|46 0.0|47 0.0|48 0.0|49 0.0|140 0.0|141 0.0|"
                          "142 1.0|143 1.0|70 {}|72 1|73 0|74 5|7 |75 16|147 1.0|148 0.0|149 0.0",
                          handle, is_model ? 1024 : 0));
    append_tags(
        text,
        fmt::format("100 AcDbLayout|1 {}|70 1|71 {}|10 0.0|20 0.0|11 210.0|21 297.0|12 0.0|22 0.0|32 0.0|"
                    "14 0.0|24 0.0|34 0.0|15 0.0|25 0.0|35 0.0|146 0.0|13 0.0|23 0.0|33 0.0|"
                    "16 1.0|26 0.0|36 0.0|17 0.0|27 1.0|37 0.0|76 0|330 {}",
                    name, is_model ? 0 : 1, is_model ? "17" : "1B"));
}

}  // namespace

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

std::string dxf_before_entities(const DxfScaffold& scaffold) {
    std::string text;
    append_header(text, scaffold);
    append_classes(text);
    append_tags(text, "0 SECTION|2 TABLES");
    append_view(text, scaffold);
    append_line_types(text);
    append_layers(text, scaffold.layers);
    append_other_tables(text, scaffold);
    append_tags(text, "0 ENDSEC");
    append_blocks(text, scaffold.blocks);
    append_tags(text, "0 SECTION|2 ENTITIES");
    return text;
}

std::string dxf_after_entities() {
    std::string text;
    append_tags(
        text,
        "0 ENDSEC|0 SECTION|2 OBJECTS|0 DICTIONARY|5 A|330 0|100 AcDbDictionary|281 1|3 ACAD_GROUP|350 C|"
        "3 ACAD_LAYOUT|350 D|3 ACAD_MLINESTYLE|350 B|3 ACAD_PLOTSTYLENAME|350 E|"
        "0 DICTIONARY|5 C|330 A|100 AcDbDictionary|281 1|"
        "0 DICTIONARY|5 D|330 A|100 AcDbDictionary|281 1|3 Model|350 1A|3 Layout1|350 1E|"
        "0 DICTIONARY|5 B|330 A|100 AcDbDictionary|281 1|3 Standard|350 2A|"
        "0 ACDBDICTIONARYWDFLT|5 E|330 A|100 AcDbDictionary|281 1|3 Normal|350 F|"
        "100 AcDbDictionaryWithDefault|340 F|0 ACDBPLACEHOLDER|5 F|330 E");
    append_layout(text, "Model", "1A", true);
    append_layout(text, "Layout1", "1E", false);
    append_tags(
        text,
        "0 MLINESTYLE|5 2A|102 {ACAD_REACTORS|330 B|102 }|330 B|100 AcDbMlineStyle|2 Standard|70 0|3 |62 256|"
        "51 90.0|52 90.0|71 2|49 0.5|62 256|6 BYLAYER|49 -0.5|62 256|6 BYLAYER|0 ENDSEC|0 EOF");
    return text;
}

}  // namespace camopt
