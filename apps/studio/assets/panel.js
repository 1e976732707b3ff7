// SPDX-License-Identifier: MIT
// The panel beside the report: state of the solve, undo, groups of controls, laws, scene text, downloads.
'use strict';
(function (camopt) {
  const { element } = camopt;

  /** What a list of controls looks like, whatever the values. */
  const shapeOf = (controls) => controls.map((one) => [camopt.controlPath(one), one.given, one.type, ['kind', 'type', 'least', 'largest'].includes(one.item) ? one.value : ''].join(' ')).join('\n');

  /** Which segment an angle of a closed program takes from. */
  function giverRow(controls, giver) {
    const angles = camopt.turnAngles(controls);
    if (!angles.length) return null;
    const select = element('select', { 'data-control': 'giver', 'aria-label': 'An angle takes from' }, element('option', { value: '' }, 'the next segment'),
      ...angles.map((one) => element('option', { value: camopt.controlPath(one) }, one.group.toLowerCase())));
    select.value = angles.some((one) => camopt.controlPath(one) === giver.path) ? giver.path : '';
    select.addEventListener('change', () => { giver.path = select.value; });
    return element('div', { class: 'control', title: 'The angles add up to 360°: what one gains, another loses.' }, element('span', { class: 'control-name' }, 'an angle takes from'), select);
  }

  /** The buttons of a table that add and remove entries of lists. */
  function listButtons(table, controls, edit) {
    const own = controls.filter((one) => one.table === table);
    const button = (name, words, act) => element('button', { type: 'button', class: 'small', 'data-edit': name, onclick: act }, words);
    const value = (item) => (own.find((one) => one.item === item) || {}).value, segment = /^motion\.segments\[(\d+)\]$/.exec(table), made = [];
    const index = segment ? Number(segment[1]) : 0;
    if (segment ? value('kind') === 'spline' : table === 'motion' && !['program', 'valve'].includes(value('type'))) made.push(button('add-point', '+ set point', () => edit((edits, unit) => edits.addPoint(table, unit))));
    if (segment) {
      made.push(button('add-dwell', '+ dwell after', () => edit((edits, unit) => edits.addSegment(index, 'dwell', unit))),
        button('add-stroke', '+ stroke after', () => edit((edits, unit) => edits.addSegment(index, 'spline', unit))));
      if (controls.some((one) => one.table === 'motion.segments[1]')) made.push(button('remove', 'Remove segment', () => edit((edits) => edits.removeSegment(index))));
    }
    if (/\.via\[\d+\]$/.test(table)) made.push(button('remove', 'Remove set point', () => edit((edits) => edits.remove(table))));
    return made.length ? element('div', { class: 'buttons list-buttons' }, ...made) : null;
  }

  /** Groups of controls by table; rebuilt only where keys came or went. */
  function controlGroups({ set, giver, edit }) {
    const host = element('div', { class: 'groups' });
    let shape = '', rows = new Map();
    const closed = new Set(['solver']);
    function build(controls) {
      const tables = [...new Set(controls.map((one) => one.table))];
      rows = new Map();
      const valueOf = (path) => controls.find((one) => one.given && camopt.controlPath(one) === path)?.value;
      host.replaceChildren(...tables.map((table) => {
        const own = controls.filter((one) => one.table === table);
        const made = own.filter((one) => one.given).map((one) => { const row = camopt.controlRow(one, set, valueOf); rows.set(camopt.controlPath(one), row); return row.row; });
        const group = element('details', { class: 'group', open: !closed.has(table), 'data-table': table },
          element('summary', {}, own[0].group), listButtons(table, controls, edit), ...made, table === 'motion' ? giverRow(controls, giver) : null, camopt.addKey(table, own.filter((one) => !one.given), set));
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
    const host = element('details', { class: 'group laws' }, element('summary', {}, 'Compared laws'));
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
    const ask = () => use(text.value);
    text.addEventListener('input', mark);
    const file = element('input', { type: 'file', accept: '.toml', 'aria-label': 'Open a scene file' });
    file.addEventListener('change', async () => { if (file.files.length) use(await file.files[0].text(), file.files[0].name); file.value = ''; });
    const host = element('details', { class: 'group editor' }, element('summary', {}, 'Scene file'), text, unused,
      element('div', { class: 'buttons' }, element('button', { type: 'button', 'data-control': 'use-scene', onclick: ask }, 'Use this text'), file));
    /** given: the text that the scene was made of. */
    return {
      host,
      show(scene, given) { if (text.value === held || given === asked) text.value = scene; held = scene; mark(); },
      /** A text from elsewhere replaces what is in the editor, once it is the scene. */
      asked(scene) { asked = scene; },
      /** A refused text, to be corrected. */
      correct(scene) { text.value = scene; host.open = true; mark(); },
    };
  }

  /** A button a file; those of controllers in one choice. What a scene has not is not shown. */
  function downloadPart(files, download) {
    const isController = (file) => file.name.startsWith('plc_');
    const buttons = files.filter((file) => !isController(file)).map((file) => element('button', { type: 'button', 'data-download-file': file.name, onclick: () => download(file.name) }, file.words));
    const select = element('select', { 'aria-label': 'Controller', 'data-control': 'controller' }, ...files.filter(isController).map((file) => element('option', { value: file.name }, file.words.replace('Controller: ', ''))));
    const host = element('div', { class: 'group downloads' }, element('h2', {}, 'Download'), element('div', { class: 'buttons' }, ...buttons),
      element('div', { class: 'buttons controller' }, select, element('button', { type: 'button', 'data-download-file': 'plc', onclick: () => download(select.value) }, 'Controller table (PLC)')));
    return { host, show(names) { for (const button of buttons) button.hidden = !names.includes(button.dataset.downloadFile); } };
  }

  function unitChoice(change) {
    const select = element('select', { 'aria-label': 'Units', 'data-control': 'units' }, element('option', { value: 'mm' }, 'mm'), element('option', { value: 'in' }, 'inch'));
    select.addEventListener('change', () => change(select.value));
    return { host: element('label', { class: 'units' }, 'Units ', select), show(units) { select.value = units; } };
  }

  camopt.studioPanel = function (begin, actions) {
    const undo = element('button', { type: 'button', 'data-control': 'undo', title: 'Ctrl+Z', onclick: actions.undo }, 'Undo');
    const redo = element('button', { type: 'button', 'data-control': 'redo', title: 'Ctrl+Shift+Z', onclick: actions.redo }, 'Redo');
    const headline = element('p', { class: 'headline', 'aria-live': 'polite' }), figures = element('dl', { class: 'live-figures' });
    const name = element('p', { class: 'kind' }, 'Studio · ' + begin.name);
    const fault = element('p', { class: 'fault', role: 'alert', hidden: true }), state = element('span', { class: 'solving' });
    const groups = controlGroups(actions), editor = sceneEditor(actions.use);
    const laws = lawChoice(begin.catalogue, actions.laws, actions.lawsChanged);
    const showFault = (text) => { fault.textContent = text || ''; fault.hidden = !text; };
    const downloads = downloadPart(begin.files, actions.download), units = unitChoice(actions.units);
    const host = element('aside', { class: 'studio', 'aria-label': 'Studio' },
      element('div', { class: 'studio-head' }, name, element('div', { class: 'buttons' }, undo, redo, units.host, state), headline, figures, fault),
      element('details', { class: 'all-groups', open: true }, element('summary', {}, 'Controls'), groups.host, laws, editor.host, downloads.host));
    camopt.refused.listen(showFault);
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
        name.textContent = 'Studio · ' + (given.name || (given.typed ? 'text from this page' : begin.name));
        groups.show(answer.controls, refused);
        editor.show(answer.scene, given.scene);
        units.show(answer.units);
        downloads.show(answer.downloads);
      },
      history(canUndo, canRedo) { undo.disabled = !canUndo; redo.disabled = !canRedo; },
      fault: showFault,
      asked: editor.asked,
      correct: editor.correct,
      solving(on) { state.textContent = on ? 'solving …' : ''; },
    };
  };
})(window.Camopt);
