width = 1120; height = 540
load scripts.'/style.gp'
set multiplot layout 1,2 title 'Few rounds cost lag: more of them where something is fast mend it' font ',16' offset 0,-0.6 margins 0.075,0.985,0.13,0.82 spacing 0.09
place(way) = way eq '1' ? 1 : way eq '2' ? 2 : way eq '3' ? 3 : way eq '3 to 8' ? 4 : way eq '5' ? 5 : way eq 'unbounded' ? 6 : NaN
set xtics ('1' 1, '2' 2, '3' 3, "3 to 8\n(default)" 4, '5' 5, 'any' 6)
set xrange [0.8:6.2]
set xlabel 'rounds in a tick (3 to 8: more than 3 only for what is fast)' offset 0,0.2
array colours[3] = [green, blue, red]
speeds = '20 100 200'
set title 'through 6 (dashed) and 16 panes 5 cm apart' font ',13'
set ylabel 'behind where it should be, as time [ms], worst phase'
set yrange [0:*]
set key at graph 0.97, graph 0.97 title ''
behind(speed, panes) = column(4) == speed && column(3) == panes ? place(strcol(1)) : NaN
plot for [i = 2:3] table('panes') using (behind(real(word(speeds, i)), 16)):9 smooth unique with linespoints lw 2.5 pt 7 lc rgb colours[i] title word(speeds, i).' m/s', \
     for [i = 1:3] table('panes') using (behind(real(word(speeds, i)), 6)):9 smooth unique with linespoints lw 2.5 dt 2 pt 7 lc rgb colours[i] title (i == 1 ? '20 m/s' : '')
set yrange [1:500]
set logscale y
set key at graph 0.97, graph 0.75
set title 'momentum that the shards of six panes took along' font ',13'
set ylabel 'least of all phases [mN s]'
plot for [i = 1:3] table('panes') using (behind(real(word(speeds, i)), 6)):($10 * 1000) smooth unique with linespoints lw 2.5 dt 2 pt 7 lc rgb colours[i] title word(speeds, i).' m/s'
unset multiplot
