// SPDX-License-Identifier: MIT
// The panel beside the report: state of the solve, undo, groups of controls, laws, scene text, downloads.
'use strict';
(function (camopt) {
  const { element } = camopt;

  /** What a list of controls looks like, whatever the values. */
  const shapeOf = (controls) => controls.map((one) => [camopt.controlPath(one), one.given, one.type].join(' ')).join('\n');

  /** Groups of controls by table; rebuilt only where keys came or went. */
  function controlGroups(set) {
    const host = element('div', { class: 'groups' });
    let shape = '', rows = new Map();
    const closed = new Set(['solver']);
    function build(controls) {
      const tables = [...new Set(controls.map((one) => one.table))];
      rows = new Map();
      host.replaceChildren(...tables.map((table) => {
        const own = controls.filter((one) => one.table === table);
        const made = own.filter((one) => one.given).map((one) => { const row = camopt.controlRow(one, set); rows.set(camopt.controlPath(one), row); return row.row; });
        const group = element('details', { class: 'group', open: !closed.has(table), 'data-table': table },
          element('summary', {}, table.replaceAll('_', ' ')), ...made, camopt.addKey(table, own.filter((one) => !one.given), set));
        group.addEventListener('toggle', () => { if (group.open) closed.delete(table); else closed.add(table); });
        return group;
      }));
    }
    return {
      host,
      show(controls) {
        const fresh = shapeOf(controls);
        if (fresh !== shape) build(controls);
        shape = fresh;
        for (const one of controls) if (one.given) rows.get(camopt.controlPath(one)).show(one);
      },
    };
  }

  function lawChoice(catalogue, chosen, change) {
    const host = element('details', { class: 'group laws' }, element('summary', {}, 'laws beside'));
    catalogue.forEach((law, place) => {
      const box = element('input', { type: 'checkbox', 'data-law': law.key });
      box.addEventListener('change', () => { if (box.checked) chosen.add(law.key); else chosen.delete(law.key); change(); });
      host.append(element('label', { class: 'law' }, box, element('span', { class: 'swatch', 'data-colour': String(place) }), law.title, element('span', { class: 'misfit', 'data-misfit': law.key })));
    });
    return host;
  }

  function sceneEditor(use) {
    const text = element('textarea', { rows: '14', spellcheck: 'false', 'aria-label': 'Scene file, TOML' });
    const file = element('input', { type: 'file', accept: '.toml', 'aria-label': 'Open a scene file' });
    file.addEventListener('change', async () => { if (file.files.length) { text.value = await file.files[0].text(); use(text.value); } });
    const host = element('details', { class: 'group editor' }, element('summary', {}, 'scene file'), text,
      element('div', { class: 'buttons' }, element('button', { type: 'button', 'data-control': 'use-scene', onclick: () => use(text.value) }, 'Use this text'), file));
    return { host, show(scene) { if (document.activeElement !== text) text.value = scene; } };
  }

  const downloadWords = { scene: 'Scene (TOML)', motion: 'Motion (CSV)', cam: 'Cam (CSV)', dxf: 'Cam (DXF)', result: 'Result (JSON)', report: 'Report (HTML)' };

  camopt.studioPanel = function (begin, actions) {
    const undo = element('button', { type: 'button', 'data-control': 'undo', title: 'Ctrl+Z', onclick: actions.undo }, 'Undo');
    const redo = element('button', { type: 'button', 'data-control': 'redo', title: 'Ctrl+Shift+Z', onclick: actions.redo }, 'Redo');
    const headline = element('p', { class: 'headline', 'aria-live': 'polite' }), figures = element('dl', { class: 'live-figures' });
    const fault = element('p', { class: 'fault', role: 'alert', hidden: true }), state = element('span', { class: 'solving' });
    const groups = controlGroups(actions.set), editor = sceneEditor(actions.use);
    const laws = lawChoice(begin.catalogue, actions.laws, actions.lawsChanged);
    const downloads = element('div', { class: 'group downloads' }, element('h2', {}, 'Download'), element('div', { class: 'buttons' },
      ...begin.downloads.map((name) => element('button', { type: 'button', 'data-download-file': name, onclick: () => actions.download(name) }, downloadWords[name] || name))));
    const host = element('aside', { class: 'studio', 'aria-label': 'Studio' },
      element('div', { class: 'studio-head' }, element('p', { class: 'kind' }, 'Studio · ' + begin.name), element('div', { class: 'buttons' }, undo, redo, state), headline, figures, fault),
      element('details', { class: 'all-groups', open: true }, element('summary', {}, 'Controls'), groups.host, laws, editor.host, downloads));
    return {
      host,
      /** The verdict in one line, with the first figures. */
      status(answer) {
        headline.textContent = answer.data.verdict.headline;
        headline.dataset.tone = answer.data.verdict.tone;
        headline.dataset.objective = String(answer.objective);
        headline.dataset.stage = answer.stage;
        figures.replaceChildren(...answer.data.figures.map((figure) => element('div', {}, element('dt', {}, figure.name), element('dd', {}, figure.value))));
        for (const mark of laws.querySelectorAll('[data-misfit]')) {
          const law = answer.laws.find((one) => one.key === mark.dataset.misfit);
          mark.textContent = law && law.misfit ? law.misfit : '';
        }
      },
      controls(answer) { groups.show(answer.controls); editor.show(answer.scene); },
      history(canUndo, canRedo) { undo.disabled = !canUndo; redo.disabled = !canRedo; },
      fault(text) { fault.textContent = text || ''; fault.hidden = !text; },
      solving(on) { state.textContent = on ? 'solving …' : ''; },
    };
  };
})(window.Camopt);
