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
constexpr double capital_height = 0.729;  // of the font's size
constexpr double halo = 0.8;              // mm: the white rim of words
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

class PdfSheet final : public PdfPainter {
 public:
    explicit PdfSheet(const Sheet& sheet)
        : height_(sheet.height),
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

    void path(const SheetPath& path) override {
        const std::size_t count = path.vertices.size();
        cairo_new_path(context_.get());
        move_to(path.vertices.front().position);
        for (std::size_t i = 0; i + (path.closed ? 0 : 1) < count; ++i) {
            const ArcVertex &from = path.vertices[i], &to = path.vertices[(i + 1) % count];
            step(from, to.position);
        }
        if (path.closed) cairo_close_path(context_.get());
        black();
        if (path.filled)
            cairo_fill(context_.get());
        else
            stroke(path.pen);
    }
    void circle(const SheetCircle& circle) override {
        cairo_new_path(context_.get());
        cairo_arc(context_.get(), x_of(circle.center), y_of(circle.center), mm_a_metre * circle.radius, 0.0,
                  2.0 * M_PI);
        black();
        stroke(circle.pen);
    }
    void text(const DrawnText& text) override {
        cairo_t* const at = context_.get();
        cairo_save(at);
        cairo_translate(at, x_of(text.at), y_of(text.at));
        cairo_rotate(at, -text.turn);
        cairo_set_font_size(at, mm_a_metre * text.height / capital_height);
        cairo_text_extents_t size;
        cairo_text_extents(at, text.words.c_str(), &size);
        const double part = text.anchor == TextSide::start    ? 0.0
                            : text.anchor == TextSide::middle ? 0.5
                                                              : 1.0;
        const double left = -part * size.x_advance;
        cairo_set_source_rgb(at, 1.0, 1.0, 1.0);
        cairo_rectangle(at, left + size.x_bearing - 0.5 * halo, size.y_bearing - 0.5 * halo,
                        size.width + halo, size.height + halo);
        cairo_fill(at);
        black();
        cairo_move_to(at, left, 0.0);
        cairo_show_text(at, text.words.c_str());
        cairo_restore(at);
    }
    [[nodiscard]] std::string finish() override {
        const cairo_status_t drawn = cairo_status(context_.get());
        cairo_surface_finish(surface_.get());
        const cairo_status_t status =
            drawn == CAIRO_STATUS_SUCCESS ? cairo_surface_status(surface_.get()) : drawn;
        if (status != CAIRO_STATUS_SUCCESS)
            throw InputError(fmt::format("PDF: cairo fails: {}", cairo_status_to_string(status)));
        return bytes_;
    }

 private:
    void black() const { cairo_set_source_rgb(context_.get(), 0.0, 0.0, 0.0); }
    [[nodiscard]] double x_of(const Vector2d& point) const { return mm_a_metre * point.x(); }
    [[nodiscard]] double y_of(const Vector2d& point) const { return mm_a_metre * (height_ - point.y()); }
    void move_to(const Vector2d& point) const { cairo_move_to(context_.get(), x_of(point), y_of(point)); }
    void line_to(const Vector2d& point) const { cairo_line_to(context_.get(), x_of(point), y_of(point)); }
    void stroke(SheetPen pen) const {
        const PenLook look = look_of(pen);
        std::vector<double> dashes;
        for (const double length : look.dashes) dashes.push_back(mm_a_metre * length);
        cairo_set_line_width(context_.get(), mm_a_metre * look.width);
        cairo_set_dash(context_.get(), dashes.data(), static_cast<int>(dashes.size()), 0.0);
        cairo_stroke(context_.get());
    }
    void step(const ArcVertex& from, const Vector2d& to) const {
        constexpr double nearly_straight = 1e3;  // m
        if (from.bulge == 0.0) return line_to(to);
        const BulgeArc arc = bulge_arc(from.position, to, from.bulge);
        if (!(arc.radius < nearly_straight)) return line_to(to);
        // y points down here: what turns to the left runs against cairo's sense.
        const auto draw = from.bulge > 0.0 ? cairo_arc_negative : cairo_arc;
        draw(context_.get(), x_of(arc.center), y_of(arc.center), mm_a_metre * arc.radius, -arc.from, -arc.to);
    }

    std::string bytes_;
    double height_;
    std::unique_ptr<cairo_surface_t, CloseSurface> surface_;
    std::unique_ptr<cairo_t, CloseContext> context_;
};

constexpr PdfPart pdf_table = {
    [](const Sheet& sheet) -> std::unique_ptr<PdfPainter> { return std::make_unique<PdfSheet>(sheet); }};

}  // namespace

}  // namespace camopt

extern "C" const void* camopt_part_pdf(const char* build);
const void* camopt_part_pdf(const char* build) {
    return camopt::part_for(build, &camopt::pdf_table);
}
