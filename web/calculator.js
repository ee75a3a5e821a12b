// What the page does: takes the inputs, lets the program compute, shows figures, drawing and curves.
(async function () {
  "use strict";
  const tables = JSON.parse(document.getElementById("tables").textContent);
  const inputs = window.genevaInputs(tables);
  const place = (id) => document.getElementById(id);
  const program = await window.genevaModule();

  function calculate(values) {
    const pointer = program.ccall("geneva_calculate", "number", ["string"], [JSON.stringify(values)]);
    const answer = JSON.parse(program.UTF8ToString(pointer));
    program._free(pointer);
    return answer;
  }

  let state = inputs.defaults();
  let answer = null; // the last one that had figures

  // Units and numbers

  const systems = tables.units;
  const shownUnit = (unit) => unit.replace(/\^2/g, "²").replace(/\^3/g, "³").replace(/\./g, "·");
  const factorOf = (dimension) => (dimension ? systems[state.system][dimension].factor : 1);
  const unitOf = (dimension) => (dimension ? shownUnit(systems[state.system][dimension].unit) : "");
  const inUnits = (value, dimension) => (value === null || value === undefined ? null : value * factorOf(dimension));
  const written = (value, digits = 5) => (value === null ? "–" : window.genevaNumber(value, digits));
  const shown = (value, dimension) => written(inUnits(value, dimension));
  const withUnit = (value, dimension) => `${shown(value, dimension)} ${unitOf(dimension)}`.trim();
  const labelled = (name, dimension) => (dimension ? `${name} [${unitOf(dimension)}]` : name);
  const escaped = (text) => text.replace(/[&<>"]/g, (letter) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[letter]);

  // Inputs

  function groupOf(key) {
    if (/material|modulus|ratio|density/.test(key)) return "material";
    if (["pins", "slot_clearance", "slot_friction"].includes(key)) return "more";
    if (["driver_speed", "load_inertia", "friction_moment", "wheel_inertia"].includes(key)) return "load";
    return "mechanism";
  }
  function numberField(input) {
    const rule = input.rule ? `<label class="rule"><input type="checkbox" data-rule="${input.key}"> by ${input.rule}</label>` : "";
    return `<div class="field" data-field="${input.key}"><label for="input-${input.key}">${input.label} <span class="unit"></span></label>
<div class="entry"><input type="range" data-slider="${input.key}" aria-label="${input.label}, slider"><input type="text" inputmode="decimal" autocomplete="off" spellcheck="false" id="input-${input.key}" data-number="${input.key}" aria-describedby="hint-${input.key}"></div>${rule}
<p class="hint" id="hint-${input.key}">${input.hint}</p></div>`;
  }
  const choiceField = (input) => `<div class="field" data-field="${input.key}"><label for="input-${input.key}">${input.label}</label>
<select id="input-${input.key}" data-choice="${input.key}">${input.options.map((option) => `<option>${escaped(option)}</option>`).join("")}</select></div>`;

  const order = ["type", "stations", "centre_distance", "sphere_radius", "shaft_angle", "crank_radius", "sprocket_spacing", "sprocket_line", "pin_material", "pin_youngs_modulus", "pin_poissons_ratio", "wheel_material"];
  function buildFields() {
    const all = [...inputs.choices.map((input) => ({ input, html: choiceField(input) })), ...inputs.numbers.map((input) => ({ input, html: numberField(input) }))];
    const rank = ({ input }) => (order.includes(input.key) ? order.indexOf(input.key) : order.length);
    for (const { input, html } of all.sort((a, b) => rank(a) - rank(b))) place(`group-${groupOf(input.key)}`).insertAdjacentHTML("beforeend", html);
  }

  const field = (key, kind) => document.querySelector(`[data-${kind}="${key}"]`);
  const sliderOf = (input) => (Array.isArray(input.slider) ? input.slider : input.slider[state.system]);

  // The boxes and sliders as the state is; the one that is being typed into keeps its text.
  function showInputs() {
    for (const input of inputs.choices) {
      field(input.key, "choice").value = state.chosen[input.key];
      field(input.key, "field").hidden = Boolean(input.kinds && !input.kinds.includes(state.chosen.type));
    }
    for (const input of inputs.numbers) showNumber(input);
    document.querySelector(`[name="system"][value="${state.system}"]`).checked = true;
  }
  function showNumber(input) {
    field(input.key, "field").hidden = !inputs.isUsed(state, input);
    const unit = inputs.unitOf(input, state.system);
    field(input.key, "field").querySelector(".unit").textContent = unit ? `[${shownUnit(unit)}]` : "";
    const byRule = state.values[input.key] === null;
    const box = field(input.key, "number");
    const slider = field(input.key, "slider");
    for (const element of [box, slider]) element.disabled = byRule;
    if (input.rule) field(input.key, "rule").checked = byRule;
    const text = byRule ? ruleText(input) : inputs.shown(state, input);
    if (box !== document.activeElement) box.value = text;
    const [least, greatest, step] = sliderOf(input);
    Object.assign(slider, { min: least, max: greatest, step });
    slider.value = Number(text) || 0;
  }
  // What a rule gives, as far as is known.
  const ruleText = (input) => (answer ? String(Number(inUnits(answer.lengths[input.length], "length").toPrecision(5))) : "");

  function take(input, text) {
    state.values[input.key] = { text, unit: inputs.unitOf(input, state.system) };
    schedule();
  }
  function listen() {
    for (const input of inputs.numbers) {
      field(input.key, "number").addEventListener("input", (event) => take(input, event.target.value));
      field(input.key, "number").addEventListener("blur", () => showNumber(input));
      field(input.key, "slider").addEventListener("input", (event) => {
        take(input, event.target.value);
        field(input.key, "number").value = event.target.value;
      });
      if (input.rule) field(input.key, "rule").addEventListener("change", (event) => {
        if (event.target.checked) state.values[input.key] = null;
        else take(input, ruleText(input));
        schedule();
      });
    }
    for (const input of inputs.choices)
      field(input.key, "choice").addEventListener("change", (event) => {
        state.chosen[input.key] = event.target.value;
        schedule();
      });
    for (const button of document.querySelectorAll('[name="system"]'))
      button.addEventListener("change", () => {
        state.system = button.value;
        schedule();
      });
    window.addEventListener("hashchange", (event) => readLink(new URL(event.newURL).hash));
    window.addEventListener("resize", () => answer && showDrawing(positionShown()));
    place("copy-case").addEventListener("click", () => copy(place("case-text").value, "copy-case"));
    place("copy-link").addEventListener("click", () => copy(location.href.split("#")[0] + inputs.fragment(state), "copy-link"));
    place("reset").addEventListener("click", () => {
      state = inputs.defaults();
      schedule();
    });
  }
  async function copy(text, id) {
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      const area = document.body.appendChild(Object.assign(document.createElement("textarea"), { value: text }));
      area.select();
      document.execCommand("copy");
      area.remove();
    }
    place(`${id}-told`).textContent = "copied";
    setTimeout(() => (place(`${id}-told`).textContent = ""), 2000);
  }

  // Figures

  function row(name, cells) {
    return `<tr><th scope="row">${name}</th>${cells.map(([label, text]) => `<td data-label="${escaped(label)}">${text}</td>`).join("")}</tr>`;
  }
  const figures = () => {
    const { kinematics, hertz, reference_speed: speed } = answer;
    const k = kinematics;
    const dwells = k.dwell_time;
    const h = hertz || {};
    return [
      ["Motion"],
      ["index time", "t<sub>m</sub>", k.motion_time, "time"],
      ["dwell", "t<sub>s</sub>", dwells.length ? dwells[0] : null, "time"],
      ["index time over dwell", "k<sub>t</sub>", k.time_ratio, ""],
      ["driver angle in engagement", "Δθ", k.engagement_angle, "angle"],
      ["maximum wheel speed", "φ̇", k.peak_speed_ratio * speed, "angular speed", k.peak_speed_ratio_angle],
      ["maximum wheel acceleration", "φ̈", k.peak_acceleration_ratio * speed ** 2, "angular acceleration", k.peak_acceleration_angle],
      ["acceleration jump at entry", "φ̈(θ<sub>0</sub>)", k.entry_acceleration_ratio === null ? null : k.entry_acceleration_ratio * speed ** 2, "angular acceleration"],
      ["maximum wheel jerk between entry and exit", "|φ⃛|", k.peak_jerk_ratio * speed ** 3, "jerk", k.peak_jerk_angle],
      ["Force and contact"],
      ["maximum pin force, driving wall", "F", k.peak_force, "force", k.peak_force_angle],
      ["maximum pin force, braking wall", "F<sub>b</sub>", k.peak_braking_force, "force", k.peak_braking_force_angle],
      ["maximum Hertz pressure", "p<sub>0</sub>", k.peak_hertz_pressure, "stress", k.peak_hertz_pressure_angle],
      ["half-width of the contact there", "b", h.half_width, "length", h.driver_angle],
      ["maximum shear below it", "τ", h.max_shear, "stress", h.driver_angle],
      ["its depth", "z", h.max_shear_depth, "length", h.driver_angle],
      ["maximum sliding speed of the pin", "v<sub>s</sub>", k.peak_slip_speed, "speed", k.peak_slip_speed_angle],
      ["maximum pressure × sliding speed", "p<sub>0</sub> v<sub>s</sub>", k.peak_pressure_times_slip, "pressure times speed", k.peak_pressure_times_slip_angle],
      ["Wheel"],
      ["wheel diameter", "D", answer.lengths.wheel_diameter, "length"],
      ["crank radius", "r", answer.lengths.crank_radius, "length"],
      ["slot depth", "", answer.lengths.slot_depth, "length"],
      ["moment of inertia of the wheel", "J<sub>G</sub>", answer.wheel_inertia, "moment of inertia"],
    ];
  };
  // The jerk has the same unit in both systems.
  const figureValue = (value, dimension) => (dimension === "jerk" ? written(value ?? null) : shown(value, dimension));
  const figureName = (name, dimension) => (dimension === "jerk" ? `${name} [rad/s³]` : labelled(name, dimension));
  function showFigures() {
    place("figure-rows").innerHTML = figures()
      .filter((one) => one.length === 1 || one[2] !== undefined)
      .map(([name, symbol, value, dimension, angle]) =>
        value === undefined
          ? `<tr class="group"><th scope="rowgroup" colspan="4">${name}</th></tr>`
          : row(figureName(name, dimension), [["symbol", symbol], ["value", figureValue(value, dimension)], ["at a driver angle of", angle === undefined || angle === null ? "" : withUnit(angle, "angle")]]),
      )
      .join("");
    const { kinematics: k, hertz } = answer;
    place("answer-force").textContent = withUnit(Math.max(k.peak_force, k.peak_braking_force), "force");
    place("answer-pressure").textContent = withUnit(k.peak_hertz_pressure, "stress");
    place("answer-width").textContent = hertz ? withUnit(hertz.half_width, "length") : "–";
    place("answer-time").textContent = `${withUnit(k.motion_time, "time")} / ${k.dwell_time.length ? withUnit(k.dwell_time[0], "time") : "–"}`;
    place("unbounded").innerHTML = k.unbounded
      .map((one) => `<p class="warning"><strong>Not bounded:</strong> the ${escaped(one.quantity)} at ${withUnit(one.driver_angle, "angle")}: ${escaped(one.cause)}</p>`)
      .join("");
  }

  function showDesign() {
    const { design } = answer;
    place("design-refused").textContent = design.refused || "";
    place("design-refused").hidden = !design.refused;
    place("design-figures").hidden = Boolean(design.refused);
    if (design.refused) return;
    const wheels = [["best, Johnson's proportions", design.johnson], ["best as drawn", design.drawn], ["this wheel", design.own]];
    const lines = [
      ["diameter", "diameter", "length"],
      ["pin diameter", "pin_diameter", "length"],
      ["thickness", "thickness", "length"],
      ["locking radius", "locking_radius", "length"],
      ["moment of inertia", "inertia", "moment of inertia"],
      ["pin force", "force", "force"],
      ["peak contact pressure", "peak_pressure", "stress"],
    ];
    place("design-rows").innerHTML = lines
      .map(([name, key, dimension]) => row(labelled(name, dimension), wheels.map(([whose, wheel]) => [whose, wheel ? shown(wheel[key], dimension) : "–"])))
      .join("");
    place("design-answer").textContent = `⌀ ${withUnit((design.johnson || design.drawn).diameter, "length")}, ${withUnit((design.johnson || design.drawn).peak_pressure, "stress")}`;
  }

  // Drawing and curves

  // That of the greatest force, until the user has moved it.
  let isMoved = false;
  function positionShown() {
    const step = Number(document.querySelector('#mechanism-controls [name="step"]').value);
    return isMoved && answer ? answer.drawing.steps[step].driver_angle : null;
  }
  function showDrawing(position) {
    const mechanism = answer.drawing;
    const drawing = window.genevaDrawing(place("drawing").clientWidth);
    mechanism.projection = drawing.projection(mechanism);
    place("drawing").innerHTML = drawing.svg(mechanism, answer.lengths, escaped(answer.mechanism), (length) => withUnit(length, "length"));
    for (const output of document.querySelectorAll("#mechanism-readings output")) {
      const dimension = output.dataset.dimension;
      output.dataset.factor = factorOf(dimension);
      output.closest("tr").querySelector("th").textContent = labelled(output.dataset.name, dimension);
    }
    place("mechanism-name").textContent = answer.mechanism;
    place("mechanism-angle-unit").textContent = unitOf("angle");
    const slider = document.querySelector('#mechanism-controls [name="step"]');
    const angle = position ?? answer.kinematics.peak_force_angle ?? 0;
    slider.max = mechanism.steps.length - 1;
    window.genevaMechanism.takeUp(mechanism);
    window.genevaMechanism.goTo(angle);
  }
  const curves = [
    ["pin_force", "pin force", "force"],
    ["hertz_pressure", "Hertz pressure", "stress"],
    ["wheel_angle", "wheel angle", "angle"],
    ["wheel_speed", "wheel speed", "angular speed"],
    ["wheel_acceleration", "wheel acceleration", "angular acceleration"],
    ["slip_speed", "sliding speed of the pin on its wall", "speed"],
  ];
  function cycleChart([key, name, dimension]) {
    const points = answer.drawing.steps.map((step) => [inUnits(step.driver_angle, "angle"), inUnits(step[key], dimension)]);
    return {
      id: `chart-${key}`,
      over_cycle: true,
      x: { label: labelled("driver angle", "angle"), logarithmic: false, step: (Math.PI / 4) * factorOf("angle") },
      y: { label: labelled(name, dimension), logarithmic: false, step: 0 },
      series: [{ name, style: "line", points }],
    };
  }
  function designChart() {
    const { curve, johnson, drawn, own } = answer.design;
    const line = (index) => curve.map((point) => [inUnits(point[0], "length"), inUnits(point[index], "stress")]);
    const mark = (name, wheel) => ({ name, style: "markers", points: [[inUnits(wheel.diameter, "length"), inUnits(wheel.peak_pressure, "stress")]] });
    const series = [];
    if (johnson) series.push({ name: "Johnson's proportions", style: "line", points: line(1) });
    series.push({ name: "as drawn", style: "dashed", points: line(2) });
    if (johnson) series.push(mark("best, Johnson", johnson));
    series.push(mark("best as drawn", drawn), mark("this wheel", own));
    return {
      id: "chart-design",
      over_cycle: false,
      x: { label: labelled("wheel diameter", "length"), logarithmic: false, step: 0 },
      y: { label: labelled("peak contact pressure", "stress"), logarithmic: false, step: 0 },
      series,
    };
  }

  // The round trip of an input

  // Why there are no figures; what a link said that could not be taken does not make figures stale.
  function tell(refused, byLink) {
    const sentences = [...byLink, ...refused];
    place("refused").innerHTML = sentences.map((sentence) => `<p>${escaped(sentence)}</p>`).join("");
    place("refused").hidden = sentences.length === 0;
    place("workplace").classList.toggle("stale", refused.length > 0);
    place("stale-told").hidden = refused.length === 0 || !answer;
  }
  // What the program says to the inputs, or why they are no inputs.
  function answered() {
    const wrong = inputs.complaints(state);
    for (const input of inputs.numbers) field(input.key, "number").setAttribute("aria-invalid", String(wrong.some((one) => one.key === input.key)));
    if (wrong.length) return { refused: wrong.map((one) => one.text) };
    try {
      const found = calculate(inputs.siValues(state));
      return found.refused ? { refused: [found.refused] } : found;
    } catch (error) {
      return { refused: [`The calculation failed by a fault of its own (${error}); the link of this page shows it again.`] };
    }
  }
  let toldByLink = [];
  function update() {
    const found = answered();
    const position = positionShown();
    if (!found.refused) answer = found;
    tell(found.refused || [], toldByLink);
    toldByLink = [];
    showInputs();
    place("case-text").value = inputs.complaints(state).length ? "" : inputs.caseText(state);
    if (answer) showAnswer(position);
    keepLink();
    document.body.dataset.ready = String(Number(document.body.dataset.ready || 0) + 1);
  }
  function showAnswer(position) {
    showFigures();
    showDesign();
    showDrawing(position);
    const charts = curves.map(cycleChart);
    if (!answer.design.refused) charts.push(designChart());
    window.genevaDrawCharts(charts);
  }

  let scheduled = 0;
  function schedule() {
    if (!scheduled)
      scheduled = requestAnimationFrame(() => {
        scheduled = 0;
        update();
      });
  }
  let waiting = 0;
  function keepLink() {
    clearTimeout(waiting);
    waiting = setTimeout(() => history.replaceState(null, "", inputs.fragment(state)), 200);
  }
  function readLink(link) {
    const { state: read, wrong } = inputs.read(link);
    state = read;
    toldByLink = wrong;
    update();
  }

  window.genevaCalculator = { calculate, values: () => inputs.siValues(state), answer: () => answer, link: () => inputs.fragment(state) };
  buildFields();
  listen();
  for (const event of ["input", "click"]) place("mechanism-controls").addEventListener(event, () => (isMoved = true));
  readLink(location.hash);
})();
