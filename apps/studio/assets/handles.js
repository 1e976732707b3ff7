// SPDX-License-Identifier: MIT
// The handles of the displacement chart: set points and the joints of segments, moved by pointer or arrow keys; and
// what adds and removes them. A handle knows which keys its place is: x, y are { path, of(degrees or shown value) }.
'use strict';
(function (camopt) {
  const { element } = camopt;
  const tidy = (value) => Number(value.toPrecision(12));
  const factorOf = (control, unit) => (control.units.find((one) => one.unit === unit) || {}).factor;

  /** The controls of an answer, by table and by the key without its unit. */
  function sceneOf(controls) {
    const find = (table, item) => controls.find((one) => one.table === table && one.item === item);
    const given = (table, item) => { const one = find(table, item); return one?.given ? one : null; };
    const motion = (item) => find('motion', item);
    const count = (pattern) => new Set(controls.map((one) => one.table).filter((table) => pattern.test(table))).size;
    return { find, given, motion, segments: count(/^motion\.segments\[\d+\]$/), points: (list) => count(new RegExp('^' + list.replace(/[.[\]]/g, '\\$&') + '\\[\\d+\\]$')) };
  }

  /** Where each segment lies, deg. Of a searched angle what was found, else the middle of its range. */
  function stretchesOf(scene, found) {
    const all = [];
    let from = 0;
    for (let i = 0; i < scene.segments; ++i) {
      const angle = scene.find('motion.segments[' + i + ']', 'angle');
      const shown = found.length === scene.segments ? found[i].to - found[i].from : null;
      const value = angle.type === 'range' ? (angle.value.min + angle.value.max) / 2 : angle.value;
      const size = angle.type === 'range' && shown !== null ? shown : value / factorOf(angle, 'deg');
      all.push({ from, to: from + size, table: 'motion.segments[' + i + ']', angle, kind: scene.find('motion.segments[' + i + ']', 'kind').value });
      from += size;
    }
    return all;
  }

  /** Every handle of a scene. chart: unit, angles and values of the displacement. */
  camopt.handlesOf = function (controls, chart, found) {
    const scene = sceneOf(controls), lift = scene.motion('lift'), type = scene.motion('type').value;
    // A displacement without a unit counts in lifts; a program whose displacements all have one has no lift.
    const liftShown = scene.given('motion', 'lift') ? lift.value / factorOf(lift, chart.unit) : 1;
    const heightOf = (control) => {
      if (!control) return null;
      const size = control.unit ? factorOf(control, chart.unit) : 1 / liftShown;
      return { path: camopt.controlPath(control), of: (shown) => shown * size, shown: control.given && control.type === 'number' ? control.value / size : null };
    };
    const placeOf = (control, from, stretch) => {
      if (!control || (control.given && control.type !== 'number')) return null;
      const size = control.unit ? factorOf(control, 'deg') : 1 / stretch;
      return { path: camopt.controlPath(control), of: (degrees) => (degrees - from) * size, shown: control.given ? from + control.value / size : null };
    };
    const handles = [];
    const add = (kind, words, table, x, y, at) => { if (x || y) handles.push({ kind, words, table, x, y, at: x && x.shown !== null ? x.shown : at }); };
    const points = (list, from, stretch, group) => {
      for (let i = 0; i < scene.points(list); ++i) {
        const table = list + '[' + i + ']', item = (name) => scene.given(table, name);
        const words = group + 'set point ' + (i + 1), height = heightOf(item('displacement')), at = item('at');
        if (at) { add('point', words, table, placeOf(at, from, stretch), height); continue; }
        add('point', words + ', beginning', table, placeOf(item('from'), from, stretch), height);
        add('point', words + ', end', table, placeOf(item('to'), from, stretch), null);
      }
    };
    if (type === 'valve') {
      // The follower lifts by (valve lift + lash) / ratio; the duration ends where the valve comes down to the checking height.
      const { angles, values } = chart, nose = values.reduce((best, value, i) => (value > values[best] ? i : best), 0);
      const inChart = (item) => { const one = scene.given('motion', item); return one ? one.value / (factorOf(one, chart.unit) ?? NaN) : 0; };
      const ratio = scene.given('motion', 'rocker_ratio')?.value ?? 1;
      const size = factorOf(lift, chart.unit);
      if (size) add('joint', 'Nose', 'motion', null, { path: camopt.controlPath(lift), of: (shown) => lift.value + (shown - values[nose]) * ratio * size, shown: values[nose] }, angles[nose]);
      const duration = scene.motion('duration'), checked = (inChart('checking_height') + inChart('lash')) / ratio, last = values.findLastIndex((value) => value >= checked);
      if (last > nose && last + 1 < values.length) {
        const at = angles[last] + (angles[last + 1] - angles[last]) * (values[last] - checked) / (values[last] - values[last + 1]), perDegree = duration.unit === 'crank deg' ? 2 : factorOf(duration, 'deg');
        add('joint', 'End of the duration', 'motion', { path: camopt.controlPath(duration), of: (degrees) => duration.value + (degrees - at) * perDegree, shown: at }, null);
      }
      return handles;
    }
    if (type !== 'program') {
      const rise = placeOf(scene.motion('rise'), 0, 1), back = scene.motion('return');
      const top = rise.shown ?? 180;
      add('joint', type === 'RR' ? 'Top' : 'End of the rise', 'motion', rise, heightOf(lift), top);
      if (type === 'RR') add('joint', 'End of the return', 'motion', placeOf(back, top, 1), null, top + top);
      points('motion.via', 0, top, '');
      return handles;
    }
    const stretches = stretchesOf(scene, found), closed = scene.motion('closed').value !== false;
    let height = null; // of what a dwell keeps
    stretches.forEach((one, i) => {
      const last = i + 1 === stretches.length;
      if (one.kind !== 'dwell') height = heightOf(scene.find(one.table, 'to'));
      const x = closed && last ? null : placeOf(one.angle, one.from, 1);
      add('joint', last ? 'End of segment ' + (i + 1) : 'Joint of segments ' + (i + 1) + ' and ' + (i + 2), one.table, x, closed && last ? null : height, one.to);
      points(one.table + '.via', one.from, one.to - one.from, 'Segment ' + (i + 1) + ', ');
    });
    return handles;
  };

  /** value of the displacement at an angle, between the rows of the chart. */
  function curveAt(chart, degrees) {
    const angles = chart.all.angle.values, values = chart.curve.values;
    let row = 0;
    while (row + 2 < angles.length && angles[row + 1] < degrees) row += 1;
    const step = angles[row + 1] - angles[row], share = step > 0 ? Math.min(Math.max((degrees - angles[row]) / step, 0), 1) : 0;
    return values[row] + (values[row + 1] - values[row]) * share;
  }

  /** A round step of at most this size: 1, 2 or 5 times a power of ten. */
  function roundStep(size) {
    const decade = 10 ** Math.floor(Math.log10(size)), figure = [5, 2, 1].find((one) => one * decade <= size * 1.000001);
    return figure * decade;
  }

  /** The layer over the displacement chart. set(path → value, moving). */
  camopt.handleLayer = function (set, remove) {
    const host = element('div', { class: 'handles' }), watched = new WeakSet();
    let chart = null, shown = [], held = null;

    const positions = (one) => ({ at: one.at, value: one.y && one.y.shown !== null ? one.y.shown : curveAt(chart, one.at) });
    function place(one) {
      const { at, value } = held && held.one === one ? held : positions(one), plot = chart.plot;
      one.button.style.transform = 'translate(' + plot.valToPos(at, 'x') + 'px,' + plot.valToPos(value, 'y') + 'px)';
      one.button.hidden = !Number.isFinite(value);
    }

    /** What is set where a handle stands at (at, value), along these axes. Rounded to what a pixel is worth, or a tenth of it. */
    function settings(one, to, axes, fine) {
      const plot = chart.plot, sizes = {};
      for (const name of ['x', 'y']) {
        const axis = one[name], pixel = Math.abs(plot.posToVal(1, name) - plot.posToVal(0, name));
        if (!axis || !axes[name]) continue;
        const step = roundStep(Math.abs(axis.of(pixel) - axis.of(0)) * (fine ? 0.1 : 1));
        sizes[axis.path] = tidy(Math.round(axis.of(to[name]) / step) * step);
      }
      return sizes;
    }

    function move(one, to, axes, moving, fine) {
      const sizes = settings(one, to, axes, fine);
      held = moving ? { one, at: one.x && axes.x ? to.x : one.at, value: one.y && axes.y ? to.y : positions(one).value } : null;
      if (moving) place(one);
      if (Object.keys(sizes).length) set(sizes, moving);
    }

    /** An axis along which the hand has not moved yet stays as it is. */
    function drag(one, event) {
      const start = positions(one), from = [event.clientX, event.clientY], plot = chart.plot, axes = { x: false, y: false };
      const origin = [plot.valToPos(start.at, 'x'), plot.valToPos(start.value, 'y')];
      const to = (now) => ({ x: plot.posToVal(origin[0] + now.clientX - from[0], 'x'), y: plot.posToVal(origin[1] + now.clientY - from[1], 'y') });
      const follow = (now) => {
        axes.x ||= Math.abs(now.clientX - from[0]) >= 4;
        axes.y ||= Math.abs(now.clientY - from[1]) >= 4;
        if (axes.x || axes.y) move(one, to(now), axes, true, now.shiftKey);
      };
      const listeners = { pointermove: follow, pointerup: end, pointercancel: end };
      function end(now) {
        for (const [name, listener] of Object.entries(listeners)) one.button.removeEventListener(name, listener);
        if (axes.x || axes.y) move(one, to(now), axes, false, now.shiftKey);
      }
      one.button.setPointerCapture(event.pointerId);
      for (const [name, listener] of Object.entries(listeners)) one.button.addEventListener(name, listener);
    }

    function key(one, event) {
      const [name, sign] = { ArrowLeft: ['x', -1], ArrowRight: ['x', 1], ArrowUp: ['y', -1], ArrowDown: ['y', 1] }[event.key] || [];
      if (event.key === 'Delete' && one.kind === 'point') remove(one.table);
      else if (name) {
        const start = positions(one), plot = chart.plot, to = { x: start.at, y: start.value };
        to[name] = plot.posToVal(plot.valToPos(to[name], name) + sign * (event.shiftKey ? 0.2 : 2), name);
        move(one, to, { [name]: true }, false, event.shiftKey);
      } else return;
      event.preventDefault();
      event.stopPropagation();
    }

    function make(one) {
      const words = one.words + ': drag, or arrow keys' + (one.kind === 'point' ? '; Delete removes it' : '');
      const along = one.x && one.y ? 'both' : one.x ? 'angle' : 'height';
      one.button = element('button', { type: 'button', class: 'handle ' + one.kind + ' ' + along, 'data-handle': one.words, title: words, 'aria-label': words });
      // The chart below would begin to zoom.
      for (const name of ['mousedown', 'dblclick']) one.button.addEventListener(name, (event) => event.stopPropagation());
      one.button.addEventListener('pointerdown', (event) => { if (event.button === 0) drag(one, event); });
      one.button.addEventListener('keydown', (event) => key(one, event));
      return one.button;
    }

    return {
      curveAt: (degrees) => (chart && chart.plot ? curveAt(chart, degrees) : null),
      /** Draws the handles anew; those of a chart that is in the hand stay the same elements. */
      show(answer, charts) {
        chart = charts.get('displacement');
        if (!chart || !chart.plot) return;
        if (host.parentNode !== chart.plot.over) chart.plot.over.append(host);
        const fresh = camopt.handlesOf(answer.controls, { unit: chart.curve.unit, angles: chart.all.angle.values, values: chart.curve.values }, answer.data.segments);
        const same = fresh.length === shown.length && fresh.every((one, i) => one.words === shown[i].words && Boolean(one.x) === Boolean(shown[i].x) && Boolean(one.y) === Boolean(shown[i].y));
        if (same) fresh.forEach((one, i) => Object.assign(shown[i], one));
        else { shown = fresh; held = null; host.replaceChildren(...shown.map(make)); }
        if (!watched.has(chart.plot)) {
          watched.add(chart.plot);
          (chart.plot.hooks.draw ||= []).push(() => { if (chart && chart.plot) shown.forEach(place); });
        }
        shown.forEach(place);
      },
    };
  };

  /** What a segment's buttons set. Each returns path → value, in the order in which it is applied. */
  camopt.edits = function (controls, curveAt, cursor, found) {
    const scene = sceneOf(controls), closed = (scene.motion('closed') || {}).value !== false;
    const half = (value) => (typeof value === 'object' ? { min: tidy(value.min / 2), max: tidy(value.max / 2) } : tidy(value / 2));
    const entry = (index) => 'motion.segments[' + index + ']';
    const program = () => stretchesOf(scene, found);
    const shownUnit = (curveUnit, control) => (control.unit ? factorOf(control, curveUnit) : null);
    return {
      /** A segment is cut in two: kind "dwell" or "spline" is its second half. */
      addSegment(index, kind, unit) {
        const one = program()[index], to = scene.find(one.table, 'to'), made = { kind, [one.angle.key]: half(one.angle.value) };
        const steps = { [camopt.controlPath(one.angle)]: half(one.angle.value) };
        const height = curveAt((one.from + one.to) / 2), size = to && shownUnit(unit, to);
        const last = closed && index + 1 === scene.segments;
        if (kind === 'spline' && one.kind !== 'dwell') {
          if (to.given) made[to.key] = to.value;
          if (size && height !== null) steps[camopt.controlPath(to)] = tidy(Number((height * size).toPrecision(4)));
        } else if (kind === 'spline' && size && !last) made[to.key] = tidy(Number((curveAt(one.to) * size).toPrecision(6)));
        steps[entry(index + 1)] = { insert: made };
        return steps;
      },
      /** Its angle goes to a neighbour, so that a closed program stays one revolution. */
      removeSegment(index) {
        const all = program(), neighbour = all[index > 0 ? index - 1 : 1], own = all[index], steps = {};
        const amount = (angle) => (typeof angle === 'object' ? (angle.min + angle.max) / 2 : angle);
        const ratio = factorOf(neighbour.angle, 'deg') / factorOf(own.angle, 'deg'), add = amount(own.angle.value) * ratio;
        const value = neighbour.angle.value;
        if (closed) steps[camopt.controlPath(neighbour.angle)] = typeof value === 'object' ? { min: tidy(value.min + add), max: tidy(value.max + add) } : tidy(value + add);
        steps[entry(index)] = null;
        return steps;
      },
      /** At the cursor where it lies inside, else in the middle of what is free; on the curve as it is. */
      addPoint(table, unit) {
        const list = table + '.via', stretch = table === 'motion' ? null : program().find((one) => one.table === table);
        const rise = scene.given('motion', 'rise'), from = stretch ? stretch.from : 0;
        const to = stretch ? stretch.to : rise ? rise.value / factorOf(rise, 'deg') : 180;
        const margin = 0.02 * (to - from), inside = cursor > from + margin && cursor < to - margin;
        const at = inside ? cursor : from + (to - from) / 2, value = curveAt(at) ?? 0;
        const lift = scene.given('motion', 'lift'), size = lift ? factorOf(lift, unit) : 1;
        const height = 'displacement_' + (lift ? lift.unit : unit);
        return { [list + '[' + scene.points(list) + ']']: { insert: { at_deg: Number((at - from).toPrecision(4)), [height]: Number((value * size).toPrecision(4)) } } };
      },
      remove: (table) => ({ [table]: null }),
    };
  };
})(window.Camopt);
