'use strict';

function tensionChart(holder, data) {
  const { tension, turning_points: turning } = data;
  const time = timeScale(data.summary.duration_s);
  const force = axisScale(largestMagnitude([...tension.high_N, ...tension.low_N]));
  const banded = tension.samples_per_bucket > 1;
  // A row without values breaks the lines where samples are missing.
  const opened = (values, filler) => values.flatMap((value, index) =>
    (tension.gaps.includes(index) ? [filler(values, index), value] : [value]));
  const none = () => null;
  const bandTimes = opened(divided(tension.time_s, time.divisor),
    (values, index) => (values[index - 1] + values[index]) / 2);
  const high = opened(divided(tension.high_N, force.divisor), none);
  const low = opened(divided(tension.low_N, force.divisor), none);
  const line = {
    ink: 'line',
    width: 1,
    value: valueText,
    points: { show: tension.time_s.length < 100, size: 4, fill: () => colour('line') },
  };
  const turningPoints = {
    label: 'Turning point',
    ink: 'mark',
    paths: () => null,
    value: valueText,
    points: {
      show: true,
      size: turning.time_s.length > 300 ? 2.5 : 5,
      width: 0,
      fill: () => colour('mark'),
    },
  };
  const lines = banded
    ? [{ ...line, label: 'Highest' }, { ...line, label: 'Lowest' }]
    : [{ ...line, label: 'Tension' }];
  return lineChart(holder, {
    data: uPlot.join([
      banded ? [bandTimes, high, low] : [bandTimes, high],
      [divided(turning.time_s, time.divisor), divided(turning.tension_N, force.divisor)],
    ]),
    series: [{ label: time.label, value: valueText }, ...lines, turningPoints],
    bands: banded ? [{ series: [1, 2], fill: () => colour('band') }] : [],
    xAxis: time.label,
    yAxis: `Input tension, N${force.suffix}`,
  });
}

function trajectoryChart(holder, data) {
  const { trajectory } = data;
  const time = timeScale(data.summary.duration_s);
  const damage = axisScale(largestMagnitude(trajectory.damage));
  return lineChart(holder, {
    data: [
      divided(trajectory.time_s, time.divisor),
      divided(trajectory.damage, damage.divisor),
    ],
    series: [
      { label: time.label, value: valueText },
      {
        label: `Damage${damage.suffix}`,
        ink: 'line',
        width: 2,
        value: valueText,
        points: { show: trajectory.time_s.length < 100, size: 4, fill: () => colour('line') },
      },
    ],
    xAxis: time.label,
    yAxis: `Damage${damage.suffix}`,
    yRange: (chart, low, high) => [0, (high || 1) * 1.08],
  });
}

/**
 * Marks B10, B50, the mean and B90 on the curve of broken wires. Of the two in the middle, which
 * can lie close together, the earlier has its name to the left of the curve.
 */
function lifeMarks(marks) {
  const middle = marks.filter(({ name }) => name === 'B50' || name === 'mean');
  const leftOne = middle.reduce((a, b) => (a.repeats <= b.repeats ? a : b)).name;
  return (chart) => {
    const { ctx, bbox } = chart;
    const pixel = uPlot.pxRatio;
    ctx.save();
    ctx.font = `600 ${12 * pixel}px system-ui, sans-serif`;
    ctx.textBaseline = 'middle';
    for (const { name, repeats, broken, text } of marks) {
      const x = chart.valToPos(repeats, 'x', true);
      const y = chart.valToPos(broken, 'y', true);
      if (x < bbox.left || x > bbox.left + bbox.width) {
        continue;
      }
      ctx.strokeStyle = colour('mark');
      ctx.setLineDash([3 * pixel, 3 * pixel]);
      ctx.lineWidth = pixel;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top + bbox.height);
      ctx.lineTo(x, y);
      ctx.stroke();
      ctx.fillStyle = colour('mark');
      ctx.beginPath();
      ctx.arc(x, y, 4 * pixel, 0, 2 * Math.PI);
      ctx.fill();
      const label = `${name} ${text}`;
      const gap = 10 * pixel;
      const length = ctx.measureText(label).width;
      const fitsLeft = x - gap - length > bbox.left;
      const fitsRight = x + gap + length < bbox.left + bbox.width;
      const toLeft = (name === leftOne && fitsLeft) || !fitsRight;
      ctx.textAlign = toLeft ? 'right' : 'left';
      ctx.fillStyle = colour('ink');
      ctx.fillText(label, toLeft ? x - gap : x + gap, y);
    }
    ctx.restore();
  };
}

function lifeChart(holder, data) {
  const { life, summary } = data;
  const percent = 100;
  const scale = axisScale(largestMagnitude(life.repeats));
  const brokenAt = (repeats) => {
    const after = life.repeats.findIndex((value) => value >= repeats);
    if (after <= 0) {
      return life.broken[after === 0 ? 0 : life.broken.length - 1];
    }
    const [from, to] = [life.repeats[after - 1], life.repeats[after]];
    const part = (repeats - from) / (to - from);
    return life.broken[after - 1] + part * (life.broken[after] - life.broken[after - 1]);
  };
  const marks = Object.entries(summary.repeats_to)
    .filter(([, repeats]) => repeats !== null)
    .map(([name, repeats]) => ({
      name,
      repeats: repeats / scale.divisor,
      broken: percent * brokenAt(repeats),
      text: numberText(repeats),
    }));
  return lineChart(holder, {
    data: [divided(life.repeats, scale.divisor), life.broken.map((share) => percent * share)],
    series: [
      { label: `Repeats${scale.suffix}`, value: valueText },
      {
        label: 'Broken wires, %',
        ink: 'line',
        wash: 'band',
        width: 2,
        value: valueText,
        points: { show: false },
      },
    ],
    xAxis: `Repeats of this profile${scale.suffix}`,
    yAxis: 'Broken wires, %',
    yRange: () => [0, percent],
    onDraw: marks.length > 0 ? lifeMarks(marks) : undefined,
  });
}
