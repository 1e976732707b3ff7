// SPDX-License-Identifier: MIT
// What every part of a page uses: elements, numbers as text, colours of the theme, and the cam angle that all
// pictures show.
'use strict';
window.Camopt = window.Camopt || {};
(function (camopt) {
  // Charts are canvases, drawn once for screen and paper: at least two dots a pixel, or letters blur in print.
  const dots = Object.getOwnPropertyDescriptor(window, 'devicePixelRatio');
  camopt.screenDots = () => dots.get.call(window);
  Object.defineProperty(window, 'devicePixelRatio', { configurable: true, get: () => Math.max(2, camopt.screenDots()) });

  /** element('p', {class: 'note'}, 'text', child): text is text, never markup. */
  camopt.element = function (tag, attributes, ...children) {
    const svg = ['svg', 'g', 'path', 'circle', 'line', 'polyline', 'rect', 'text', 'title', 'desc'].includes(tag);
    const made = svg ? document.createElementNS('http://www.w3.org/2000/svg', tag) : document.createElement(tag);
    for (const [name, value] of Object.entries(attributes || {})) {
      if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
      else if (value === true) made.setAttribute(name, '');
      else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, value);
    }
    made.append(...children.flat().filter((child) => child !== null && child !== undefined));
    return made;
  };

  /** A picture that was drawn for paper, as wide as there is room. */
  camopt.paper = function (text) {
    const svg = document.adoptNode(new DOMParser().parseFromString(text, 'image/svg+xml').documentElement);
    svg.removeAttribute('width');
    svg.removeAttribute('height');
    return camopt.element('section', { class: 'study-picture' }, camopt.element('div', { class: 'paper' }, svg));
  };

  /** As many significant digits as are asked for, no trailing zeros, a true minus. */
  camopt.numberText = function (value, digits = 5) {
    if (value === null || value === undefined || Number.isNaN(value)) return '–';
    if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
    const size = Math.abs(value);
    const text = size !== 0 && (size >= 1e7 || size < 1e-4)
      ? value.toExponential(digits - 1).replace(/\.?0+e/, 'e').replace('e+', 'e')
      : String(Number(value.toPrecision(digits)));
    return text.replace(/^-/, '−');
  };

  camopt.angleText = (degrees) => (degrees < 0 ? '−' : '') + Math.abs(degrees).toFixed(1) + '°';

  /** A colour of the theme: colour('curve') is the CSS variable --curve. */
  camopt.colour = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();

  /** Listeners by name. */
  camopt.signal = function () {
    const listeners = [];
    return { listen: (one) => listeners.push(one), send: (...values) => listeners.forEach((one) => one(...values)) };
  };

  camopt.themeChanged = camopt.signal();
  const stored = () => { try { return localStorage.getItem('camopt-theme'); } catch (error) { return null; } };
  const systemDark = window.matchMedia('(prefers-color-scheme: dark)');
  let theme = stored();
  let printing = false;
  function applyTheme() {
    const dark = !printing && (theme ? theme === 'dark' : systemDark.matches);
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    camopt.themeChanged.send(dark);
  }
  camopt.isDark = () => document.documentElement.dataset.theme === 'dark';
  camopt.setTheme = function (name) {
    theme = name;
    try { localStorage.setItem('camopt-theme', name); } catch (error) { /* a file that may keep nothing */ }
    applyTheme();
  };
  systemDark.addEventListener('change', applyTheme);
  camopt.printing = camopt.signal();
  function setPrinting(on) {
    if (printing === on) return;
    printing = on;
    applyTheme();
    camopt.printing.send(on);
  }
  window.addEventListener('beforeprint', () => setPrinting(true));
  window.addEventListener('afterprint', () => setPrinting(false));
  window.matchMedia('print').addEventListener('change', (event) => setPrinting(event.matches));
  camopt.isPrinting = () => printing;
  applyTheme();

  /** The cam angle that all pictures show: set by pointer, slider, keys and the animation. */
  camopt.angle = function () {
    const changed = camopt.signal(), played = camopt.signal();
    const self = {
      values: [0], at: 0, index: 0, playing: false, turnsPerMinute: 10, changed, played,
      /** The row that shows this angle best. */
      rowOf(at) {
        const values = self.values;
        let low = 0, high = values.length - 1;
        while (high - low > 1) {
          const middle = (low + high) >> 1;
          if (values[middle] <= at) low = middle; else high = middle;
        }
        return at - values[low] <= values[high] - at ? low : high;
      },
      set(at) {
        const values = self.values;
        self.at = Math.min(Math.max(at, values[0]), values[values.length - 1]);
        self.index = self.rowOf(self.at);
        changed.send(self);
      },
      setRow(index) {
        self.index = Math.min(Math.max(index, 0), self.values.length - 1);
        self.at = self.values[self.index];
        changed.send(self);
      },
      use(values) {
        self.values = values;
        self.set(self.at);
      },
      /** Where the angle lies between two rows: [row, next row, share of the next]. */
      between() {
        const values = self.values;
        let row = self.index;
        if (values[row] > self.at && row > 0) row -= 1;
        const next = Math.min(row + 1, values.length - 1);
        const step = values[next] - values[row];
        return [row, next, step > 0 ? Math.min(Math.max((self.at - values[row]) / step, 0), 1) : 0];
      },
      play(on) {
        if (self.playing === on) return;
        self.playing = on;
        played.send(on);
        if (!on) return;
        let before = performance.now();
        const step = (now) => {
          if (!self.playing) return;
          const values = self.values, from = values[0], length = values[values.length - 1] - from;
          const moved = self.at + (now - before) * self.turnsPerMinute * 360 / 60000;
          before = now;
          self.set(length > 0 ? from + (((moved - from) % length) + length) % length : from);
          requestAnimationFrame(step);
        };
        requestAnimationFrame(step);
      },
    };
    return self;
  };

  camopt.download = function (name, text, type = 'text/plain') {
    const address = URL.createObjectURL(new Blob([text], { type }));
    const link = camopt.element('a', { href: address, download: name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  };
})(window.Camopt);
