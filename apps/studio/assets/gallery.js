// SPDX-License-Identifier: MIT
// Scenes to begin with: the examples of the page, a file that is dropped on it, and a scene that was written into it.
// Files are read where they are; an address is never opened.
'use strict';
(function (camopt) {
  const { element } = camopt, most = 1000000;
  const block = (id) => { const found = document.getElementById(id); return found && JSON.parse(found.textContent); };
  const use = (scene, name) => camopt.studio.actions.use(scene, name);

  /** Displacements, 0 to 100, as a small curve. */
  function sparkline(values) {
    const points = values.map((value, i) => (4 + 112 * i / (values.length - 1)).toFixed(1) + ',' + (40 - 0.34 * value).toFixed(1));
    return element('svg', { viewBox: '0 0 120 44', 'aria-hidden': 'true' }, element('line', { x1: 4, x2: 116, y1: 40, y2: 40 }), values.length ? element('polyline', { points: points.join(' ') }) : null);
  }

  function gallery(examples) {
    const cards = examples.map((one) => element('button', { type: 'button', class: 'example', 'data-example': one.name, title: one.words, onclick: () => open(one) },
      sparkline(one.curve), element('strong', {}, one.title), element('span', { class: 'example-kind' }, one.kind), element('span', { class: 'example-words' }, one.words)));
    const groups = [...new Set(examples.map((one) => one.group))];
    const strip = element('div', { class: 'example-strip' }, ...cards), none = element('p', { class: 'note', hidden: true }, 'No example has these words.');
    const find = element('input', { type: 'search', placeholder: 'Find: roller, limit, dwell …', 'aria-label': 'Find an example' });
    const chips = ['All', ...groups].map((name) => element('button', { type: 'button', class: 'chip', 'aria-pressed': String(name === 'All'), onclick: () => { chosen = name; filter(); } }, name));
    const all = element('button', { type: 'button', class: 'quiet-button', onclick: () => { strip.classList.toggle('wide'); all.textContent = strip.classList.contains('wide') ? 'One row' : 'Show all'; } }, 'Show all');
    const file = element('input', { type: 'file', accept: '.toml', hidden: true, 'aria-label': 'Open a scene file', onchange: () => { read(file.files); file.value = ''; } });
    let chosen = 'All';
    function filter() {
      const words = find.value.toLowerCase().split(/\s+/).filter(Boolean);
      examples.forEach((one, i) => {
        const text = (one.name + ' ' + one.title + ' ' + one.kind + ' ' + one.words).toLowerCase();
        cards[i].hidden = (chosen !== 'All' && one.group !== chosen) || !words.every((word) => text.includes(word));
      });
      none.hidden = cards.some((card) => !card.hidden);
      for (const chip of chips) chip.setAttribute('aria-pressed', String(chip.textContent === chosen));
    }
    function open(one) {
      for (const card of cards) card.setAttribute('aria-pressed', String(card.dataset.example === one.name));
      use(one.scene, one.name);
    }
    find.addEventListener('input', filter);
    return element('details', { class: 'examples', open: true }, element('summary', {}, 'Examples'),
      element('div', { class: 'example-tools' }, ...chips, find, all,
        element('button', { type: 'button', class: 'quiet-button', 'data-control': 'open-file', onclick: () => file.click() }, 'Open a file …'), file,
        element('span', { class: 'note' }, 'or drop a scene (.toml) on this page. Everything is computed here; nothing is sent.')),
      strip, none);
  }

  /** The first scene file among these. */
  async function read(files) {
    const file = [...files].find((one) => one.name.toLowerCase().endsWith('.toml'));
    if (!file) { camopt.refused.send('This is no scene file; allowed: a text file whose name ends in .toml.'); return; }
    if (file.size > most) { camopt.refused.send(file.name + ': found ' + file.size + ' bytes; allowed: at most ' + most + '.'); return; }
    use(await file.text(), file.name);
  }

  const hasFiles = (event) => Boolean(event.dataTransfer) && [...event.dataTransfer.types].includes('Files');
  const mark = (on) => document.body.classList.toggle('dropping', on);
  document.addEventListener('dragover', (event) => { if (hasFiles(event)) { event.preventDefault(); mark(true); } });
  document.addEventListener('dragleave', (event) => { if (!event.relatedTarget) mark(false); });
  document.addEventListener('drop', (event) => {
    mark(false);
    if (!hasFiles(event)) return;
    event.preventDefault();
    read(event.dataTransfer.files);
  });

  const examples = block('examples');
  if (examples) document.querySelector('#page .top').after(gallery(examples));
  const opening = block('opening-scene');
  if (opening) {
    document.body.classList.add('opening'); // until it is solved: the page holds the answer to another scene
    use(opening.scene, opening.name);
  }
})(window.Camopt);
