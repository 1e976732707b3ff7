// SPDX-License-Identifier: MIT
// Tables, lists, the scene.
'use strict';
(function (camopt) {
  const { element } = camopt;

  /** A key breaks behind its points and underscores where there is little room; a number does not. */
  const breakable = (text) => String(text).split(/(?<=[A-Za-z\]][._])/).flatMap((part, i) => (i ? [element('wbr'), part] : [part]));

  /** {columns: [{title, left}], rows: [[text]], folders: [of rows, to whose pages their first cells lead]} */
  camopt.table = function (table, caption) {
    const head = element('tr', {}, ...table.columns.map((column) => element('th', { scope: 'col', class: column.left ? 'left' : null }, column.title)));
    const link = (row, text) => element('a', { href: encodeURIComponent(table.folders[row]) + '/report.html' }, text);
    const rows = table.rows.map((cells, row) => element('tr', {}, ...cells.map((cell, i) =>
      element(i === 0 && table.columns[0].left ? 'th' : 'td', { scope: i === 0 && table.columns[0].left ? 'row' : null, class: (table.columns[i] || {}).left ? 'left' : null },
        ...(i === 0 && table.folders && table.folders[row] ? [link(row, cell)] : breakable(cell))))));
    return element('div', { class: 'table-scroll', tabindex: '0', role: 'region', 'aria-label': caption || 'table' },
      element('table', {}, caption ? element('caption', {}, caption) : null, element('thead', {}, head), element('tbody', {}, ...rows)));
  };

  camopt.tableSection = (table) => element('section', { class: table.columns.length > 5 ? 'table-block wide' : 'table-block', 'data-table': table.key },
    element('h2', {}, table.title), camopt.table(table, table.title), table.note ? element('p', { class: 'note' }, table.note) : null);

  camopt.list = (sentences, name) => element('ul', { class: name || 'sentences' }, ...sentences.map((sentence) => element('li', {}, sentence)));

  /** null where there is no text. */
  camopt.sceneSection = function (scene) {
    if (!scene.text) return null;
    const section = element('section', { class: 'scene-block' }, element('h2', {}, 'The scene'));
    const name = (scene.file || 'scene.toml').split(/[\\/]/).pop();
    section.append(
      element('details', { class: 'scene-text', open: true }, element('summary', {}, 'The scene as text, to repeat this result'),
        element('pre', { tabindex: '0' }, scene.text)),
      element('p', { class: 'controls-line' }, element('button', { type: 'button', 'data-download': 'scene', onclick: () => camopt.download(name, scene.text, 'application/toml') }, 'Download ' + name)));
    return section;
  };

  /** null where there is nothing to say. */
  camopt.appendixSection = function (data) {
    const { sentences, command } = data.appendix;
    if (!sentences.length && !data.notes.length && !command) return null;
    const section = element('section', { class: 'appendix' }, element('h2', {}, 'Appendix: how it was found'));
    if (sentences.length) section.append(camopt.list(sentences));
    if (data.notes.length) section.append(element('h3', {}, 'Notes of the solve'), camopt.list(data.notes));
    if (command) section.append(element('p', { class: 'note' }, 'Command: ', element('code', {}, command)));
    return section;
  };
})(window.Camopt);
