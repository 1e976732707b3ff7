// SPDX-License-Identifier: MIT
// The studio: what the user sets goes to the program, what it finds is drawn: first the curve, then its proof with
// words and tables, then the rest. One request at a time; while one is under way only the newest wish waits behind it.
'use strict';
(function (camopt) {
  const begin = JSON.parse(document.getElementById('page-data').textContent).studio;
  const page = Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16).padStart(2, '0')).join('');
  const patience = 700; // ms: an older solve that takes longer is given up for a newer wish
  const lawColours = ['#c2410c', '#15803d', '#7e22ce', '#be185d', '#0e7490', '#a16207', '#4d7c0f', '#4338ca'];
  const laws = new Set();

  /** What is asked: a scene's text and what was set since. */
  let now = { scene: begin.scene, set: {} }; // and units, once they are chosen; typed: the user's own text
  let kept = now, good = now;
  const giver = { path: '' };
  const before = [], after = [];
  let wanted = null, running = null, drawn = '';
  /** Of each answer, for who measures: its stage, ms from the wish to the picture, ms of the solve. */
  const times = [];

  /** A request and its Response: from the server that served this page, or from the engine in it (offline.js). */
  camopt.ask ||= (what, body, signal) => fetch(what, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body), signal });
  camopt.lost ??= ' Is camopt studio still running?';

  /** What a picture is of. */
  const subjectOf = (wish) => JSON.stringify([wish.state, wish.laws]);

  /** moving: a slider is still in the hand; only the curve is wanted. */
  function ask(moving) {
    wanted = { stage: 'curve', proof: !moving, since: performance.now(), laws: [...laws], state: now };
    if (!running) work();
    // Nobody waits for the proof of what has changed since.
    else if (running.stage !== 'curve' || performance.now() - running.begun > patience) running.abort.abort();
  }

  async function work() {
    while (wanted) {
      const wish = wanted;
      wanted = null;
      if (wish.stage === 'curve' && wish.proof && drawn === subjectOf(wish)) wish.stage = 'proof'; // its curve is there already
      running = { abort: new AbortController(), begun: performance.now(), stage: wish.stage };
      const late = setTimeout(() => panel.solving(true), 250);
      try {
        await solve(wish, running.abort.signal);
      } catch (error) {
        if (error.name !== 'AbortError') { panel.fault('No answer: ' + error.message + '.' + camopt.lost); takeBack(wish.state); }
      }
      clearTimeout(late);
      panel.solving(false);
      running = null;
    }
    document.documentElement.dataset.settled = String(Number(document.documentElement.dataset.settled || 0) + 1);
  }

  async function solve(wish, signal) {
    const response = await camopt.ask('solve', { page, ...wish.state, laws: wish.laws, stage: wish.stage }, signal);
    const answer = await response.json();
    if (response.status === 409 && wanted) return;
    if (!response.ok) { panel.fault(answer.error); takeBack(wish.state); return; }
    panel.fault('');
    good = wish.state;
    drawn = subjectOf(wish);
    show(answer, wish.state);
    requestAnimationFrame(() => times.push({ stage: wish.stage, ms: performance.now() - wish.since, solve: 1000 * answer.seconds }));
    if (wanted) return;
    if (wish.stage === 'curve' && wish.proof) wanted = { ...wish, stage: 'proof' };
    else if (answer.more) wanted = { ...wish, stage: 'rest' };
  }

  const colourOf = (key) => lawColours[begin.catalogue.findIndex((law) => law.key === key) % lawColours.length];

  /** The laws' curves as further series of the charts of the motion. */
  function overlay(answer) {
    const fitting = answer.laws.filter((law) => law.curves);
    for (const [key, chart] of camopt.page.charts.charts) {
      const beside = fitting.filter((law) => law.curves[key]);
      const own = chart.ownColumns || (chart.ownColumns = chart.columns.bind(chart));
      chart.columns = () => [...own(), ...beside.map((law) => law.curves[key])];
      if (!chart.plot) continue;
      const first = own().length, names = beside.map((law) => law.key);
      if ((chart.lawNames || []).join() === names.join() && chart.lawPlot === chart.plot) continue;
      while (chart.plot.series.length > first) chart.plot.delSeries(chart.plot.series.length - 1);
      beside.forEach((law) => chart.plot.addSeries({ label: law.title, stroke: colourOf(law.key), width: 1.3, points: { show: false } }, chart.plot.series.length));
      chart.lawNames = names;
      chart.lawPlot = chart.plot;
      chart.plot.setData(chart.columns());
    }
  }

  function show(answer, state) {
    const open = answer.stage === 'curve';
    document.body.classList.remove('opening');
    // A chart draws as many columns as it has series: the laws' change between the two.
    if (answer.data.angle) forgetChangedLaws(answer);
    camopt.page.show(answer.data, open);
    if (answer.data.angle) overlay(answer);
    panel.status(answer);
    panel.controls(answer, state);
    camopt.studio.answer = answer;
    layer.show(answer, camopt.page.charts.charts);
  }

  function forgetChangedLaws(answer) {
    const names = answer.laws.filter((law) => law.curves).map((law) => law.key).join();
    for (const [key, chart] of camopt.page.charts.charts) {
      if (!chart.ownColumns) continue;
      const same = (chart.lawNames || []).join() === names;
      const columns = answer.laws.filter((law) => law.curves && law.curves[key]).map((law) => law.curves[key]);
      if (same && chart.lawPlot === chart.plot) { chart.columns = () => [...chart.ownColumns(), ...columns]; continue; }
      chart.columns = chart.ownColumns;
      while (chart.plot && chart.plot.series.length > chart.ownColumns().length) chart.plot.delSeries(chart.plot.series.length - 1);
      chart.lawNames = [];
    }
  }

  function change(next, moving) {
    now = next;
    if (!moving) keep();
    ask(moving);
  }

  /** What the program refused was never there: the fields show what the scene holds again; the reason says what was asked. */
  function takeBack(state) {
    document.body.classList.remove('opening');
    if (state.typed && !Object.keys(state.set).length) panel.correct(state.scene);
    if (kept === state && before.length) kept = before.pop();
    if (now === state) {
      now = good;
      panel.controls(camopt.studio.answer, good, true);
      layer.show(camopt.studio.answer, camopt.page.charts.charts);
      // Of what was seen while a slider moved only the curve is there.
      if (camopt.studio.answer.stage === 'curve' && !wanted) wanted = { stage: 'curve', proof: true, since: performance.now(), laws: [...laws], state: now };
    }
    panel.history(before.length > 0, after.length > 0);
  }

  /** What a path is to be: as set, or as the scene has it. */
  const valueOf = (path) => now.set[path] ?? camopt.studio.answer.controls.find((one) => camopt.controlPath(one) === path).value;

  /** What stands now is what undo comes back to. */
  function keep() {
    if (JSON.stringify(now) === JSON.stringify(kept)) return;
    before.push(kept);
    after.length = 0;
    kept = now;
    panel.history(before.length > 0, after.length > 0);
  }

  function step(from, to) {
    if (!from.length) return;
    to.push(kept);
    now = kept = from.pop();
    panel.history(before.length > 0, after.length > 0);
    ask(false);
  }

  async function download(name) {
    const response = await camopt.ask('export', { page, ...now, what: name }).catch((error) => { panel.fault('No answer: ' + error.message + '.' + camopt.lost); return null; });
    if (!response) return;
    if (!response.ok) { panel.fault((await response.json()).error); return; }
    panel.fault('');
    const file = /filename="([^"]+)"/.exec(response.headers.get('Content-Disposition') || '');
    const address = URL.createObjectURL(await response.blob());
    camopt.element('a', { href: address, download: file ? file[1] : name }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  }

  /** What is set last is applied last. */
  function setAll(settings, moving) {
    const set = { ...now.set };
    for (const key of Object.keys(settings)) delete set[key];
    change({ ...now, set: { ...set, ...settings } }, moving);
  }

  /** One number of the scene, and what an angle of a closed program takes from another. */
  const settingsOf = (key, value, from) => camopt.withGiver(camopt.studio.answer.controls, key, value, from, valueOf);

  /** Entries of lists come and go: what was set before is in the scene's text, so that their numbers stay those of the page. */
  function edit(make) {
    const answer = camopt.studio.answer, page = camopt.page, chart = page.charts.charts.get('displacement');
    const edits = camopt.edits(answer.controls, layer.curveAt, page.angle.at, answer.data.segments);
    if (now === good) now = { ...now, scene: answer.scene, set: {} };
    setAll(make(edits, chart.curve.unit), false);
  }

  const actions = {
    laws, download, giver, edit,
    set: (key, value, moving) => setAll(settingsOf(key, value, giver.path), moving),
    units: (units) => change({ ...now, units }, false),
    /** name: of a file or an example; none: typed on the page. */
    use: (scene, name) => { panel.asked(scene); change({ scene, set: {}, typed: true, name }, false); },
    lawsChanged: () => ask(false),
    undo: () => step(before, after),
    redo: () => step(after, before),
  };
  const panel = camopt.studioPanel(begin, actions);
  const layer = camopt.handleLayer(
    (sizes, moving) => setAll(Object.assign({}, ...Object.entries(sizes).map(([key, value]) => settingsOf(key, value, ''))), moving),
    (table) => edit((edits) => edits.remove(table)));
  document.body.classList.add('with-studio');
  document.body.prepend(panel.host);
  if (window.matchMedia('(max-width: 980px)').matches) panel.host.querySelector('.all-groups').open = false;
  for (const swatch of panel.host.querySelectorAll('.swatch')) swatch.style.background = lawColours[Number(swatch.dataset.colour) % lawColours.length];
  panel.history(false, false);
  document.addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z' || event.target.matches('textarea, input[type=text]:not(.number)')) return;
    event.preventDefault();
    if (event.shiftKey) actions.redo(); else actions.undo();
  });
  camopt.studio = { times, actions, answer: null };
  camopt.page.keepsPictures = true;
  const first = { ...begin, data: JSON.parse(document.getElementById('page-data').textContent) };
  panel.status(first);
  panel.controls(first, now);
  camopt.studio.answer = first;
  layer.show(first, camopt.page.charts.charts);
  document.documentElement.dataset.studio = 'ready';
})(window.Camopt);
