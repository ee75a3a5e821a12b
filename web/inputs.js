// The inputs of the page: what they are, what was typed, and the same as SI values, as a link and as a case file.
window.genevaInputs = function (tables) {
  "use strict";
  const lengths = (mm, inch) => ({ "mm-N": mm, "in-lbf": inch });
  const drawn = ["external", "internal"];
  const schematic = ["spherical", "long dwell"];
  const all = [...drawn, ...schematic];

  // Sliders: least, greatest, step in each system of units. What is typed may lie beyond.
  const numbers = [
    { key: "stations", label: "Stations", parameter: "Stations", whole: true, slider: [3, 16, 1], hint: "slots of the wheel, 3 to 24" },
    { key: "centre_distance", label: "Centre distance", parameter: "Centre distance", dimension: "length", size: true, kinds: drawn, slider: lengths([20, 400, 1], [1, 16, 0.05]), hint: "between the axes of driver and wheel, greater than 0" },
    { key: "sphere_radius", label: "Sphere radius", parameter: "Sphere radius", dimension: "length", size: true, kinds: ["spherical"], slider: lengths([20, 300, 1], [1, 12, 0.05]), hint: "from where the shafts meet to the pin, greater than 0" },
    { key: "shaft_angle", label: "Shaft angle", parameter: "Shaft angle", dimension: "angle", kinds: ["spherical"], slider: [10, 170, 1], hint: "between the shafts, between 0 and 180 deg" },
    { key: "crank_radius", label: "Crank radius", parameter: "Crank radius", dimension: "length", size: true, kinds: ["long dwell"], slider: lengths([10, 150, 1], [0.5, 6, 0.05]), hint: "pitch radius of the two sprockets, greater than 0" },
    { key: "sprocket_spacing", label: "Sprocket spacing", parameter: "Sprocket spacing", dimension: "length", kinds: ["long dwell"], slider: lengths([0, 400, 1], [0, 16, 0.05]), hint: "between the axes of the sprockets, 0 or more" },
    { key: "pin_diameter", label: "Pin diameter", parameter: "Pin diameter", dimension: "length", rule: "Johnson's proportion", length: "pin_diameter", slider: lengths([2, 60, 0.5], [0.1, 2.5, 0.01]), hint: "greater than 0, not wider than the slot" },
    { key: "thickness", label: "Wheel thickness", parameter: "Wheel thickness", dimension: "length", rule: "Johnson's proportion", length: "wheel_thickness", slider: lengths([2, 60, 0.5], [0.1, 2.5, 0.01]), hint: "on which the pin bears, greater than 0" },
    { key: "driver_speed", label: "Driver speed", parameter: "Driver speed", dimension: "angular speed", slider: [5, 1200, 5], hint: "constant, greater than 0" },
    { key: "load_inertia", label: "Load inertia", parameter: "Load inertia", dimension: "moment of inertia", slider: { "mm-N": [0, 20000, 10], "in-lbf": [0, 0.2, 0.0001] }, hint: "of what the wheel turns, about the wheel's axis, 0 or more" },
    { key: "friction_moment", label: "Friction moment", parameter: "Friction moment", dimension: "moment", slider: { "mm-N": [0, 5000, 10], "in-lbf": [0, 50, 0.1] }, hint: "on the wheel's axis, 0 or more" },
    { key: "wheel_inertia", label: "Wheel inertia", parameter: "Wheel inertia", dimension: "moment of inertia", kinds: schematic, slider: { "mm-N": [10, 20000, 10], "in-lbf": [0.0001, 0.2, 0.0001] }, hint: "this wheel is not drawn: greater than 0" },
    { key: "pins", label: "Pins", parameter: "Pins", whole: true, slider: [1, 4, 1], hint: "equally spaced on the driver; no two may be engaged together" },
    { key: "slot_clearance", label: "Slot clearance", parameter: "Slot clearance", dimension: "length", kinds: drawn, slider: lengths([0, 2, 0.01], [0, 0.08, 0.0005]), hint: "slot width less the pin's diameter, 0 or more" },
    { key: "slot_friction", label: "Slot friction", parameter: "Slot friction", slider: [0, 0.5, 0.01], hint: "coefficient of pin and wall, 0 or more" },
    { key: "pin_youngs_modulus", label: "Young's modulus of the pin", parameter: "Young's modulus", dimension: "stress", material: "pin", slider: { "mm-N": [1000, 250000, 1000], "in-lbf": [2e5, 3.6e7, 1e5] }, hint: "greater than 0" },
    { key: "pin_poissons_ratio", label: "Poisson's ratio of the pin", parameter: "Poisson's ratio", material: "pin", slider: [0, 0.49, 0.01], hint: "between -1 and 0.5" },
    { key: "wheel_youngs_modulus", label: "Young's modulus of the wheel", parameter: "Young's modulus", dimension: "stress", material: "wheel", slider: { "mm-N": [1000, 250000, 1000], "in-lbf": [2e5, 3.6e7, 1e5] }, hint: "greater than 0" },
    { key: "wheel_poissons_ratio", label: "Poisson's ratio of the wheel", parameter: "Poisson's ratio", material: "wheel", slider: [0, 0.49, 0.01], hint: "between -1 and 0.5" },
    { key: "wheel_density", label: "Density of the wheel", parameter: "Density", dimension: "density", material: "wheel", slider: { "mm-N": [1000, 9000, 10], "in-lbf": [0.03, 0.33, 0.001] }, hint: "greater than 0" },
  ];
  const choices = [
    { key: "type", label: "Type", parameter: "Type", options: all },
    { key: "sprocket_line", label: "Sprocket line", parameter: "Sprocket line", kinds: ["long dwell"], options: ["along line of centres", "across line of centres"] },
    { key: "pin_material", label: "Pin material", parameter: "Material", options: ["own values", ...tables.materials.map((one) => one.name)] },
    { key: "wheel_material", label: "Wheel material", parameter: "Material", options: ["own values", ...tables.materials.map((one) => one.name)] },
  ];
  const systems = ["mm-N", "in-lbf"];

  const unitOf = (input, system) => (input.dimension ? tables.units[system][input.dimension].unit : "");
  const unitsOf = (input) => [...new Set(systems.map((system) => unitOf(input, system)))];
  function scaleOf(input, unit) {
    if (!input.dimension) return 1;
    return systems.map((system) => tables.units[system][input.dimension]).find((one) => one.unit === unit).scale;
  }
  const plain = (text) => ({ text, unit: "" });
  const metric = (text, dimension) => ({ text, unit: tables.units["mm-N"][dimension].unit });

  // A value is the text that was typed with the unit that it was typed in; none: it follows from a rule.
  function defaults() {
    return {
      system: "mm-N",
      chosen: { type: "external", sprocket_line: "along line of centres", pin_material: "100Cr6 hardened", wheel_material: "42CrMo4 quenched and tempered" },
      values: {
        stations: plain("6"), centre_distance: metric("70", "length"), sphere_radius: metric("80", "length"), shaft_angle: metric("90", "angle"),
        crank_radius: metric("40", "length"), sprocket_spacing: metric("120", "length"), pin_diameter: null, thickness: null,
        driver_speed: metric("300", "angular speed"), load_inertia: metric("2000", "moment of inertia"), friction_moment: metric("500", "moment"),
        wheel_inertia: metric("1000", "moment of inertia"), pins: plain("1"), slot_clearance: metric("0", "length"), slot_friction: plain("0"),
        pin_youngs_modulus: metric("210000", "stress"), pin_poissons_ratio: plain("0.3"),
        wheel_youngs_modulus: metric("210000", "stress"), wheel_poissons_ratio: plain("0.3"), wheel_density: metric("7850", "density"),
      },
    };
  }

  const isOwn = (state, body) => state.chosen[`${body}_material`] === "own values";
  function isUsed(state, input) {
    return (!input.kinds || input.kinds.includes(state.chosen.type)) && (!input.material || isOwn(state, input.material));
  }

  const number = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
  // What is wrong with a typed number; nothing if it is one.
  function complaint(input, value) {
    const text = value.text.trim();
    if (text === "") return `${input.label}: a number is wanted`;
    if (/^[+-]?\d+,\d+$/.test(text)) return `${input.label} is '${text}': a decimal number is written with a point`;
    if (!number.test(text)) return `${input.label} is '${text}': this is no number; type one such as 12.5 or 1e-3, without its unit`;
    const size = Math.abs(Number(text));
    if (!Number.isFinite(size) || (size === 0 && /[1-9]/.test(text.split(/[eE]/)[0]))) return `${input.label} is '${text}': the number is too large or too small`;
    return "";
  }
  const complaints = (state) =>
    numbers.filter((input) => isUsed(state, input) && state.values[input.key]).map((input) => ({ key: input.key, text: complaint(input, state.values[input.key]) })).filter((one) => one.text);

  const si = (input, value) => Number(value.text) * scaleOf(input, value.unit);

  function material(state, body) {
    if (!isOwn(state, body)) return tables.materials.find((one) => one.name === state.chosen[`${body}_material`]);
    const own = {};
    for (const input of numbers.filter((one) => one.material === body)) own[input.key.replace(`${body}_`, "")] = si(input, state.values[input.key]);
    return own;
  }

  // What the program behind the page takes; SI units.
  function siValues(state) {
    const value = (key) => {
      const input = numbers.find((one) => one.key === key);
      return isUsed(state, input) && state.values[key] ? si(input, state.values[key]) : null;
    };
    const size = numbers.find((one) => one.size && isUsed(state, one));
    return {
      kind: state.chosen.type,
      stations: value("stations"),
      size: value(size.key),
      shaft_angle: value("shaft_angle") ?? 0,
      sprocket_spacing: value("sprocket_spacing") ?? 0,
      sprocket_line: state.chosen.sprocket_line,
      pins: value("pins"),
      driver_speed: value("driver_speed"),
      pin_diameter: value("pin_diameter"),
      thickness: value("thickness"),
      slot_clearance: value("slot_clearance"),
      wheel_inertia: value("wheel_inertia"),
      load_inertia: value("load_inertia"),
      friction_moment: value("friction_moment"),
      slot_friction: value("slot_friction"),
      pin: material(state, "pin"),
      wheel: material(state, "wheel"),
    };
  }

  // As a box shows it: what was typed, or the same in other units to six digits.
  function shown(state, input) {
    const value = state.values[input.key];
    const unit = unitOf(input, state.system);
    if (value.unit === unit || complaint(input, value)) return value.text;
    return String(Number((si(input, value) * tables.units[state.system][input.dimension].factor).toPrecision(6)));
  }

  const withUnit = (value) => (value.unit ? `${value.text.trim()} ${value.unit}` : value.text.trim());

  function fragment(state) {
    const parts = [["units", state.system]];
    for (const input of choices) if (!input.kinds || input.kinds.includes(state.chosen.type)) parts.push([input.key, state.chosen[input.key]]);
    for (const input of numbers) if (isUsed(state, input) && state.values[input.key]) parts.push([input.key, withUnit(state.values[input.key])]);
    return "#" + parts.map(([key, value]) => `${key}=${encodeURIComponent(value).replaceAll("%20", "+")}`).join("&");
  }

  function readValue(input, text) {
    const words = text.trim().split(/\s+/);
    const unit = words[1] || "";
    if (words.length < 3 && unitsOf(input).includes(unit)) return { value: { text: words[0], unit } };
    const wanted = unitsOf(input).filter((one) => one !== "").join(" or ");
    return { wrong: `the link gives ${input.label} as '${text}': ${wanted ? `a number and ${wanted} are wanted` : "a plain number is wanted"}` };
  }

  // The state that a link carries, and what it says that cannot be taken.
  function read(link) {
    const state = defaults();
    const wrong = [];
    const given = new URLSearchParams(link.replace(/^#/, ""));
    for (const input of numbers) if (input.rule) state.values[input.key] = null;
    for (const [key, text] of given) {
      const choice = choices.find((one) => one.key === key);
      const input = numbers.find((one) => one.key === key);
      if (key === "units" && systems.includes(text)) state.system = text;
      else if (choice && choice.options.includes(text)) state.chosen[key] = text;
      else if (input) {
        const { value, wrong: sentence } = readValue(input, text);
        if (value) state.values[key] = value;
        else wrong.push(sentence);
      } else if (choice || key === "units") wrong.push(`the link gives ${key} as '${text}': one of ${(choice ? choice.options : systems).join(", ")} is wanted`);
      else wrong.push(`the link gives '${key}': this page has no such input`);
    }
    return { state, wrong };
  }

  function lines(indent, pairs) {
    const wide = Math.max(...pairs.map(([name]) => name.length));
    return pairs.map(([name, value]) => `${indent}set ${name.padEnd(wide)} = ${value}\n`).join("");
  }
  function materialText(state, body) {
    const pairs = isOwn(state, body)
      ? numbers.filter((input) => input.material === body).map((input) => [input.parameter, withUnit(state.values[input.key])])
      : [["Material", state.chosen[`${body}_material`]]];
    return `\n  subsection ${body === "pin" ? "Pin" : "Wheel"} material\n${lines("    ", pairs)}  end\n`;
  }
  // A case file for the program of exactly these inputs.
  function caseText(state) {
    const type = state.chosen.type;
    const pairs = [["Type", type]];
    for (const input of numbers) {
      if (input.material || !isUsed(state, input) || !state.values[input.key]) continue;
      pairs.push([input.parameter, withUnit(state.values[input.key])]);
      if (input.key === "sprocket_spacing") pairs.push(["Sprocket line", state.chosen.sprocket_line]);
      if (input.key === "driver_speed") pairs.push(["Driver angle", "at maximum pin force"]);
    }
    if (schematic.includes(type)) pairs.push(["Contact model", "local"]);
    const general = [["Title", `${type} Geneva mechanism, ${state.values.stations.text.trim()} stations`], ["Model", "mechanism"], ["Output units", state.system]];
    return `${lines("", general)}\nsubsection Mechanism\n${lines("  ", pairs)}${materialText(state, "pin")}${materialText(state, "wheel")}end\n`;
  }

  return { numbers, choices, systems, defaults, isUsed, unitOf, complaints, siValues, si, shown, fragment, read, caseText };
};
