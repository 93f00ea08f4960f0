width = 1200; height = 540
load scripts.'/style.gp'
set multiplot layout 1,2 title "Glass that breaks inside the step leaves the ball its exact speed" font ',16' offset 0,-0.6 margins 0.07,0.745,0.13,0.82 spacing 0.1
set logscale xy
set xrange [17:235]
set xtics (20, 50, 100, 200)
set xlabel 'speed at six panes 5 cm apart [m/s]'
set format y '%g'
ways = "'after' 'blended' 'restored' 'after capped' '1' '3' '3 to 8' 'unbounded'"
names = "'after the step' 'after it, blended' 'after it, restored' 'after it, capped' 'in it, 1 round' 'in it, 3 rounds' 'in it, 3 to 8 (default)' 'in it, unbounded'"
array colours[8] = [red, orange, yellow, purple, grey, sky, blue, green]
row(way, panes) = strcol(1) eq way && column(3) == panes && column(2) == 1
set title 'exit speed, worst phase of the gap' font ',13'
set ylabel 'off the exact one by [%]'
set yrange [0.02:400]
set key off
set arrow 1 from graph 0, first 2 to graph 1, first 2 nohead lc rgb black dt 3 lw 1.5
set label 1 'what the default must keep: 2 %' at graph 0.97, first 2.7 right tc rgb '#444444' font ',11'
plot for [i = 1:8] table('panes') using (row(word(ways, i), 6) ? $4 : NaN):($6 < 0.02 ? 0.02 : $6) with linespoints lw (i == 7 ? 4 : 2) pt 7 ps (i == 7 ? 1.1 : 0.7) lc rgb colours[i] title word(names, i)
unset arrow 1
unset label 1
set title 'place, worst phase of the gap' font ',13'
set ylabel 'behind where it should be by [cm]'
set yrange [0.05:20000]
set key at screen 0.995, screen 0.80 right top vertical Left reverse
plot for [i = 1:8] table('panes') using (row(word(ways, i), 6) ? $4 : NaN):($8 < 0.05 ? 0.05 : $8) with linespoints lw (i == 7 ? 4 : 2) pt 7 ps (i == 7 ? 1.1 : 0.7) lc rgb colours[i] title word(names, i)
unset multiplot
