// SPDX-License-Identifier: MIT
// The panel beside the report: state of the solve, undo, groups of controls, laws, scene text, downloads.
'use strict';
(function (camopt) {
  const { element } = camopt;

  /** What a list of controls looks like, whatever the values. */
  const shapeOf = (controls) => controls.map((one) => [camopt.controlPath(one), one.given, one.type].join(' ')).join('\n');

  /** Which segment an angle of a closed program takes from. */
  function giverRow(controls, giver) {
    const angles = camopt.turnAngles(controls);
    if (!angles.length) return null;
    const select = element('select', { 'data-control': 'giver', 'aria-label': 'An angle takes from' }, element('option', { value: '' }, 'the next segment'),
      ...angles.map((one) => element('option', { value: camopt.controlPath(one) }, one.table.replace(/^.*\[(\d+)\]$/, 'segment $1'))));
    select.value = angles.some((one) => camopt.controlPath(one) === giver.path) ? giver.path : '';
    select.addEventListener('change', () => { giver.path = select.value; });
    return element('div', { class: 'control', title: 'The angles add up to 360°: what one gains, another loses.' }, element('span', { class: 'control-name' }, 'an angle takes from'), select);
  }

  /** Groups of controls by table; rebuilt only where keys came or went. */
  function controlGroups(set, giver) {
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
          element('summary', {}, table.replaceAll('_', ' ')), ...made, table === 'motion' ? giverRow(controls, giver) : null, camopt.addKey(table, own.filter((one) => !one.given), set));
        group.addEventListener('toggle', () => { if (group.open) closed.delete(table); else closed.add(table); });
        return group;
      }));
    }
    return {
      host,
      /** refused: what was written or moved is none of the scene, and goes. */
      show(controls, refused) {
        const fresh = shapeOf(controls);
        if (fresh !== shape) build(controls);
        shape = fresh;
        for (const one of controls) if (one.given) rows.get(camopt.controlPath(one)).show(one, refused);
        if (refused) for (const field of host.querySelectorAll('.new-value input')) field.value = '';
      },
    };
  }

  function lawChoice(catalogue, chosen, change) {
    const host = element('details', { class: 'group laws' }, element('summary', {}, 'compared laws'));
    catalogue.forEach((law, place) => {
      const box = element('input', { type: 'checkbox', 'data-law': law.key });
      box.addEventListener('change', () => { if (box.checked) chosen.add(law.key); else chosen.delete(law.key); change(); });
      host.append(element('label', { class: 'law' }, box, element('span', { class: 'swatch', 'data-colour': String(place) }), law.title, element('span', { class: 'misfit', 'data-misfit': law.key })));
    });
    return host;
  }

  function sceneEditor(use) {
    const text = element('textarea', { rows: '14', spellcheck: 'false', 'aria-label': 'Scene file, TOML' });
    const unused = element('p', { class: 'unused', hidden: true }, 'Not applied: the scene is unchanged.');
    let held = '', asked = null;
    const mark = () => { unused.hidden = text.value === held; };
    const ask = () => { asked = text.value; use(asked); };
    text.addEventListener('input', mark);
    const file = element('input', { type: 'file', accept: '.toml', 'aria-label': 'Open a scene file' });
    file.addEventListener('change', async () => { if (file.files.length) { text.value = await file.files[0].text(); mark(); ask(); } });
    const host = element('details', { class: 'group editor' }, element('summary', {}, 'scene file'), text, unused,
      element('div', { class: 'buttons' }, element('button', { type: 'button', 'data-control': 'use-scene', onclick: ask }, 'Use this text'), file));
    /** given: the text that the scene was made of. */
    return { host, show(scene, given) { if (text.value === held || given === asked) text.value = scene; held = scene; mark(); } };
  }

  const downloadWords = { scene: 'Scene (TOML)', motion: 'Motion (CSV)', cam: 'Cam (CSV)', dxf: 'Cam (DXF)', result: 'Result (JSON)', report: 'Report (HTML)' };

  camopt.studioPanel = function (begin, actions) {
    const undo = element('button', { type: 'button', 'data-control': 'undo', title: 'Ctrl+Z', onclick: actions.undo }, 'Undo');
    const redo = element('button', { type: 'button', 'data-control': 'redo', title: 'Ctrl+Shift+Z', onclick: actions.redo }, 'Redo');
    const headline = element('p', { class: 'headline', 'aria-live': 'polite' }), figures = element('dl', { class: 'live-figures' });
    const name = element('p', { class: 'kind' }, 'Studio · ' + begin.name);
    const fault = element('p', { class: 'fault', role: 'alert', hidden: true }), state = element('span', { class: 'solving' });
    const groups = controlGroups(actions.set, actions.giver), editor = sceneEditor(actions.use);
    const laws = lawChoice(begin.catalogue, actions.laws, actions.lawsChanged);
    const downloads = element('div', { class: 'group downloads' }, element('h2', {}, 'Download'), element('div', { class: 'buttons' },
      ...begin.downloads.map((name) => element('button', { type: 'button', 'data-download-file': name, onclick: () => actions.download(name) }, downloadWords[name] || name))));
    const host = element('aside', { class: 'studio', 'aria-label': 'Studio' },
      element('div', { class: 'studio-head' }, name, element('div', { class: 'buttons' }, undo, redo, state), headline, figures, fault),
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
      controls(answer, given, refused) {
        name.textContent = 'Studio · ' + (given === begin.scene ? begin.name : 'text from this page');
        groups.show(answer.controls, refused);
        editor.show(answer.scene, given);
      },
      history(canUndo, canRedo) { undo.disabled = !canUndo; redo.disabled = !canRedo; },
      fault(text) { fault.textContent = text || ''; fault.hidden = !text; },
      solving(on) { state.textContent = on ? 'solving …' : ''; },
    };
  };
})(window.Camopt);
