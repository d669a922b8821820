// The page of `durer watch`: displays the picture and the state that the server sends, and sends the author's settings.
"use strict";

const at = (id) => document.getElementById(id);
const [stage, picture, before] = [at("stage"), at("picture"), at("before")];

/** The last state from the server; number and completeness of the picture on the canvas. */
let state = null;
let run = 0;
let done = false;

// ---------------------------------------------------------------- from the server

const events = new EventSource("events");
events.addEventListener("state", (event) => showState(JSON.parse(event.data)));
events.addEventListener("picture", (event) => paint(JSON.parse(event.data)));
events.onerror = () => setStatus("durer has ended or cannot be reached", true);

function showState(news) {
  state = news.state;
  document.title = `${{ broken: "✗ ", done: "", reading: "… ", drawing: "… " }[state.status]}${state.name} – durer`;
  at("name").textContent = state.name;
  const errors = state.messages.filter((message) => message.severity === "error").length;
  setStatus(
    {
      reading: "reading …",
      drawing: "drawing …",
      done: "done",
      broken: errors > 1 ? `${errors} errors; this is the previous picture` : "an error; this is the previous picture",
    }[state.status],
    state.status === "broken",
  );
  stage.classList.toggle("stale", state.status === "broken");
  showSettings();
  showMessages();
  showTimes();
  at("log-section").hidden = state.log === "";
  at("log").textContent = state.log;
  at("save").disabled = state.status !== "done";
  if (news.before && at("compare").disabled) loadBefore();
}

function setStatus(text, broken) {
  at("status").textContent = text;
  at("status").classList.toggle("broken", broken);
}

function image([x, y, width, height, data]) {
  const bytes = Uint8ClampedArray.from(atob(data), (c) => c.charCodeAt(0));
  return { x, y, pixels: new ImageData(bytes, width, height) };
}

function paint(news) {
  const to = picture.getContext("2d", { willReadFrequently: true });
  if (news.size) {
    if (done) keepBefore();
    [run, done] = [news.run, false];
    const [width, height] = news.size;
    // Keep the old picture until the first pixels of the new one.
    const old = document.createElement("canvas");
    [old.width, old.height] = [picture.width, picture.height];
    old.getContext("2d").drawImage(picture, 0, 0);
    [picture.width, picture.height] = news.size;
    to.drawImage(old, 0, 0, width, height);
    stage.style.aspectRatio = `${width} / ${height}`;
  }
  if (news.run !== run) return;
  if (news.coarse) {
    const { pixels } = image(news.coarse);
    const small = document.createElement("canvas");
    [small.width, small.height] = [pixels.width, pixels.height];
    small.getContext("2d").putImageData(pixels, 0, 0);
    to.imageSmoothingQuality = "high";
    to.clearRect(0, 0, picture.width, picture.height);
    to.drawImage(small, 0, 0, picture.width, picture.height);
  }
  for (const tile of news.tiles) {
    const { x, y, pixels } = image(tile);
    to.putImageData(pixels, x, y);
  }
  at("progress").value = news.progress;
  done = news.done;
  stage.dataset.run = run;
  stage.dataset.done = done;
}

// ---------------------------------------------------------------- now and before

function keepBefore() {
  [before.width, before.height] = [picture.width, picture.height];
  before.getContext("2d").drawImage(picture, 0, 0);
  at("compare").disabled = false;
}

/** Loads the previous picture from the server after the page was reloaded. */
function loadBefore() {
  const old = new Image();
  old.onload = () => {
    if (!at("compare").disabled) return;
    [before.width, before.height] = [old.width, old.height];
    before.getContext("2d").drawImage(old, 0, 0);
    at("compare").disabled = false;
  };
  old.src = "before.png";
}

at("compare").addEventListener("input", () => {
  const share = Number(at("compare").value);
  before.hidden = at("divide").hidden = share === 0;
  before.style.clipPath = `inset(0 ${100 - share}% 0 0)`;
  at("divide").style.left = `${share}%`;
});

// ---------------------------------------------------------------- settings

