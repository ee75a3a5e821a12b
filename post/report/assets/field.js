// The field view: triangles of view.json, coloured by a stress, deformed, cut and turned with three.js.
(function () {
  "use strict";
  const box = document.getElementById("field-view");
  const view = JSON.parse(document.getElementById("view").textContent);
  const FIELDS = [
    ["von_mises", "von Mises stress"],
    ["max_shear", "maximum shear"],
    ["principal_stress_1", "maximum principal stress"],
    ["principal_stress_2", "middle principal stress"],
    ["principal_stress_3", "minimum principal stress"],
    ["displacement", "displacement"],
    ["contact_pressure", "contact pressure"],
    ["hertz_difference", "contact pressure less Hertz's"],
    ["mcewen_difference", "difference from McEwen's stress"],
  ];
  const NONE = -1e30; // in place of a value that does not exist
  const COLOURS = JSON.parse(document.getElementById("palette").textContent);

  function decoded(text, Type) {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    return new Type(bytes.buffer);
  }

  // Numbers that are kept as steps between the minimum and the maximum.
  function restored({ low, high, steps }) {
    return Float32Array.from(decoded(steps, Uint16Array), (step) => (step === 65535 ? NaN : low + ((high - low) * step) / 65534));
  }

  function decodedMesh(mesh) {
    const result = {
      name: mesh.name,
      normal: mesh.normal,
      points: decoded(mesh.points, Float32Array),
      displacements: restored(mesh.displacements),
      bodies: decoded(mesh.bodies, Uint8Array),
      triangles: decoded(mesh.triangles, Uint32Array),
      fields: {},
    };
    for (const name of Object.keys(mesh.fields)) result.fields[name] = restored(mesh.fields[name]);
    const u = result.displacements;
    if (mesh.name !== "contact")
      result.fields.displacement = Float32Array.from({ length: u.length / 3 }, (_, i) =>
        Math.hypot(u[3 * i], u[3 * i + 1], u[3 * i + 2]));
    return result;
  }

  const meshes = Object.fromEntries(view.meshes.map((mesh) => [mesh.name, decodedMesh(mesh)]));

  // In 3-D the pressure is drawn as a mountain over the contact surface, which is far longer than wide.
  const mountain = { widening: 1 };
  function raiseMountain() {
    const { points, displacements, fields, triangles } = meshes.contact;
    const [along, across] = [meshes.across.normal, meshes.along.normal];
    const dot = (v, i) => v[0] * points[i] + v[1] * points[i + 1] + v[2] * points[i + 2];
    const wide = 2.5 * view.half_width;
    const kept = [];
    const widths = Array.from({ length: points.length / 3 }, (_, i) => dot(across, 3 * i));
    const lengths = widths.map((_, i) => dot(along, 3 * i));
    for (let i = 0; i < triangles.length; i += 3) {
      const corners = [triangles[i], triangles[i + 1], triangles[i + 2]];
      if (corners.every((corner) => Math.abs(widths[corner]) < wide)) kept.push(...corners);
    }
    const ends = kept.map((corner) => lengths[corner]);
    const [first, last] = [Math.min(...ends), Math.max(...ends)];
    const peak = Math.max(...fields.contact_pressure);
    mountain.widening = Math.max(1, Math.round((0.12 * (last - first)) / view.half_width));
    mountain.length = last - first;
    mountain.places = points.slice();
    for (let i = 0; i < widths.length; ++i) {
      points[3 * i] = lengths[i] - (first + last) / 2;
      points[3 * i + 1] = (0.3 * mountain.length * fields.contact_pressure[i]) / peak;
      points[3 * i + 2] = mountain.widening * widths[i];
    }
    displacements.fill(0);
    meshes.contact.triangles = Uint32Array.from(kept);
  }

  // The displacement of the contact, if there is one, which the deformed shape is drawn relative to.
  function displacementOfContact() {
    if (!meshes.contact) return [0, 0, 0];
    const { displacements, fields } = meshes.contact;
    const pressure = fields.contact_pressure;
    const mean = [0, 0, 0];
    let weight = 0;
    for (let i = 0; i < pressure.length; ++i) {
      weight += pressure[i];
      for (let k = 0; k < 3; ++k) mean[k] += pressure[i] * displacements[3 * i + k];
    }
    return mean.map((sum) => sum / weight);
  }

  const still = displacementOfContact();
  if (view.dimension === 3 && meshes.contact) raiseMountain();

  function extentOf(points) {
    let extent = 0;
    for (let i = 0; i < points.length; ++i) extent = Math.max(extent, Math.abs(points[i]));
    return extent;
  }
  const extent = extentOf(meshes.model.points);
  const zone = 4 * view.half_width;
  const besideContact = meshes.contact ? Math.max(6 * view.half_width, 0.05 * extent) : 0;

  function rangeOf(mesh, field, isZone) {
    const values = mesh.fields[field];
    if (!values) return [0, 1];
    const points = mesh.points;
    let low = Infinity;
    let high = -Infinity;
    for (let i = 0; i < values.length; ++i) {
      const distance = Math.hypot(points[3 * i], points[3 * i + 1], view.dimension === 2 || mesh.name === "across" ? points[3 * i + 2] : 0);
      if (!Number.isFinite(values[i]) || (isZone ? distance > zone : distance < besideContact)) continue;
      low = Math.min(low, values[i]);
      high = Math.max(high, values[i]);
    }
    return low < high ? [low, high] : isZone ? rangeOf(mesh, field, false) : [0, 1];
  }

  function palette() {
    const colours = new Uint8Array(256 * 3);
    for (let i = 0; i < 256; ++i) {
      const at = (i / 255) * (COLOURS.length - 1);
      const k = Math.min(Math.floor(at), COLOURS.length - 2);
      for (let c = 0; c < 3; ++c) {
        const [a, b] = [k, k + 1].map((j) => parseInt(COLOURS[j].substr(2 * c, 2), 16));
        colours[3 * i + c] = Math.round(a + (at - k) * (b - a));
      }
    }
    const texture = new THREE.DataTexture(colours, 256, 1, THREE.RGBFormat);
    texture.magFilter = texture.minFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    return texture;
  }

  const uniforms = {
    palette: { value: palette() },
    factor: { value: 0 },
    still: { value: new THREE.Vector3(...still) },
    low: { value: 0 },
    high: { value: 1 },
    shade: { value: view.dimension === 3 ? 0.45 : 0 },
  };
  const VERTEX = `
    attribute vec3 displacement;
    attribute float value;
    uniform float factor;
    uniform vec3 still;
    varying float shown;
    varying vec3 place;
    #include <clipping_planes_pars_vertex>
    void main() {
      shown = value;
      vec4 mvPosition = modelViewMatrix * vec4(position + factor * (displacement - still), 1.0);
      vec3 viewPosition = -mvPosition.xyz;
      #include <clipping_planes_vertex>
      place = mvPosition.xyz;
      gl_Position = projectionMatrix * mvPosition;
    }`;
  const FRAGMENT = `
    uniform sampler2D palette;
    uniform float low;
    uniform float high;
    uniform float shade;
    varying float shown;
    varying vec3 place;
    #include <clipping_planes_pars_fragment>
    void main() {
      #include <clipping_planes_fragment>
      vec3 colour = vec3(0.72);
      if (shown > -1e29)
        colour = texture2D(palette, vec2(clamp((shown - low) / (high - low), 0.002, 0.998), 0.5)).rgb;
      vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
      gl_FragColor = vec4(colour * (1.0 - shade + shade * abs(normal.z)), 1.0);
    }`;

  function geometryOf(mesh) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(mesh.points, 3));
    geometry.setAttribute("displacement", new THREE.BufferAttribute(mesh.displacements, 3));
    geometry.setAttribute("value", new THREE.BufferAttribute(new Float32Array(mesh.bodies.length), 1));
    geometry.setIndex(new THREE.BufferAttribute(mesh.triangles, 1));
    return geometry;
  }

  // Where a cell meets smaller ones, roundings of places leave gaps of a pixel, through which the triangles' edges are
  // seen behind them.
  function edgesOf(object) {
    const edges = new THREE.Mesh(object.geometry, new THREE.ShaderMaterial({
      uniforms: uniforms,
      vertexShader: VERTEX.replace("* mvPosition;", "* mvPosition; gl_Position.z += 1e-4 * gl_Position.w;"),
      fragmentShader: FRAGMENT.replace("normalize(cross(dFdx(place), dFdy(place)))", "vec3(0.0, 0.0, 1.0)"),
      clipping: true,
      wireframe: true,
    }));
    edges.frustumCulled = false;
    return edges;
  }

  function objectOf(mesh) {
    const inFront = mesh.name !== "model";
    const material = new THREE.ShaderMaterial({
      uniforms: uniforms,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: THREE.DoubleSide,
      clipping: true,
      extensions: { derivatives: true },
      polygonOffset: inFront,
      polygonOffsetFactor: -1,
      polygonOffsetUnits: -4,
    });
    const object = new THREE.Mesh(geometryOf(mesh), material);
    object.frustumCulled = false;
    if (view.dimension === 2) object.add(edgesOf(object));
    return object;
  }

  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  } catch (error) {
    box.querySelector(".status").textContent = "This browser cannot draw in three dimensions: the picture stands in for the field view.";
    document.documentElement.classList.add("no-webgl");
    return;
  }
  renderer.localClippingEnabled = true;
  const scene = new THREE.Scene();
  const objects = Object.fromEntries(Object.entries(meshes).map(([name, mesh]) => [name, objectOf(mesh)]));
  scene.add(...Object.values(objects));
  const outlines = new THREE.LineSegments(
    new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x808890 }));
  outlines.geometry.setAttribute("position", objects.model.geometry.attributes.position);
  outlines.geometry.setIndex(new THREE.BufferAttribute(decoded(view.outlines, Uint32Array), 1));
  outlines.frustumCulled = false;
  scene.add(outlines);
  // A sign at a place of the model, always in front and of the same size; it goes along with the deformation.
  function markOf(place, displacement, text, shade) {
    const canvas = Object.assign(document.createElement("canvas"), { width: 64, height: 64 });
    const pen = canvas.getContext("2d");
    pen.beginPath();
    pen.arc(32, 32, 26, 0, 2 * Math.PI);
    pen.fillStyle = shade;
    pen.fill();
    pen.lineWidth = 5;
    pen.strokeStyle = pen.fillStyle = "#1b2126";
    pen.stroke();
    pen.font = "bold 34px sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillText(text, 32, 34);
    const mark = new THREE.Sprite(new THREE.SpriteMaterial({ map: new THREE.CanvasTexture(canvas), depthTest: false }));
    mark.userData = { place: place, displacement: displacement };
    mark.renderOrder = 1;
    scene.add(mark);
    return mark;
  }
  function nearestDisplacement(place) {
    const { points, displacements } = meshes.model;
    let nearest = 0;
    let least = Infinity;
    for (let i = 0; i < points.length; i += 3) {
      const distance = Math.hypot(points[i] - place[0], points[i + 1] - place[1], points[i + 2] - place[2]);
      if (distance < least) [nearest, least] = [i, distance];
    }
    return Array.from(displacements.slice(nearest, nearest + 3));
  }
  // The numbered places of the maximum stresses, and the lettered ones of the values that are kept.
  const marks = view.marks.map(({ place }, i) => markOf(place, nearestDisplacement(place), String(i + 1), "rgba(255, 255, 255, 0.85)"));
  const keptMarks = [];
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -20 * extent, 20 * extent);
  const stage = box.querySelector(".stage");
  stage.appendChild(renderer.domElement);
  renderer.domElement.setAttribute("role", "application");
  renderer.domElement.setAttribute("aria-label", `Stress field of the model; ${view.dimension === 3 ? "arrow keys turn it, with Shift they" : "arrow keys"} move it, plus and minus zoom, Home shows all again`);
  renderer.domElement.tabIndex = 0;
  const controls = new THREE.OrbitControls(camera, renderer.domElement);
  controls.enableRotate = view.dimension === 3;
  controls.screenSpacePanning = true;
  if (view.dimension === 2) controls.mouseButtons.LEFT = THREE.MOUSE.PAN;

  const control = (name) => box.querySelector(`[name="${name}"]`);
  for (const [value, label] of FIELDS) {
    if (!Object.values(meshes).some((mesh) => value in mesh.fields)) continue;
    control("field").add(new Option(label, value));
  }

  const cut = () => (view.dimension === 3 ? control("cut").value : "none");
  const isOnContact = () => ["contact_pressure", "hertz_difference"].includes(control("field").value);
  const isMountain = () => view.dimension === 3 && isOnContact();
  const isZone = () => control("part").value === "zone" && (view.dimension === 2 || cut() !== "none");

  const nameOf = (field) => FIELDS.find(([value]) => value === field)[1];

  function unitOf(field) {
    return field === "displacement" ? view.length_unit : view.stress_unit;
  }

  function colour() {
    const field = control("field").value;
    for (const [name, mesh] of Object.entries(meshes)) {
      const attribute = objects[name].geometry.attributes.value;
      const values = mesh.fields[field];
      for (let i = 0; i < attribute.count; ++i) attribute.array[i] = values && Number.isFinite(values[i]) ? values[i] : NONE;
      attribute.needsUpdate = true;
    }
    const leading = meshes[isOnContact() ? "contact" : cut() === "none" ? "model" : cut()];
    [uniforms.low.value, uniforms.high.value] = isOnContact() ? rangeOnContact(field) : rangeOf(leading, field, isZone());
    if (objects.contact) objects.contact.visible = isOnContact();
    label(field);
  }

  function rangeOnContact(field) {
    const values = meshes.contact.fields[field];
    const drawn = Array.from(meshes.contact.triangles, (corner) => values[corner]);
    const high = drawn.reduce((a, b) => Math.max(a, b), 0);
    return field === "contact_pressure" ? [0, high] : [drawn.reduce((a, b) => Math.min(a, b), 0), high];
  }

  const widthOfLetter = 9; // pixels
  function label(field) {
    const { low, high } = uniforms;
    const bar = box.querySelector(".bar");
    bar.style.background = `linear-gradient(to right, ${COLOURS.map((c) => "#" + c).join(",")})`;
    const shareOf = (value) => (value - low.value) / (high.value - low.value);
    const tick = (value) => {
      const span = Object.assign(document.createElement("span"), { textContent: genevaNumber(value, 5) });
      span.style.left = `${(100 * shareOf(value)).toFixed(2)}%`;
      return span;
    };
    box.querySelector(".ticks").replaceChildren(...genevaMarksThatFit(low.value, high.value, 6, 5, (bar.clientWidth || Infinity) / widthOfLetter).map(tick));
    const isExceeded = meshes.contact && !isZone() && field !== "displacement" && !isMountain();
    const ends = `, ${genevaNumber(low.value, 4)} to ${genevaNumber(high.value, 4)}${isExceeded ? ", more at the contact" : ""}`;
    const name = nameOf(field);
    const note = isMountain() ? `, drawn ${mountain.widening} times as wide as it is` : "";
    box.querySelector(".unit").textContent = `${name} [${unitOf(field)}]${ends}${note}`;
  }

  // What the model keeps: all on the far side of the cut's own plane, which may lie just below a face of the model. A
  // plane through that face would leave triangles of it by rounding.
  function planeBehind(mesh) {
    const normal = new THREE.Vector3(...mesh.normal);
    const distance = normal.dot(new THREE.Vector3(...mesh.points.slice(0, 3)));
    return new THREE.Plane(normal.negate(), distance);
  }

  function clip() {
    const name = cut();
    objects.model.visible = !isMountain();
    for (const one of ["across", "along"]) if (objects[one]) objects[one].visible = name === one && !isMountain();
    const planes = name === "none" ? [] : [planeBehind(meshes[name])];
    objects.model.material.clippingPlanes = planes;
    outlines.material.clippingPlanes = planes;
    outlines.visible = objects.model.visible && Number(control("deformation").value) === 0;
    const isNearCut = (mark) => planes.every((plane) => Math.abs(plane.distanceToPoint(new THREE.Vector3(...mark.userData.place))) < 0.05 * extent);
    for (const mark of marks) mark.visible = objects.model.visible && !(isZone() && meshes.contact) && isNearCut(mark);
    for (const mark of keptMarks) mark.visible = !isMountain() && isNearCut(mark);
    if (view.dimension === 3) control("part").disabled = name === "none";
  }

  function deform() {
    const share = Number(control("deformation").value);
    const u = isZone() ? relativeDisplacement(zone) : relativeDisplacement(Infinity);
    const maximum = u > 0 ? (0.15 * (isZone() ? zone : extent)) / u : 0;
    const factor = share * Math.max(maximum, 1);
    uniforms.factor.value = isMountain() ? 0 : factor;
    for (const mark of marks.concat(keptMarks)) {
      const { place, displacement } = mark.userData;
      mark.position.fromArray(place.map((x, k) => x + uniforms.factor.value * (displacement[k] - still[k])));
    }
    control("deformation").nextElementSibling.textContent =
      factor === 0 ? "undeformed" : `${Number(factor.toPrecision(2))} times`;
  }

  function relativeDisplacement(within) {
    const { points, displacements } = meshes.model;
    let maximum = 0;
    for (let i = 0; i < points.length; i += 3) {
      if (Math.hypot(points[i], points[i + 1], points[i + 2]) > within) continue;
      maximum = Math.max(maximum, Math.hypot(...still.map((s, k) => displacements[i + k] - s)));
    }
    return maximum;
  }

  // With the deformation that is shown.
  function boundsOfShown() {
    const { points, displacements } = meshes[cut() === "none" ? "model" : cut()];
    const factor = uniforms.factor.value;
    const bounds = new THREE.Box3();
    const place = new THREE.Vector3();
    for (let i = 0; i < points.length; i += 3)
      bounds.expandByPoint(place.fromArray([0, 1, 2].map((k) => points[i + k] + factor * (displacements[i + k] - still[k]))));
    return bounds;
  }

  function directionOfLook() {
    if (isMountain()) return new THREE.Vector3(0.35, 0.8, 1).normalize();
    if (view.dimension === 2) return new THREE.Vector3(0, 0, 1);
    if (cut() === "none") return new THREE.Vector3(0.5, 0.35, 0.8).normalize();
    const lean = isZone() ? [0, 0, 0] : [0.25, 0.2, 0.25];
    return new THREE.Vector3(...meshes[cut()].normal).add(new THREE.Vector3(...lean)).normalize();
  }

  let isMoved = false; // by the user, whose view is kept
  function lookAt() {
    const target = new THREE.Vector3();
    if (isMountain()) target.set(0, 0.12 * mountain.length, 0);
    else if (!isZone()) boundsOfShown().getCenter(target);
    const direction = directionOfLook();
    camera.up.set(0, 1, 0);
    if (Math.abs(direction.y) > 0.9) camera.up.set(1, 0, 0);
    camera.position.copy(target).addScaledVector(direction, 4 * extent);
    camera.zoom = 1;
    isMoved = false;
    controls.target.copy(target);
    controls.update();
    frame();
  }

  function halfHeight() {
    if (isMountain()) return Math.max(0.45, (0.6 * stage.clientHeight) / stage.clientWidth) * mountain.length;
    if (isZone()) return zone;
    const size = boundsOfShown().getSize(new THREE.Vector3());
    const aspect = stage.clientWidth / stage.clientHeight;
    const diagonal = view.dimension === 3 ? size.length() / 1.6 : 0;
    return 0.55 * Math.max(size.y, size.x / aspect, diagonal);
  }

  function frame() {
    const [width, height] = [stage.clientWidth, stage.clientHeight];
    if (width === 0 || height === 0) return;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    renderer.setSize(width, height);
    const half = halfHeight();
    camera.top = half;
    camera.bottom = -half;
    camera.right = (half * width) / height;
    camera.left = -camera.right;
    camera.updateProjectionMatrix();
    draw();
  }

  function draw() {
    const size = (22 * (camera.top - camera.bottom)) / (camera.zoom * Math.max(stage.clientHeight, 1));
    for (const mark of marks.concat(keptMarks)) mark.scale.set(size, size, 1);
    renderer.setClearColor(getComputedStyle(document.documentElement).getPropertyValue("--panel").trim());
    renderer.render(scene, camera);
  }

  // The value under the cursor, from the front triangle there.
  const hint = box.querySelector(".status").textContent;
  const ray = new THREE.Raycaster();
  function probe(event) {
    const frameBox = renderer.domElement.getBoundingClientRect();
    const at = new THREE.Vector2(
      (2 * (event.clientX - frameBox.left)) / frameBox.width - 1,
      1 - (2 * (event.clientY - frameBox.top)) / frameBox.height);
    ray.setFromCamera(at, camera);
    const planes = objects.model.material.clippingPlanes || [];
    return ray.intersectObjects(Object.values(objects).filter((object) => object.visible))
      .find((one) => one.object !== objects.model || planes.every((plane) => plane.distanceToPoint(one.point) >= 0));
  }

  function point(event) {
    const hit = probe(event);
    box.querySelector(".status").textContent = hit ? describe(hit) : hint;
  }

  // A press without a drag keeps the value at its place, until the next one beside the model.
  const kept = box.querySelector(".kept");
  let pressed = null;
  function press(event) {
    pressed = [event.clientX, event.clientY];
  }
  function release(event) {
    const isDrag = !pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4;
    pressed = null;
    if (isDrag) return;
    keep(probe(event));
    refresh(false);
  }
  // The newest values, with their letters in the picture.
  const LETTERS = "ABCDEFGHIJKL";
  function keep(hit) {
    if (!hit) {
      kept.replaceChildren();
      scene.remove(...keptMarks.splice(0));
      return;
    }
    if (kept.children.length === LETTERS.length) {
      kept.firstChild.remove();
      scene.remove(keptMarks.shift());
    }
    const used = keptMarks.map((mark) => mark.userData.letter);
    const letter = [...LETTERS].find((one) => !used.includes(one));
    kept.append(Object.assign(document.createElement("li"), { textContent: `${letter}: ${nameOf(control("field").value)} ${describe(hit)}` }));
    const mark = markOf(placeOf(hit), displacementAt(hit), letter, "rgba(255, 236, 160, 0.9)");
    mark.userData.letter = letter;
    keptMarks.push(mark);
  }

  function weightsOf(hit) {
    const mesh = meshes[Object.keys(objects).find((one) => objects[one] === hit.object)];
    const corners = ["a", "b", "c"].map((corner) => new THREE.Vector3().fromArray(mesh.points, 3 * hit.face[corner]));
    return THREE.Triangle.getBarycoord(hit.point, ...corners, new THREE.Vector3()).toArray();
  }
  // The mountain of pressure stands elsewhere than the surface that carries it.
  const placeOf = (hit) => (isMountain() ? placeOnSurface(hit.face, weightsOf(hit)) : hit.point.toArray());

  function displacementAt(hit) {
    if (isMountain()) return nearestDisplacement(placeOf(hit));
    const { displacements } = meshes[Object.keys(objects).find((one) => objects[one] === hit.object)];
    return [0, 1, 2].map((k) => displacements[3 * hit.face.a + k]);
  }

  function describe(hit) {
    const name = Object.keys(objects).find((one) => objects[one] === hit.object);
    const mesh = meshes[name];
    const field = control("field").value;
    const values = mesh.fields[field];
    const weights = weightsOf(hit);
    const value = values ? ["a", "b", "c"].reduce((sum, corner, k) => sum + weights[k] * values[hit.face[corner]], 0) : NaN;
    const at = isMountain() ? placeOnSurface(hit.face, weights) : hit.point.toArray();
    const place = at.slice(0, view.dimension)
      .map((x, k) => `${"xyz"[k]} = ${Number((x + view.origin[k]).toPrecision(6))}`).join(", ");
    const shown = Number.isFinite(value) ? `${Number(value.toPrecision(5))} ${unitOf(field)}` : "no value";
    return `${shown} in the ${view.bodies[mesh.bodies[hit.face.a]]} at ${place} ${view.length_unit}`;
  }

  function placeOnSurface(face, weights) {
    return [0, 1, 2].map((k) => ["a", "b", "c"].reduce((sum, corner, i) => sum + weights[i] * mountain.places[3 * face[corner] + k], 0));
  }

  // What mouse and touch do, by keys.
  function turn(right, up) {
    const arm = camera.position.clone().sub(controls.target);
    arm.applyAxisAngle(camera.up, -right);
    const polar = arm.angleTo(camera.up);
    const lowered = Math.min(Math.max(polar + up, 0.01), Math.PI - 0.01) - polar;
    arm.applyAxisAngle(new THREE.Vector3().crossVectors(camera.up, arm).normalize(), lowered);
    camera.position.copy(controls.target).add(arm);
  }

  function move(right, up) {
    const step = (0.1 * (camera.top - camera.bottom)) / camera.zoom;
    const shift = new THREE.Vector3(-right * step, -up * step, 0).applyQuaternion(camera.quaternion);
    camera.position.add(shift);
    controls.target.add(shift);
  }

  function zoom(factor) {
    camera.zoom *= factor;
    camera.updateProjectionMatrix();
  }

  function onKey(event) {
    const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const way = ways[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (way && (event.shiftKey || view.dimension === 2)) move(...way);
    else if (way) turn(0.1 * way[0], 0.1 * way[1]);
    else if (event.key === "+" || event.key === "=") zoom(1.2);
    else if (event.key === "-") zoom(1 / 1.2);
    else if (event.key !== "Home") return;
    isMoved = event.key !== "Home";
    if (!isMoved) lookAt();
    event.preventDefault();
    controls.update();
    draw();
  }

  function refresh(moveCamera) {
    clip();
    colour();
    deform();
    if (moveCamera) lookAt();
    else draw();
  }
  let wasMountain = false;
  control("field").addEventListener("change", () => {
    refresh(isMountain() !== wasMountain);
    wasMountain = isMountain();
  });
  control("part").addEventListener("change", () => refresh(true));
  if (view.dimension === 3) control("cut").addEventListener("change", () => refresh(true));
  control("deformation").addEventListener("input", () => refresh(!isMoved));
  let isInHand = false; // a click alone leaves the view where it is
  controls.addEventListener("start", () => { isInHand = true; });
  controls.addEventListener("change", () => { isMoved = isMoved || isInHand; });
  controls.addEventListener("end", () => { isInHand = false; });
  controls.addEventListener("change", draw);
  renderer.domElement.addEventListener("pointermove", point);
  renderer.domElement.addEventListener("pointerdown", press);
  renderer.domElement.addEventListener("pointerup", release);
  renderer.domElement.addEventListener("keydown", onKey);
  new ResizeObserver(frame).observe(stage);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  refresh(true);
  window.genevaField = { uniforms: uniforms, canvas: renderer.domElement, meshes: meshes };
})();
