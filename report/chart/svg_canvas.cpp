// SPDX-License-Identifier: MIT
#include "report/chart/svg_canvas.hpp"

#include "core/text/printable.hpp"
#include "report/view/number_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// What every picture has: its page, titles, the frame of a plot. A picture's own rules come behind and hold.
constexpr std::string_view common_style =
    ".page{fill:#fff}.title{font-size:20px;font-weight:600;fill:#111}.subtitle{font-size:13px;fill:#444}."
    "caption{font-size:14px;font-weight:600;fill:#111}.value{font-size:12px;fill:#222}.value.right,.end{text-"
    "anchor:end}.middle{text-anchor:middle}.faint{fill:#777}.head{font-size:12px;font-weight:600;fill:#333;"
    "text-anchor:end}.head.left{text-anchor:start}.grid{stroke:#e6e6e6;stroke-width:1}.frame{fill:none;"
    "stroke:#8a8a8a;stroke-width:1}.zero{stroke:#a8a8a8;stroke-width:1}.tick{font-size:11px;fill:#444}.tick."
    "middle{text-anchor:middle}.tick.right{text-anchor:end}.axis-title{font-size:12px;fill:#333;text-anchor:"
    "middle}";

constexpr double bold_wider = 1.1;
constexpr double ascent = 0.78, descent = 0.26;  // of the font's size
constexpr double apart = 1.0;                    // px

constexpr double rounding = 1e-9;  // relative to the step: a tick on the end of the axis is inside

std::vector<double> multiples(double step, double lower, double upper) {
    std::vector<double> ticks;
    const long first = std::lround(std::ceil(lower / step - rounding));
    const long last = std::lround(std::floor(upper / step + rounding));
    for (long k = first; k <= last; ++k) ticks.push_back(static_cast<double>(k) * step);
    return ticks;
}

double round_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - rounding)) return factor * power;
    return 10.0 * power;
}

/// "10⁻⁹".
std::string power_words(int exponent) {
    static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (exponent == 0 || exponent == 1) return exponent == 0 ? "1" : "10";
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
    return text;
}

constexpr double tick_font = 11, tick_gap = 7, title_ascent = 12;  // px

}  // namespace

std::string svg_number(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

SvgCanvas::SvgCanvas(double width, double height, std::string_view style, std::string_view title) {
    begin(width, height, "",
          fmt::format("text{{font-family:{};font-size:12px;fill:#222}}{}{}", picture_fonts, common_style,
                      style),
          title);
}

SvgCanvas SvgCanvas::on_paper(double width, double height, std::string_view style, std::string_view title) {
    SvgCanvas canvas;
    canvas.decimals_ = 4;
    canvas.begin(width, height, "mm", style, title);
    return canvas;
}

void SvgCanvas::begin(double width, double height, std::string_view unit, std::string_view style,
                      std::string_view title) {
    content_ = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}{2}\" height=\"{1}{2}\" viewBox=\"0 0 {0} "
        "{1}\" "
        "role=\"img\">\n<title>{3}</title>\n<style>{4}</style>\n",
        number(width), number(height), unit, xml_text(title), style);
}

std::string SvgCanvas::number(double value) const {
    return svg_number(value, decimals_);
}

void SvgCanvas::line(double x1, double y1, double x2, double y2, std::string_view css_class) {
    content_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" class=\"{}\"/>\n", number(x1),
                            number(y1), number(x2), number(y2), css_class);
}

void SvgCanvas::rectangle(double x, double y, double width, double height, std::string_view css_class) {
    content_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" class=\"{}\"/>\n", number(x),
                            number(y), number(width), number(height), css_class);
}

void SvgCanvas::circle(double x, double y, double radius, std::string_view css_class) {
    content_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" class=\"{}\"/>\n", number(x), number(y),
                            number(radius), css_class);
}

void SvgCanvas::path(std::string_view data, std::string_view css_class) {
    content_ += fmt::format("<path d=\"{}\" class=\"{}\"/>\n", data, css_class);
}

void SvgCanvas::text(double x, double y, std::string_view words, std::string_view css_class, double turn,
                     double size) {
    const std::string rotation =
        turn == 0.0 ? std::string{}
                    : fmt::format(" transform=\"rotate({} {} {})\"", number(-turn), number(x), number(y));
    const std::string font = size == 0.0 ? std::string{} : fmt::format(" font-size=\"{}\"", number(size));
    content_ += fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\"{}{}>{}</text>\n", number(x), number(y),
                            css_class, font, rotation, xml_text(words));
}

void SvgCanvas::insert(double x, double y, std::string_view elements) {
    content_ += fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", number(x), number(y), elements);
}

