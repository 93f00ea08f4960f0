width = 1060
load scripts.'/style.gp'
set title 'What a budget buys: the best settings that 99 of 100 ticks of a room keep it with' font ',15'
set logscale xy
set xrange [0.4:18]
set xtics (0.5, 1, 2, 4, 8)
set format y '%g'
set xlabel 'budget of a tick of the whole game [ms]'
set ylabel 'error score (1: as much as one would notice)'
set yrange [0.05:12]
set key off
plot table('budget') using 1:3 with steps lw 3 lc rgb blue, \
     '' using 1:3 with points pt 7 ps 1.4 lc rgb blue, \
     '' using 1:3:(sprintf("%s\nscore %.2g, p99 %.2g ms", strcol(2), $3, $4)) with labels left offset 0.8,1.6 font ',11' tc rgb '#222222'
