width = 1060
load scripts.'/style.gp'
set title 'One round inside the step is enough for the exit speed, at every speed' font ',15'
place(way) = way eq 'after' ? 1 : way eq 'blended' ? 2 : way eq 'restored' ? 3 : way eq 'after capped' ? 4 : way eq '1' ? 5 : way eq '2' ? 6 : way eq '3' ? 7 : way eq '3 to 8' ? 8 : way eq '5' ? 9 : way eq 'unbounded' ? 10 : NaN
set xtics ("after" 1, "blended" 2, "restored" 3, "capped" 4, "1" 5, "2" 6, "3" 7, "3, fast 8" 8, "5" 9, "any" 10)
set xrange [0.6:10.4]
set logscale y
set yrange [0.008:400]
set format y '%g'
set ylabel 'exit speed off the exact one by [%], worst phase'
set xlabel 'after the step  |  inside it: rounds in a tick (default: 3, but 8 for what is fast)'
set arrow from graph 0, first 2 to graph 1, first 2 nohead lc rgb black dt 3 lw 1.5
set label '2 %' at graph 0.96, first 2.6 tc rgb '#444444'
set arrow from first 4.5, graph 0 to first 4.5, graph 1 nohead lc rgb grey dt 2
set key outside right top vertical Left reverse title 'speed, panes'
array colours[6] = [purple, orange, green, sky, blue, red]
speeds = '5 10 20 50 100 200'
panes(i) = i < 3 ? 1 : i < 4 ? 6 : 16
# One point for each way, in the order of the axis: the table has them in the order they were measured in.
plot for [i = 1:6] table('panes') using (column(4) == real(word(speeds, i)) && column(3) == panes(i) ? place(strcol(1)) : NaN):6 with points pt 7 ps 1.2 lc rgb colours[i] title sprintf('%s m/s, %d', word(speeds, i), panes(i)), \
     for [i = 1:6] table('panes') using (column(4) == real(word(speeds, i)) && column(3) == panes(i) && strcol(1) ne 'default' && place(strcol(1)) > 4 ? place(strcol(1)) : NaN):6 smooth unique with lines lw 2.5 lc rgb colours[i] notitle
