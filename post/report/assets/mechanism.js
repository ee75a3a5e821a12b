// Turns the drawing of a mechanism: what shows a step of it, beside what it shows at first.
window.genevaTurning = function (mechanism) {
  "use strict";
  const { rows, offset, arrow } = mechanism.projection;
  const drawing = document.getElementById("mechanism-drawing");
  const scale = Math.hypot(...rows[0]);
  const greatestForce = Math.max(...mechanism.steps.map((step) => Math.abs(step.pin_force)));

  const pixel = (place) => rows.map((row, i) => offset[i] + row[0] * place[0] + row[1] * place[1] + row[2] * place[2]);

  function turned([x, y, z], angle) {
    return [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle), z];
  }

  function pathData(places, angle) {
    return places.map((place, i) => (i === 0 ? "M" : "L") + pixel(turned(place, angle)).map((c) => c.toFixed(2)).join(" ")).join("");
  }

  function setLine(element, from, to) {
    [["x1", from[0]], ["y1", from[1]], ["x2", to[0]], ["y2", to[1]]].forEach(([name, value]) => element.setAttribute(name, value.toFixed(2)));
  }

  function drawForce(step) {
    const line = document.getElementById("mechanism-force");
    const isThere = step.engaged_pin !== null && Math.abs(step.pin_force) > 1e-3 * greatestForce;
    const dot = document.getElementById("mechanism-contact");
    for (const element of [line, dot]) element.style.visibility = isThere ? "visible" : "hidden";
    if (!isThere) return;
    line.setAttribute("marker-end", "url(#arrow)");
    const pin = step.pins[step.engaged_pin];
    const angle = Math.atan2(pin[1], pin[0]);
    const along = (length) => {
      const side = Math.sign(step.pin_force) * length;
      return pixel([pin[0] - side * Math.sin(angle), pin[1] + side * Math.cos(angle), pin[2]]);
    };
    const radius = mechanism.pin_diameter / 2;
    const [x, y] = along(radius);
    dot.setAttribute("cx", x.toFixed(2));
    dot.setAttribute("cy", y.toFixed(2));
    dot.setAttribute("r", 4);
    setLine(line, along(radius), along(radius + (arrow * Math.abs(step.pin_force)) / greatestForce / scale));
  }

  // The pin's diameter stands beside the pin where no other label is, and away from the force and the heads of arrows.
  const heads = [...drawing.querySelectorAll("line.dimension[marker-end]")].map(headOf);
  const labels = [...drawing.querySelectorAll(".label:not(#mechanism-pin-label)")].map(boxOf).concat(heads);
  function boxOf(label) {
    const { x, y, width, height } = label.getBBox();
    const { e, f } = label.transform.baseVal.consolidate().matrix;
    return { x: x + e, y: y + f, width, height };
  }
  function headOf({ x1, y1, x2, y2 }) {
    const [from, to] = [[x1, y1], [x2, y2]].map((at) => at.map((c) => c.baseVal.value));
    const back = 5 / Math.hypot(to[0] - from[0], to[1] - from[1]);
    return { x: to[0] + back * (from[0] - to[0]) - 8, y: to[1] + back * (from[1] - to[1]) - 8, width: 16, height: 16 };
  }
  function covered(box, other) {
    const wide = Math.min(box.x + box.width, other.x + other.width) - Math.max(box.x, other.x);
    const high = Math.min(box.y + box.height, other.y + other.height) - Math.max(box.y, other.y);
    return wide > 0 && high > 0 ? wide * high : 0;
  }
  const { width, height } = drawing.viewBox.baseVal;
  const outside = (box) => box.width * box.height - covered(box, { x: 0, y: 0, width, height });
  function labelPin(at) {
    const label = document.getElementById("mechanism-pin-label");
    const { width: wide, height: high } = label.getBBox();
    const radius = (scale * mechanism.pin_diameter) / 2 + 4;
    const places = [90, -90, 0, 180, 45, 135, -45, -135].map((degrees) => {
      const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
      return [at[0] + c * (radius + wide / 2), at[1] + s * (radius + high / 2)];
    });
    const force = document.getElementById("mechanism-force");
    const taken = force.style.visibility === "hidden" ? labels : [...labels, force.getBBox()];
    const cost = ([x, y]) => {
      const box = { x: x - wide / 2, y: y - high / 2, width: wide, height: high };
      return taken.reduce((sum, other) => sum + covered(box, other), 0) + 10 * outside(box);
    };
    const best = places.reduce((found, place) => (cost(place) < cost(found) ? place : found));
    label.setAttribute("transform", `translate(${best[0].toFixed(2)} ${best[1].toFixed(2)})`);
  }

  // A label steps aside while a pin or the force passes; it fades where there is no room.
  const sizes = [...drawing.querySelectorAll(".label:not(#mechanism-pin-label)")];
  const sizeBoxes = labels.slice(0, sizes.length);
  const beside = ({ x, y, width: wide, height: high }, [dx, dy]) => ({ x: x + dx, y: y + dy, width: wide, height: high });
  function passes(force, box) {
    if (force.style.visibility === "hidden") return false;
    const [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map((name) => Number(force.getAttribute(name)));
    const parts = 40; // of the arrow
    return Array.from({ length: parts + 1 }, (_, i) => [x1 + ((x2 - x1) * i) / parts, y1 + ((y2 - y1) * i) / parts]).some(
      ([x, y]) => x > box.x - 4 && x < box.x + box.width + 4 && y > box.y - 4 && y < box.y + box.height + 4);
  }
  function giveWay() {
    const force = document.getElementById("mechanism-force");
    const pins = [...drawing.querySelectorAll(".pin, #mechanism-pin-label")].map((one) => (one.id ? boxOf(one) : one.getBBox()));
    sizes.forEach((label, i) => {
      const { width: wide, height: high } = sizeBoxes[i];
      const steps = [1, 1.6, 2.4].flatMap((far) => [[0, -far * high], [0, far * high], [-far * wide, 0], [far * wide, 0]]);
      const others = labels.filter((_, k) => k !== i).concat(pins);
      const isFree = (step) => {
        const box = beside(sizeBoxes[i], step);
        return !passes(force, box) && outside(box) === 0 && others.every((other) => covered(box, other) === 0);
      };
      const isLeft = !passes(force, sizeBoxes[i]) && pins.every((pin) => covered(sizeBoxes[i], pin) === 0);
      const step = isLeft ? [0, 0] : steps.find(isFree);
      label.style.opacity = step ? 1 : 0.15;
      const [dx, dy] = step || [0, 0];
      label.style.translate = `${dx.toFixed(1)}px ${dy.toFixed(1)}px`;
    });
  }

  function show(step) {
    document.getElementById("mechanism-wheel").setAttribute("d", mechanism.wheel.map((loop) => pathData(loop, step.wheel_angle) + "Z").join(""));
    const linkage = document.getElementById("mechanism-linkage");
    if (linkage) linkage.setAttribute("d", pathData(step.linkage, 0));
    drawing.querySelectorAll(".pin").forEach((circle, i) => {
      const at = pixel(step.pins[i]);
      circle.setAttribute("cx", at[0].toFixed(2));
      circle.setAttribute("cy", at[1].toFixed(2));
    });
    if (mechanism.driver_axis)
      drawing.querySelectorAll(".mechanism-crank").forEach((line, i) => setLine(line, pixel(mechanism.driver_axis), pixel(step.pins[i])));
    drawForce(step);
    labelPin(pixel(step.pins[0]));
    giveWay();
    document.querySelectorAll("#mechanism-readings output").forEach((output) => {
      const value = step[output.dataset.key];
      output.textContent = value === null ? "not bounded" : genevaNumber(value * Number(output.dataset.factor), 5);
    });
    tellPosition(step);
    drawing.dataset.wheelAngle = step.wheel_angle;
  }

  // Caption and charts follow.
  function tellPosition(step) {
    const angle = step.driver_angle * Number(document.querySelector('#mechanism-readings [data-key="driver_angle"]').dataset.factor);
    document.getElementById("mechanism-angle").textContent = genevaNumber(angle, 5);
    document.querySelector('#mechanism-controls [name="step"]').setAttribute("aria-valuetext", `driver angle ${genevaNumber(angle, 4)}`);
    const isAnalysed = mechanism.analysed && Math.abs(mechanism.analysed.driver_angle - step.driver_angle) < 1e-9;
    document.getElementById("mechanism-analysed").textContent = isAnalysed ? ", which is analysed" : "";
    if (window.genevaCursor) window.genevaCursor(angle);
  }

  return {
    show,
    begin(step) {
      labelPin(pixel(step.pins[0]));
      giveWay();
      tellPosition(step);
    },
  };
};
// The slider and the button that move it.
(function () {
  "use strict";
  const slider = document.querySelector('#mechanism-controls [name="step"]');
  const button = document.querySelector('#mechanism-controls [name="run"]');
  let steps = [];
  let turning = null;
  // Of two steps of the motion the one that lies a share of the way from the first to the second.
  function between(from, to, share, key) {
    if (from === null || to === null || key === "engaged_pin") return share < 0.5 ? from : to;
    if (Array.isArray(from)) return from.map((value, i) => between(value, to[i], share));
    if (typeof from === "number") return from + share * (to - from);
    return Object.fromEntries(Object.keys(from).map((name) => [name, between(from[name], to[name], share, name)]));
  }
  const showStep = () => turning.show(steps[Number(slider.value)]);
  function goTo() {
    showStep();
    if (window.genevaCycle) window.genevaCycle.follow(steps[Number(slider.value)].driver_angle);
  }
  window.genevaMechanism = {
    // Another mechanism, of which there is a drawing already.
    takeUp(mechanism) {
      steps = mechanism.steps;
      turning = window.genevaTurning(mechanism);
    },
    begin: (step) => turning.begin(step),
    goTo(driverAngle) {
      const found = steps.findIndex((step) => step.driver_angle >= driverAngle);
      const after = found < 0 ? steps.length - 1 : Math.max(1, found);
      const [from, to] = [steps[after - 1], steps[after]];
      const share = (driverAngle - from.driver_angle) / (to.driver_angle - from.driver_angle);
      slider.value = share < 0.5 ? after - 1 : after;
      turning.show(between(from, to, share));
    },
  };
  let running = 0;
  function advance() {
    slider.value = (Number(slider.value) + 1) % steps.length;
    goTo();
    running = requestAnimationFrame(advance);
  }
  slider.addEventListener("input", goTo);
  button.addEventListener("click", () => {
    if (running) cancelAnimationFrame(running);
    running = running ? 0 : requestAnimationFrame(advance);
    button.textContent = running ? "Stop" : "Play";
    button.setAttribute("aria-pressed", String(running !== 0));
  });
  const data = document.getElementById("mechanism-data");
  if (!data) return;
  const mechanism = JSON.parse(data.textContent);
  window.genevaMechanism.takeUp(mechanism);
  window.genevaMechanism.begin(mechanism.analysed || steps[Number(slider.value)]);
})();
