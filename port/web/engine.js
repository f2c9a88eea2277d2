// The program contact2d in a page: loadContact2d makes a module of it, runContact2d runs one command of it, among files that
// live in memory. What WebAssembly asks of its system (WASI, preview 1) is here as far as the program needs it.
"use strict";

// Base64 of the gzipped module, as `make web` writes it -> a WebAssembly.Module, to be run any number of times.
async function loadContact2d(base64) {
  return WebAssembly.compile(await unpackContact2d(base64));
}
async function unpackContact2d(base64) {
  const packed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

// runContact2d(module, ["run", "deck.dat", "--csv", "contact.csv"], {"deck.dat": text}) ->
// {status, out, err, files}: exit status, what it printed, and the files that are there afterwards, as text. `tell`, if given,
// hears what goes to standard error while it runs.
function runContact2d(module, words, files = {}, tell = null) {
  const system = new WasiSystem(["contact2d", ...words], files, tell);
  const instance = new WebAssembly.Instance(module, {wasi_snapshot_preview1: system.calls()});
  system.memory = instance.exports.memory;
  try {
    instance.exports._start();
  } catch (end) {
    if (!(end instanceof WasiExit)) throw end;
  }
  return system.result();
}

class WasiExit {}

class WasiFile {
  constructor(bytes = new Uint8Array(0)) {
    this.bytes = bytes;
    this.size = bytes.length;
  }
  write(at, from) {
    const end = at + from.length;
    if (end > this.bytes.length) this.resize(Math.max(end, 2 * this.bytes.length, 4096));
    this.bytes.set(from, at);
    this.size = Math.max(this.size, end);
  }
  resize(room) {
    const bytes = new Uint8Array(room);
    bytes.set(this.bytes.subarray(0, Math.min(room, this.size)));
    this.bytes = bytes;
  }
  truncate(size) {
    if (size > this.bytes.length) this.resize(size);
    this.bytes.fill(0, Math.min(size, this.size), Math.max(size, this.size));
    this.size = size;
  }
  text() { return new TextDecoder().decode(this.bytes.subarray(0, this.size)); }
}

const WASI = {ok: 0, badFile: 8, exists: 20, invalid: 28, isFolder: 31, none: 44, missing: 52, noFolder: 54, notEmpty: 55};
const FILE = 4, FOLDER = 3, TERMINAL = 2;

class WasiSystem {
  constructor(words, files, tell) {
    this.words = words.map((word) => this.ended(word));
    this.tell = tell, this.status = 0, this.memory = null;
    this.tree = new Map([["", null]]); // null: a folder; names have no slash in front
    for (const [name, content] of Object.entries(files)) {
      const bytes = typeof content === "string" ? new TextEncoder().encode(content) : content;
      this.tree.set(name, new WasiFile(bytes));
    }
    this.streams = [new WasiFile(), new WasiFile(), new WasiFile()];
    this.open = new Map([[0, this.stream(0)], [1, this.stream(1)], [2, this.stream(2)], [3, {name: "", at: 0, file: null}]]);
    this.next = 4;
  }
  stream(number) { return {file: this.streams[number], at: 0, stream: number}; }
  ended(word) { return new TextEncoder().encode(word + "\0"); }

  result() {
    const files = {};
    for (const [name, file] of this.tree) if (file !== null) files[name] = file.text();
    return {status: this.status, out: this.streams[1].text(), err: this.streams[2].text(), files};
  }

  // ---- the module's memory
  view() { return new DataView(this.memory.buffer); }
  bytes(at, length) { return new Uint8Array(this.memory.buffer, at, length); }
  text(at, length) { return new TextDecoder().decode(this.bytes(at, length)); }
  set32(at, value) { this.view().setUint32(at, value, true); }
  set64(at, value) { this.view().setBigUint64(at, BigInt(value), true); }
  pieces(list, count) {
    const view = this.view(), out = [];
    for (let i = 0; i < count; ++i) {
      out.push(this.bytes(view.getUint32(list + 8 * i, true), view.getUint32(list + 8 * i + 4, true)));
    }
    return out;
  }

  // ---- names
  path(folder, at, length) {
    const parts = [];
    for (const part of ((this.open.get(folder).name || "") + "/" + this.text(at, length)).split("/")) {
      if (part === "..") parts.pop();
      else if (part !== "" && part !== ".") parts.push(part);
    }
    return parts.join("/");
  }
  parent(name) { return name.includes("/") ? name.slice(0, name.lastIndexOf("/")) : ""; }
  below(name) { return [...this.tree.keys()].filter((each) => each !== "" && this.parent(each) === name); }

  stat(at, file, name) {
    this.bytes(at, 64).fill(0);
    let number = 1;
    for (const letter of name) number = (number * 31 + letter.charCodeAt(0)) % 4294967291;
    this.set64(at + 8, number);
    this.view().setUint8(at + 16, file === null ? FOLDER : FILE);
    this.set64(at + 24, 1);
    this.set64(at + 32, file === null ? 0 : file.size);
    return WASI.ok;
  }

  transfer(handle, list, count, done, at, writes) {
    const entry = this.open.get(handle);
    if (entry === undefined || entry.file === null) return WASI.badFile;
    let place = at === null ? entry.at : at;
    const begin = place;
    for (const piece of this.pieces(list, count)) {
      if (writes) {
        if (entry.appends && at === null) place = entry.file.size;
        entry.file.write(place, piece);
        place += piece.length;
        if (entry.stream === 2 && this.tell !== null) this.tell(new TextDecoder().decode(piece));
      } else {
        const length = Math.max(0, Math.min(piece.length, entry.file.size - place));
        piece.set(entry.file.bytes.subarray(place, place + length));
        place += length;
      }
    }
    if (at === null) entry.at = place;
    this.set32(done, place - begin);
    return WASI.ok;
  }

  lists(list, room) { // of words that end in a zero byte
    for (const word of this.words) {
      this.set32(list, room);
      this.bytes(room, word.length).set(word);
      list += 4, room += word.length;
    }
    return WASI.ok;
  }

  openPath(folder, at, length, flags, wants, out) {
    const name = this.path(folder, at, length), creates = flags & 1, folders = flags & 2, alone = flags & 4, cuts = flags & 8;
    let file = this.tree.get(name);
    if (file === undefined) {
      if (!creates) return WASI.none;
      if (this.tree.get(this.parent(name)) !== null) return WASI.none;
      file = new WasiFile();
      this.tree.set(name, file);
    } else if (creates && alone) {
      return WASI.exists;
    }
    if (folders && file !== null) return WASI.noFolder;
    if (file === null && (creates || cuts)) return WASI.isFolder;
    if (file !== null && cuts) file.truncate(0);
    this.open.set(this.next, {name, file, at: 0, appends: (wants & 1) !== 0});
    this.set32(out, this.next++);
    return WASI.ok;
  }

  rename(folder, at, length, toFolder, toAt, toLength) {
    const from = this.path(folder, at, length), to = this.path(toFolder, toAt, toLength);
    if (!this.tree.has(from)) return WASI.none;
    for (const [name, file] of [...this.tree]) {
      if (name !== from && !name.startsWith(from + "/")) continue;
      this.tree.delete(name);
      this.tree.set(to + name.slice(from.length), file);
    }
    return WASI.ok;
  }

  remove(name, folder) {
    const file = this.tree.get(name);
    if (file === undefined) return WASI.none;
    if ((file === null) !== folder) return folder ? WASI.noFolder : WASI.isFolder;
    if (folder && this.below(name).length > 0) return WASI.notEmpty;
    this.tree.delete(name);
    return WASI.ok;
  }

  list(handle, at, room, cookie, used) {
    const entry = this.open.get(handle), names = this.below(entry.name);
    let written = 0;
    for (let i = Number(cookie); i < names.length && written < room; ++i) {
      const name = new TextEncoder().encode(names[i].slice(entry.name === "" ? 0 : entry.name.length + 1));
      const record = new Uint8Array(24 + name.length), view = new DataView(record.buffer);
      view.setBigUint64(0, BigInt(i + 1), true);
      view.setUint32(16, name.length, true);
      view.setUint8(20, this.tree.get(names[i]) === null ? FOLDER : FILE);
      record.set(name, 24);
      const part = record.subarray(0, room - written);
      this.bytes(at + written, part.length).set(part);
      written += part.length;
    }
    this.set32(used, written);
    return WASI.ok;
  }

  calls() {
    const entry = (handle) => this.open.get(handle);
    const known = {
      args_sizes_get: (count, bytes) => {
        this.set32(count, this.words.length);
        this.set32(bytes, this.words.reduce((sum, word) => sum + word.length, 0));
        return WASI.ok;
      },
      args_get: (list, room) => this.lists(list, room),
      environ_sizes_get: (count, bytes) => (this.set32(count, 0), this.set32(bytes, 0), WASI.ok),
      environ_get: () => WASI.ok,
      clock_res_get: (_, out) => (this.set64(out, 1000), WASI.ok),
      clock_time_get: (which, _, out) => {
        const now = which === 0 ? Date.now() : performance.now();
        this.set64(out, Math.round(now * 1e6));
        return WASI.ok;
      },
      random_get: (at, length) => (crypto.getRandomValues(this.bytes(at, length)), WASI.ok),
      sched_yield: () => WASI.ok,
      proc_exit: (status) => {
        this.status = status;
        throw new WasiExit();
      },
      fd_prestat_get: (handle, out) => {
        if (handle !== 3) return WASI.badFile;
        this.set32(out, 0), this.set32(out + 4, 1);
        return WASI.ok;
      },
      fd_prestat_dir_name: (_, at) => (this.bytes(at, 1).set([47]), WASI.ok),
      fd_fdstat_get: (handle, out) => {
        const open = entry(handle);
        if (open === undefined) return WASI.badFile;
        this.bytes(out, 24).fill(0);
        this.view().setUint8(out, open.stream !== undefined ? TERMINAL : open.file === null ? FOLDER : FILE);
        this.set64(out + 8, 0x1fffffff), this.set64(out + 16, 0x1fffffff);
        // a stream that cannot seek is a terminal to the C library: these are files without names
        if (open.stream !== undefined) this.view().setUint8(out, FILE);
        return WASI.ok;
      },
      fd_fdstat_set_flags: () => WASI.ok,
      fd_filestat_get: (handle, out) => {
        const open = entry(handle);
        return open === undefined ? WASI.badFile : this.stat(out, open.file, open.name || "stream" + open.stream);
      },
      fd_filestat_set_size: (handle, size) => (entry(handle).file.truncate(Number(size)), WASI.ok),
      fd_filestat_set_times: () => WASI.ok,
      fd_allocate: (handle, offset, length) => {
        const file = entry(handle).file, size = Number(offset) + Number(length);
        if (size > file.size) file.truncate(size);
        return WASI.ok;
      },
      fd_advise: () => WASI.ok,
      fd_sync: () => WASI.ok,
      fd_datasync: () => WASI.ok,
      fd_close: (handle) => this.open.delete(handle) ? WASI.ok : WASI.badFile,
      fd_read: (handle, list, count, done) => this.transfer(handle, list, count, done, null, false),
      fd_write: (handle, list, count, done) => this.transfer(handle, list, count, done, null, true),
      fd_pread: (handle, list, count, at, done) => this.transfer(handle, list, count, done, Number(at), false),
      fd_pwrite: (handle, list, count, at, done) => this.transfer(handle, list, count, done, Number(at), true),
      fd_seek: (handle, offset, whence, out) => {
        const open = entry(handle);
        if (open === undefined || open.file === null) return WASI.badFile;
        const place = Number(offset) + [0, open.at, open.file.size][whence];
        if (place < 0) return WASI.invalid;
        open.at = place;
        this.set64(out, place);
        return WASI.ok;
      },
      fd_tell: (handle, out) => (this.set64(out, entry(handle).at), WASI.ok),
      fd_renumber: (from, to) => (this.open.set(to, entry(from)), this.open.delete(from), WASI.ok),
      fd_readdir: (handle, at, room, cookie, used) => this.list(handle, at, room, cookie, used),
      path_open: (folder, _, at, length, flags, rights, inheriting, wants, out) =>
        this.openPath(folder, at, length, flags, wants, out),
      path_filestat_get: (folder, _, at, length, out) => {
        const name = this.path(folder, at, length), file = this.tree.get(name);
        return file === undefined ? WASI.none : this.stat(out, file, name);
      },
      path_filestat_set_times: () => WASI.ok,
      path_create_directory: (folder, at, length) => {
        const name = this.path(folder, at, length);
        if (this.tree.has(name)) return WASI.exists;
        if (this.tree.get(this.parent(name)) !== null) return WASI.none;
        this.tree.set(name, null);
        return WASI.ok;
      },
      path_remove_directory: (folder, at, length) => this.remove(this.path(folder, at, length), true),
      path_unlink_file: (folder, at, length) => this.remove(this.path(folder, at, length), false),
      path_rename: (folder, at, length, toFolder, toAt, toLength) => this.rename(folder, at, length, toFolder, toAt, toLength),
      path_readlink: () => WASI.invalid,
    };
    return new Proxy(known, {get: (calls, name) => calls[name] || (() => WASI.missing)});
  }
}