/** Sends changes of the settings, one request at a time. */
let waiting = null;
let busy = false;
async function change(settings) {
  waiting = { ...waiting, ...settings };
  if (busy) return;
  busy = true;
  while (waiting) {
    const now = waiting;
    waiting = null;
    await ask("change", now);
  }
  busy = false;
}

async function ask(what, body) {
  try {
    const answer = await fetch(what, { method: "POST", body: JSON.stringify(body) });
    const json = await answer.json();
    return json.error ? { error: json.error } : json;
  } catch {
    return { error: "durer does not respond" };
  }
}

function showSettings() {
  const { settings, size, clock } = state;
  for (const button of at("sizes").children) {
    button.setAttribute("aria-pressed", Number(button.dataset.scale) === settings.scale);
  }
  at("size").textContent = size.map((side) => Math.max(1, Math.round(side * settings.scale))).join(" × ");
  at("antialias").checked = settings.antialias;
  at("quality").value = settings.quality;
  at("whole").disabled = !settings.zoom;
  const [now, first, last] = clock;
  [at("clock").min, at("clock").max] = [Math.min(first, last), Math.max(first, last)];
  at("clock").step = Math.abs(last - first) / 200 || 0.01;
  for (const input of [at("clock"), at("clock-number")]) {
    if (document.activeElement !== input) input.value = now;
  }
}

at("sizes").addEventListener("click", (event) => {
  if (event.target.dataset.scale) change({ scale: Number(event.target.dataset.scale) });
});
at("antialias").addEventListener("change", () => change({ antialias: at("antialias").checked }));
at("quality").addEventListener("change", () => change({ quality: Number(at("quality").value) }));
for (const [one, other] of [["clock", "clock-number"], ["clock-number", "clock"]]) {
  at(one).addEventListener("input", () => {
    const clock = at(one).valueAsNumber;
    if (!Number.isFinite(clock)) return;
    at(other).value = clock;
    change({ clock });
  });
}
at("controls").addEventListener("submit", (event) => event.preventDefault());
at("whole").addEventListener("click", () => change({ zoom: [] }));
at("save").addEventListener("click", save);

async function save() {
  const { text, error } = await ask("save", {});
  at("saved").textContent = error ?? `written to ${text}`;
}

// ---------------------------------------------------------------- messages and times

function link(place) {
  const a = document.createElement("a");
  a.textContent = `${place.file}:${place.line}:${place.column}`;
  a.href = place.url;
  a.addEventListener("click", (event) => {
    if (state?.editor) {
      event.preventDefault();
      open(place);
    }
  });
  return a;
}

async function open(place) {
  if (!state?.editor) {
    window.location.href = place.url;
    return;
  }
  const { file, line, column } = place;
  const { error } = await ask("open", { file, line, column });
  if (error) at("saved").textContent = error;
}

function showMessages() {
  const list = state.messages.map((message) => {
    const item = document.createElement("div");
    item.className = `message ${message.severity}`;
    if (message.place) item.append(link(message.place));
    const text = document.createElement("pre");
    text.textContent = message.text;
    item.append(text);
    return item;
  });
  if (list.length === 0) {
    const none = document.createElement("p");
    none.className = "none";
    none.textContent = "None.";
    list.push(none);
  }
  at("messages").replaceChildren(...list);
}

function showTimes() {
  const seconds = (time) => (time < 1 ? `${(time * 1000).toFixed(time < 0.01 ? 1 : 0)} ms` : `${time.toFixed(2)} s`);
  const rows = state.times.map(([what, time]) => [what, seconds(time)]);
  if (state.rays) rows.push(["rays", state.rays.toLocaleString("en")]);
  at("times").replaceChildren(
    ...rows.map((cells) => {
      const row = document.createElement("tr");
      row.append(...cells.map((text) => Object.assign(document.createElement("td"), { textContent: text })));
      return row;
    }),
  );
}

// ---------------------------------------------------------------- under the pointer

/** The pixel under the pointer. */
let pointer = null;
let picked = null;
let picking = false;

function pixel(event) {
  const box = picture.getBoundingClientRect();
  const inside = (share, pixels) => Math.min(Math.max(Math.floor(share * pixels), 0), pixels - 1);
  return [
    inside((event.clientX - box.left) / box.width, picture.width),
    inside((event.clientY - box.top) / box.height, picture.height),
  ];
}

