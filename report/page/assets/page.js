// SPDX-License-Identifier: MIT
// The page: puts the parts together and shows data. camopt.page.show(data) draws it again, with what is there.
'use strict';
(function (camopt) {
  const { element } = camopt;

  function themeButton() {
    const button = element('button', { type: 'button', class: 'quiet-button', 'data-control': 'theme' });
    const name = () => { button.textContent = camopt.isDark() ? 'Light' : 'Dark'; button.setAttribute('aria-label', camopt.isDark() ? 'Light colours' : 'Dark colours'); };
    button.addEventListener('click', () => camopt.setTheme(camopt.isDark() ? 'light' : 'dark'));
    camopt.themeChanged.listen(name);
    name();
    return button;
  }

  /** At the foot of printed pages: these words, today's date, page numbers. */
  let footRule = null;
  function printFoot(words) {
    const sheet = document.styleSheets[document.styleSheets.length - 1];
    if (footRule !== null) sheet.deleteRule(footRule);
    const text = JSON.stringify(words + ' · printed ' + new Date().toISOString().slice(0, 10));
    const font = 'font: 8px sans-serif; color: #555;';
    footRule = sheet.insertRule('@page { @bottom-left { content: ' + text + '; ' + font + ' } ' +
      '@bottom-right { content: "page " counter(page) " of " counter(pages); ' + font + ' } }', footRule ?? sheet.cssRules.length);
  }

  camopt.header = function () {
    const title = element('h1', {}), kind = element('p', { class: 'kind' });
    const host = element('header', { class: 'top' },
      element('div', { class: 'titles' }, kind, title),
      element('div', { class: 'top-buttons' }, element('button', { type: 'button', class: 'quiet-button', onclick: () => window.print() }, 'Print'), themeButton()));
    return { host, kind, title };
  };

  camopt.verdictPanel = function (data) {
    const panel = element('section', { class: 'verdict ' + data.verdict.tone, 'data-verdict': data.verdict.key, 'aria-label': 'Verdict' },
      element('h2', {}, data.verdict.headline), ...data.verdict.sentences.map((sentence) => element('p', {}, sentence)));
    return panel;
  };

  camopt.referencePanel = (reference) => element('section', { class: 'against', 'aria-label': 'Compared with the reference law' },
    element('h2', {}, reference.title), ...reference.sentences.map((sentence) => element('p', {}, sentence)));

  camopt.figureStrip = (figures) => element('dl', { class: 'figures' }, ...figures.map((figure) =>
    element('div', {}, element('dt', {}, figure.name), element('dd', {}, figure.value, figure.at ? element('span', {}, 'at ' + figure.at) : null))));

  /** Of a scene or a study. */
  camopt.report = function (host) {
    const angle = camopt.angle(), charts = camopt.charts(angle), drawing = camopt.drawing(angle), solid = camopt.solid(angle);
    const top = camopt.header();
    const words = element('div', { class: 'words' }), motions = element('div', {}), tables = element('div', { class: 'tables' }), end = element('div', { class: 'end' });
    const controls = camopt.angleControls(angle);
    const stage = element('aside', { class: 'stage', 'aria-label': 'The cam in motion' }, element('h2', {}, 'The cam in motion'), drawing.host, solid.host, controls);
    const pictures = element('div', { class: 'pictures' }, element('div', { class: 'chart-column' }, charts.chips, charts.host), stage);
    const foot = element('footer', { class: 'foot' });
    host.replaceChildren(top.host, element('main', {}, words, pictures, motions, tables, end), foot);
    let shown = false; // a motion, at some time
    const self = {
      angle, charts, drawing, solid, stage, data: null, motions: null,
      /** Where there is no motion, those of the last one stay, greyed: for a page that shows one scene after another. */
      keepsPictures: false,
      /** open: curves and pictures before their proof; words and tables stay as they were, and say so. */
      show(data, open = false) {
        self.data = data;
        for (const part of [words, tables, end]) part.classList.toggle('outdated', open);
        words.dataset.open = open ? data.verdict.headline + '. ' + data.verdict.sentences.join(' ') : '';
        document.title = data.title;
        top.kind.textContent = data.kind;
        top.title.textContent = data.title;
        printFoot(data.foot);
        const hasMotion = Boolean(data.angle);
        const keeps = !hasMotion && self.keepsPictures && shown;
        pictures.classList.toggle('of-before', keeps);
        if (!keeps) {
          const hasCam = Boolean(data.drawing || data.solid);
          pictures.hidden = !hasMotion;
          stage.hidden = !hasCam;
          pictures.classList.toggle('without-cam', !hasCam);
        }
        if (hasMotion) {
          shown = true;
          angle.use(data.angle.values);
          charts.show(data);
          drawing.show(data.drawing);
          solid.show(data.solid);
        }
        if (open) return;
        words.replaceChildren(camopt.verdictPanel(data));
        if (data.reference) words.append(camopt.referencePanel(data.reference));
        words.append(camopt.figureStrip(data.figures));
        const many = data.tables.find((table) => table.items);
        self.motions = many ? camopt.motions(many, data.pictures) : null;
        motions.replaceChildren(...(many ? [self.motions.host] : data.pictures.map(camopt.paper)));
        if (many) self.motions.fitScatter?.();
        tables.replaceChildren(...data.tables.filter((table) => table !== many).map(camopt.tableSection));
        tables.append(...data.lists.map((list) => element('section', { class: 'table-block' }, element('h2', {}, list.title), camopt.list(list.sentences))));
        end.replaceChildren(...[camopt.sceneSection(data.scene), camopt.appendixSection(data)].filter((part) => part));
        end.hidden = !end.children.length;
        foot.textContent = 'Made by camopt ' + data.camopt + '. This page loads no external resources.';
      },
    };
    return self;
  };

  camopt.page = camopt.report(document.getElementById('page'));
  camopt.page.show(JSON.parse(document.getElementById('page-data').textContent));
  document.documentElement.dataset.ready = 'true';
})(window.Camopt);
