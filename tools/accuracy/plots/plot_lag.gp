width = 1120; height = 540
load scripts.'/style.gp'
set multiplot layout 1,2 title 'Few rounds cost lag; more of them only for what is fast mend it' font ',16' offset 0,-0.6 margins 0.085,0.985,0.13,0.82 spacing 0.09
place(way) = way eq '1' ? 1 : way eq '2' ? 2 : way eq '3' ? 3 : way eq '5' ? 4 : way eq 'unbounded' ? 5 : way eq '3 to 8' ? 6 : NaN
set xtics ('1' 1, '2' 2, '3' 3, '5' 4, 'any' 5, '3, fast 8' 6)
set xrange [0.8:6.4]
set arrow from first 5.5, graph 0 to first 5.5, graph 1 nohead lc rgb grey dt 2
set xlabel 'rounds in a tick'
array colours[3] = [green, blue, red]
speeds = '20 100 200'
of(speed, panes) = column(4) == speed && column(3) == panes
old(speed, panes) = of(speed, panes) && place(strcol(1)) < 6 ? place(strcol(1)) : NaN
new(speed, panes) = of(speed, panes) && strcol(1) eq '3 to 8' ? 6 : NaN
set title 'lag, worst phase: 6 (dashed) and 16 panes' font ',13'
set ylabel 'late by [ms]'
set yrange [0:*]
set key top right
plot for [i = 2:3] table('panes') using (old(real(word(speeds, i)), 16)):9 smooth unique with linespoints lw 2.5 pt 7 lc rgb colours[i] notitle, \
     for [i = 1:3] table('panes') using (old(real(word(speeds, i)), 6)):9 smooth unique with linespoints lw 2.5 dt 2 pt 7 lc rgb colours[i] notitle, \
     for [i = 2:3] table('panes') using (new(real(word(speeds, i)), 16)):9 with points pt 7 ps 1.4 lc rgb colours[i] notitle, \
     for [i = 1:3] table('panes') using (new(real(word(speeds, i)), 6)):9 with points pt 6 ps 1.4 lw 2 lc rgb colours[i] notitle, \
     for [i = 1:3] NaN with lines lw 2.5 lc rgb colours[i] title word(speeds, i).' m/s'
set title 'push of the shards of 6 panes, least phase' font ',13'
set ylabel '[mN s]' offset 1.5,0
set logscale y
set yrange [1:500]
set key bottom right
plot for [i = 1:3] table('panes') using (old(real(word(speeds, i)), 6)):($10 * 1000) smooth unique with linespoints lw 2.5 dt 2 pt 7 lc rgb colours[i] notitle, \
     for [i = 1:3] table('panes') using (new(real(word(speeds, i)), 6)):($10 * 1000) with points pt 6 ps 1.4 lw 2 lc rgb colours[i] notitle
unset multiplot