async function pick() {
  if (picking) return;
  picking = true;
  for (let last = null; pointer && String(pointer) !== String(last); ) {
    last = pointer;
    const [x, y] = last;
    try {
      const answer = await fetch(`pick?x=${x}&y=${y}`);
      picked = await answer.json();
      showPick(x, y);
    } catch {
      break;
    }
  }
  picking = false;
}

function showPick(x, y) {
  const text = at("pick");
  text.classList.remove("empty");
  text.replaceChildren(`${x}, ${y}\n`, picked.words ?? "nothing is rendered yet");
  if (picked.place) text.append(link(picked.place));
}

// ---------------------------------------------------------------- frames, clicks and keys

let start = null;

function share(event) {
  const box = picture.getBoundingClientRect();
  const clamp = (x) => Math.min(Math.max(x, 0), 1);
  return [clamp((event.clientX - box.left) / box.width), clamp((event.clientY - box.top) / box.height)];
}

function frameTo(event) {
  const [a, b] = [start, share(event)];
  const [left, top] = [Math.min(a[0], b[0]), Math.min(a[1], b[1])];
  return [left, top, Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1])];
}

stage.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  start = share(event);
  stage.setPointerCapture(event.pointerId);
});

stage.addEventListener("pointermove", (event) => {
  pointer = pixel(event);
  at("cross").hidden = true;
  pick();
  if (!start) return;
  const [x, y, width, height] = frameTo(event).map((part) => `${part * 100}%`);
  Object.assign(at("frame").style, { left: x, top: y, width, height });
  at("frame").hidden = false;
});

stage.addEventListener("pointerup", async (event) => {
  if (!start) return;
  const frame = frameTo(event);
  const clicked = frame[2] * picture.clientWidth < 5 && frame[3] * picture.clientHeight < 5;
  start = null;
  at("frame").hidden = true;
  if (!clicked) return zoom(frame);
  pointer = pixel(event);
  await pick();
  if (picked?.place) open(picked.place);
});

stage.addEventListener("pointercancel", () => {
  start = null;
  at("frame").hidden = true;
});

/** A part of the displayed picture, which may be a part itself. */
function zoom([x, y, width, height]) {
  if (width < 0.005 || height < 0.005) return;
  const [left, top, across, down] = state?.settings.zoom ?? [0, 0, 1, 1];
  change({ zoom: [left + x * across, top + y * down, width * across, height * down] });
}

stage.addEventListener("keydown", (event) => {
  const step = event.shiftKey ? 10 : 1;
  const move = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[event.key];
  if (event.key === "Enter" && picked?.place) return open(picked.place);
  if (!move) return;
  event.preventDefault();
  const [x, y] = pointer ?? [picture.width >> 1, picture.height >> 1];
  const inside = (at, pixels) => Math.min(Math.max(at, 0), pixels - 1);
  pointer = [inside(x + move[0], picture.width), inside(y + move[1], picture.height)];
  const cross = at("cross");
  cross.hidden = false;
  cross.style.left = `${((pointer[0] + 0.5) / picture.width) * 100}%`;
  cross.style.top = `${((pointer[1] + 0.5) / picture.height) * 100}%`;
  pick();
});

document.addEventListener("keydown", (event) => {
  const typing = event.target.matches("input[type=number], select");
  if (event.ctrlKey || event.metaKey || event.altKey || typing) return;
  const sizes = { 1: 0.25, 2: 0.5, 3: 1, 4: 2 };
  if (event.key in sizes) change({ scale: sizes[event.key] });
  else if (event.key === "a") change({ antialias: !at("antialias").checked });
  else if (event.key === "q") at("quality").focus();
  else if (event.key === "c") at("clock").focus();
  else if (event.key === "b" && !at("compare").disabled) at("compare").focus();
  else if (event.key === "s" && !at("save").disabled) save();
  else if (event.key === "p") stage.focus();
  else if (event.key === "Escape" && start) [start, at("frame").hidden] = [null, true];
  else if (event.key === "Escape" && state?.settings.zoom) change({ zoom: [] });
});
