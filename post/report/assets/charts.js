// Draws the charts that the page names, with Chart.js.
(function () {
  "use strict";
  const specifications = JSON.parse(document.getElementById("charts").textContent);
  // Okabe and Ito's colours, which the colour-blind can tell apart.
  const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
  const style = getComputedStyle(document.documentElement);
  const ink = () => style.getPropertyValue("--ink").trim();
  const rule = () => style.getPropertyValue("--rule").trim();

  function baseName(name) {
    return name.split(",")[0];
  }

  function datasets(series) {
    const bases = [...new Set(series.map((one) => baseName(one.name)))];
    const paired = bases.length < series.length;
    return series.map((one, index) => {
      const colour = colours[(paired ? bases.indexOf(baseName(one.name)) : index) % colours.length];
      const markers = one.style === "markers";
      return {
        label: one.name,
        data: one.points.map(([x, y]) => ({ x: x, y: y })),
        showLine: !markers,
        borderColor: colour,
        backgroundColor: markers ? "transparent" : colour,
        pointStyle: markers ? "circle" : one.style === "dashed" || one.points.length >= 20 ? "line" : "rectRot",
        borderWidth: 2,
        borderDash: one.style === "dashed" ? [6, 4] : [],
        pointRadius: markers ? 3 : one.points.length < 20 ? 3 : 0,
        pointHitRadius: 6,
      };
    });
  }

  function axis(specification, values) {
    const result = {
      type: specification.logarithmic ? "logarithmic" : "linear",
      title: { display: true, text: specification.label, color: ink() },
      ticks: { color: ink(), maxRotation: 0, autoSkipPadding: 12 },
      grid: { color: rule() },
    };
    if (specification.logarithmic) divide(result, Math.min(...values), Math.max(...values));
    return result;
  }

  // A short logarithmic axis gets the round numbers that a linear one would have, a longer one 1, 2
  // and 5 in each decade.
  function divide(axis, least, maximum) {
    if (!(least > 0 && least < maximum)) return;
    const marks = maximum < 3 * least ? evenMarks(least, maximum) : decadeMarks(least, maximum);
    axis.min = marks[0];
    axis.max = marks[marks.length - 1];
    axis.afterBuildTicks = (scale) => {
      scale.ticks = marks.map((mark) => ({ value: mark }));
    };
    axis.ticks.callback = (value) => Number(value.toPrecision(6)).toLocaleString(undefined, { maximumSignificantDigits: 6 });
  }

  function evenMarks(least, maximum) {
    const coarse = Math.pow(10, Math.floor(Math.log10((maximum - least) / 4)));
    const step = coarse * [1, 2, 5, 10].find((factor) => maximum - least <= 5 * factor * coarse);
    const first = Math.floor(least / step); // 1 or more: the step is at most the minimum value
    const last = Math.ceil(maximum / step);
    return Array.from({ length: last - first + 1 }, (_, i) => (first + i) * step);
  }

  function decadeMarks(least, maximum) {
    const first = Math.floor(Math.log10(least));
    const last = Math.ceil(Math.log10(maximum));
    const shares = last - first > 3 ? [1] : [1, 2, 5];
    const marks = Array.from({ length: last - first + 1 }, (_, i) => shares.map((share) => share * Math.pow(10, first + i))).flat();
    return marks.filter((mark, i) => !(marks[i + 1] <= least) && !(i > 0 && marks[i - 1] >= maximum));
  }

  const coordinates = (chart, index) => chart.series.flatMap((one) => one.points.map((point) => point[index])).filter((value) => value > 0);

  window.genevaCharts = {};
  for (const chart of specifications) {
    const canvas = document.getElementById(chart.id);
    window.genevaCharts[chart.id] = new Chart(canvas, {
      type: "scatter",
      data: { datasets: datasets(chart.series) },
      options: {
        animation: false,
        maintainAspectRatio: false,
        interaction: { mode: "nearest", intersect: false },
        scales: { x: axis(chart.x, coordinates(chart, 0)), y: axis(chart.y, coordinates(chart, 1)) },
        plugins: { legend: { labels: { color: ink(), usePointStyle: true, boxWidth: 22 } } },
      },
    });
  }
  // Paper is white, whatever the screen is.
  function recolour(onPaper) {
    document.documentElement.classList.toggle("paper", onPaper);
    for (const chart of Object.values(window.genevaCharts)) {
      for (const scale of Object.values(chart.options.scales)) {
        scale.title.color = scale.ticks.color = ink();
        scale.grid.color = rule();
      }
      chart.options.plugins.legend.labels.color = ink();
      chart.update();
    }
  }
  window.addEventListener("beforeprint", () => recolour(true));
  window.addEventListener("afterprint", () => recolour(false));
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => recolour(false));
})();
