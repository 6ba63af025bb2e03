// The search of the book: finds sections by all of their words, in the browser alone.
// The list of sections, book_index.js, is loaded when the field is first used.
(function () {
  "use strict";
  const MOST = 30;

  function element(name, properties) {
    return Object.assign(document.createElement(name), properties);
  }

  // Words count by where they stand; texts come before documentation, that before
  // sources, and sections with more of the words before all others
  function scoreOf(section, words) {
    const [address, page, heading, text] = section.lower;
    const scores = words.map((word) => 20 * heading.includes(word) +
      8 * page.includes(word) + Math.min(text.split(word).length - 1, 5));
    const weight =
      /^(chapter|index)/.test(address) ? 3 : /^source/.test(address) ? 1 : 2;
    const phrase = 10 * text.includes(words.join(" "));
    const sum = scores.reduce((a, b) => a + b, phrase);
    return 1000 * scores.filter(Boolean).length + weight * sum;
  }

  function find(query) {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    if (words.length === 0) return { words, hits: [] };
    const hits = window.bookIndex
      .map((section) => ({ section, score: scoreOf(section, words) }))
      .filter((hit) => hit.score > 0)
      .sort((a, b) => b.score - a.score);
    return { words, hits: hits.map((hit) => hit.section) };
  }

  // The text around the first word that is in it, as nodes, with every word marked
  function excerpt(text, words) {
    const places = words.map((word) => text.toLowerCase().indexOf(word));
    const found = places.filter((place) => place >= 0);
    const start = found.length ? Math.max(0, Math.min(...found) - 60) : 0;
    const piece = (start > 0 ? "…" : "") + text.slice(start, start + 180);
    const literal = words.map((w) => w.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
    return piece.split(new RegExp(`(${literal.join("|")})`, "i"))
      .map((part, i) => (i % 2 ? element("mark", { textContent: part }) : part));
  }

  function entry(section, words) {
    const [address, page, heading, text] = section;
    const title = heading ? `${page} › ${heading}` : page;
    const link = element("a", { href: address, textContent: title });
    const shown = element("p", {});
    shown.append(...excerpt(text, words));
    const item = element("li", {});
    item.append(link, shown);
    return item;
  }

  const form = element("form", { id: "book-search" });
  form.setAttribute("role", "search");
  form.innerHTML = '<input type="search" placeholder="Search the book ( / )"' +
    ' aria-label="Search the book" autocomplete="off"/>';
  const results = element("div", { id: "book-results", hidden: true });
  results.innerHTML = '<p role="status"></p><ol></ol>';
  const field = form.firstElementChild;
  const [status, list] = results.children;

  function show() {
    if (!window.bookIndex) return;
    const { words, hits } = find(field.value);
    results.hidden = words.length === 0;
    status.textContent = hits.length === 0 ? "Nothing found"
      : `${hits.length} ${hits.length === 1 ? "section" : "sections"}` +
        (hits.length > MOST ? `, the best ${MOST} shown` : "");
    const shown = hits.slice(0, MOST);
    list.replaceChildren(...shown.map((section) => entry(section, words)));
  }

  function load() {
    const script = element("script", { src: "book_index.js" });
    script.onload = () => {
      for (const section of window.bookIndex)
        section.lower = section.map((part) => part.toLowerCase());
      show();
    };
    document.head.append(script);
  }

  field.addEventListener("focus", load, { once: true });
  field.addEventListener("input", show);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    list.querySelector("a")?.click();
  });
  results.addEventListener("click", (event) => {
    if (event.target.closest("a")) results.hidden = true;
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") results.hidden = true;
    if (event.key !== "/" || event.target === field) return;
    event.preventDefault();
    field.focus();
  });

  document.getElementById("titlearea").append(form);
  document.body.append(results);
})();
