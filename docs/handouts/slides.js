"use strict";
// Slides of 1280 x 720: what does not fit goes on to a further slide, or is made smaller if it is
// one block. Steps of a slide appear one by one. Keys: arrows, space, Page, Home, End; N shows the
// notes, F fills the screen.

/** Move the blocks of a slide that do not fit, and give each slide the notes of its blocks. */
function paginate(slide) {
  const blocks = [...slide.querySelectorAll(".block")];
  blocks.forEach((block) => block.remove());
  const empty = slide.cloneNode(true);
  empty.classList.remove("first");
  for (const block of blocks) {
    let room = slide.querySelector(".body");
    const isFull = () => room.scrollHeight > room.clientHeight + 1;
    room.append(block);
    if (isFull() && room.children.length > 1) {
      slide.after(empty.cloneNode(true));
      slide = slide.nextElementSibling;
      room = slide.querySelector(".body");
      room.append(block);
    }
    if (isFull()) block.style.zoom = String((0.98 * room.clientHeight) / room.scrollHeight);
    const note = block.querySelector("template");
    slide.querySelector(".notes").append(note.content);
    note.remove();
  }
}

/** Choose the size of code so that its longest line is not broken, as far as it can be read. */
function fit(code) {
  const longest = Math.max(...code.textContent.split("\n").map((line) => line.length));
  code.style.fontSize = `${Math.max(14, Math.min(22, 1125 / (0.603 * longest)))}px`;
}

let now = 0;
/** @type {HTMLElement[]} */
let all = [];

/** Show so many steps of the slide, if it has more; return whether it has. */
function step(change) {
  const steps = [...all[now].querySelectorAll(".step")];
  const shown = steps.filter((one) => !one.matches(".later")).length + change;
  if (shown < 0 || shown > steps.length) return false;
  steps.forEach((one, index) => one.classList.toggle("later", index >= shown));
  return true;
}

/** Show a slide, without its steps or with all of them. */
function show(number, whole = false) {
  now = Math.max(0, Math.min(all.length - 1, number));
  const scale = Math.min(innerWidth / 1280, innerHeight / 720);
  all.forEach((slide, index) => slide.classList.toggle("now", index === now));
  const place = `translate(${(innerWidth - 1280 * scale) / 2}px, ${(innerHeight - 720 * scale) / 2}px)`;
  all[now].style.transform = `${place} scale(${scale})`;
  all[now].querySelectorAll(".step").forEach((one) => one.classList.toggle("later", !whole));
  history.replaceState(null, "", `#${now + 1}`);
}

/** Go on by a step or a slide, or back. */
function go(change) {
  if (Math.abs(change) > 1 || !step(change)) show(now + change, change < 0);
}

const KEYS = {
  ArrowRight: 1, ArrowDown: 1, PageDown: 1, " ": 1, ArrowLeft: -1, ArrowUp: -1, PageUp: -1,
  Home: -Infinity, End: Infinity,
};

addEventListener("load", () => {
  document.querySelectorAll("pre").forEach(fit);
  document.querySelectorAll(".slide").forEach(paginate);
  all = [...document.querySelectorAll(".slide")];
  all.forEach((slide, index) => {
    slide.querySelector(".foot span").textContent = `${index + 1} / ${all.length}`;
  });
  document.body.classList.add("showing");
  show(Number(location.hash.slice(1)) - 1 || 0);
});
addEventListener("resize", () => show(now));
addEventListener("beforeprint", () => all.forEach((slide) => (slide.style.transform = "")));
addEventListener("afterprint", () => show(now));
addEventListener("hashchange", () => show(Number(location.hash.slice(1)) - 1 || 0));
addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key in KEYS) {
    event.preventDefault();
    go(KEYS[event.key]);
  } else if (event.key === "n") {
    document.body.classList.toggle("noted");
  } else if (event.key === "f") {
    document.documentElement.requestFullscreen();
  }
});
addEventListener("touchend", (event) => {
  if (event.target.closest("a, pre")) return;
  go(event.changedTouches[0].clientX > innerWidth / 2 ? 1 : -1);
});
