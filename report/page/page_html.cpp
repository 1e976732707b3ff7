// SPDX-License-Identifier: MIT
#include "report/page/page_html.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"
#include "report/page/page_parts.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// In the order in which they build on one another.
constexpr std::array page_scripts = {"assets/charts.js", "assets/drawing.js", "assets/solid.js",
                                     "assets/tables.js", "assets/motions.js", "assets/page.js"};

/// Added to the sources of scripts.
constexpr const char* engine_policy = " 'wasm-unsafe-eval'; worker-src blob:";

/// "<" begins nothing then: no end of the script, no comment. What a terminal would obey is escaped as JSON
/// does it.
std::string script_json(std::string_view text) {
    std::string safe;
    safe.reserve(text.size());
    for (const char c : printable_lines(text)) {
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    }
    return safe;
}

std::string script(std::string_view text, const std::string& nonce) {
    return fmt::format("<script{}>\n{}\n</script>\n",
                       nonce.empty() ? "" : fmt::format(" nonce=\"{}\"", xml_text(nonce)), text);
}

/// The licences of what the page carries, for who reads its text.
std::string licences(const PageHtml& page) {
    std::string text = page.licenses;
    if (text.find("</script") != std::string::npos || text.find("<!--") != std::string::npos)
        throw InputError("licences: found </script or <!--, which a page cannot carry as text");
    text += "uPlot\n" + std::string(page_asset("vendor/uPlot.LICENSE"));
    if (page.solids) text += "\nthree.js\n" + std::string(page_asset("vendor/three.LICENSE"));
    return fmt::format("<script type=\"text/plain\" id=\"licences\">\n{}</script>\n", text);
}

std::string style(std::string_view text) {
    return fmt::format("<style>\n{}\n</style>\n", text);
}

/// A part of a page and its mark in the skeleton.
struct PagePart {
    std::string_view mark;
    std::string text;
};

/// Every mark of the skeleton becomes its part; marks within parts stay what they are.
std::string filled(std::string_view skeleton, const std::vector<PagePart>& parts) {
    std::string page;
    while (true) {
        std::size_t first = std::string_view::npos;
        const PagePart* next = nullptr;
        for (const PagePart& part : parts)
            if (const std::size_t at = skeleton.find(part.mark); at < first) {
                first = at;
                next = &part;
            }
        page += skeleton.substr(0, first);
        if (next == nullptr) return page;
        page += next->text;
        skeleton.remove_prefix(first + next->mark.size());
    }
}

}  // namespace

std::string page_block(const PageBlock& block) {
    return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>", block.id,
                       script_json(block.json));
}

std::string page_html(const PageHtml& page) {
    std::string styles = style(page_asset("vendor/uPlot.min.css")) + style(page_asset("assets/page.css"));
    for (const std::string& text : page.styles) styles += style(text);
    // The base comes before the charts' library, which asks once how many dots a pixel has.
    std::string scripts = licences(page) + script(page_asset("assets/base.js"), page.nonce) +
                          script(page_asset("vendor/uPlot.iife.min.js"), page.nonce);
    if (page.solids) scripts += script(page_asset("vendor/three.min.js"), page.nonce);
    for (const char* const name : page_scripts) scripts += script(page_asset(name), page.nonce);
    for (const std::string& text : page.scripts) scripts += script(text, page.nonce);
    std::string blocks;
    for (const PageBlock& block : page.blocks) blocks += page_block(block) + "\n";
    if (!page.engine.empty())
        scripts += fmt::format("<script type=\"text/plain\" id=\"engine\">{}</script>\n", page.engine);
    return filled(page_asset("assets/page.html"), {{"@ENGINE@", page.engine.empty() ? "" : engine_policy},
                                                   {"@CONNECT@", xml_text(page.connect)},
                                                   {"@TITLE@", xml_text(page.title)},
                                                   {"@STYLES@", std::move(styles)},
                                                   {"@DATA@", script_json(page.data)},
                                                   {"@SCRIPTS@", blocks + scripts}});
}

std::string report_html_with(const SolidParts* solids, const View& view, const RunOrigin& origin) {
    if (!view.solution.motion) {
        const SolveControl timed = SolveControl{}.sooner(view.solution.scene.solver.explain_seconds);
        if (Solution nearest = view.solution; show_nearest(nearest, timed))
            return report_html_with(solids, View(nearest), origin);
    }
    const Solution& solution = view.solution;
    PageHtml page;
    page.title = solution.scene.title.empty() ? "Motion" : solution.scene.title;
    page.data = page_data_with(solids, view, origin);
    page.solids = solids != nullptr && solids->needed(solution);
    return page_html(page);
}

}  // namespace camopt
