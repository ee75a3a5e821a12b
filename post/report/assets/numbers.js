// How the page's scripts write numbers: significant digits, thousands apart from five digits on.
window.genevaNumber = function (value, digits) {
  "use strict";
  if (!Number.isFinite(value)) return "not bounded";
  const size = Math.abs(value);
  if (size < 1e-12) return "0";
  if (size >= 1e12 || size < 1e-4) return Number(value.toPrecision(digits)).toExponential();
  const [whole, rest] = String(Number(value.toPrecision(digits))).split(".");
  const grouped = whole.replace("-", "").length < 5 ? whole : whole.replace(/\B(?=(\d{3})+$)/g, "\u202f");
  return rest ? `${grouped}.${rest}` : grouped;
};
// Fewer of the marks below, so that they stand beside each other in so many letters.
window.genevaMarksThatFit = function (low, high, most, digits, letters) {
  "use strict";
  const apart = 2;
  const needed = (marks) => marks.reduce((sum, mark) => sum + genevaNumber(mark, digits).length + apart, 0);
  for (let count = most; count > 1; --count) {
    const marks = genevaMarks(low, high, count);
    if (needed(marks) <= letters) return marks;
  }
  return genevaMarks(low, high, 1);
};
// Multiples of a round step that cover a range, about so many.
window.genevaMarks = function (low, high, count) {
  "use strict";
  if (!(high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)))) return [];
  const raw = (high - low) / count;
  const power = Math.pow(10, Math.floor(Math.log10(raw)));
  const step = power * [1, 2, 2.5, 5, 10].find((factor) => raw <= factor * power * (1 + 1e-9));
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => Number(((first + i) * step).toPrecision(12)));
};
