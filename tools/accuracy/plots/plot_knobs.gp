width = 1240; height = 1120
load scripts.'/style.gp'
knobs = "'fracture' 'iterations' 'substeps' 'grid' 'position iterations' 'manifold' 'recycle distance' 'speculative margin' 'warm start' 'deactivation' 'stacks' 'direct solve mass ratio' 'pattern density' 'smallest body' 'debris kept' 'bodies kept'"
set multiplot layout 4,4 title 'Error against time, knob by knob: grey is everything measured, the line its front, the star the default' font ',16' offset 0,-0.2 margins 0.05,0.99,0.05,0.93 spacing 0.035,0.055
set logscale xy
set format '%g'
set key off
set tics font ',9'
set xtics (5, 20, 100, 500, 2000)
set ytics (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10)
stats table('settings') using 7 nooutput
set xrange [STATS_min * 0.8:STATS_max * 1.3]
stats table('settings') using 6 nooutput
set yrange [STATS_min * 0.8:STATS_max * 1.3]
do for [i = 1:words(knobs)] {
  knob = word(knobs, i)
  set title (knob eq 'grid' ? 'iterations x sub-steps' : knob) font ',12' offset 0,-0.7
  set xlabel (i > 12 ? 'ms per simulated second' : '') font ',10' offset 0,0.7
  set ylabel (i % 4 == 1 ? 'error score' : '') font ',10' offset 2.2,0
  plot table('settings') using 7:6 with points pt 7 ps 0.25 lc rgb '#c4c4c4', \
       table('settings') using ($5 == 1 ? $7 : NaN):6 smooth unique with lines lw 1.5 lc rgb '#9a9a9a', \
       table('settings') using (strcol(1) eq knob ? $7 : NaN):6 with points pt 7 ps 0.6 lc rgb blue, \
       table('settings') using (strcol(1) eq knob && knob ne 'grid' ? $7 : 1/0):6 with lines lw 1.8 lc rgb blue, \
       table('settings') using (strcol(1) eq knob ? $7 : NaN):6:2 with labels left offset 0.5,0.4 font ',8' tc rgb '#222222', \
       table('settings') using ($4 == 1 ? $7 : NaN):6 with points pt 3 ps 1.3 lw 1.5 lc rgb red
}
unset multiplot