double text_width(std::string_view words, double font_size, bool bold) {
    double ems = 0.0;
    for (const char c : words) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0U) == 0x80U) continue;  // inside a letter of UTF-8
        constexpr std::string_view narrow = " ,.:;|!'()ijlIft[]r-/", wide = "mwMWOQ%@";
        ems += narrow.find(c) != std::string_view::npos                          ? 0.42
               : wide.find(c) != std::string_view::npos                          ? 0.99
               : (c >= 'A' && c <= 'Z') || byte >= 0x80U || c == '=' || c == '+' ? 0.84
                                                                                 : 0.64;
    }
    return ems * font_size * (bold ? bold_wider : 1.0);
}

std::vector<TextPlace> places_around(double x, double y, double width, double font_size, LabelSide side) {
    constexpr double gap = 6.0, gap_of_side = 9.0, step = 4.0;
    constexpr int rings = 20, rings_of_side = 6;
    std::vector<TextPlace> places;
    if (side == LabelSide::beside) places = {{x + gap, y + 4.0}, {x - gap - width, y + 4.0}};
    for (int ring = 0; side >= LabelSide::above && ring < rings_of_side; ++ring) {
        const double out = gap_of_side + step * ring;
        const double base = side == LabelSide::above ? y - out : y + out + 0.8 * font_size;
        for (const double left : {x - 0.5 * width, x + gap, x - gap - width}) places.push_back({left, base});
    }
    for (int ring = 0; ring < rings; ++ring) {
        const double out = step * ring;
        const double right = x + gap + 0.5 * out, left = x - gap - 0.5 * out - width;
        for (const double up : {y - 3.0 - out, y + 0.8 * font_size + out}) {
            places.push_back({right, up});
            places.push_back({left, up});
        }
        places.push_back({x - 0.5 * width, y - gap - out});
        places.push_back({x - 0.5 * width, y + gap + font_size + out});
    }
    return places;
}

std::vector<TextPlace> places_along(double from, double to, double y, bool above) {
    std::vector<TextPlace> places;
    for (const double base : {above ? y - 6 : y + 15, above ? y + 15 : y - 6}) {
        places.push_back({from + 6, base, TextSide::start});
        places.push_back({to - 6, base, TextSide::end});
        places.push_back({0.5 * (from + to), base, TextSide::middle});
        places.push_back({to + 6, base, TextSide::start});
        places.push_back({from - 6, base, TextSide::end});
    }
    return places;
}

void PlacedTexts::avoid(const TextPlace& from, const TextPlace& to) {
    constexpr double step = 4.0, half = 0.8;  // px
    const int pieces = 1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / step);
    for (int i = 0; i <= pieces; ++i) {
        const double part = static_cast<double>(i) / pieces, x = from.x + part * (to.x - from.x),
                     y = from.y + part * (to.y - from.y);
        avoided_.push_back({x - half, y - half, x + half, y + half});
    }
}

bool PlacedTexts::draw(SvgCanvas& canvas, std::string_view words, std::span<const TextPlace> places,
                       std::string_view css_class, double font_size, bool bold) {
    const double width = text_width(words, font_size, bold);
    std::vector<Box> avoided = taken_;
    avoided.insert(avoided.end(), avoided_.begin(), avoided_.end());
    for (std::size_t i = 0; i < 2 * places.size(); ++i) {  // first those off every line
        const TextPlace& place = places[i % places.size()];
        const double part = place.side == TextSide::start ? 0.0 : place.side == TextSide::middle ? 0.5 : 1.0;
        const Box box{place.x - part * width - apart, place.y - ascent * font_size - apart,
                      place.x + (1.0 - part) * width + apart, place.y + descent * font_size + apart};
        if (box.left < left_ || box.top < top_ || box.right > right_ || box.bottom > bottom_) continue;
        const auto covers = [&](const Box& other) {
            return box.left < other.right && other.left < box.right && box.top < other.bottom &&
                   other.top < box.bottom;
        };
        if (std::ranges::any_of(i < places.size() ? avoided : taken_, covers)) continue;
        taken_.push_back(box);
        std::string classes(css_class);
        if (place.side != TextSide::start) classes += place.side == TextSide::middle ? " middle" : " end";
        canvas.text(place.x, place.y, words, classes);
        return true;
    }
    return false;
}

std::vector<double> round_ticks(double lower, double upper, int wanted) {
    if (!(upper > lower) || !std::isfinite(upper - lower)) return {};
    return multiples(round_step((upper - lower) / wanted), lower, upper);
}

std::vector<PlotTick> labelled_ticks(double lower, double upper, int wanted) {
    std::vector<PlotTick> ticks;
    const double step = round_step((upper - lower) / wanted);
    for (const double value : round_ticks(lower, upper, wanted))
        ticks.push_back({value, tick_text(value, step)});
    return ticks;
}

std::vector<double> degree_ticks(double lower, double upper, int wanted) {
    if (!(upper > lower) || !std::isfinite(upper - lower)) return {};
    const double least = (upper - lower) / wanted;
    for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0})
        if (least > 0.5 && step >= least) return multiples(step, lower, upper);
    return multiples(round_step(least), lower, upper);
}

