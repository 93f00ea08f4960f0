width = 1060
load scripts.'/style.gp'
set title 'Where the time of a break goes: contacts and the solver, not the cutting' font ',15'
set style data histograms
set style histogram rowstacked
set style fill solid 1 border lc rgb '#ffffff'
set boxwidth 0.7
set ylabel 'all ticks in which six panes break at 100 m/s [ms]'
set xlabel 'rounds in a tick (ticks that break something)'
set yrange [0:*]
set grid noxtics
set key outside right top vertical Left reverse invert
array colours[10] = [sky, '#b8dcf2', blue, red, orange, '#7cc8ae', green, yellow, purple, '#c8c8c8']
plot for [i = 3:12] table('phases') using i:xtic((strcol(1) eq 'unbounded' ? 'any' : strcol(1) eq '3 to 8' ? '3, fast 8' : strcol(1)).' ('.strcol(2).')') lc rgb colours[i - 2] title columnheader(i)
