# What all plots share. Set from outside: folder (of the tables and the plot), name, kind (svg or png). Before loading it a plot may
# set width and height [pixels].
if (!exists("width")) width = 960
if (!exists("height")) height = 600
set datafile separator comma
set datafile columnheaders
set datafile missing NaN  # what a plot leaves out does not tear its lines
set encoding utf8
if (kind eq 'svg') { set terminal svg size width, height font 'DejaVu Sans,13' background '#ffffff' enhanced linewidth 1.2
} else { set terminal pngcairo size 2 * width, 2 * height font 'DejaVu Sans,13' fontscale 2 background '#ffffff' enhanced linewidth 2 pointscale 2 }
set output folder.'/'.name.'.'.kind
table(what) = folder.'/'.what.'.csv'

# Colours that the colour-blind tell apart (Okabe, Ito: Color Universal Design, 2008).
black = '#222222'; orange = '#e69f00'; sky = '#56b4e9'; green = '#009e73'; yellow = '#d8c400'; blue = '#0072b2'; red = '#d55e00'; purple = '#cc79a7'; grey = '#9a9a9a'
set border 3 lc rgb '#555555' lw 1
set tics nomirror tc rgb '#333333'
set grid ytics xtics lc rgb '#e4e4e4' lw 1 lt 1
set key tc rgb '#222222' samplen 2.5 spacing 1.15
set style line 1 lc rgb black lw 2.5 pt 7 ps 0.9
set title tc rgb '#111111'
set xlabel tc rgb '#333333'
set ylabel tc rgb '#333333'
