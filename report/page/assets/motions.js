// SPDX-License-Identifier: MIT
// Tables whose rows are motions: sorted, any column over any other, all over one another. What the pointer or the keys
// rest on is named; a click or Enter saves its scene.
'use strict';
(function (camopt) {
  const { element, numberText, colour } = camopt;
  const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);

  /** Steps of 1, 2, 5 over a range. */
  function ticksOf(low, high, wanted) {
    const rough = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(rough));
    const step = power * ([1, 2, 5, 10].find((one) => one * power >= rough) || 10), ticks = [];
    for (let i = Math.ceil(low / step); i * step <= high + 1e-9 * step; ++i) ticks.push(i * step);
    return ticks;
  }

  /** A value of a column: a number, a text, both as a list, or null. */
  const numberOf = (value) => Array.isArray(value) ? value[0] : value;
  const textOf = (value) => value === null ? '' : Array.isArray(value) ? value[1] : isNumber(value) ? numberText(value, 7) : value;

  class Motions {
    constructor(data, pictures) {
      this.data = data;
      this.host = element('div', { class: 'study' });
      this.tip = element('div', { class: 'tip', hidden: true });
      this.notice = element('div', { role: 'status' });
      this.status = element('p', { class: 'hidden-status', role: 'status' });
      const parts = [this.overlay(), ...pictures.map((text) => this.picture(text)), this.explorer(), this.table(), this.tip, this.notice, this.status];
      this.host.append(...parts.filter((part) => part));
    }

    /** The scene of an item as text; null: it has none. */
    sceneOf(item) {
      const scenes = this.data.scenes;
      if (!scenes || !scenes.edits || !scenes.edits[item]) return null;
      const lines = scenes.base.split('\n');
      for (const [line, text] of scenes.edits[item]) {
        if (line < 0) return text;
        lines[line] = text;
      }
      return lines.join('\n');
    }

    /** The command that solves an item of a page without scenes; null: it has scenes. */
    commandOf(item) {
      const without = this.data.without_scenes, name = this.data.items.names[item], colon = name.indexOf(': ');
      if (!without || colon < 0) return null;
      return without.command + name.slice(colon + 2).split(', ').map((one) => ' --set ' + one).join('');
    }

    /** What cannot be handed out is told, with the way to get it. */
    tellCommand(item) {
      const command = this.commandOf(item);
      if (command === null) return;
      const close = element('button', { type: 'button', onclick: () => this.notice.replaceChildren() }, 'Close');
      const copy = element('button', { type: 'button', onclick: () => { navigator.clipboard?.writeText(command); } }, 'Copy');
      this.notice.replaceChildren(element('div', { class: 'notice' }, element('p', {}, this.data.without_scenes.words),
        element('pre', {}, command), element('p', { class: 'controls-line' }, copy, ' ', close)));
      this.notice.querySelector('button').focus({ preventScroll: true });
    }

    handOut(item) {
      const text = this.sceneOf(item);
      if (text === null) { this.tellCommand(item); return; }
      const name = this.data.items.names[item].normalize('NFKD').replace(/[^A-Za-z0-9]+/g, '_').replace(/^_|_$/g, '').slice(0, 60);
      camopt.download(name + '.toml', text, 'application/toml');
      this.status.textContent = 'Downloaded ' + name + '.toml';
    }

    words(item) {
      return this.data.columns.filter((column) => column.values[item] !== null && column.values[item] !== '')
        .map((column) => column.title + ': ' + textOf(column.values[item]));
    }

    point(item, x, y) {
      if (item === this.pointed) return this.placeTip(x, y);
      this.mark(this.pointed, false);
      this.pointed = item;
      this.mark(item, true);
      if (item === null || item === undefined) { this.tip.hidden = true; return undefined; }
      const scene = this.sceneOf(item) !== null;
      this.tip.replaceChildren(element('strong', {}, this.data.items.names[item]), ...this.words(item).map((line) => element('div', {}, line)),
        scene ? element('div', { class: 'tip-hint' }, 'click: its scene as TOML')
          : this.commandOf(item) !== null ? element('div', { class: 'tip-hint' }, 'click: the command that solves its scene') : null);
      this.tip.hidden = false;
      return this.placeTip(x, y);
    }

    placeTip(x, y) {
      if (x === undefined || this.tip.hidden) return;
      this.tip.style.left = Math.max(4, Math.min(x + 14, innerWidth - this.tip.offsetWidth - 8)) + 'px';
      this.tip.style.top = Math.max(4, Math.min(y + 14, innerHeight - this.tip.offsetHeight - 8)) + 'px';
    }

    mark(item, on) {
      if (item === null || item === undefined) return;
      this.host.querySelectorAll(`[data-item="${item}"]`).forEach((one) => one.classList.toggle('pointed', on));
    }

    /** Pointer, keys and click of anything that stands for an item. */
    listen(one, item) {
      one.dataset.item = item;
      one.addEventListener('mousemove', (event) => this.point(item, event.clientX, event.clientY));
      one.addEventListener('mouseleave', () => this.point(null));
      one.addEventListener('focus', () => { const box = one.getBoundingClientRect(); this.point(item, box.right, box.bottom); });
      one.addEventListener('blur', () => this.point(null));
      one.addEventListener('click', () => this.handOut(item));
      one.addEventListener('keydown', (event) => { if (event.key === 'Enter') this.handOut(item); });
    }

    picture(text) {
      const picture = camopt.paper(text);
      const at = new Map(this.data.items.numbers.map((number, item) => [String(number), item]));
      picture.querySelectorAll('svg [class]').forEach((one) => {
        const found = /(?:^| )r(\d+)(?: |$)/.exec(one.getAttribute('class'));
        if (found && at.has(found[1])) this.listen(one, at.get(found[1]));
      });
      return picture;
    }

    /** Any column against any other. */
    explorer() {
      const numeric = this.data.columns.map((column) => ({ ...column, values: column.values.map(numberOf) }))
        .filter((column) => column.values.filter(isNumber).length > 1);
      if (numeric.length < 2) return null;
      const chosen = { x: this.data.axes.x, y: this.data.axes.y };
      const host = element('div', { class: 'scatter' });
      const select = (axis, words) => {
        const made = element('select', { 'aria-label': words }, ...numeric.map((column) =>
          element('option', { value: column.key, selected: column.key === chosen[axis] }, column.title)));
        made.addEventListener('change', () => { chosen[axis] = made.value; draw(); });
        return made;
      };
      const draw = () => host.replaceChildren(this.scatter(numeric.find((column) => column.key === chosen.x) || numeric[0],
        numeric.find((column) => column.key === chosen.y) || numeric[1]));
      // Drawn for the width there is, so that its letters keep their size on a telephone.
      let drawn = 0;
      this.fitScatter = () => {
        const width = Math.round(Math.min(Math.max(host.clientWidth - 14, 300), 960));
        if (width === drawn || camopt.isPrinting()) return;
        drawn = this.scatterWidth = width;
        draw();
      };
      new ResizeObserver(this.fitScatter).observe(host);
      return element('section', { class: 'study-block' }, element('h2', {}, 'One figure over another'),
        element('p', { class: 'controls-line' }, select('y', 'Figure upwards'), ' over ', select('x', 'Figure to the right')), host);
    }

    scatter(x, y) {
      const width = this.scatterWidth || 860, height = Math.max(300, width / 2), left = width < 560 ? 62 : 74, right = 18, top = 14, bottom = 46;
      const items = this.data.items.names.map((name, item) => item).filter((item) => isNumber(x.values[item]) && isNumber(y.values[item]));
      const range = (column) => {
        const values = items.map((item) => column.values[item]), low = Math.min(...values), high = Math.max(...values);
        const room = 0.06 * (high - low) || Math.abs(high) * 0.1 || 1;
        return [low - room, high + room];
      };
      const [x0, x1] = range(x), [y0, y1] = range(y);
      const px = (value) => left + (width - left - right) * (value - x0) / (x1 - x0);
      const py = (value) => height - bottom - (height - top - bottom) * (value - y0) / (y1 - y0);
      const svg = element('svg', { viewBox: `0 0 ${width} ${height}`, role: 'group', 'aria-label': y.title + ' over ' + x.title });
      for (const tick of ticksOf(x0, x1, Math.max(5, width / 120))) svg.append(element('line', { class: 'grid', x1: px(tick), x2: px(tick), y1: top, y2: height - bottom }),
        element('text', { x: px(tick), y: height - bottom + 17, 'text-anchor': 'middle' }, numberText(tick, 6)));
      for (const tick of ticksOf(y0, y1, 6)) svg.append(element('line', { class: 'grid', x1: left, x2: width - right, y1: py(tick), y2: py(tick) }),
        element('text', { x: left - 8, y: py(tick) + 4, 'text-anchor': 'end' }, numberText(tick, 6)));
      svg.append(element('text', { class: 'axis', x: (left + width - right) / 2, y: height - 8, 'text-anchor': 'middle' }, x.title),
        element('text', { class: 'axis', x: 0, y: 0, 'text-anchor': 'middle', transform: `translate(16 ${(top + height - bottom) / 2}) rotate(-90)` }, y.title));
      for (const item of items) {
        const dot = element('circle', { class: 'dot ' + this.data.items.tones[item], cx: px(x.values[item]), cy: py(y.values[item]), r: 5,
          tabindex: items.length <= 60 ? 0 : null, role: 'button', 'aria-label': this.data.items.names[item] });
        this.listen(dot, item);
        svg.append(dot);
      }
      if (items.length <= 40) this.nameDots(svg, items, (item) => [px(x.values[item]), py(y.values[item])], { left, right: width - right, top, bottom: height - bottom });
      return svg;
    }

    /** Names beside dots, where there is room for them. */
    nameDots(svg, items, place, frame) {
      const taken = items.map((item) => { const [x, y] = place(item); return [x - 6, y - 6, x + 6, y + 6]; });
      for (const item of items) {
        const [x, y] = place(item), name = this.data.items.names[item].split(':')[0], width = 6.1 * name.length;
        for (const [left, below] of [[x + 9, y - 6], [x - 9 - width, y - 6], [x - width / 2, y - 20], [x - width / 2, y + 8]]) {
          const box = [left, below, left + width, below + 12];
          if (box[0] < frame.left || box[2] > frame.right || box[1] < frame.top || box[3] > frame.bottom) continue;
          if (taken.some((one) => box[0] < one[2] && one[0] < box[2] && box[1] < one[3] && one[1] < box[3])) continue;
          taken.push(box);
          svg.append(element('text', { class: 'dot-name', x: left, y: below + 10 }, name));
          break;
        }
      }
    }

    overlay() {
      const overlay = this.data.overlay;
      if (!overlay) return null;
      this.plots = [];
      const host = element('div', { class: 'overlay' });
      // Thirty laws are a grey band; what the pointer is near stands out, the optimum always.
      const isBest = (item) => this.data.items.tones[item] === 'good';
      const hue = (item) => item === this.curve ? colour('now') : isBest(item) ? colour('curve') : colour('rule');
      const shown = overlay.curves[0].lines.map((line, item) => line ? item : -1).filter((item) => item >= 0)
        .sort((one, other) => isBest(one) - isBest(other));
      const sync = 'camopt-motions';
      for (const curve of overlay.curves) {
        const plotHost = element('div', { class: 'plot', role: 'img', 'aria-label': curve.title + ' of all motions by cam angle; the table below has their peaks' });
        const name = element('output', { class: 'read-out' });
        host.append(element('figure', { class: 'chart' }, element('figcaption', {},
          element('h3', {}, curve.title[0].toUpperCase() + curve.title.slice(1) + ' ', element('span', { class: 'symbol' }, curve.symbol), ', ' + curve.unit), name), plotHost));
        const plot = new uPlot({
          width: 300, height: 230, pxAlign: 0.5, padding: [6, 20, 0, 0], legend: { show: false }, focus: { alpha: 0.55 },
          cursor: { y: false, sync: { key: sync, setSeries: true }, focus: { prox: 24 }, drag: { x: true, y: false }, points: { show: false } },
          scales: { x: { time: false, range: (u, low, high) => [low, high] } },
          axes: [{ stroke: () => colour('quiet'), grid: { stroke: () => colour('grid'), width: 1 }, ticks: { show: false }, size: 26, space: 56,
            values: (u, splits) => splits.map((value) => numberText(value, 6) + '°'), incrs: [1, 2, 5, 10, 15, 30, 45, 60, 90, 120, 180, 360] },
          { stroke: () => colour('quiet'), grid: { stroke: () => colour('grid'), width: 1 }, ticks: { show: false }, size: 62, space: 30,
            values: (u, splits) => splits.map((value) => numberText(value, 6)) }],
          series: [{}].concat(shown.map((item) => ({ label: this.data.items.names[item], stroke: () => hue(item),
            width: isBest(item) ? 2.6 : 1.2, points: { show: false } }))),
          hooks: { setSeries: [(u, series) => {
            const item = series === null || series === undefined ? null : shown[series - 1];
            this.mark(this.curve, false);
            this.curve = item;
            this.mark(item, true);
            for (const one of this.plots) one.name.textContent = item === null || item === undefined ? '' : this.data.items.names[item];
          }] },
        }, [overlay.angles].concat(shown.map((item) => curve.lines[item])), plotHost);
        plot.over.addEventListener('click', () => { if (this.curve !== null && this.curve !== undefined) this.handOut(this.curve); });
        this.plots.push({ plot, plotHost, name });
      }
      const resize = () => this.plots.forEach(({ plot, plotHost }) => plot.setSize({ width: Math.max(220, plotHost.clientWidth), height: 230 }));
      new ResizeObserver(resize).observe(host);
      camopt.themeChanged.listen(() => this.plots.forEach(({ plot }) => plot.redraw(false)));
      camopt.printing.listen((on) => this.plots.forEach(({ plot }) => plot.setSize({ width: on ? 320 : Math.max(220, plot.root.parentElement.clientWidth), height: on ? 190 : 230 })));
      return element('section', { class: 'study-block' }, element('h2', {}, 'The motions superimposed'), host);
    }

    table() {
      const { items } = this.data;
      const heads = this.data.columns.filter((column) => column.values.some((value) => value !== null));
      let rows = items.names.map((name, item) => item), sorted = -1, up = false;
      const body = element('tbody', {});
      const fill = () => body.replaceChildren(...rows.map((item) => lines[item]));
      const lines = items.names.map((name, item) => {
        const row = element('tr', { class: items.tones[item], tabindex: 0 }, ...heads.map((column, i) =>
          element(i === 0 ? 'th' : 'td', { scope: i === 0 ? 'row' : null, class: column.left ? 'left' : null }, textOf(column.values[item]))));
        this.listen(row, item);
        return row;
      });
      const head = element('tr', {}, ...heads.map((column, i) => {
        const button = element('button', { type: 'button', class: 'sort' }, column.title);
        const made = element('th', { scope: 'col', class: column.left ? 'left' : null, 'aria-sort': 'none' }, button);
        button.addEventListener('click', () => {
          up = sorted === i ? !up : true;
          sorted = i;
          const value = (item) => numberOf(column.values[item]);
          rows.sort((one, other) => {
            const a = value(one), b = value(other);
            if (isNumber(a) !== isNumber(b)) return isNumber(a) ? -1 : 1;
            if (!isNumber(a)) return (up ? 1 : -1) * String(a ?? '').localeCompare(String(b ?? ''));
            return (up ? 1 : -1) * (a - b);
          });
          head.querySelectorAll('th').forEach((one, k) => one.setAttribute('aria-sort', k !== i ? 'none' : up ? 'ascending' : 'descending'));
          fill();
        });
        return made;
      }));
      fill();
      return element('section', { class: 'study-block', 'data-table': this.data.key }, element('h2', {}, this.data.title),
        element('p', { class: 'note' }, 'A click on a head sorts. A click on a row, a mark or a curve ' +
          (this.data.without_scenes ? 'shows the command that solves its scene.' : 'saves its scene.') + ' ' + this.data.note),
        element('div', { class: 'table-scroll study-table', tabindex: 0, role: 'region', 'aria-label': this.data.title },
          element('table', {}, element('thead', {}, head), body)));
    }
  }

  /** Of a table; pictures whose marks are its rows. */
  camopt.motions = (table, pictures) => new Motions(table, pictures);
})(window.Camopt);
