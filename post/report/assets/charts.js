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
      const number = paired ? bases.indexOf(baseName(one.name)) : index;
      const colour = colours[number % colours.length];
      const markers = one.style === "markers";
      return {
        label: one.name,
        data: one.points.map(([x, y]) => ({ x: x, y: y })),
        showLine: !markers,
        borderColor: colour,
        backgroundColor: markers ? "transparent" : colour,
        pointStyle: markers ? "circle" : "rectRot",
        borderWidth: one.style === "wide" ? 6 : 2,
        borderDash: one.style === "dashed" ? [6, 4] : number >= colours.length ? [2, 3] : [],
        pointRadius: markers ? 3 : one.style !== "wide" && one.points.length < 20 ? 3 : 0,
        pointHitRadius: 6,
      };
    });
  }

  // A legend's mark as the plot has it: the line with its dashes, and the points on it.
  function markOf(dataset) {
    const mark = Object.assign(document.createElement("canvas"), { width: 32, height: 12 });
    const pen = mark.getContext("2d");
    pen.strokeStyle = dataset.borderColor;
    pen.fillStyle = dataset.backgroundColor;
    pen.lineWidth = dataset.borderWidth;
    pen.setLineDash(dataset.borderDash);
    if (dataset.showLine) {
      pen.beginPath();
      pen.moveTo(0, 6);
      pen.lineTo(26, 6);
      pen.stroke();
    }
    pen.setLineDash([]);
    if (dataset.pointRadius > 0) Chart.helpers.drawPoint(pen, { pointStyle: dataset.pointStyle, radius: dataset.pointRadius, borderWidth: dataset.borderWidth }, 13, 6);
    return mark;
  }

  function legendLabels(chart) {
    return chart.data.datasets.map((dataset, i) => ({
      text: dataset.label,
      datasetIndex: i,
      hidden: !chart.isDatasetVisible(i),
      fontColor: ink(),
      pointStyle: markOf(dataset),
    }));
  }

  // An axis is no longer than the chart is high.
  function inLines(label, most = 38) {
    const lines = [""];
    for (const word of label.split(" ")) {
      if (lines[lines.length - 1].length + word.length > most) lines.push("");
      lines[lines.length - 1] += (lines[lines.length - 1] === "" ? "" : " ") + word;
    }
    return lines.length > 1 ? lines : label;
  }

  // Values that differ by round-off alone are shown as equal.
  function rangeOf(values) {
    const [least, maximum] = [Math.min(...values), Math.max(...values)];
    const size = Math.max(Math.abs(least), Math.abs(maximum));
    return maximum - least > 1e-6 * size ? [least, maximum] : [least - 0.05 * size, maximum + 0.05 * size];
  }

  function axis(specification, values, margin, isBelow) {
    const result = {
      type: specification.logarithmic ? "logarithmic" : "linear",
      title: { display: true, text: inLines(specification.label), label: specification.label, color: ink() },
      ticks: { color: ink(), maxRotation: 0, autoSkipPadding: 12, callback: (value) => genevaNumber(value, 6) },
      grid: { color: rule() },
    };
    const [least, maximum] = rangeOf(values);
    if (specification.logarithmic) divide(result, Math.min(...positive(values)), maximum);
    else if (specification.step > 0 && least < maximum && maximum - least < mostSteps * specification.step) step(result, least, maximum, specification.step);
    else if (least < maximum) round(result, least, maximum, margin * (maximum - least), isBelow);
    return result;
  }

  const mostSteps = 100;
  const lettersOnPaper = 34; // below a chart of half a page
  const positive = (values) => values.filter((value) => value > 0);

  function setMarks(axis, marks) {
    axis.afterBuildTicks = (scale) => {
      scale.ticks = marks.map((mark) => ({ value: mark }));
    };
  }

  // The axis ends where the data do; its marks are multiples of the step, of twice or four times that
  // if they were many, of a third, a ninth or a 45th if they were one or two.
  function step(axis, least, maximum, whole) {
    axis.min = least;
    axis.max = maximum;
    const marksOf = (step) => Math.floor(maximum / step + 1e-9) - Math.ceil(least / step - 1e-9) + 1;
    axis.ticks.autoSkip = false;
    const factor = [4, 2, 1, 1 / 3, 1 / 9, 1 / 45].find((one) => marksOf(one * whole) >= (one > 1 ? 6 : 3)) || 1 / 45;
    const step = factor * whole;
    const first = Math.ceil(least / step - 1e-9);
    const count = Math.floor(maximum / step + 1e-9) - first + 1;
    setMarks(axis, Array.from({ length: count }, (_, i) => (first + i) * step));
    if (Math.abs(whole - Math.PI / 4) < 1e-9) axis.ticks.callback = (value) => inPartsOfPi(Math.round((180 * value) / Math.PI));
  }

  // Of so many degrees: "-π/4", "3π/2", "0".
  function inPartsOfPi(degrees) {
    if (degrees === 0) return "0";
    let [divisor, rest] = [180, Math.abs(degrees)];
    while (rest > 0) [divisor, rest] = [rest, divisor % rest];
    const [number, parts] = [Math.abs(degrees) / divisor, 180 / divisor];
    return `${degrees < 0 ? "-" : ""}${number === 1 ? "" : number}π${parts === 1 ? "" : `/${parts}`}`;
  }

  // Round marks, 0 among them where the axis crosses it.
  function round(axis, least, maximum, margin, isBelow) {
    axis.min = least === 0 ? 0 : least - margin;
    axis.max = maximum === 0 ? 0 : maximum + margin;
    setMarks(axis, isBelow ? genevaMarksThatFit(axis.min, axis.max, 6, 6, lettersOnPaper) : genevaMarks(axis.min, axis.max, 6));
  }

  // A short logarithmic axis gets the round numbers that a linear one would have, a longer one 1, 2
  // and 5 in each decade.
  function divide(axis, least, maximum) {
    if (!(least > 0 && least < maximum)) return;
    const marks = maximum < 3 * least ? evenMarks(least, maximum) : decadeMarks(least, maximum);
    axis.min = marks[0];
    axis.max = marks[marks.length - 1];
    setMarks(axis, marks);
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

  const coordinates = (chart, index) => chart.series.flatMap((one) => one.points.map((point) => point[index])).filter((value) => value !== null);

  // The position that the drawing of the mechanism shows, in the charts over the cycle.
  const cursor = { at: null };
  const cursorLine = {
    id: "cursor",
    afterDatasetsDraw(chart) {
      const { ctx, chartArea, scales } = chart;
      if (cursor.at === null || !chart.options.isOverCycle) return;
      const x = scales.x.getPixelForValue(cursor.at);
      ctx.save();
      ctx.strokeStyle = ink();
      ctx.lineWidth = 1;
      ctx.setLineDash([2, 3]);
      ctx.beginPath();
      ctx.moveTo(x, chartArea.top);
      ctx.lineTo(x, chartArea.bottom);
      ctx.stroke();
      ctx.restore();
    },
  };
  window.genevaCursor = (at) => {
    cursor.at = at;
    for (const chart of Object.values(window.genevaCharts)) if (chart.options.isOverCycle) chart.draw();
  };

  window.genevaCharts = {};
  // Many curves make a legend of many lines, which must not take the place of the curves.
  const extraLines = (chart) => Math.max(0, chart.series.length - 4);
  function configuration(chart) {
    return {
      type: "scatter",
      data: { datasets: datasets(chart.series) },
      plugins: [cursorLine],
      options: {
        isOverCycle: chart.over_cycle,
        animation: false,
        maintainAspectRatio: false,
        interaction: { mode: "nearest", intersect: false },
        scales: { x: axis(chart.x, coordinates(chart, 0), 0, true), y: axis(chart.y, coordinates(chart, 1), 0.05, false) },
        plugins: {
          legend: { labels: { color: ink(), usePointStyle: true, pointStyleWidth: 32, generateLabels: legendLabels } },
          tooltip: { callbacks: { label: (item) => `${item.dataset.label}: ${genevaNumber(item.parsed.y, 5)} at ${genevaNumber(item.parsed.x, 5)}` } },
        },
      },
    };
  }
  // Those that are there already are drawn anew.
  window.genevaDrawCharts = (charts) => {
    for (const chart of charts) {
      const canvas = document.getElementById(chart.id);
      if (extraLines(chart) > 0) canvas.parentElement.style.height = `${20 + 1.6 * extraLines(chart)}rem`;
      const drawn = window.genevaCharts[chart.id];
      if (drawn) {
        const { data, options } = configuration(chart);
        Object.assign(drawn, { data, options });
        drawn.update();
      } else {
        window.genevaCharts[chart.id] = new Chart(canvas, configuration(chart));
      }
    }
  };
  window.genevaDrawCharts(specifications);
  // Paper is white, whatever the screen is.
  function recolour(onPaper) {
    document.documentElement.classList.toggle("paper", onPaper);
    for (const chart of Object.values(window.genevaCharts)) {
      // Two charts side by side are less than half as wide on paper.
      const isAlone = chart.canvas.closest(".charts").children.length === 1;
      const font = { size: onPaper ? (isAlone ? 14 : 20) : 12 };
      for (const scale of Object.values(chart.options.scales)) {
        scale.title.color = scale.ticks.color = ink();
        scale.title.font = scale.ticks.font = font;
        scale.title.text = inLines(scale.title.label, scale === chart.options.scales.y && onPaper && !isAlone ? 22 : 38);
        scale.grid.color = rule();
      }
      chart.options.plugins.legend.labels.color = ink();
      chart.options.plugins.legend.labels.font = chart.data.datasets.length > 4 ? { size: Math.min(font.size, 16) } : font;
      chart.update();
      // Paper scales the drawing to its columns: in a narrow window it would be taller than wide.
      // The library keeps half of the height from the legend.
      if (onPaper) chart.resize(isAlone ? 1120 : 552, Math.max(320, 54 * chart.data.datasets.length));
      else chart.resize();
    }
  }
  window.addEventListener("beforeprint", () => recolour(true));
  window.addEventListener("afterprint", () => recolour(false));
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => recolour(false));
})();
