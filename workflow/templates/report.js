// The phase space: choose a set of runs and a point; the panel shows its numbers and its trajectory.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const select = document.getElementById("set");
  if (!select) return;
  const details = document.getElementById("details");
  const marks = Array.from(document.querySelectorAll("#plot .point"));
  let pinned = null;

  const element = (name, attributes, text) => {
    const svg = ["svg", "circle", "polyline"].includes(name);
    const made = svg ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    return made;
  };

  // A value with its unit; null, which is not shown, where there is none.
  const number = (value, unit) => (value === null || value === undefined ? null : value + unit);

  // Pillars and path of one run, y upwards; null if the run has no trajectory.
  const thumbnail = (point) => {
    const path = data.trajectories[point.run];
    if (!path || path.length < 4) return null;
    const { pillar_radius: radius, pitch, rows } = data.geometry;
    const ys = path.filter((_, i) => i % 2).map((y) => y / 10);
    const low = Math.min(...ys) - 8, high = Math.max(...ys) + 8, left = -pitch / 2, width = rows * pitch;
    const box = [left, -high, width, high - low].join(" ");
    const svg = element("svg", { viewBox: box, role: "img", "aria-label": "Trajectory of the cell's centre" });
    for (let n = 0; n < rows; n++) {
      const offset = n * point.d;
      const last = Math.ceil((high + radius - offset) / pitch);
      for (let m = Math.floor((low - radius - offset) / pitch); m <= last; m++)
        svg.append(element("circle", { class: "pillar", cx: n * pitch, cy: -(m * pitch + offset), r: radius }));
    }
    const corners = [];
    for (let i = 0; i < path.length; i += 2) corners.push(path[i] / 10 + "," + -path[i + 1] / 10);
    const color = `stroke: var(--${point.class})`;
    svg.append(element("polyline", { class: "trajectory", points: corners.join(" "), style: color }));
    return svg;
  };

  const show = (index) => {
    const point = data.points[index];
    const list = element("dl", {});
    const lines = [
      ["class", point.class + (point.failing ? ` (${point.failing})` : "")],
      ["class in print", point.printed || "not stated"],
      ["row shift d", number(point.d, " µm")], ["Ca", number(point.ca, "")],
      ["pressure, healthy cell", number(point.pressure, " bar/m")],
      ["lateral extent", number(point.d_perp_um, " µm")], ["2 s, without a cell", number(point.two_s_um, " µm")],
      ["film", number(point.film_um, " µm")],
      ["rows crossed", number(point.crossings, "")], ["steps", number(point.steps, "")],
      ["lattice", number(point.dx, " µm")], ["sweep", point.sweep], ["run", point.run],
    ].filter(([, value]) => value !== null);
    for (const [name, value] of lines) list.append(element("dt", {}, name), element("dd", {}, value));
    const picture = thumbnail(point);
    details.replaceChildren(list, picture || element("p", {}, "No trajectory."));
    marks.forEach((mark, i) => mark.classList.toggle("chosen", i === index));
  };

  const visible = () => marks.filter((mark) => mark.dataset.set === select.value);
  const choose = (index) => {
    pinned = index;
    for (const mark of marks) mark.setAttribute("tabindex", Number(mark.dataset.index) === index ? 0 : -1);
    show(index);
    history.replaceState(null, "", "#run-" + data.points[index].run);
  };

  const showSet = () => {
    for (const mark of marks) {
      if (mark.dataset.set === select.value) mark.removeAttribute("display");
      else mark.setAttribute("display", "none");
    }
    pinned = null;
    details.replaceChildren(element("p", {}, "No point chosen."));
    marks.forEach((mark) => mark.classList.remove("chosen"));
    const first = visible()[0];
    if (first) first.setAttribute("tabindex", 0);
  };

  // The nearest visible point in the direction of an arrow key.
  const neighbour = (index, dx, dy) => {
    const from = data.points[index];
    let best = null, least = Infinity;
    for (const mark of visible()) {
      const to = data.points[Number(mark.dataset.index)];
      const along = (to.x - from.x) * dx + (to.y - from.y) * dy;
      const across = Math.abs((to.x - from.x) * dy) + Math.abs((to.y - from.y) * dx);
      if (along > 0.5 && along + 3 * across < least) [best, least] = [mark, along + 3 * across];
    }
    return best;
  };

  const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  for (const mark of marks) {
    const index = Number(mark.dataset.index);
    mark.addEventListener("pointerenter", () => show(index));
    mark.addEventListener("pointerleave", () => pinned !== null && show(pinned));
    mark.addEventListener("click", () => choose(index));
    mark.addEventListener("focus", () => show(index));
    mark.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") choose(index);
      else if (!(event.key in arrows)) return;
      else {
        const next = neighbour(index, ...arrows[event.key]);
        if (next) {
          choose(Number(next.dataset.index));
          next.focus();
        }
      }
      event.preventDefault();
    });
  }
  select.addEventListener("change", showSet);
  showSet();

  // A link such as #run-0123456789ab, from outside or from a claim, opens the page at that run; one to a table
  // opens the table.
  const follow = () => {
    const target = document.getElementById(location.hash.slice(1));
    if (target && target.tagName === "DETAILS") target.open = true;
    const wanted = data.points.findIndex((point) => location.hash === "#run-" + point.run);
    if (wanted < 0) return;
    select.value = data.points[wanted].set;
    showSet();
    choose(wanted);
    document.getElementById("space").scrollIntoView();
  };
  addEventListener("hashchange", follow);
  follow();
})();
