// SPDX-License-Identifier: MIT
// Curves by the cam angle, one chart each, with one cursor for all: reference, limits shaded, peaks marked.
'use strict';
(function (camopt) {
  const { element, numberText, colour } = camopt;
  const chartHeight = 168, printHeight = 128, printWidth = 322, labelRoom = 15, frameWidth = 18;  // px; the last: padding and border of a chart (page.css)
  const font = '11px system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

  const dots = (pixels) => pixels * devicePixelRatio;  // of a dash, which the library takes in dots

  /** Value range with room; a limit far beyond the curve stays out of sight. */
  function rangeOf(curve, shown, height, titled) {
    let low = Infinity, high = -Infinity;
    const take = (value) => { if (value !== null && value !== undefined) { low = Math.min(low, value); high = Math.max(high, value); } };
    curve.values.forEach(take);
    if (!(high >= low)) return [-1, 1];
    const own = Math.max(Math.abs(low), Math.abs(high));
    for (const name of ['reference', 'measured'])
      if (shown[name] && curve[name]) curve[name].values.forEach((value) => { if (value !== null && Math.abs(value) < 3 * own) take(value); });
    curve.marks.forEach((mark) => take(mark.value));
    if (shown.band && curve.band) [curve.band.low, curve.band.high].forEach((edge) => edge.forEach(take));
    if (shown.measured && curve.points) curve.points.forEach((point) => take(point[1]));
    if (shown.limits) curve.limits.forEach((limit) => { if (Math.abs(limit.at) < 2.2 * own) take(limit.at); });
    if (low > 0 && low < 0.6 * high) low = 0;
    if (high < 0 && high > 0.6 * low) high = 0;
    const size = high - low || Math.abs(high) || 1;
    // Above and below marked points a label needs its own height: this part of the axis.
    const part = Math.min(25 / Math.max(height - 32, 60), 0.3);
    const labelled = (sign) => shown.marks && curve.marks.some((mark) => (mark.value >= 0 ? 1 : -1) === sign);
    const above = titled || labelled(1), below = low !== 0 && labelled(-1);
    const room = size * part / (1 - part * (above + below));
    return [low - (low === 0 ? 0.03 * size : below ? room : 0.08 * size), high + (above ? room : 0.08 * size)];
  }

  /** How much of what is drawn lies under a rectangle of the canvas: rows of curves, and its width for each line of a limit. */
  function inkUnder(u, curve, [left, top, right, bottom]) {
    const first = u.valToIdx(u.posToVal(left, 'x', true)), last = u.valToIdx(u.posToVal(right, 'x', true));
    let rows = 0;
    for (const series of u.data.slice(1))
      for (let row = Math.max(first - 1, 0); row <= last; ++row) {
        if (series[row] === null || series[row] === undefined) continue;
        // From row to row, so that a steep stretch is not stepped over.
        const here = u.valToPos(series[row], 'y', true), next = series[row + 1] ?? series[row];
        const there = u.valToPos(next, 'y', true);
        if (Math.max(here, there) > top && Math.min(here, there) < bottom) rows += 1;
      }
    const lines = curve.limits.filter((limit) => {
      const y = u.valToPos(limit.at, 'y', true);
      return y > top && y < bottom && u.valToPos(limit.from, 'x', true) < right && u.valToPos(limit.to, 'x', true) > left;
    });
    return rows / Math.max(last - first, 1) + lines.length;
  }

  /** A text beside a place on the canvas, within the plot and over no other, where it hides least; false where there is no room. */
  function label(u, curve, taken, text, x, y, above, align) {
    const context = u.ctx, ratio = u.pxRatio || devicePixelRatio, box = u.bbox;
    context.font = font.replace(/^11/, String(11 * ratio));
    const width = context.measureText(text).width, height = labelRoom * ratio;
    const near = align === 'right' ? [x - width] : align === 'left' ? [x] : [x - width / 2, x + 4 * ratio, x - width - 4 * ratio];
    const up = y - height - 4 * ratio, down = y + 5 * ratio, step = 5 * ratio;
    const away = (from, towards) => [0, 1, 2, 3, 4, 5, 6].map((k) => from + towards * k * step);
    const tops = above ? [...away(up, -1), ...away(down, 1)] : [...away(down, 1), ...away(up, -1)];
    let best = null;
    near.forEach((wanted, side) => tops.forEach((top, place) => {
      const left = Math.min(Math.max(wanted, box.left + 3 * ratio), box.left + box.width - width - 3 * ratio);
      const rect = [left, top, left + width, top + height];
      if (top < box.top || top + height > box.top + box.height) return;
      if (taken.some((one) => rect[0] < one[2] && one[0] < rect[2] && rect[1] < one[3] && one[1] < rect[3])) return;
      // Off every curve and line where there is such a place; the nearest of them.
      const ink = inkUnder(u, curve, rect);
      const cost = (ink > 0 ? 2 + ink : 0) + 0.06 * (place % 7) + (place < 7 ? 0 : 0.12) + 0.05 * side;
      if (!best || cost < best.cost) best = { cost, rect };
    }));
    if (!best) return false;
    const [left, top] = best.rect;
    taken.push(best.rect);
    context.textAlign = 'left';
    context.textBaseline = 'top';
    context.lineWidth = 3 * ratio;
    context.lineJoin = 'round';
    context.strokeStyle = colour('surface');
    context.strokeText(text, left, top + 1.5 * ratio);
    context.fillText(text, left, top + 1.5 * ratio);
    return true;
  }

  function drawLimits(u, curve) {
    const context = u.ctx, box = u.bbox, ratio = u.pxRatio || devicePixelRatio;
    for (const limit of curve.limits) {
      const left = Math.max(u.valToPos(limit.from, 'x', true), box.left);
      const right = Math.min(u.valToPos(limit.to, 'x', true), box.left + box.width);
      const y = u.valToPos(limit.at, 'y', true);
      if (y < box.top || y > box.top + box.height || right <= left) continue;
      const top = limit.outside > 0 ? box.top : y, bottom = limit.outside > 0 ? y : box.top + box.height;
      context.fillStyle = colour('limit-shade');
      context.fillRect(left, top, right - left, bottom - top);
      context.strokeStyle = colour('limit');
      context.lineWidth = 1.2 * ratio;
      context.setLineDash([5 * ratio, 4 * ratio]);
      context.beginPath();
      context.moveTo(left, y);
      context.lineTo(right, y);
      context.stroke();
      context.setLineDash([]);
    }
  }

  /** Where the curve lies beyond a limit; one that it touches has the rounding of its numbers. */
  function drawViolations(u, curve) {
    const context = u.ctx, angles = u.data[0];
    const rounding = 1e-5 * Math.max(...curve.values.map((value) => Math.abs(value || 0)));
    context.strokeStyle = colour('limit');
    context.lineWidth = 4 * (u.pxRatio || devicePixelRatio);
    for (const limit of curve.limits) {
      let on = false;
      context.beginPath();
      curve.values.forEach((value, row) => {
        const beyond = value !== null && angles[row] >= limit.from && angles[row] <= limit.to &&
          limit.outside * (value - limit.at) > rounding;
        const x = u.valToPos(angles[row], 'x', true), y = u.valToPos(value, 'y', true);
        if (beyond && on) context.lineTo(x, y);
        else if (beyond) context.moveTo(x, y);
        on = beyond;
      });
      context.stroke();
    }
  }

  function nameLimits(u, curve, taken) {
    const box = u.bbox, said = new Set();
    u.ctx.fillStyle = colour('limit');
    for (const limit of curve.limits) {
      const y = u.valToPos(limit.at, 'y', true);
      if (y < box.top || y > box.top + box.height || said.has(limit.words)) continue;
      const right = Math.min(u.valToPos(limit.to, 'x', true), box.left + box.width);
      const left = Math.max(u.valToPos(limit.from, 'x', true), box.left);
      const done = label(u, curve, taken, limit.words, right - 4, y, limit.outside > 0, 'right') ||
        label(u, curve, taken, limit.words, left + 4, y, limit.outside > 0, 'left');
      if (done) said.add(limit.words);
    }
  }

  /** Rows of a measured table. */
  function drawPoints(u, curve) {
    const context = u.ctx, ratio = u.pxRatio || devicePixelRatio, box = u.bbox;
    context.fillStyle = colour('given');
    for (const [at, value] of curve.points || []) {
      const x = u.valToPos(at, 'x', true), y = u.valToPos(value, 'y', true);
      if (x < box.left - 1 || x > box.left + box.width + 1 || y < box.top || y > box.top + box.height) continue;
      context.beginPath();
      context.arc(x, y, 1.8 * ratio, 0, 2 * Math.PI);
      context.fill();
    }
  }

  function drawMarks(u, curve, taken) {
    const context = u.ctx, ratio = u.pxRatio || devicePixelRatio, box = u.bbox;
    for (const mark of curve.marks) {
      const x = u.valToPos(mark.at, 'x', true), y = u.valToPos(mark.value, 'y', true);
      if (x < box.left - 1 || x > box.left + box.width + 1 || y < box.top || y > box.top + box.height) continue;
      if (mark.to !== undefined) {
        context.strokeStyle = colour('given');
        context.lineWidth = 5 * ratio;
        context.globalAlpha = 0.45;
        context.beginPath();
        context.moveTo(x, y);
        context.lineTo(u.valToPos(mark.to, 'x', true), y);
        context.stroke();
        context.globalAlpha = 1;
      }
      context.fillStyle = colour(mark.given ? 'given' : 'curve');
      context.strokeStyle = colour('surface');
      context.lineWidth = 1.5 * ratio;
      context.beginPath();
      if (mark.given) context.rect(x - 4 * ratio, y - 4 * ratio, 8 * ratio, 8 * ratio);
      else context.arc(x, y, 4.2 * ratio, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
      context.fillStyle = colour(mark.given ? 'given' : 'curve-text');
      label(u, curve, taken, mark.words + ' at ' + numberText(mark.at, 5) + '°', x, y, mark.value >= 0, 'middle');
    }
  }

  function drawSegments(u, curve, segments, taken) {
    const context = u.ctx, ratio = u.pxRatio || devicePixelRatio, box = u.bbox;
    context.strokeStyle = colour('rule');
    context.lineWidth = ratio;
    context.setLineDash([2 * ratio, 3 * ratio]);
    segments.forEach((segment, place) => {
      const x = u.valToPos(segment.from, 'x', true);
      if (place === 0 || x < box.left || x > box.left + box.width) return;
      context.beginPath();
      context.moveTo(x, box.top);
      context.lineTo(x, box.top + box.height);
      context.stroke();
    });
    context.setLineDash([]);
    if (curve.key !== 'displacement') return;
    context.fillStyle = colour('quiet');
    for (const segment of segments) {
      const left = u.valToPos(segment.from, 'x', true), right = u.valToPos(segment.to, 'x', true);
      context.font = font.replace(/^11/, String(11 * ratio));
      const width = context.measureText(segment.title).width;
      if (width + 8 * ratio < right - left) label(u, curve, taken, segment.title, (left + right) / 2, box.top + 16 * ratio + 4, true, 'middle');
    }
  }

  const angleTitle = (angle) => angle.title || 'cam angle';

  /** The table of a chart: about seventy rows and those of the marks. */
  function chartTable(curve, angle) {
    const angles = angle.values;
    const step = Math.max(1, Math.round(angles.length / 72)), rows = [];
    const near = new Set();
    for (const mark of curve.marks) {
      let best = 0;
      angles.forEach((angle, row) => { if (Math.abs(angle - mark.at) < Math.abs(angles[best] - mark.at)) best = row; });
      near.add(best);
    }
    const unit = curve.unit ? ' (' + curve.unit + ')' : '';
    const columns = [{ title: angleTitle(angle) + ' (' + angle.unit + ')' }, { title: curve.title + unit }];
    if (curve.beside) columns.push({ title: curve.beside.unit });
    const others = [curve.reference, curve.measured].filter((one) => one);
    others.forEach((one) => columns.push({ title: one.title + unit }));
    angles.forEach((angle, row) => {
      if (row % step !== 0 && row !== angles.length - 1 && !near.has(row)) return;
      const cells = [numberText(angle, 6), numberText(curve.values[row], 6)];
      if (curve.beside) cells.push(curve.values[row] === null ? '–' : numberText(curve.values[row] * curve.beside.factor, 6));
      others.forEach((one) => cells.push(numberText(one.values[row], 6)));
      rows.push(cells);
    });
    return camopt.table({ columns, rows });
  }

  class Chart {
    constructor(all, curve) {
      this.all = all;
      this.key = curve.key;
      this.value = element('output', { class: 'read-out', 'aria-label': curve.title + ' at the cursor' });
      this.heading = element('h3', {});
      this.plotHost = element('div', { class: 'plot', role: 'img', tabindex: '0' });
      this.tableHost = element('details', { class: 'picture-table' }, element('summary', {}, 'Table'));
      this.tableHost.addEventListener('toggle', () => this.fillTable());
      this.figure = element('figure', { class: 'chart', 'data-curve': curve.key },
        element('figcaption', {}, this.heading, this.value), this.plotHost, this.tableHost);
      this.plotHost.addEventListener('keydown', (event) => this.all.key(event));
      this.now = element('div', { class: 'now', 'aria-hidden': 'true' });
    }

    fillTable() {
      while (this.tableHost.children.length > 1) this.tableHost.lastChild.remove();
      if (this.tableHost.open) this.tableHost.append(chartTable(this.curve, this.all.data.angle));
    }

    columns() {
      const shown = this.all.shown;
      const beside = (name) => shown[name] && this.curve[name] ? this.curve[name].values : this.all.nothing;
      const edge = (name) => shown.band && this.curve.band ? this.curve.band[name] : this.all.nothing;
      return [this.all.angle.values, this.curve.values, beside('reference'), beside('measured'), edge('low'), edge('high')];
    }

    show(curve) {
      this.curve = curve;
      this.noise = 1e-11 * Math.max(...curve.values.map((value) => Math.abs(value || 0)));
      const unit = curve.unit ? ', ' + curve.unit : '';
      this.heading.replaceChildren(curve.title + ' ', element('span', { class: 'symbol' }, curve.symbol), unit);
      const marks = curve.marks.map((mark) => mark.words + ' at ' + numberText(mark.at, 5) + ' degrees');
      this.plotHost.setAttribute('aria-label', curve.title + ' by ' + angleTitle(this.all.data.angle) + '. ' + (marks.length ? 'Marked: ' + marks.join('; ') + '. ' : '') +
        'Arrow keys move the cursor; the table below has the numbers.');
      if (this.plot) {
        this.plot.setData(this.columns());
      } else {
        this.plot = this.make();
      }
      this.fillTable();
    }

    make() {
      const all = this.all, self = this;
      const axis = { font, stroke: () => colour('quiet'), grid: { stroke: () => colour('grid'), width: 1 },
        ticks: { stroke: () => colour('grid'), size: 4, width: 1 } };
      const plot = new uPlot({
        width: all.width(), height: all.height(), pxAlign: 0.5, padding: [6, 20, 0, 0],
        legend: { show: false },
        cursor: { y: false, sync: { key: all.syncKey, setSeries: false }, drag: { x: true, y: false },
          points: { size: 7, fill: () => colour('curve') } },
        scales: { x: { time: false, range: (u, low, high) => [low, high] },
          y: { range: () => rangeOf(self.curve, all.shown, all.height(), self.curve.key === 'displacement' && all.data.segments.length > 0) } },
        axes: [
          Object.assign({}, axis, { size: 26, space: 56, values: (u, splits) => splits.map((value) => numberText(value, 6) + '°'),
            incrs: [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 60, 90, 120, 180, 360] }),
          Object.assign({}, axis, { size: 62, space: 30, values: (u, splits) => splits.map((value) => numberText(value, 6)) }),
        ],
        series: [{}, { stroke: () => colour('curve'), width: 2, points: { show: false } },
          { stroke: () => colour('reference'), width: 1.4, dash: [6, 4].map(dots), points: { show: false } },
          { stroke: () => colour('given'), width: 1.4, dash: [2, 3].map(dots), points: { show: false } },
          ...[0, 1].map(() => ({ stroke: () => colour('band'), width: 0.8, points: { show: false } }))],
        bands: [{ series: [5, 4], fill: () => colour('band-shade') }],
        hooks: {
          drawClear: [(u) => { if (all.shown.limits) drawLimits(u, self.curve); }],
          draw: [(u) => {
            const taken = [];
            u.ctx.save();
            drawSegments(u, self.curve, all.data.segments, taken);
            if (all.shown.measured) drawPoints(u, self.curve);
            if (all.shown.marks) drawMarks(u, self.curve, taken);
            if (all.shown.limits) drawViolations(u, self.curve);
            if (all.shown.limits) nameLimits(u, self.curve, taken);
            u.ctx.restore();
            self.place();
          }],
          setCursor: [(u) => {
            // Only the chart under the pointer leads; the others follow its signal.
            if (u.cursor.idx !== null && u.cursor.event && !all.angle.playing && u.over.matches(':hover')) all.angle.setRow(u.cursor.idx);
          }],
          setScale: [(u, key) => { if (key === 'x') all.zoomed(self); }],
        },
      }, this.columns(), this.plotHost);
      plot.over.append(this.now);
      return plot;
    }

    place() {
      if (!this.plot) return;
      const x = this.plot.valToPos(this.all.angle.at, 'x');
      const inside = x >= -0.5 && x <= this.plot.over.clientWidth + 0.5;
      this.now.style.display = inside ? '' : 'none';
      this.now.style.transform = 'translateX(' + x + 'px)';
    }

    read() {
      const exact = this.curve.values[this.all.angle.index];
      const value = exact !== null && Math.abs(exact) < this.noise ? 0 : exact;  // what rounding leaves of nothing
      const unit = this.curve.unit ? ' ' + this.curve.unit : '';
      let text = numberText(value, 6) + unit;
      if (this.curve.beside && value !== null) text += '  (' + numberText(value * this.curve.beside.factor, 5) + ' ' + this.curve.beside.unit + ')';
      this.value.textContent = text;
    }
  }

  /** All charts of a page. show(data) draws, or redraws with what is there. */
  camopt.charts = function (angle) {
    const host = element('div', { class: 'charts' });
    const chips = element('div', { class: 'chips', role: 'group', 'aria-label': 'Curves shown' });
    const charts = new Map(), hidden = new Set(), motor = element('div', { 'data-picture': 'motor' });
    const self = {
      host, chips, angle, charts, data: null, nothing: [], syncKey: 'camopt-' + Math.random(),
      shown: { reference: true, measured: true, band: true, limits: true, marks: true },
      printWidth: 0,
      width() { return self.printWidth || Math.max(host.clientWidth - frameWidth, 220); },
      redraw() { charts.forEach((chart) => { if (chart.plot) { chart.plot.setData(chart.columns()); } }); },
      height() { return self.printWidth ? printHeight : chartHeight; },
      resize() { charts.forEach((chart) => { if (chart.plot) chart.plot.setSize({ width: self.width(), height: self.height() }); }); },
      zoomed(from) {
        if (self.zooming) return;
        self.zooming = true;
        const { min, max } = from.plot ? from.plot.scales.x : {};
        if (min !== undefined && min !== null)
          charts.forEach((chart) => { if (chart !== from && chart.plot) chart.plot.setScale('x', { min, max }); });
        self.zooming = false;
      },
      key(event) {
        const step = event.shiftKey ? 10 : 1;
        if (event.key === 'ArrowRight') angle.setRow(angle.index + step);
        else if (event.key === 'ArrowLeft') angle.setRow(angle.index - step);
        else if (event.key === 'Home') angle.setRow(0);
        else if (event.key === 'End') angle.setRow(angle.values.length - 1);
        else if (event.key === ' ') angle.play(!angle.playing);
        else return;
        if (event.key.startsWith('Arrow')) angle.play(false);
        event.preventDefault();
      },
      show(data) {
        self.data = data;
        self.nothing = data.angle ? data.angle.values.map(() => null) : [];
        const keys = data.curves.map((curve) => curve.key);
        const same = keys.length === charts.size && keys.every((key) => charts.has(key));
        if (!same) build(data);
        data.curves.forEach((curve) => charts.get(curve.key).show(curve));
        motor.replaceChildren(...(data.motor ? [camopt.paper(data.motor)] : []));
        charts.forEach((chart) => { chart.read(); chart.place(); });
      },
    };
    function chip(name, words, isOn, toggle) {
      const button = element('button', { type: 'button', class: 'chip', 'aria-pressed': String(isOn()), 'data-chip': name }, words);
      button.addEventListener('click', () => { toggle(); button.setAttribute('aria-pressed', String(isOn())); });
      return button;
    }
    function build(data) {
      charts.forEach((chart) => { if (chart.plot) chart.plot.destroy(); });
      charts.clear();
      host.replaceChildren();
      chips.replaceChildren();
      const titles = { motion: 'Motion', motor: 'Motor', cam: 'Cam over one revolution', forces: 'Forces over one revolution' };
      for (const group of new Set([...Object.keys(titles), ...data.curves.map((curve) => curve.group)])) {
        const title = titles[group] || group, curves = data.curves.filter((curve) => curve.group === group);
        if (!curves.length) continue;
        host.append(element('h2', {}, title));
        for (const curve of curves) {
          const chart = new Chart(self, curve);
          charts.set(curve.key, chart);
          chart.figure.hidden = hidden.has(curve.key);
          host.append(chart.figure);
          chips.append(chip(curve.key, curve.title.split(',')[0], () => !hidden.has(curve.key), () => {
            if (hidden.has(curve.key)) hidden.delete(curve.key); else hidden.add(curve.key);
            chart.figure.hidden = hidden.has(curve.key);
          }));
        }
        if (group === 'motor') host.append(motor);
      }
      const reference = data.curves.find((curve) => curve.reference);
      const extras = [];
      if (reference) extras.push(['reference', reference.reference.title + ' (dashed)']);
      if (data.curves.some((curve) => curve.measured)) extras.push(['measured', 'measured (dotted, rows as dots)']);
      if (data.curves.some((curve) => curve.band)) extras.push(['band', 'made cams (shaded)']);
      if (data.curves.some((curve) => curve.limits.length)) extras.push(['limits', 'limits']);
      extras.push(['marks', 'marked points']);
      for (const [name, words] of extras)
        chips.append(chip(name, words, () => self.shown[name], () => { self.shown[name] = !self.shown[name]; self.redraw(); }));
    }
    angle.changed.listen(() => charts.forEach((chart) => { if (!chart.figure.hidden && chart.curve) { chart.read(); chart.place(); } }));
    camopt.themeChanged.listen(() => charts.forEach((chart) => { if (chart.plot) chart.plot.redraw(false); }));
    // A label needs another part of a lower chart: the ranges follow the height.
    camopt.printing.listen((on) => { self.printWidth = on ? printWidth : 0; self.resize(); self.redraw(); });
    new ResizeObserver(() => { if (!self.printWidth && charts.size) self.resize(); }).observe(host);
    return self;
  };
})(window.Camopt);
