// SPDX-License-Identifier: MIT
#include "core/text/printable.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

struct Letter {
    char32_t code = 0;
    std::size_t bytes = 0;  ///< 0: not UTF-8
};

/// The first letter of a text that is not empty.
Letter first_letter(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
    char32_t code = lead & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) return {};
        code = code << 6U | (byte(i) & 0x3fU);
    }
    const char32_t least = bytes == 4 ? 0x10000 : bytes == 3 ? 0x800 : 0x80;
    if (code < least || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return {};
    return {code, bytes};
}

// U+00A0 … 00FF, between commas.
constexpr std::string_view latin_letters =
    " ,!,c,GBP,?,JPY,|,par. ,\",(C),a,<<,not ,-,(R),-, deg,+/-,2,3,',u,par. "
    ",.,,1,o,>>,1/4,1/2,3/"
    "4,?,A,A,A,A,Ae,A,Ae,C,E,E,E,E,I,I,I,I,D,N,O,O,O,O,Oe,x,Oe,U,U,U,Ue,Y,Th,ss,a,a,a,a,ae,a,ae,c,e,e,e,e,i,"
    "i,i,i,d,n,o,o,o,o,oe,/,oe,u,u,u,ue,y,th,y";

std::string_view ascii_of(char32_t code) {
    struct Sign {
        char32_t code;
        std::string_view ascii;
    };
    static constexpr Sign signs[] = {
        {0x152, "Oe"},   {0x153, "oe"},  {0x160, "S"},     {0x161, "s"},    {0x17d, "Z"},   {0x17e, "z"},
        {0x3a9, "Ohm"},  {0x3bc, "u"},   {0x2010, "-"},    {0x2011, "-"},   {0x2012, "-"},  {0x2013, "-"},
        {0x2014, "-"},   {0x2018, "'"},  {0x2019, "'"},    {0x201c, "\""},  {0x201d, "\""}, {0x201e, "\""},
        {0x2026, "..."}, {0x2032, "'"},  {0x2033, "\""},   {0x20ac, "EUR"}, {0x2192, "->"}, {0x2212, "-"},
        {0x2264, "<="},  {0x2265, ">="}, {0x2300, "dia. "}};
    for (const Sign& sign : signs)
        if (sign.code == code) return sign.ascii;
    if (code < 0xa0 || code > 0xff) return "?";
    std::string_view rest = latin_letters;
    for (char32_t k = 0xa0; k < code; ++k) rest.remove_prefix(rest.find(',') + 1);
    return rest.substr(0, rest.find(','));
}

bool is_obeyed(char32_t code) {
    const auto within = [&](char32_t first, char32_t last) { return code >= first && code <= last; };
    return code < 0x20 || within(0x7f, 0x9f) || within(0x200e, 0x200f) || within(0x2028, 0x202e) ||
           within(0x2066, 0x2069);
}

std::string shown(std::string_view text, std::string_view kept) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        const std::size_t bytes = letter.bytes == 0 ? 1 : letter.bytes;
        if (letter.bytes == 0)
            result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
        else if (is_obeyed(letter.code) && kept.find(text[0]) == std::string_view::npos)
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(letter.code));
        else
            result += text.substr(0, bytes);
        text.remove_prefix(bytes);
    }
    return result;
}

}  // namespace

std::string printable(std::string_view text) {
    return shown(text, "");
}

std::string printable_lines(std::string_view text) {
    return shown(text, "\n\t");
}

std::string ascii_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        if (letter.bytes == 1)
            result += letter.code < 0x20 || letter.code == 0x7f ? ' ' : text[0];
        else
            result += letter.bytes == 0 ? "?" : ascii_of(letter.code);
        text.remove_prefix(std::max<std::size_t>(letter.bytes, 1));
    }
    return result;
}

std::string xml_text(std::string_view text) {
    std::string result;
    for (const char letter : printable(text)) {
        switch (letter) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += letter;
        }
    }
    return result;
}

std::string unit_words(std::string_view unit) {
    std::string shown(unit);
    for (const auto& [written, sign] : {std::pair("^2", "²"), std::pair("^3", "³"), std::pair("um", "µm")})
        if (const std::size_t found = shown.find(written); found != std::string::npos)
            shown.replace(found, std::string_view(written).size(), sign);
    return shown;
}

}  // namespace camopt
