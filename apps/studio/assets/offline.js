// SPDX-License-Identifier: MIT
// camopt.ask of a page without a server: the engine is in the page and runs in Workers, so that the page never blocks. One
// Worker solves, one makes files; a spare with the compiled engine takes the place of one that is ended.
'use strict';
(function (camopt) {
  const patience = 200; // ms that an outdated solve may still run: its Worker knows the last solution, a new one does not
  let module = null, spare = null, failure = null;

  /** The program of a Worker; `wasi` is its only name from outside. */
  function program(wasi) {
    let engine = null;
    const unpacked = (base64) => new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))]).stream().pipeThrough(new DecompressionStream('gzip'));
    function start(compiled) {
      const system = wasi((text) => console.error(text));
      engine = new WebAssembly.Instance(compiled, system.imports).exports;
      system.attach(engine);
      engine._initialize();
    }
    function text(at) {
      const bytes = new Uint8Array(engine.memory.buffer);
      return new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)));
    }
    function answer(call, body) {
      const bytes = new TextEncoder().encode(body), at = engine.reserve(bytes.length);
      new Uint8Array(engine.memory.buffer, at, bytes.length).set(bytes);
      const status = engine[call](at, bytes.length);
      engine.release(at);
      const from = engine.answer_text();
      return { status, type: text(engine.answer_type()), file: text(engine.answer_file()), bytes: engine.memory.buffer.slice(from, from + engine.answer_size()) };
    }
    onmessage = async ({ data }) => {
      try {
        if (data.call) { const made = answer(data.call, data.body); postMessage(made, [made.bytes]); return; }
        const compiled = data.module || await WebAssembly.compileStreaming(new Response(unpacked(data.packed), { headers: { 'Content-Type': 'application/wasm' } }));
        start(compiled);
        postMessage({ module: compiled });
      } catch (error) {
        postMessage({ fault: String(error) });
      }
    };
  }

  function newWorker(first) {
    const address = URL.createObjectURL(new Blob(["'use strict';(" + program + ')(' + camopt.wasi + ');'], { type: 'text/javascript' }));
    const worker = new Worker(address);
    URL.revokeObjectURL(address);
    worker.postMessage(first);
    return worker;
  }

  function takeSpare() {
    const worker = spare || newWorker({ module });
    spare = null;
    setTimeout(() => { spare ||= newWorker({ module }); }, 100);
    return worker;
  }

  /** Requests one after another. A newer solve replaces one that waits. */
  function lane(call, newestOnly) {
    let worker = null, running = null, waiting = [];
    function end() {
      worker.terminate();
      worker = null;
      running = null;
      next();
    }
    function finish(job, made) {
      clearTimeout(job.late);
      running = null;
      if (made.fault) {
        // What it holds is not known any more.
        job.reject(new Error('the engine stopped (' + made.fault + ')'));
        end();
        return;
      }
      const headers = { 'Content-Type': made.type, ...(made.file ? { 'Content-Disposition': 'attachment; filename="' + made.file + '"' } : {}) };
      job.resolve(new Response(made.bytes, { status: made.status, headers }));
      next();
    }
    function next() {
      if (running || !waiting.length || (!module && !failure)) return;
      const job = running = waiting.shift();
      if (failure) { running = null; job.reject(new Error(failure)); next(); return; }
      worker ||= takeSpare();
      worker.onmessage = ({ data }) => { if (!data.module) finish(job, data); };
      worker.onerror = (event) => finish(job, { fault: event.message });
      worker.postMessage({ call, body: job.body });
    }
    function outdate(job) {
      job.reject(new DOMException('a newer request came', 'AbortError'));
      if (running === job) job.late = setTimeout(() => { if (running === job) end(); }, patience);
      else waiting = waiting.filter((one) => one !== job);
      next();
    }
    return { next, ask: (body, signal) => new Promise((resolve, reject) => {
      const job = { body, resolve, reject, late: 0 };
      if (newestOnly) waiting.forEach(outdate);
      if (signal) signal.addEventListener('abort', () => outdate(job));
      waiting.push(job);
      next();
    }) };
  }

  const lanes = { solve: lane('solve', true), export: lane('download', false) };
  camopt.ask = (what, body, signal) => lanes[what].ask(JSON.stringify(body), signal);
  camopt.lost = '';

  function begin() {
    if (typeof DecompressionStream === 'undefined' || typeof WebAssembly === 'undefined') ready(null, 'this browser is too old: it cannot unpack or run the engine');
    else {
      spare = newWorker({ packed: document.getElementById('engine').textContent.trim() });
      spare.onmessage = ({ data }) => ready(data.module, data.fault);
      spare.onerror = (event) => ready(null, event.message);
    }
  }
  function ready(compiled, fault) {
    module = compiled;
    failure = fault || null;
    document.documentElement.dataset.engine = fault ? 'failed' : 'ready';
    for (const one of Object.values(lanes)) one.next();
  }
  // The engine is the last element of the page.
  document.addEventListener('DOMContentLoaded', begin);
})(window.Camopt);
