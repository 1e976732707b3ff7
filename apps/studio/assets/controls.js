// SPDX-License-Identifier: MIT
// The controls of a scene: one row a key, as the reader of scene files describes it. Nothing here knows a key.
'use strict';
(function (camopt) {
  const { element } = camopt;

  const pathOf = (control) => (control.table ? control.table + '.' : '') + control.key;
  const plain = (text) => text.replaceAll('`', '').replaceAll('*', '');
  const hintOf = (control) => plain(control.meaning) + ' Allowed: ' + control.allowed + '. Default: ' + control.default + '.';
  /** What a slider's steps make of 0.1 + 0.2. */
  const tidy = (value) => Number(value.toPrecision(12));
  const choiceWords = { DRD: 'rise between two dwells', RR: 'rise and return', program: 'program of segments', spline: 'optimized (spline)' };

  /** Told why what was written is no value. */
  camopt.refused = camopt.signal();

  /** The same unit, however it is typed: "N m" and "Nm", "mm/s²" and "mm/s^2", 1" and 1 in. */
  const plainUnit = (unit) => unit.toLowerCase().replace(/["″]|inch(es)?/g, 'in').replace(/°/g, 'deg').replace(/²/g, '^2').replace(/³/g, '^3').replace(/[µμ]/g, 'u').replace(/[\s·*]/g, '');

  /** "1 in" in a field of mm is 25.4; null: no number, and the reason was told. */
  function typedNumber(text, control) {
    const found = /^([-+−]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(.*)$/i.exec(text.trim());
    const unit = found ? plainUnit(found[2]) : '', value = found ? Number(found[1].replace('−', '-')) : NaN;
    if (found && !unit) return value;
    const known = found && control.units.find((one) => plainUnit(one.unit) === unit);
    if (known) return Number((value * known.factor).toPrecision(10));
    const units = control.units.map((one) => one.unit), own = control.shown_unit;
    const allowed = units.length > 1 ? 'a number in ' + own + ', or a number with one of the units ' + units.join(', ') : own ? 'a number in ' + own : 'a number without a unit';
    camopt.refused.send(control.label + ': found "' + text.trim() + '"; allowed: ' + allowed + (/\d,\d/.test(text) ? ', with a decimal point' : '') + '.');
    return null;
  }

  /**
   * A field that shows what the scene holds, but while the user writes in it. take(): what was written is asked for;
   * false: it is none, and the field returns to what the scene holds.
   */
  function mirror(field, take) {
    let held = field.value, writing = false;
    const back = () => { writing = false; field.value = held; };
    field.addEventListener('input', () => { writing = true; });
    field.addEventListener('change', () => { writing = false; if (!take()) back(); });
    field.addEventListener('blur', () => { if (writing) back(); });
    return (value, refused) => { held = String(value ?? ''); if (refused || !writing) back(); };
  }

  function numberField(value, control, change) {
    const field = element('input', { type: 'text', inputmode: 'decimal', class: 'number', autocomplete: 'off', value: String(value ?? ''), 'aria-label': control.label, title: hintOf(control) });
    const show = mirror(field, () => {
      const typed = field.value.trim() === '' ? null : typedNumber(field.value, control);
      if (typed === null) return false;
      field.value = String(typed);
      change(typed);
      return true;
    });
    return { field, show };
  }

  /** Number and slider, moved together; the slider tells while it moves. It stands where the value is, between its steps too. */
  function slidingNumber(control, set) {
    const path = pathOf(control);
    const number = numberField(control.value, control, (value) => { place(value); set(path, value, false); });
    if (!control.slider) return { parts: [number.field], show: (fresh, refused) => number.show(fresh.value, refused) };
    let range = control.slider;
    const slider = element('input', { type: 'range', step: control.type === 'integer' ? '1' : 'any', 'aria-label': control.label + ', slider', title: hintOf(control) });
    const place = (value) => {
      // Beyond its ends the slider goes further.
      slider.min = String(Math.min(range.from, value));
      slider.max = String(Math.max(range.to, value));
      slider.value = String(value);
    };
    /** A hand chooses among the steps. */
    const stepped = () => {
      const value = slider.valueAsNumber;
      if (value <= Number(slider.min) || value >= Number(slider.max)) return value;
      return tidy(range.from + Math.round((value - range.from) / range.step) * range.step);
    };
    const take = (moving) => { const value = stepped(); slider.value = String(value); number.field.value = String(value); set(path, value, moving); };
    slider.addEventListener('input', () => take(true));
    slider.addEventListener('change', () => take(false));
    place(control.value);
    const show = (fresh, refused) => {
      if (slider.matches(':active') && !refused) return; // in the hand
      range = fresh.slider;
      place(fresh.value);
      number.show(fresh.value, refused);
    };
    return { parts: [number.field, slider], show };
  }

  function rangeFields(control, set) {
    let value = control.value;
    const end = (name) => numberField(value[name], control, (number) => set(pathOf(control), Object.assign({}, value, { [name]: number }), false));
    const low = end('min'), high = end('max');
    const show = (fresh, refused) => { value = fresh.value; low.show(value.min, refused); high.show(value.max, refused); };
    return { parts: [element('span', { class: 'range-ends' }, low.field, ' to ', high.field)], show };
  }

  function choice(control, set) {
    const select = element('select', { 'aria-label': control.label, title: hintOf(control) },
      ...control.choices.map((one) => element('option', { value: String(one) }, choiceWords[one] || String(one).replaceAll('_', ' '))));
    const valueOf = (text) => control.choices.find((one) => String(one) === text) ?? text;
    select.addEventListener('change', () => set(pathOf(control), valueOf(select.value), false));
    const show = (fresh) => {
      const value = String(fresh.value);
      if (![...select.options].some((one) => one.value === value)) select.append(element('option', { value }, value));
      select.value = value;
    };
    show(control);
    return { parts: [select], show };
  }

  function tick(control, set) {
    const box = element('input', { type: 'checkbox', 'aria-label': control.label, title: hintOf(control) });
    box.addEventListener('change', () => set(pathOf(control), box.checked, false));
    const show = (fresh) => { box.checked = fresh.value === true; };
    show(control);
    return { parts: [box], show };
  }

  function textField(control, set) {
    const field = element('input', { type: 'text', value: control.value, 'aria-label': control.label, title: hintOf(control) });
    const show = mirror(field, () => { set(pathOf(control), field.value, false); return true; });
    return { parts: [field], show: (fresh, refused) => show(fresh.value, refused) };
  }

  const makers = { number: slidingNumber, integer: slidingNumber, range: rangeFields, choice, boolean: tick, text: textField };

  /** A number becomes a range that the optimizer searches, and back. */
  function searchButton(control, set) {
    if (!control.may_range || (control.type !== 'number' && control.type !== 'range')) return null;
    const isRange = control.type === 'range', value = control.value;
    const other = isRange ? tidy((value.min + value.max) / 2)
      : { min: tidy(Math.min(value * 0.5, value * 1.5)), max: tidy(Math.max(value * 0.5, value * 1.5)) };
    if (!isRange && value === 0) return null;
    return element('button', { type: 'button', class: 'small', 'aria-pressed': String(isRange), title: isRange ? 'Give the number' : 'Let the optimizer choose it from a range',
      onclick: () => set(pathOf(control), other, false) }, 'search');
  }

  /** How far can this limit go? The scene seeks its number, and the weights choose among the motions at it. */
  function seekButton(control, set, valueOf) {
    if (!control.seek || control.type !== 'number') return null;
    const path = pathOf(control), sought = valueOf(control.seek) === path;
    const other = control.seek === 'objective.least' ? 'objective.largest' : 'objective.least';
    const seek = () => {
      if (!sought && valueOf(other) !== undefined) set(other, null, true); // one number at a time
      set(control.seek, sought ? null : path, false);
    };
    const way = control.seek === 'objective.least' ? 'least' : 'largest';
    return element('button', { type: 'button', class: 'small', 'data-seek': path, 'aria-pressed': String(sought), onclick: seek,
      title: sought ? 'Take the number as it is' : 'Find and prove the ' + way + ' value for which motions exist' }, 'how far?');
  }

  /** valueOf: what the scene gives for a path; undefined: nothing. */
  camopt.controlRow = function (control, set, valueOf) {
    const made = makers[control.type](control, set);
    const away = control.default === 'required' ? null
      : element('button', { type: 'button', class: 'small away', 'aria-label': 'Leave out ' + control.label, title: 'Leave out: ' + control.default, onclick: () => set(pathOf(control), null, false) }, '×');
    const row = element('div', { class: 'control type-' + control.type, 'data-key': pathOf(control) },
      element('span', { class: 'control-name', title: hintOf(control) }, control.name + (control.shown_unit ? ', ' : ''), control.shown_unit ? element('span', { class: 'unit' }, control.shown_unit) : null),
      ...made.parts, element('span', { class: 'control-buttons' }, seekButton(control, set, valueOf), searchButton(control, set), away));
    return { row, show: made.show };
  };

  /** What a key that is added begins with; null: the user says. */
  function firstValue(control) {
    if (control.type === 'boolean') return control.default !== 'true';
    if (control.type === 'choice') return control.choices.find((one) => !control.default.includes(String(one))) ?? control.choices[0];
    const number = Number.parseFloat(control.default);
    const ofUnit = !control.unit || control.default.endsWith(control.unit);
    return Number.isFinite(number) && number > 0 && ofUnit ? number : null;
  }

  /** A choice of the keys a table could have. */
  camopt.addKey = function (table, controls, set) {
    if (!controls.length) return null;
    const place = element('div', { class: 'add-key' });
    const select = element('select', { 'aria-label': 'Add to ' + controls[0].group, 'data-add': table }, element('option', { value: '' }, 'add …'),
      ...controls.map((control) => element('option', { value: pathOf(control), title: hintOf(control) }, control.name + (control.shown_unit ? ', ' + control.shown_unit : ''))));
    select.addEventListener('change', () => {
      const control = controls.find((one) => pathOf(one) === select.value);
      if (!control) return;
      const value = firstValue(control);
      if (value !== null) { set(pathOf(control), value, false); return; }
      const field = control.type === 'text' ? textField(Object.assign({}, control, { value: '' }), set) : { parts: [numberField('', control, (number) => set(pathOf(control), number, false)).field] };
      place.replaceChildren(select, element('span', { class: 'new-value' }, ...field.parts, ' ' + control.shown_unit), element('p', { class: 'note' }, hintOf(control)));
      field.parts[0].focus();
    });
    place.append(select);
    return place;
  };

  camopt.controlPath = pathOf;

  /** The angles of the segments of a closed program, which add up to a turn; none where one of them is searched. */
  const turns = { deg: 360, rad: 2 * Math.PI };
  camopt.turnAngles = function (controls) {
    if (controls.some((one) => pathOf(one) === 'motion.closed' && one.value === false)) return [];
    const angles = controls.filter((one) => /^motion\.segments\[\d+\]$/.test(one.table) && one.key.startsWith('angle') && one.given);
    const same = angles.every((one) => one.type === 'number' && one.unit === angles[0].unit);
    return same && angles.length > 1 && turns[angles[0].unit] ? angles : [];
  };

  /**
   * What is set where `path` becomes `value`: what an angle of a closed program gains, another gives, so that they still
   * add up to a turn. giver: its path; '' or the angle itself: the next segment. valueOf: what a path is to be now.
   */
  camopt.withGiver = function (controls, path, value, giver, valueOf) {
    const angles = camopt.turnAngles(controls).map(pathOf), own = angles.indexOf(path);
    if (own < 0 || typeof value !== 'number') return { [path]: value };
    const gives = angles.includes(giver) && giver !== path ? giver : angles[(own + 1) % angles.length];
    const others = angles.filter((one) => one !== path && one !== gives).reduce((sum, one) => sum + valueOf(one), 0);
    if (!Number.isFinite(others)) return { [path]: value }; // one has just become a range
    return { [path]: value, [gives]: tidy(turns[controls.find((one) => pathOf(one) === path).unit] - others - value) };
  };
})(window.Camopt);
