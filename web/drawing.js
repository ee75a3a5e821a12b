// Draws a mechanism as SVG, from its lines in metres, with the classes and names of the reports' drawings; in a narrow
// place with fewer pixels, so that its letters stay legible.
window.genevaDrawing = function (placeWidth) {
  "use strict";
  const width = Math.min(640, Math.max(320, placeWidth));
  const height = (490 / 640) * width;
  const sideMargin = 16;
  const bottomMargin = 46; // for the centre distance
  const arrow = width / 8; // of the greatest force

  function turned([x, y, z], angle) {
    return [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle), z];
  }
  const isSpherical = (mechanism) => mechanism.pin_path.some((place) => place[2] !== 0);

  // To the right and down: y is up in the plane, a sphere is seen from above the line of centres.
  function directions(mechanism) {
    if (!isSpherical(mechanism)) return [[1, 0, 0], [0, -1, 0]];
    const [around, above] = [0.6, 0.55];
    return [
      [Math.cos(around), Math.sin(around), 0],
      [Math.sin(around) * Math.sin(above), -Math.cos(around) * Math.sin(above), -Math.cos(above)],
    ];
  }

  // Everything that the drawing has to hold; the wheel in any position.
  function extremes(mechanism) {
    const eighths = Array.from({ length: 8 }, (_, i) => (i * Math.PI) / 4);
    const places = mechanism.wheel.flatMap((loop) => loop.flatMap((place) => eighths.map((angle) => turned(place, angle))));
    const radius = mechanism.pin_diameter / 2;
    for (const [x, y, z] of mechanism.pin_path)
      for (const side of [-radius, radius]) places.push([x + side, y, z], [x, y + side, z]);
    if (mechanism.driver_axis) places.push(mechanism.driver_axis);
    return places;
  }

  function projection(mechanism) {
    const rows = directions(mechanism);
    const low = [Infinity, Infinity];
    const high = [-Infinity, -Infinity];
    for (const place of extremes(mechanism))
      rows.forEach((row, i) => {
        const at = row[0] * place[0] + row[1] * place[1] + row[2] * place[2];
        low[i] = Math.min(low[i], at);
        high[i] = Math.max(high[i], at);
      });
    const scale = Math.min((width - 2 * sideMargin) / (high[0] - low[0]), (height - sideMargin - bottomMargin) / (high[1] - low[1]));
    return {
      rows: rows.map((row) => row.map((component) => component * scale)),
      offset: [width / 2 - (scale * (low[0] + high[0])) / 2, (height + sideMargin - bottomMargin) / 2 - (scale * (low[1] + high[1])) / 2],
      arrow,
    };
  }

  const fixed = (number) => number.toFixed(2);
  const circle = (attributes, [x, y], radius) => `<circle ${attributes} cx="${fixed(x)}" cy="${fixed(y)}" r="${fixed(radius)}"/>`;
  const line = (attributes, from, to) => `<line ${attributes} x1="${fixed(from[0])}" y1="${fixed(from[1])}" x2="${fixed(to[0])}" y2="${fixed(to[1])}"/>`;
  const wide = (text) => 7.4 * text.length + 6;
  function label(id, [x, y], text) {
    const across = wide(text);
    return `<g${id} class="label" transform="translate(${fixed(x)} ${fixed(y)})"><rect x="${fixed(-across / 2)}" y="-9" width="${fixed(across)}" height="18"/><text class="dimension-text" y="5">${text}</text></g>`;
  }

  // An arrow from the middle of a circle to its line, with its label before the head, or behind it where it is too short.
  function radius(centre, length, direction, text) {
    const at = (along) => [centre[0] + along * Math.cos(direction), centre[1] - along * Math.sin(direction)];
    const half = Math.min(wide(text) / 2 / Math.abs(Math.cos(direction)), 9 / Math.abs(Math.sin(direction)));
    const before = Math.min(0.62 * length, length - 12 - half);
    return { lines: line('class="dimension" marker-end="url(#dimension-end)"', at(0), at(length)), labels: label("", at(before > half ? before : length + half + 2), text) };
  }

  // The distance of two places of one height, below the drawing.
  function distanceBelow(from, to, text) {
    const below = height - bottomMargin + 18;
    const lines = [from, to].map((at) => line('class="dimension"', at, [at[0], below + 5])).join("");
    const ends = 'class="dimension" marker-start="url(#dimension-end)" marker-end="url(#dimension-end)"';
    return { lines: lines + line(ends, [from[0], below], [to[0], below]), labels: label("", [(from[0] + to[0]) / 2, below + 14], text) };
  }

  // Those that hold in every position; those of a sphere do not lie in the plane of the drawing.
  function dimensions(mechanism, lengths, pixel, scale, text) {
    if (isSpherical(mechanism)) return [];
    const centre = pixel([0, 0, 0]);
    const list = [
      { lines: circle('class="way"', centre, (scale * lengths.wheel_diameter) / 2), labels: "" },
      radius(centre, (scale * lengths.wheel_diameter) / 2, 2, `R ${text(lengths.wheel_diameter / 2)}`),
    ];
    if (!mechanism.driver_axis || !lengths.crank_radius) return list;
    const axis = pixel(mechanism.driver_axis);
    list.push(radius(axis, scale * lengths.crank_radius, 1.1, `R ${text(lengths.crank_radius)}`));
    if (mechanism.locking_radius) list.push(radius(axis, scale * mechanism.locking_radius, -0.6, `R ${text(mechanism.locking_radius)}`));
    list.push(distanceBelow(centre, axis, text(lengths.centre_distance)));
    return list;
  }

  const markers =
    '<defs><marker id="arrow" viewBox="0 0 10 10" refX="8" refY="5" markerWidth="5" markerHeight="5" orient="auto"><path class="arrow" d="M0 0L10 5L0 10z"/></marker>' +
    '<marker id="dimension-end" viewBox="0 0 10 6" refX="10" refY="3" markerWidth="9" markerHeight="6" markerUnits="userSpaceOnUse" orient="auto-start-reverse"><path class="dimension-end" d="M0 0L10 3L0 6z"/></marker></defs>';

  // What moves is put in its place by mechanism.js. text: of a length in metres, with its unit.
  function svg(mechanism, lengths, name, text) {
    const { rows, offset } = mechanism.projection;
    const scale = Math.hypot(...rows[0]);
    const pixel = (place) => rows.map((row, i) => offset[i] + row[0] * place[0] + row[1] * place[1] + row[2] * place[2]);
    const way = mechanism.pin_path.map((place, i) => (i === 0 ? "M" : "L") + pixel(place).map(fixed).join(" ")).join("");
    const marks = dimensions(mechanism, lengths, pixel, scale, text);
    const axis = mechanism.driver_axis && pixel(mechanism.driver_axis);
    const pins = mechanism.steps[0].pins.map((place) => (axis ? line('class="link mechanism-crank"', axis, pixel(place)) : "") + circle('class="pin"', pixel(place), (scale * mechanism.pin_diameter) / 2));
    return [
      `<svg id="mechanism-drawing" viewBox="0 0 ${width} ${height}" role="img" aria-label="${name}">`,
      markers,
      `<path id="mechanism-wheel" class="wheel${isSpherical(mechanism) ? " sphere" : ""}" fill-rule="evenodd"/><path class="way" d="${way}"/>`,
      circle('class="axis"', pixel([0, 0, 0]), 3),
      marks.map((one) => one.lines).join(""),
      axis ? circle('class="axis"', axis, 3) : "",
      axis && mechanism.locking_radius ? circle('class="way"', axis, scale * mechanism.locking_radius) : "",
      pins.join(""),
      marks.map((one) => one.labels).join(""),
      label(' id="mechanism-pin-label"', [0, 0], `⌀ ${text(mechanism.pin_diameter)}`),
      line('id="mechanism-force" class="force" marker-end="url(#arrow)"', [0, 0], [0, 0]),
      circle('id="mechanism-contact" class="arrow"', [0, 0], 0),
      "</svg>",
    ].join("");
  }

  return { projection, svg };
};
