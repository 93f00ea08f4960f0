width = 1060
load scripts.'/style.gp'
set title 'The repaired splitter never fails, for about a fifth of the speed' font ',15'
set logscale xy
set xlabel 'cuts per second'
set ylabel 'failures per million cuts'
set yrange [0.5:100000]
set ytics add ('none' 1)
set format x '10^{%T}'
set key outside right top vertical Left reverse
splitters = "'naive float' 'float with epsilon' 'naive double' 'ours float' 'ours double' 'exact rationals'"
array colours[6] = [red, orange, purple, blue, sky, green]
cuts = 'random vertex edge face'
array shapes[4] = [7, 5, 9, 13]
height_of(failures) = failures < 1 ? 1 : failures
plot for [i = 1:6] for [k = 1:4] table('splitters') using (strcol(1) eq word(splitters, i) && strcol(2) eq word(cuts, k) ? $7 : NaN):(height_of($6)) with points pt shapes[k] ps 1.4 lc rgb colours[i] notitle, \
     for [i = 1:6] NaN with points pt 7 ps 1.4 lc rgb colours[i] title word(splitters, i), \
     NaN with lines lc rgb '#ffffff' title ' ', \
     for [k = 1:4] NaN with points pt shapes[k] ps 1.4 lc rgb '#555555' title 'planes: '.word(cuts, k)
