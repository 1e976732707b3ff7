// SPDX-License-Identifier: MIT
// A plane cam with its mechanism, drawn to scale and moved by the cam angle.
'use strict';
(function (camopt) {
  const { element, numberText } = camopt;

  /** y points upwards in the data, downwards on the screen. */
  const pathOf = (points, closed) => {
    let path = '', pen = 'M';
    for (let i = 0; i + 1 < points.length; i += 2) {
      if (points[i] === null) { pen = 'M'; continue; }
      path += pen + points[i] + ' ' + -points[i + 1];
      pen = 'L';
    }
    return closed ? path + 'Z' : path;
  };

  function extentOf(drawing) {
    const extent = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
    const see = (x, y, radius = 0) => {
      if (x === null || y === null) return;
      extent.left = Math.min(extent.left, x - radius);
      extent.right = Math.max(extent.right, x + radius);
      extent.low = Math.min(extent.low, y - radius);
      extent.high = Math.max(extent.high, y + radius);
    };
    const [cx, cy] = drawing.center, turns = drawing.turned;
    if (drawing.shifted) {  // a plate: as much of it around the follower as it is long
      const points = drawing.outlines.find((one) => one.closed).points, xs = points.filter((_, i) => i % 2 === 0);
      const half = 0.5 * (Math.max(...xs) - Math.min(...xs));
      for (let i = 1; i < points.length; i += 2) { see(cx - half, cy + points[i]); see(cx + half, cy + points[i]); }
      for (const part of drawing.parts)
        for (let i = 0; i + 1 < part.points.length; i += 2) see(part.points[i], part.points[i + 1], part.radius);
      return extent;
    }
    const step = Math.max(1, Math.floor(turns.length / 48));
    for (const outline of drawing.outlines.filter((one) => one.points))
      for (let row = 0; row < turns.length; row += step) {
        if (turns[row] === null) continue;
        const c = Math.cos(turns[row] * Math.PI / 180), s = Math.sin(turns[row] * Math.PI / 180);
        for (let i = 0; i + 1 < outline.points.length; i += 16) {
          const x = outline.points[i], y = outline.points[i + 1];
          if (x !== null) see(cx + c * x - s * y, cy + s * x + c * y);
        }
      }
    for (const circle of drawing.outlines.filter((one) => one.radius)) see(cx, cy, circle.radius);
    for (const part of drawing.parts)
      for (let i = 0; i + 1 < part.points.length; i += 2) see(part.points[i], part.points[i + 1], part.radius);
    // The arrow of the turn about the axis is part of the picture.
    see(cx, cy, 0.062 * Math.max(extent.right - extent.left, extent.high - extent.low));
    return extent;
  }

  /** 1, 2 or 5 times a power of ten, about this long. */
  const roundLength = (about) => {
    const power = 10 ** Math.floor(Math.log10(about));
    return power * ([5, 2, 1].find((one) => one * power <= about) || 1);
  };

  /** Points of a part at the angle now, between two rows. */
  function pointsNow(part, rows, angle) {
    const size = 2 * part.count;
    if (part.points.length === size) return part.points;
    const [row, next, share] = angle.between(), now = new Array(size);
    for (let i = 0; i < size; ++i) now[i] = part.points[row * size + i] * (1 - share) + part.points[next * size + i] * share;
    return now;
  }

  camopt.drawing = function (angle) {
    const host = element('div', { class: 'drawing' });
    const self = { host, show };
    let data = null, moving = [], turning = null, contact = null;

    function addPart(layer, part, unit) {
      const name = element('title', {}, part.name);
      if (part.kind === 'circle') {
        const group = element('g', { class: 'roller' }, name, element('circle', { r: part.radius }), element('circle', { r: 1.6 * unit, class: 'dot' }));
        layer.append(group);
        return (p) => group.setAttribute('transform', `translate(${p[0]} ${-p[1]})`);
      }
      if (part.kind === 'pivot') {
        const group = element('g', { class: 'pivot' }, name, element('path', { d: `M0 0L${-9 * unit} ${14 * unit}H${9 * unit}Z` }), element('circle', { r: 4.5 * unit }));
        layer.append(group);
        return (p) => group.setAttribute('transform', `translate(${p[0]} ${-p[1]})`);
      }
      if (part.kind === 'guide') {
        const track = element('line', { class: 'track' }), block = element('rect', { class: 'slider', width: 18 * unit, height: 18 * unit, x: -9 * unit, y: -9 * unit });
        layer.prepend(track);
        layer.append(element('g', {}, name, block));
        const xs = [], ys = [];
        for (let i = 0; i + 1 < part.points.length; i += 4) { xs.push(part.points[i], part.points[i + 2]); ys.push(part.points[i + 1], part.points[i + 3]); }
        const lowest = ys.indexOf(Math.min(...ys)), highest = ys.indexOf(Math.max(...ys));
        const leftmost = xs.indexOf(Math.min(...xs)), rightmost = xs.indexOf(Math.max(...xs));
        const [from, to] = ys[highest] - ys[lowest] > xs[rightmost] - xs[leftmost] ? [lowest, highest] : [leftmost, rightmost];
        for (const [key, value] of Object.entries({ x1: xs[from], y1: -ys[from], x2: xs[to], y2: -ys[to] })) track.setAttribute(key, value);
        return (p) => block.setAttribute('transform', `translate(${p[2]} ${-p[3]})`);
      }
      const line = element('polyline', { class: part.kind }, name), joints = [];
      layer.append(line);
      if (part.kind === 'link')
        for (let i = 0; i < part.count; ++i) { const joint = element('circle', { r: 3.2 * unit, class: 'joint' }); joints.push(joint); layer.append(joint); }
      return (p) => {
        const places = [];
        for (let i = 0; i < p.length; i += 2) places.push(p[i] + ',' + -p[i + 1]);
        line.setAttribute('points', places.join(' '));
        joints.forEach((joint, i) => { joint.setAttribute('cx', p[2 * i]); joint.setAttribute('cy', -p[2 * i + 1]); });
      };
    }

    function scaleBar(extent, size, unit) {
      const length = roundLength(0.25 * size), x = extent.left, y = -extent.low + 16 * unit;
      return element('g', { class: 'scale' },
        element('path', { d: `M${x} ${y - 4 * unit}V${y + 4 * unit}M${x} ${y}H${x + length}M${x + length} ${y - 4 * unit}V${y + 4 * unit}` }),
        element('text', { x: x + length + 6 * unit, y: y + 4 * unit, 'font-size': 11 * unit }, numberText(length) + ' ' + data.unit));
    }

    function turnArrow(extent, unit) {
      const [cx, cy] = data.center, radius = 22 * unit, sense = data.rotation > 0 ? 1 : -1;
      const at = (degrees) => [cx + radius * Math.cos(degrees * Math.PI / 180), -(cy + radius * Math.sin(degrees * Math.PI / 180))];
      const [x1, y1] = at(200), [x2, y2] = at(sense > 0 ? 330 : 70);
      const tangent = (sense > 0 ? 330 : 70) + sense * 90;
      const head = (turn) => { const a = (tangent + 180 + turn) * Math.PI / 180; return `${x2 + 7 * unit * Math.cos(a)} ${y2 - 7 * unit * Math.sin(a)}`; };
      return element('path', { class: 'turn', d: `M${x1} ${y1}A${radius} ${radius} 0 0 ${sense > 0 ? 0 : 1} ${x2} ${y2}M${head(28)}L${x2} ${y2}L${head(-28)}` });
    }

    /** Below the plate, the way that it slides. */
    function slideArrow(unit) {
      const [cx, cy] = data.center, last = data.shifted[data.shifted.length - 2], way = last < data.shifted[0] ? -1 : 1;
      const y = -cy + 9 * unit, tip = cx + 24 * unit * way;
      return element('path', { class: 'turn', d: `M${cx - 24 * unit * way} ${y}H${tip}M${tip - 7 * unit * way} ${y - 3.5 * unit}L${tip} ${y}L${tip - 7 * unit * way} ${y + 3.5 * unit}` });
    }

    function build() {
      const extent = extentOf(data), width = extent.right - extent.left, height = extent.high - extent.low;
      const size = Math.max(width, height), unit = size / 420, room = 14 * unit;
      const [cx, cy] = data.center, [x, y] = [cx, -cy];
      const svg = element('svg', { viewBox: `${extent.left - room} ${-extent.high - room} ${width + 2 * room} ${height + 2 * room + 26 * unit}`,
        role: 'img', 'aria-label': 'The cam with its follower to scale, at the cam angle of the slider', style: `--unit:${unit}` });
      turning = element('g', {});
      const paths = data.outlines.filter((one) => one.points), circles = data.outlines.filter((one) => one.radius);
      const rim = circles.find((one) => one.style === 'rim');
      const walls = paths.filter((one) => !one.style.includes('pitch') && one.style !== 'open');
      if (rim) {  // the disk that the groove is cut into: the groove stays empty
        const r = rim.radius, disk = `M${r} 0A${r} ${r} 0 0 0 ${-r} 0A${r} ${r} 0 0 0 ${r} 0Z`;
        turning.append(element('path', { d: disk + walls.map((one) => pathOf(one.points, true)).join(''), class: 'grooved' }, element('title', {}, rim.name)));
      }
      for (const circle of circles.filter((one) => one !== rim))
        svg.append(element('circle', { cx: x, cy: y, r: circle.radius, class: 'guide-circle' }, element('title', {}, circle.name)));
      for (const path of paths)
        turning.append(element('path', { d: pathOf(path.points, path.closed), class: 'outline ' + path.style + (path.closed && !rim ? ' closed' : '') }, element('title', {}, path.name)));
      const first = walls[0].points;
      if (!data.shifted) turning.append(element('line', { x1: 0, y1: 0, x2: 0.94 * first[0], y2: -0.94 * first[1], class: 'datum' }, element('title', {}, 'mark at cam angle 0')));
      svg.append(turning);
      if (!data.shifted) svg.append(element('circle', { cx: x, cy: y, r: 5 * unit, class: 'center' }), element('path', { class: 'center-cross', d: `M${x - 10 * unit} ${y}H${x + 10 * unit}M${x} ${y - 10 * unit}V${y + 10 * unit}` }));
      svg.append(data.shifted ? slideArrow(unit) : turnArrow(extent, unit));
      const layer = element('g', {});
      moving = data.parts.map((part) => { const place = addPart(layer, part, unit); return { part, place }; });
      svg.append(layer);
      contact = element('circle', { r: 3.2 * unit, class: 'contact' }, element('title', {}, 'contact'));
      svg.append(contact, scaleBar(extent, size, unit));
      const key = element('ul', { class: 'key' });
      const has = (name) => data.parts.some((part) => part.kind === name);
      for (const path of paths.filter((one) => one.style !== 'open')) key.append(element('li', { class: 'key-' + path.style }, path.name));
      circles.filter((one) => one !== rim).forEach((circle) => key.append(element('li', { class: 'key-circle' }, `${circle.name}, radius ${numberText(circle.radius, 6)} ${data.unit}`)));
      const named = [...new Set(data.parts.filter((part) => part.kind !== 'pivot').map((part) => part.name))];
      key.append(element('li', { class: has('circle') ? 'key-roller' : 'key-link' }, named.join(', ')));
      host.replaceChildren(svg, key);
      move();
    }

    function move() {
      if (!data) return;
      const [row, next, share] = angle.between();
      const turned = data.turned[row] * (1 - share) + data.turned[next] * share;
      const [cx, cy] = data.center;
      const [dx, dy] = [0, 1].map((i) => data.shifted ? data.shifted[2 * row + i] * (1 - share) + data.shifted[2 * next + i] * share : 0);
      turning.setAttribute('transform', `translate(${cx + dx} ${-cy - dy}) rotate(${-turned})`);
      for (const { part, place } of moving) place(pointsNow(part, data.turned.length, angle));
      const [x, y] = [0, 1].map((i) => data.contact[2 * row + i] * (1 - share) + data.contact[2 * next + i] * share);
      contact.setAttribute('cx', x);
      contact.setAttribute('cy', -y);
      host.dataset.turned = turned.toFixed(3);
    }

    function show(drawing) {
      data = drawing;
      host.hidden = !data;
      if (data) build();
    }
    angle.changed.listen(move);
    return self;
  };

  /** The slider of the cam angle with play, speed and what it reads. */
  camopt.angleControls = function (angle) {
    const play = element('button', { type: 'button', class: 'play', 'aria-label': 'Play', 'aria-pressed': 'false' }, '▶');
    const slider = element('input', { type: 'range', class: 'angle', 'aria-label': 'Cam angle', step: 'any' });
    const output = element('output', { class: 'angle-now' });
    const speed = element('select', { 'aria-label': 'Speed of the animation' },
      ...[2, 5, 10, 20, 40, 60].map((turns) => element('option', { value: turns, selected: turns === angle.turnsPerMinute }, turns + ' turns/min')));
    const host = element('div', { class: 'controls' }, play, slider, output, speed);
    play.addEventListener('click', () => angle.play(!angle.playing));
    slider.addEventListener('input', () => { angle.play(false); angle.set(Number(slider.value)); });
    slider.addEventListener('keydown', (event) => {
      const step = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (!step) return;
      event.preventDefault();
      angle.play(false);
      angle.set(angle.at + step);
    });
    speed.addEventListener('change', () => { angle.turnsPerMinute = Number(speed.value); });
    angle.played.listen((on) => {
      play.textContent = on ? '❚❚' : '▶';
      play.setAttribute('aria-label', on ? 'Pause' : 'Play');
      play.setAttribute('aria-pressed', String(on));
    });
    const follow = () => {
      const values = angle.values;
      slider.min = values[0];
      slider.max = values[values.length - 1];
      slider.value = angle.at;
      slider.setAttribute('aria-valuetext', angle.at.toFixed(1) + ' degrees');
      output.textContent = camopt.angleText(angle.at);
    };
    angle.changed.listen(follow);
    follow();
    return host;
  };
})(window.Camopt);
