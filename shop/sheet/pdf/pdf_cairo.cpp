// SPDX-License-Identifier: MIT
// The part "pdf": a separate module, or a part of camopt_shop_pdf.
#include "core/errors.hpp"
#include "core/platform/part_entry.hpp"
#include "core/units.hpp"
#include "shop/sheet/pdf/pdf_part.hpp"

#include <fmt/format.h>

#include <cairo-pdf.h>
#include <cairo.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

// A point of PDF is 1/72 in: no unit of a scene.
constexpr double points_a_metre = 72.0 / units::inch, points_a_mm = 72.0 / (units::inch / units::millimetre);
// cairo counts in mm here: it takes gaps of a dash pattern below 1/512 of its unit for none.
constexpr double mm_a_metre = 1.0 / units::millimetre;
constexpr double halo = mm_a_metre * words_halo;
constexpr const char* font = "DejaVu Sans";

struct CloseSurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct CloseContext {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};

/// Called by cairo, through which no exception may pass.
cairo_status_t append_bytes(void* target, const unsigned char* data, unsigned int length) {
    try {
        static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(data), length);
    } catch (...) {
        return CAIRO_STATUS_WRITE_ERROR;
    }
    return CAIRO_STATUS_SUCCESS;
}

class PdfSheet {
 public:
    explicit PdfSheet(const Sheet& sheet)
        : place_(sheet.place(mm_a_metre)),
          surface_(cairo_pdf_surface_create_for_stream(append_bytes, &bytes_, points_a_metre * sheet.width,
                                                       points_a_metre * sheet.height)) {
        cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_TITLE, sheet.title.c_str());
        cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATOR, "camopt");
        // A date would make two files of one drawing differ.
        cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00");
        context_.reset(cairo_create(surface_.get()));
        cairo_scale(context_.get(), points_a_mm, points_a_mm);
        cairo_select_font_face(context_.get(), font, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
    }
    PdfSheet(const PdfSheet&) = delete;
    PdfSheet& operator=(const PdfSheet&) = delete;

    void draw(const DrawnPath& path, SheetPen pen) const {
        const std::size_t count = path.vertices.size();
        cairo_new_path(context_.get());
        const Vector2d begin = place_(path.vertices.front().position);
        cairo_move_to(context_.get(), begin.x(), begin.y());
        for (std::size_t i = 0; i + (path.closed ? 0 : 1) < count; ++i)
            step(path.vertices[i], path.vertices[(i + 1) % count].position);
        if (path.closed) cairo_close_path(context_.get());
        stroke(pen);
    }
    void draw(const DrawnCircle& circle, SheetPen pen) const {
        const Vector2d center = place_(circle.center);
        cairo_new_path(context_.get());
        cairo_arc(context_.get(), center.x(), center.y(), place_.scale.x() * circle.radius, 0.0, 2.0 * M_PI);
        stroke(pen);
    }
    void draw(const DrawnText& text, SheetPen /*pen*/) const {
        cairo_t* const at = context_.get();
        const Vector2d anchor = place_(text.at);
        cairo_save(at);
        cairo_translate(at, anchor.x(), anchor.y());
        cairo_rotate(at, -text.turn);
        cairo_set_font_size(at, place_.scale.x() * text.height / capital_height);
        cairo_text_extents_t size;
        cairo_text_extents(at, text.words.c_str(), &size);
        const double left = -share_before(text.anchor) * size.x_advance;
        cairo_set_source_rgb(at, 1.0, 1.0, 1.0);
        cairo_rectangle(at, left + size.x_bearing - 0.5 * halo, size.y_bearing - 0.5 * halo,
                        size.width + halo, size.height + halo);
        cairo_fill(at);
        cairo_set_source_rgb(at, 0.0, 0.0, 0.0);
        cairo_move_to(at, left, 0.0);
        cairo_show_text(at, text.words.c_str());
        cairo_restore(at);
    }
    [[nodiscard]] std::string finish() const {
        const cairo_status_t drawn = cairo_status(context_.get());
        cairo_surface_finish(surface_.get());
        const cairo_status_t status =
            drawn == CAIRO_STATUS_SUCCESS ? cairo_surface_status(surface_.get()) : drawn;
        if (status != CAIRO_STATUS_SUCCESS)
            throw InputError(fmt::format("PDF: cairo fails: {}", cairo_status_to_string(status)));
        return bytes_;
    }

 private:
    void stroke(SheetPen pen) const {
        cairo_set_source_rgb(context_.get(), 0.0, 0.0, 0.0);
        if (pen == SheetPen::filled) return cairo_fill(context_.get());
        const PenLook look = look_of(pen);
        std::vector<double> dashes;
        for (const double length : look.dashes) dashes.push_back(mm_a_metre * length);
        cairo_set_line_width(context_.get(), mm_a_metre * look.width);
        cairo_set_dash(context_.get(), dashes.data(), static_cast<int>(dashes.size()), 0.0);
        cairo_stroke(context_.get());
    }
    void step(const ArcVertex& from, const Vector2d& to) const {
        constexpr double nearly_straight = 1e3;  // m
        const auto straight = [&] {
            const Vector2d end = place_(to);
            cairo_line_to(context_.get(), end.x(), end.y());
        };
        if (from.bulge == 0.0) return straight();
        const BulgeArc arc = bulge_arc(from.position, to, from.bulge);
        if (!(arc.radius < nearly_straight)) return straight();
        // y points down here: what turns to the left runs against cairo's sense.
        const auto turn = from.bulge > 0.0 ? cairo_arc_negative : cairo_arc;
        const Vector2d center = place_(arc.center);
        turn(context_.get(), center.x(), center.y(), place_.scale.x() * arc.radius, -arc.from, -arc.to);
    }

    std::string bytes_;
    PicturePlace place_;
    std::unique_ptr<cairo_surface_t, CloseSurface> surface_;
    std::unique_ptr<cairo_t, CloseContext> context_;
};

constexpr PdfPart pdf_table = {
    [](const Sheet& sheet, const Drawing& drawing, std::span<const SheetStyle> styles) {
        const PdfSheet pdf(sheet);
        for (const SheetStyle& style : styles)
            for (const DrawnElement& element : drawing.elements)
                std::visit(
                    [&](const auto& drawn) {
                        if (drawn.style == style.name) pdf.draw(drawn, style.pen);
                    },
                    element);
        return pdf.finish();
    }};

}  // namespace

}  // namespace camopt

extern "C" const void* camopt_part_pdf(const char* build);
const void* camopt_part_pdf(const char* build) {
    return camopt::part_for(build, &camopt::pdf_table);
}