std::string tick_text(double value, double step) {
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + rounding)));
    const bool plain = decimals <= 4 && std::abs(value) < 1e6;
    // Neighbours differ in their last digit also where they are long: 1.60960, 1.60961.
    const double size = std::abs(value) < step ? step : std::abs(value);
    const int digits = std::max(
        3, 1 + static_cast<int>(std::floor(std::log10(size)) - std::floor(std::log10(step) + rounding)));
    if (!plain) return power_text(value, digits);
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.front() == '-') text.replace(0, 1, "−");
    return text;
}

void ValueRange::add(double value) {
    if (!std::isfinite(value)) return;
    lower = started ? std::min(lower, value) : value;
    upper = started ? std::max(upper, value) : value;
    started = true;
}

ValueRange ValueRange::padded(double part) const {
    constexpr double least_width =
        1e-3;  // of the values: what differs by less is level, not a curve of rounding
    const double size = std::max(std::abs(lower), std::abs(upper));
    const double width = std::max(upper - lower, least_width * (size > 0.0 ? size : 1.0));
    const double middle = 0.5 * (lower + upper);
    return {middle - (0.5 + part) * width, middle + (0.5 + part) * width, started};
}

bool ValueRange::spans_factors() const {
    constexpr double large_factor = 6.0;
    return !empty() && lower > 0.0 && upper > large_factor * lower;
}

PlotAxis axis_over(const ValueRange& range, bool logarithmic) {
    constexpr double room = 0.05;
    if (!logarithmic) {
        const ValueRange wide = range.padded(room);
        return {wide.lower, wide.upper};
    }
    const double factor = std::pow(range.upper / range.lower, room);
    return {range.lower / factor, range.upper * factor, 0.0, 1.0, true};
}

std::vector<PlotTick> labelled_ticks(const PlotAxis& axis, int wanted) {
    if (!axis.logarithmic) return labelled_ticks(axis.lower, axis.upper, wanted);
    constexpr double few = 3.0, many = 8.0;
    const double decades = std::log10(axis.upper / axis.lower);
    if (decades > few) return decade_ticks(axis.lower, axis.upper, decades > many ? 2 : 1);
    std::vector<PlotTick> ticks;
    const int first = static_cast<int>(std::floor(std::log10(axis.lower)));
    const int last = static_cast<int>(std::floor(std::log10(axis.upper)));
    for (int exponent = first; exponent <= last; ++exponent)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double value = digit * std::pow(10.0, exponent);
            if (axis.holds(value)) ticks.push_back({value, short_text(value, 5)});
        }
    return ticks;
}

double PlotAxis::place(double value) const {
    const double part =
        logarithmic ? std::log(value / lower) / std::log(upper / lower) : (value - lower) / (upper - lower);
    return begin + part * (end - begin);
}

void draw_plot_frame(SvgCanvas& canvas, const PlotFrame& frame) {
    const PlotAxis &across = frame.horizontal, &up = frame.vertical;
    for (const PlotTick& tick : frame.vertical_ticks) {
        const double y = up.place(tick.value);
        canvas.line(across.begin, y, across.end, y, "grid");
        if (!tick.words.empty()) canvas.text(across.begin - 7, y + 4, tick.words, "tick right");
    }
    for (const PlotTick& tick : frame.horizontal_ticks) {
        const double x = across.place(tick.value);
        canvas.line(x, up.begin, x, up.end, "grid");
        if (!tick.words.empty()) canvas.text(x, up.begin + 16, tick.words, "tick middle");
    }
    canvas.rectangle(across.begin, up.end, across.end - across.begin, up.begin - up.end, "frame");
    if (!frame.horizontal_title.empty())
        canvas.text(0.5 * (across.begin + across.end), up.begin + 36, frame.horizontal_title, "axis-title");
    if (!frame.vertical_title.empty())
        canvas.text(across.begin - room_before(frame) + title_ascent, 0.5 * (up.begin + up.end),
                    frame.vertical_title, "axis-title", 90.0);
}

double room_before(const PlotFrame& frame) {
    constexpr double least = 64;  // so that panels above one another mostly begin at one place
    double widest = 0.0;
    for (const PlotTick& tick : frame.vertical_ticks)
        widest = std::max(widest, text_width(tick.words, tick_font));
    return std::max(least, widest + tick_gap + 6 + title_ascent);
}

std::vector<PlotTick> decade_ticks(double lower, double upper, int stride) {
    std::vector<PlotTick> ticks;
    const int first = static_cast<int>(std::ceil(std::log10(lower) - rounding));
    const int last = static_cast<int>(std::floor(std::log10(upper) + rounding));
    for (int exponent = first; exponent <= last; ++exponent)
        ticks.push_back(
            {std::pow(10.0, exponent), exponent % stride == 0 ? power_words(exponent) : std::string{}});
    return ticks;
}

}  // namespace camopt
