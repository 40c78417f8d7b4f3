'use strict';

drawPage({
  tension: tensionChart,
  matrix: heatMap,
  trajectory: trajectoryChart,
  life: lifeChart,
});
