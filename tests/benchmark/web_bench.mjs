// SPDX-License-Identifier: MIT
// The WebAssembly rows of the benchmark: the kernels against a plain JavaScript loop, interleaved
// in one run. Prints Google Benchmark's JSON with --json, else a table.
//
//   node tests/benchmark/web_bench.mjs [--json] [build/web/tests/benchmark/versorium_web_bench.js]
import { createRequire } from "node:module";
import path from "node:path";

const SIDE = 1024;
const ITERATIONS = 1000;
const REPETITIONS = 5;

const json = process.argv.includes("--json");
const script = process.argv.slice(2).find((argument) => !argument.startsWith("--"))
  ?? "build/web/tests/benchmark/versorium_web_bench.js";
const module = await createRequire(import.meta.url)(path.resolve(script))();

function plain(side, iterations) {
  let total = 0;
  for (let y = 0; y < side; ++y) {
    for (let x = 0; x < side; ++x) {
      const cx = -0.75 + ((x + 0.5) / side - 0.5) * 2.5;
      const cy = (0.5 - (y + 0.5) / side) * 2.5;
      let a = 0, b = 0, aa = 0, bb = 0, n = 0;
      while (n < iterations && aa + bb <= 4) {
        b = 2 * a * b + cy;
        a = aa - bb + cx;
        aa = a * a;
        bb = b * b;
        ++n;
      }
      total += n;
    }
  }
  return total;
}

const rows = [
  { name: "mandelbrot/javascript", run: plain },
  { name: "mandelbrot/double/simd128", run: module._mandelbrotDouble, goal: 4 },
  { name: "mandelbrot/float/simd128", run: module._mandelbrotFloat, goal: 8 },
];
for (const row of rows) {
  row.times = [];
  row.run(SIDE / 4, ITERATIONS); // lets the engine compile it
}
for (let repetition = 0; repetition < REPETITIONS; ++repetition) {
  for (const row of rows) {
    const start = performance.now();
    row.total = row.run(SIDE, ITERATIONS);
    row.times.push(performance.now() - start);
  }
}
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
if (rows[0].total !== rows[1].total) throw new Error("the counts differ");

if (json) {
  const benchmarks = rows.map((row) => ({
    name: row.name, run_type: "aggregate", aggregate_name: "median", iterations: REPETITIONS,
    real_time: median(row.times), cpu_time: median(row.times), time_unit: "ms",
    "iterations/s": row.total / median(row.times) * 1000,
  }));
  console.log(JSON.stringify({ context: { executable: "node", library_build_type: "release" }, benchmarks }, null, 2));
} else {
  for (const row of rows) {
    const ratio = median(rows[0].times) / median(row.times);
    console.log(`${row.name.padEnd(30)} ${median(row.times).toFixed(1).padStart(8)} ms ${ratio.toFixed(2).padStart(7)}x`
      + (row.goal ? `  goal ${row.goal}x` : ""));
  }
}
