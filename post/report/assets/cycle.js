// Plays the field of a cycle, with the mechanism and a cursor in the charts.
(function () {
  "use strict";
  const frames = JSON.parse(document.getElementById("cycle-data").textContent);
  const slider = document.querySelector('#cycle-controls [name="instant"]');
  const button = document.querySelector('#cycle-controls [name="play"]');
  const milliseconds = 300;

  function show(index) {
    const frame = frames[index];
    slider.value = index;
    for (const part of ["wheel", "contact"]) document.getElementById(`cycle-${part}`).src = `data:image/png;base64,${frame[part]}`;
    document.getElementById("cycle-words").textContent = frame.words;
  }

  // The slider leads; the mechanism stands at the step nearest to the instant.
  function goTo(index) {
    show(index);
    if (window.genevaMechanism) window.genevaMechanism.goTo(frames[index].driver_angle);
    if (window.genevaCursor) window.genevaCursor(frames[index].shown_angle);
  }

  // The mechanism's own slider leads: the field of the nearest instant.
  window.genevaCycle = {
    follow(driverAngle) {
      const distance = (frame) => Math.abs(frame.driver_angle - driverAngle);
      show(frames.reduce((best, frame, i) => (distance(frame) < distance(frames[best]) ? i : best), 0));
    },
  };

  let running = 0;
  slider.addEventListener("input", () => goTo(Number(slider.value)));
  button.addEventListener("click", () => {
    if (running) clearInterval(running);
    running = running ? 0 : setInterval(() => goTo((Number(slider.value) + 1) % frames.length), milliseconds);
    button.textContent = running ? "Stop" : "Play";
    button.setAttribute("aria-pressed", String(running !== 0));
  });
  goTo(Number(slider.value));
})();
