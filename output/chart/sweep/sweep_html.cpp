// SPDX-License-Identifier: MIT
#include "output/chart/sweep/sweep_html.hpp"

#include "core/text/printable.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/chart/sweep/sweep_quantities.hpp"
#include "output/words/number_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

const char* page_style =
    "body{margin:16px;color:#222}"
    "svg{max-width:100%;height:auto}"
    "table{border-collapse:collapse;font-size:13px;margin-top:16px}"
    "th,td{padding:3px 9px;text-align:right;border-bottom:1px solid #e3e3e3;white-space:nowrap}"
    "th{cursor:pointer;position:sticky;top:0;background:#fff;border-bottom:2px solid #888}"
    "tr.marked td{background:#dcecf7}.marked-dot{stroke:#d55e00;stroke-width:2.5}"
    "#tip{position:fixed;display:none;background:#fff;border:1px solid #888;padding:6px "
    "9px;font-size:12px;box-shadow:1px 2px 5px #0003;pointer-events:none;white-space:pre}";

// Sorting compares numbers as numbers; empty cells come last.
const char* page_script = R"js(
(function () {
  var table = document.querySelector('table'), body = table.tBodies[0], tip = document.getElementById('tip');
  var heads = Array.from(table.tHead.rows[0].cells), lines = {};
  Array.from(body.rows).forEach(function (line) { lines[line.dataset.row] = line; });
  heads.forEach(function (head, column) {
    var up = false;
    head.addEventListener('click', function () {
      up = !up;
      var rows = Array.from(body.rows);
      rows.sort(function (a, b) {
        var x = a.cells[column].textContent, y = b.cells[column].textContent;
        if (x === '' || y === '') { return (x === '') - (y === ''); }
        var order = isNaN(x) || isNaN(y) ? x.localeCompare(y) : Number(x) - Number(y);
        return up ? order : -order;
      });
      rows.forEach(function (row) { body.appendChild(row); });
    });
  });
  function numberOf(mark) {
    var found = /(?:^| )r(\d+)(?: |$)/.exec(mark.getAttribute('class') || '');
    return found ? found[1] : null;
  }
  function mark(number, on) {
    document.querySelectorAll('svg .r' + number).forEach(function (dot) { dot.classList.toggle('marked-dot', on); });
    if (lines[number]) { lines[number].classList.toggle('marked', on); }
  }
  document.querySelectorAll('svg [class]').forEach(function (dot) {
    var number = numberOf(dot), line = lines[number];
    if (!line) { return; }
    dot.addEventListener('mousemove', function (event) {
      tip.textContent = heads.map(function (head, i) { return head.textContent + ': ' + line.cells[i].textContent; })
        .filter(function (text) { return !/: $/.test(text); }).join('\n');
      tip.style.display = 'block';
      tip.style.left = Math.min(event.clientX + 14, window.innerWidth - tip.offsetWidth - 8) + 'px';
      tip.style.top = Math.min(event.clientY + 14, window.innerHeight - tip.offsetHeight - 8) + 'px';
    });
    dot.addEventListener('mouseenter', function () { mark(number, true); });
    dot.addEventListener('mouseleave', function () { mark(number, false); tip.style.display = 'none'; });
  });
  Object.keys(lines).forEach(function (number) {
    lines[number].addEventListener('mouseenter', function () { mark(number, true); });
    lines[number].addEventListener('mouseleave', function () { mark(number, false); });
  });
})();
)js";

std::string number_cell(const std::optional<double>& value) {
    return value ? fmt::format("{:.8g}", *value) : std::string{};
}

}  // namespace

std::string picture_page(std::string_view title, std::string_view svg, const PictureTable& table) {
    if (const std::size_t begin = svg.find("<svg"); begin != std::string_view::npos) svg.remove_prefix(begin);
    std::string page = fmt::format(
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta "
        "charset=\"utf-8\"/>\n<title>{}</title>\n<style>body{{font-family:{}}}{}</style>\n</"
        "head>\n<body>\n{}\n<div "
        "id=\"tip\"></div>\n<table>\n<thead>\n<tr>",
        xml_text(title), picture_fonts, page_style, svg);
    for (const std::string& head : table.heads) page += fmt::format("<th>{}</th>", xml_text(head));
    page += "</tr>\n</thead>\n<tbody>\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        page += fmt::format("<tr data-row=\"{}\">", table.numbers[i]);
        for (const std::string& cell : table.rows[i]) page += fmt::format("<td>{}</td>", xml_text(cell));
        page += "</tr>\n";
    }
    return page + fmt::format("</tbody>\n</table>\n<script>//<![CDATA[{}//]]></script>\n</body>\n</html>\n",
                              page_script);
}

std::string sweep_html(const SweepPicture& picture) {
    const SweepTable& sweep = picture.table;
    const std::vector<SweepQuantity> quantities = drawn_quantities(sweep);
    PictureTable table;
    table.heads = {"row"};
    for (const std::string& key : sweep.columns.keys) table.heads.push_back(key);
    for (const SweepQuantity& quantity : quantities) table.heads.push_back(quantity.title);
    for (const char* head : {"verdict", "gap", "any-curve limit", "Pareto front", "active limits", "reason"})
        table.heads.emplace_back(head);
    for (const SweepRow& row : sweep.rows) {
        std::vector<std::string> cells = {std::to_string(row.number)};
        for (const double setting : row.settings) cells.push_back(round_trip_text(setting));
        for (const SweepQuantity& quantity : quantities) cells.push_back(number_cell(quantity.value(row)));
        cells.emplace_back(name_of(row.verdict));
        cells.push_back(row.gap ? fmt::format("{:.1e}", *row.gap) : "");
        cells.push_back(number_cell(row.any_curve_limit));
        cells.emplace_back(row.on_front ? "yes" : "");
        cells.push_back(fmt::format("{}", fmt::join(row.active_limits, "; ")));
        cells.push_back(row.reason);
        table.rows.push_back(std::move(cells));
        table.numbers.push_back(row.number);
    }
    return picture_page(picture.scene.title.empty() ? "Sweep" : picture.scene.title, sweep_svg(picture),
                        table);
}

}  // namespace camopt
