#!/usr/bin/env bash
# The line-chart library of the replay page.
# Usage: npm_package.sh.
package=uplot
version=1.6.32
sha512=KIMVnG68zvu5XXUbC4LQEPnhwOxBuLyW1AHtpm6IKTXImkbLgkMy+jabjLgSLMasNuGGzQm/ep3tOkyTxpiQIw==
files=(dist/uPlot.iife.min.js dist/uPlot.min.css LICENSE)
. "$(dirname "${BASH_SOURCE[0]}")/npm_package.sh"
