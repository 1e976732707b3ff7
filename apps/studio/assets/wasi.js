// SPDX-License-Identifier: MIT
// As much of WASI (preview 1) as the engine asks for: clocks, random bytes, text to the console; no files. Its text goes
// into a Worker: it uses nothing of the page.
'use strict';
window.Camopt.wasi = function (write) {
  const text = new TextDecoder(), unknownFile = 8;
  let memory = null;
  const view = () => new DataView(memory.buffer);
  const bytes = (at, size) => new Uint8Array(memory.buffer, at, size);
  const none = (count, size) => { view().setUint32(count, 0, true); view().setUint32(size, 0, true); return 0; };
  const calls = {
    args_sizes_get: none, args_get: () => 0, environ_sizes_get: none, environ_get: () => 0, sched_yield: () => 0,
    clock_res_get: (_, at) => { view().setBigUint64(at, 1000n, true); return 0; },
    clock_time_get: (clock, _, at) => { view().setBigUint64(at, BigInt(Math.round((clock === 0 ? Date.now() : performance.now()) * 1e6)), true); return 0; },
    random_get: (at, size) => { crypto.getRandomValues(bytes(at, size)); return 0; },
    fd_fdstat_get: (file, at) => { bytes(at, 24).fill(0); view().setUint8(at, 2); return file <= 2 ? 0 : unknownFile; },
    fd_write: (file, table, count, written) => {
      let sum = 0;
      for (let i = 0; i < count; ++i) {
        const at = view().getUint32(table + 8 * i, true), size = view().getUint32(table + 8 * i + 4, true);
        write(text.decode(bytes(at, size).slice()));
        sum += size;
      }
      view().setUint32(written, sum, true);
      return 0;
    },
    proc_exit: (code) => { throw new Error('exit ' + code); },
  };
  return {
    imports: { wasi_snapshot_preview1: new Proxy({}, { get: (_, name) => calls[name] ?? (() => unknownFile), has: () => true }) },
    attach: (exports) => { memory = exports.memory; },
  };
};
