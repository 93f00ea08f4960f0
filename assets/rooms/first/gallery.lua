-- A short room whose order is drawn anew for every seed.

function init()
	mgMusic("gallery")
	mgFogColor(0.52, 0.32, 0.46, 1.0, 0.87, 0.72)
	mgReverb(0.5, 1.0, 0.2)
	mgParticles("dustyfalling")

	confSegment("first/gallery/arches", 1)
	confSegment("first/gallery/swings", 1)
	confSegment("first/gallery/shelves", 0.7)
	confSegment("first/gallery/doublewindow", 1)

	mgLength(fillRoom(128, "first/gallery/door", 16))
end
