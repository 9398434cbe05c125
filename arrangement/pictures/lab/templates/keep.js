// What is kept and shared: links, files, pictures. Elements: `problem`, `kept`, `said`, `file`.
function say(text) {
  if (at("said").textContent !== text) at("said").textContent = text;
}

// Runs what may fail on input from outside: then the last valid state stays.
async function attempt(action) {
  try {
    await action();
    at("problem").textContent = "";
  } catch (error) {
    at("problem").textContent = `Not taken: ${error.message}.`;
  }
}

function download(name, type, text) {
  const anchor = make("a", { href: URL.createObjectURL(new Blob([text], { type })), download: name });
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 1000);
  at("kept").textContent = `saved: ${name}`;
}

const downloadJson = (name, form) => download(name, "application/json", `${JSON.stringify(form, null, 2)}\n`);

// Copies where the browser allows it; the text is shown in any case.
function copy(text) {
  at("kept").textContent = text;
  navigator.clipboard?.writeText(text).then(() => say("copied"), () => getSelection().selectAllChildren(at("kept")));
}

// A picture with its colours written into it, so that it needs no style sheet.
function svgText(view) {
  const whole = view.cloneNode(true);
  const kept = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "stroke-linecap",
    "opacity", "font-size", "font-weight", "font-family", "text-anchor", "dominant-baseline", "paint-order"];
  const copies = [...whole.querySelectorAll("*")];
  [...view.querySelectorAll("*")].forEach((element, k) => {
    const style = getComputedStyle(element);
    for (const name of kept) copies[k].setAttribute(name, style.getPropertyValue(name).replace(/"/g, "'"));
    copies[k].removeAttribute("class");
    copies[k].removeAttribute("style");
  });
  whole.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  whole.querySelectorAll("[data-grip] .target").forEach((element) => element.remove());
  return new XMLSerializer().serializeToString(whole);
}

// The head of a page; `open` gets the example that is chosen.
function listenToHead(open) {
  showHead();
  window.addEventListener("beforeprint", () => document.querySelectorAll("details.panel").forEach((/** @type {HTMLDetailsElement} */ panel) => { panel.open = true; }));
  const box = at("example");
  make("option", { value: "", disabled: "", selected: "" }, box, "examples …");
  data.examples.forEach(({ name }, k) => make("option", { value: k }, box, name));
  box.addEventListener("change", () => open(data.examples[Number(box.value)]));
}

// Buttons with data-svg save the picture of that id, under the name in data-name; copy-link copies
// the address, copy-command what `commandOf` returns; open-file gives the text of a chosen file to `open`.
function listenToKeep(open, commandOf) {
  at("copy-command").addEventListener("click", () => copy(commandOf()));
  at("copy-link").addEventListener("click", () => copy(`${location.href.split("#")[0]}#${snapshot()}`));
  document.querySelectorAll("[data-svg]").forEach((/** @type {HTMLElement} */ button) => button.addEventListener("click", () => {
    download(button.dataset.name, "image/svg+xml", svgText(at(button.dataset.svg)));
  }));
  at("open-file").addEventListener("click", () => at("file").click());
  at("file").addEventListener("change", async () => {
    const [file] = at("file").files;
    at("file").value = "";
    if (file) attempt(async () => open(await file.text()));
  });
}
