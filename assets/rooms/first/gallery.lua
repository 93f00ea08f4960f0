-- The second room: warm stone and rose glass. The order of its middle is drawn anew for every seed, each kind at most twice.

function init()
	mgMusic("gallery")
	mgFogColor(0.52, 0.32, 0.46, 1.0, 0.87, 0.72)
	mgReverb(0.5, 1.0, 0.2)
	mgParticles("dustyfalling")

	local l = 0
	l = l + mgSegment("first/gallery/start", -l)
	l = l + mgSegment("first/gallery/arches", -l)
	confSegment("first/gallery/swings", 1, 2)
	confSegment("first/gallery/shelves", 0.8, 1)
	confSegment("first/gallery/doublewindow", 1, 1)
	confSegment("first/gallery/gates", 1, 2)
	confSegment("first/gallery/blocks", 1, 2)
	confSegment("first/gallery/fan", 1, 2)
	for i = 1, 9 do
		l = l + mgSegment(nextSegment(), -l)
	end
	l = l + mgSegment("first/gallery/door", -l)
	mgLength(l)
end
