"use strict";
// Slides of 1280 x 720, with steps that appear one by one. Keys: arrows, space, Page, Home, End; N
// shows the notes, F fills the screen.

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
  const scale = Math.min(document.documentElement.clientWidth / 1280, document.documentElement.clientHeight / 720);
  all.forEach((slide, index) => slide.classList.toggle("now", index === now));
  const place = `translate(${(document.documentElement.clientWidth - 1280 * scale) / 2}px, ${(document.documentElement.clientHeight - 720 * scale) / 2}px)`;
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
  if (event.target.closest("a")) return;
  go(event.changedTouches[0].clientX > document.documentElement.clientWidth / 2 ? 1 : -1);
});
