// Search, filters and colours; the page is complete without them.
const cards = [...document.querySelectorAll("article")];
const search = document.getElementById("search");
const filters = [...document.querySelectorAll(".controls [data-verdict]")];
const words = new Map(cards.map((card) => [card, card.textContent.toLowerCase()]));

function show() {
  const wanted = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  const verdicts = filters.filter((b) => b.ariaPressed === "true").map((b) => b.dataset.verdict);
  let number = 0;
  for (const card of cards) {
    const text = words.get(card);
    card.hidden = !verdicts.includes(card.dataset.verdict) || !wanted.every((w) => text.includes(w));
    number += !card.hidden;
    document.querySelector(`nav a[href="#${CSS.escape(card.id)}"]`).parentNode.hidden = card.hidden;
  }
  for (const heading of document.querySelectorAll("h2.section")) {
    let next = heading.nextElementSibling;
    while (next && next.hidden && next.matches("article")) next = next.nextElementSibling;
    heading.hidden = !(next && next.matches("article"));
  }
  document.getElementById("shown").textContent =
    number === cards.length ? "" : `${number} of ${cards.length}`;
}

for (const button of filters) {
  button.addEventListener("click", () => {
    button.ariaPressed = String(button.ariaPressed !== "true");
    show();
  });
}
search.addEventListener("input", show);
const themes = ["auto", "light", "dark"];
const theme = document.getElementById("theme");
theme.addEventListener("click", () => {
  const next = themes[(themes.indexOf(document.documentElement.dataset.theme ?? "auto") + 1) % 3];
  document.documentElement.dataset.theme = next;
  theme.textContent = `colours: ${next}`;
});
const contents = document.querySelector("nav details");
if (matchMedia("(max-width: 62rem)").matches) contents.open = false;
window.addEventListener("beforeprint", () => { contents.open = true; });
document.querySelector(".controls").hidden = false;
