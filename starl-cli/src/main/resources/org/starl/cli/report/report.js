"use strict";
(() => {
  const copy = async (code, button) => {
    try {
      await navigator.clipboard.writeText(code.textContent);
    } catch (refused) {
      const range = document.createRange();
      range.selectNodeContents(code);
      const selection = getSelection();
      selection.removeAllRanges();
      selection.addRange(range);
      document.execCommand("copy");
    }
    button.textContent = "copied";
    setTimeout(() => { button.textContent = "copy"; }, 1500);
  };
  document.querySelectorAll("code.command").forEach(code => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = "copy";
    button.addEventListener("click", () => copy(code, button));
    code.after(button);
  });

  addEventListener("beforeprint", () => {
    document.querySelectorAll("details").forEach(details => { details.open = true; });
  });

  const table = document.getElementById("runs");
  if (table === null) { // a sweep has points instead
    return;
  }
  const body = table.tBodies[0];
  const value = (row, column) => Number(row.cells[column].dataset.v);
  const sort = head => {
    const isDown = head.getAttribute("aria-sort") === "ascending";
    const sign = isDown ? -1 : 1;
    const rows = Array.from(body.rows);
    rows.sort((a, b) => sign * (value(a, head.cellIndex) - value(b, head.cellIndex)));
    table.querySelectorAll("th[aria-sort]").forEach(other => other.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", isDown ? "descending" : "ascending");
    body.append(...rows);
  };
  table.querySelectorAll("th[data-sort]").forEach(head => {
    head.tabIndex = 0;
    head.title = "sort by " + head.textContent;
    head.addEventListener("click", () => sort(head));
    head.addEventListener("keydown", event => {
      if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        sort(head);
      }
    });
  });

  const bad = body.querySelectorAll("tr.bad").length;
  const label = document.createElement("label");
  label.className = "tool";
  const box = document.createElement("input");
  box.type = "checkbox";
  box.disabled = bad === 0;
  box.addEventListener("change", () => table.parentElement.classList.toggle("some", box.checked));
  label.append(box, " only those that did not go well (" + bad + ")");
  table.parentElement.before(label);
})();
document.documentElement.dataset.ready = "true";
