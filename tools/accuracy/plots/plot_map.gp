width = 1060
load scripts.'/style.gp'
set title 'At equal time more rounds beat more sub-steps: 100 m/s through six panes 5 cm apart' font ',15'
column_of(way) = way eq '1' ? 1 : way eq '2' ? 2 : way eq '3' ? 3 : way eq '3 to 8' ? 4 : way eq '5' ? 5 : 6
row_of(substeps) = log(substeps) / log(2) + 1
set xtics ('1' 1, '2' 2, '3' 3, '3, fast 8' 4, '5' 5, 'any' 6) scale 0
set ytics ('1 (default)' 1, '2' 2, '4' 3, '8' 4) scale 0
unset grid
set xlabel 'rounds in a tick'
set ylabel 'sub-steps'
set xrange [0.5:6.5]
set yrange [0.5:4.5]
set cblabel 'behind where it should be [ms], worst phase'
set logscale cb
set palette defined (0 '#f7fbff', 0.35 '#9ecae1', 0.7 '#4292c6', 1 '#08519c')
set key outside bottom center horizontal title ''
# Lines of equal time, from the times of the cells. Their table has no commas: a line of it is one column.
set dgrid3d 4,6,4
set contour base
unset surface
set cntrparam levels 6
set cntrparam cubicspline
set table $times
splot table('map') using (column_of(strcol(1))):(row_of($2)):13 with lines
unset table
unset dgrid3d
unset contour
set style textbox opaque noborder fillcolor rgb '#ffffff'
plot table('map') using (column_of(strcol(1))):(row_of($2)):(column_of(strcol(1)) - 0.5):(column_of(strcol(1)) + 0.5):(row_of($2) - 0.5):(row_of($2) + 0.5):($9 < 0.1 ? 0.1 : $9) with boxxyerror fs solid fc palette notitle, \
     $times using (real(word(strcol(1), 1))):(real(word(strcol(1), 2))) with lines lc rgb orange lw 2.5 title 'equal time', \
     table('map') using (column_of(strcol(1))):(row_of($2)):(sprintf("%.3g ms late\n%.0f ms/s", $9, $13)) with labels boxed font ',11' notitle
