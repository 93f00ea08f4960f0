width = 1200; height = 640
load scripts.'/style.gp'
set title 'Error against time: all that was measured, its front, and the presets' font ',15'
set logscale xy
set xlabel 'processor time per simulated second, mean of the scenes [ms/s]'
set ylabel 'error score (1: as much as one would notice)'
set format '%g'
set xtics (5, 10, 20, 50, 100, 200, 500, 1000, 2000)
set ytics (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10)
set key outside right top vertical Left reverse
knobs = "'fracture' 'iterations' 'substeps' 'grid' 'position iterations' 'manifold' 'recycle distance' 'speculative margin' 'warm start' 'deactivation' 'direct solve mass ratio'"
array colours[11] = [red, blue, green, sky, orange, purple, yellow, '#7f6000', '#8c564b', black, '#ff9da7']
shown(knob) = strcol(1) eq knob ? $7 : NaN
plot for [i = 1:11] table('settings') using (shown(word(knobs, i))):6 with points pt 7 ps 0.8 lc rgb colours[i] title (word(knobs, i) eq 'grid' ? 'iterations x sub-steps' : word(knobs, i)), \
     table('settings') using ($5 == 1 ? $7 : NaN):6 smooth unique with lines lw 2.5 lc rgb '#777777' title 'front', \
     table('settings') using (strcol(1) eq 'preset' ? $7 : NaN):6 with points pt 6 ps 2.4 lw 2 lc rgb black title 'presets', \
     table('settings') using (strcol(1) eq 'preset' && strcol(2) ne 'phone' ? $7 : NaN):6:2 with labels left offset 1,0.8 font ',12' notitle, \
     table('settings') using (strcol(2) eq 'phone' ? $7 : NaN):6:2 with labels right offset -1,0.8 font ',12' notitle, \
     table('settings') using ($4 == 1 ? $7 : NaN):6 with points pt 3 ps 2.4 lw 2 lc rgb red title 'default'
