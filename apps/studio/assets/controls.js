// SPDX-License-Identifier: MIT
// The controls of a scene: one row a key, as the reader of scene files describes it. Nothing here knows a key.
'use strict';
(function (camopt) {
  const { element } = camopt;

  const pathOf = (control) => (control.table ? control.table + '.' : '') + control.key;
  /** "base_radius_mm" in mm is "base radius". */
  const wordsOf = (control) => {
    const ending = '_' + control.unit.toLowerCase().replace(/[^a-z0-9]+/g, '_');
    const name = control.unit && control.key.endsWith(ending) ? control.key.slice(0, -ending.length) : control.key;
    return name.replaceAll('_', ' ');
  };
  const plain = (text) => text.replaceAll('`', '').replaceAll('*', '');
  const hintOf = (control) => plain(control.meaning) + ' Allowed: ' + control.allowed + '. Default: ' + control.default + '.';
  /** What a slider's steps make of 0.1 + 0.2. */
  const tidy = (value) => Number(value.toPrecision(12));

  function numberField(value, control, change) {
    const field = element('input', { type: 'number', step: 'any', value: String(value), 'aria-label': wordsOf(control) + (control.unit ? ' in ' + control.unit : ''), title: hintOf(control) });
    field.addEventListener('change', () => { if (field.value !== '' && Number.isFinite(field.valueAsNumber)) change(field.valueAsNumber); });
    return field;
  }

  /** Number and slider, moved together; the slider tells while it moves. */
  function slidingNumber(control, set) {
    const path = pathOf(control);
    const field = numberField(control.value, control, (value) => { place(value); set(path, value, false); });
    const { from, to, step } = control.slider;
    const slider = element('input', { type: 'range', min: String(from), max: String(to), step: String(step), value: String(control.value), 'aria-label': wordsOf(control) + ', slider', title: hintOf(control) });
    const place = (value) => {
      // Beyond its ends the slider goes farther.
      if (value > Number(slider.max)) slider.max = String(value);
      if (value < Number(slider.min)) slider.min = String(value);
      slider.value = String(value);
    };
    slider.addEventListener('input', () => { field.value = String(tidy(slider.valueAsNumber)); set(path, tidy(slider.valueAsNumber), true); });
    slider.addEventListener('change', () => set(path, tidy(slider.valueAsNumber), false));
    const show = (fresh) => {
      if (document.activeElement !== field) field.value = String(fresh.value);
      if (document.activeElement !== slider || !slider.matches(':active')) place(fresh.value);
    };
    return { parts: [field, slider], show };
  }

  function rangeFields(control, set) {
    let value = control.value;
    const end = (name) => numberField(value[name], control, (number) => { value = Object.assign({}, value, { [name]: number }); set(pathOf(control), value, false); });
    const low = end('min'), high = end('max');
    const show = (fresh) => { value = fresh.value; if (document.activeElement !== low) low.value = String(value.min); if (document.activeElement !== high) high.value = String(value.max); };
    return { parts: [element('span', { class: 'range-ends' }, low, ' to ', high)], show };
  }

  function choice(control, set) {
    const select = element('select', { 'aria-label': wordsOf(control), title: hintOf(control) },
      ...control.choices.map((one) => element('option', { value: String(one) }, String(one).replaceAll('_', ' '))));
    const valueOf = (text) => control.choices.find((one) => String(one) === text);
    select.addEventListener('change', () => set(pathOf(control), valueOf(select.value), false));
    const show = (fresh) => { select.value = String(fresh.value); };
    show(control);
    return { parts: [select], show };
  }

  function tick(control, set) {
    const box = element('input', { type: 'checkbox', 'aria-label': wordsOf(control), title: hintOf(control) });
    box.addEventListener('change', () => set(pathOf(control), box.checked, false));
    const show = (fresh) => { box.checked = fresh.value === true; };
    show(control);
    return { parts: [box], show };
  }

  function textField(control, set) {
    const field = element('input', { type: 'text', 'aria-label': wordsOf(control), title: hintOf(control) });
    field.addEventListener('change', () => set(pathOf(control), field.value, false));
    const show = (fresh) => { if (document.activeElement !== field) field.value = fresh.value; };
    show(control);
    return { parts: [field], show };
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

  camopt.controlRow = function (control, set) {
    const made = makers[control.type](control, set);
    const away = control.default === 'required' ? null
      : element('button', { type: 'button', class: 'small away', 'aria-label': 'Leave out ' + wordsOf(control), title: 'Leave out: ' + control.default, onclick: () => set(pathOf(control), null, false) }, '×');
    const row = element('div', { class: 'control type-' + control.type, 'data-key': pathOf(control) },
      element('span', { class: 'control-name', title: hintOf(control) }, wordsOf(control), control.unit ? element('span', { class: 'unit' }, control.unit) : null),
      ...made.parts, element('span', { class: 'control-buttons' }, searchButton(control, set), away));
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
    const select = element('select', { 'aria-label': 'Add to ' + (table || 'the scene'), 'data-add': table }, element('option', { value: '' }, 'add …'),
      ...controls.map((control) => element('option', { value: pathOf(control), title: hintOf(control) }, wordsOf(control) + (control.unit ? ', ' + control.unit : ''))));
    select.addEventListener('change', () => {
      const control = controls.find((one) => pathOf(one) === select.value);
      if (!control) return;
      const value = firstValue(control);
      if (value !== null) { set(pathOf(control), value, false); return; }
      const field = control.type === 'text' ? textField(Object.assign({}, control, { value: '' }), set) : { parts: [numberField('', control, (number) => set(pathOf(control), number, false))] };
      place.replaceChildren(select, element('span', { class: 'new-value' }, ...field.parts, ' ' + control.unit), element('p', { class: 'note' }, hintOf(control)));
      field.parts[0].focus();
    });
    place.append(select);
    return place;
  };

  camopt.controlPath = pathOf;
})(window.Camopt);
