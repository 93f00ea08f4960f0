width = 1060
load scripts.'/style.gp'
set title 'Inside the step strength is an edge; after it, most balls need more' font ',15'
set logscale x
set xrange [4:5e-7] reverse
set format x '%g'
set yrange [-300:10500]
set xlabel 'x: balls come with J / (1 + x) and with J (1 + x)'
set ylabel 'wrong answers of 10,000, both kinds'
set key outside right top vertical Left reverse
ways = '"after" "after capped" "restored" "1" "3 to 8" "unbounded" "2 iterations" "4 sub-steps"'
array colours[8] = [purple, red, yellow, sky, black, grey, green, '#7cc8ae']
# Many lie on one another: the first are the broadest.
plot for [i = 1:8] table('threshold') using (strcol(1) eq word(ways, i) ? column(2) : NaN):(column(4) + column(5)) with linespoints pt 7 ps 2.3 - 0.22 * i lw 11 - 1.2 * i lc rgb colours[i] title word(ways, i)
