// SPDX-License-Identifier: MIT
// What a page shows of a solved scene, as one JSON text: words, tables, curves along the turn, the cam with
// its follower at every cam angle. Who draws it (assets/, the studio) knows no kind of cam and computes
// nothing but pixels; every number is in the unit that stands beside it (report/view/shown_units.hpp).
//
//   camopt, kind (above the title), title
//   foot          words at the foot of printed pages
//   verdict       key (of Verdict, or "open": not proved yet), tone ("good", "fair", "bad", "open"),
//                 headline, sentences[]
//   figures[]     name, value, at (may be empty): what stands first, as texts
//   reference     null without a law to compare with; title ("Against modified sine"), sentences[]
//   angle         unit, from, to, values[]: cam angles of all curves and poses, ascending. They are the
//                 rows of motion.csv, two where the jerk jumps (seen from the left, then from the right),
//                 and after the motion those of the dwell that closes the cam. title: of another angle
//   curves[]      by cam angle:
//     key, group ("motion", "motor", "cam", "forces", or the words above them), title, symbol, unit,
//     values[] (null: nothing to say there)
//     beside        null, or unit and factor: value · factor is the same by the cam angle
//     reference     null, or title and values[] of the law
//     measured      null, or title and values[] of the measured motion
//     points        [angle, value] of rows of its table, of the displacement and the residual
//     limits[]      from, to, at (signed), words; outside (+1: values above are out, −1: below)
//     marks[]       at, value, words: the peaks and extremes that the tables name, at the tables' angles;
//                   given: true: an exact point of the scene; with "to" that velocity is held so far
//   segments[]    from, to, title: of a program
//   breakpoints[] cam angles
//   motor         null, or an SVG: torque over speed of a motor, with its curve
//   drawing       null, or a plane cam and its mechanism in the frame that stands still:
//     unit, rotation (+1 counterclockwise), center[x, y]
//     outlines[]    name, closed, pitch (it is the path of a roller's centre), points[x, y, …] in the
//                   cam frame
//     circles[]     name, radius about the centre
//     turned[]      by angle: degrees by which the cam frame has turned
//     shifted[]     by angle: x, y by which the frame of a plate has moved; absent: a cam that turns
//     contact[]     by angle: x, y
//     parts[]       kind ("link", "circle", "pivot", "guide", "face"), name, radius, count (of points) and
//                   points[x, y, …] by angle; a part that never moves has one set of points
//   solid         null, or a three-dimensional cam (needs WebGL):
//     unit, rotation, parts[] (name, closed, vertices[x, y, z, …], triangles[…]), roller (radius, length),
//     rollers[] (poses[…]: foot x, y, z and direction x, y, z by angle), pivot [x, y, z] or null
//   tables[]      key, title, columns[] (title, left), rows[][], note; folders[]: result folders of the
//                 rows, to whose pages their first cells lead.
//                 Of motions, which are sorted, drawn over one another and hand out their scenes:
//     columns[]     key, title, left, values[] by row: a number, a text, both as a list, or null
//     items         names[], numbers[] (the class "rN" of marks in pictures), tones[] ("", "good", "bad")
//     axes          x, y: keys of the columns that are drawn first
//     overlay       null, or angles[] and curves[]: title, symbol, unit, lines[] by row: values[] or null
//     scenes        null, or base (a scene in TOML), edits[] by row: null (none), or pairs of a line of base,
//                   from 0, and the text in its place
//     without_scenes null, or words that a click says, and the command but for the settings of the row
//   pictures[]    SVGs as texts
//   lists[]       title, sentences[]: on the cam, its drive, terms of a program
//   notes[]       of the solve
//   appendix      how it was found: sentences[], command
//   scene         file, text (TOML)
#pragma once

#include "report/solve/solution_document.hpp"

namespace camopt {

/// What a page and a folder show of a three-dimensional cam: result_page.hpp gives it. Plane cams need none.
struct SolidParts {
    bool (*needed)(const Solution&);
    std::string (*drawing)(const View&);  ///< "solid" of page_data as JSON
};

/// result_page.hpp for programs whose cams are plane: without `solids` the page has none.
[[nodiscard]] std::string page_data_with(const SolidParts* solids, const View& view,
                                         const RunOrigin& origin = {}, SolutionWishes wishes = {});
[[nodiscard]] std::string report_html_with(const SolidParts* solids, const View& view,
                                           const RunOrigin& origin = {});

// Laws of the catalogue in the place of a solution's motion, for the curves of its page.
//
//   key, title
//   misfit     null, or why the law does not fit the scene: then there are no curves
//   curves     displacement, velocity, acceleration, jerk: values[] by the angles and in the units of
//   page_data
//              (null: infinite, or in the dwell behind the motion)
//   peaks      velocity, acceleration, jerk, normalised as the scene's; null where infinite

/// A JSON array, one entry a key, in their order; [] for a solution without a motion. Throws InputError for a
/// law that is not in the catalogue.
[[nodiscard]] std::string page_laws(const View& view, std::span<const std::string> keys);

// A page as one HTML file that loads nothing from anywhere: styles, scripts and data stand in it. Its policy
// (Content-Security-Policy) lets it load nothing either, regardless of the data.

/// JSON for the page's scripts, as the text of an element; what could end it is written otherwise.
struct PageBlock {
    std::string id, json;
};
[[nodiscard]] std::string page_block(const PageBlock& block);

struct PageHtml {
    std::string title;
    std::string data;     ///< JSON (page_html.hpp); any text: what could end a script is written otherwise
    bool solids = false;  ///< with the library for three dimensions, half a megabyte
    /// More scripts and styles, run after the page's own, and what the page may connect to (an element of
    /// the policy's connect-src): the studio's.
    std::vector<std::string> scripts = {}, styles = {};
    std::string connect = "'none'";
    /// Of the scripts, for a policy that a server sends; empty: none.
    std::string nonce = {};
    std::vector<PageBlock> blocks = {};
    /// Texts of what the engine contains, before those of the page's scripts in the element `licences`.
    std::string licenses = {};
    /// A WebAssembly module for a Worker, gzip, base64: the last element of the page. Empty: none may run.
    std::string engine = {};
};

[[nodiscard]] std::string page_html(const PageHtml& page);

// The page of a document (report/document/document.hpp): sentences, figures, curves with one cursor, tables.

[[nodiscard]] std::string document_html(const Document& document, const RunOrigin& origin = {});

/// Names of files that studies promised before they had documents. json: empty, there is none.
struct DocumentNames {
    std::string page = "report.html", json = "document.json";
};
/// All files of a document, its JSON last.
[[nodiscard]] std::vector<FolderFile> document_files(const Document& document, const RunOrigin& origin,
                                                     const DocumentNames& names = {});

}  // namespace camopt
